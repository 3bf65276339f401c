// The operation table, and looking things up in it and in actions.
#include "grammar/operation.h"

#include <fmt/format.h>

#include <string>

#include "base/check.h"
#include "grammar/operations/rows.h"

namespace parti::grammar {
namespace {

/// Counts leaves depth first; null while `*left` of them are still to pass.
const Successor* FindLeaf(std::span<const Successor> list, int* left) {
  for (const Successor& s : list) {
    if (!s.repeat.empty()) {
      if (const Successor* found = FindLeaf(s.repeat, left)) return found;
    } else if ((*left)-- == 0) {
      return &s;
    }
  }
  return nullptr;
}

}  // namespace

std::span<const Operation> Operations() {
  static const Operation rows[] = {kExtrude,
                                   kSplit,
                                   kRepeat,
                                   kComp,
                                   kOffset,
                                   kTag,
                                   kSymbol,
                                   kColor,
                                   kLayers,
                                   kSegment,
                                   kVectorial,
                                   kSetProperty,
                                   kTranslate,
                                   kScale,
                                   kRotate,
                                   kCenter,
                                   kMirror,
                                   kRoofHip,
                                   kRoofGable,
                                   kRoofPyramid,
                                   kRoofShed,
                                   kTaper,
                                   kInsert,
                                   kCube,
                                   kSphere,
                                   kCylinder,
                                   kCone,
                                   kQuad,
                                   kDisk,
                                   kTexture,
                                   kSetupProjection,
                                   kProjectUv,
                                   kSetMaterial,
                                   kSetback,
                                   kShapeL,
                                   kShapeU,
                                   kShapeO,
                                   kInnerRectangle,
                                   kExtrudeAlong,
                                   kAlignToAxes,
                                   kAlignToGeometry,
                                   kRotateScope,
                                   kMoveInWorld,
                                   kTurnInWorld,
                                   kCleanupGeometry,
                                   kReverseNormals,
                                   kTileUv,
                                   kScaleUv,
                                   kTranslateUv,
                                   kRotateUv,
                                   kNormalizeUv,
                                   kDeleteUv,
                                   kScatter,
                                   kResetMaterial,
                                   kDeleteHoles,
                                   kReport,
                                   kPrint};
  return rows;
}

const Operation* FindOperation(std::string_view name) {
  for (const Operation& row : Operations()) {
    if (row.name == name) return &row;
  }
  return nullptr;
}

Result<const Operation*> OperationNamed(std::string_view name) {
  if (const Operation* row = FindOperation(name)) return row;
  std::vector<std::string> names;
  for (const Operation& row : Operations()) names.emplace_back(row.name);
  const auto meant = DidYouMean(name, names);
  return Fail(ErrorCode::kUnknownName, fmt::format("there is no operation '{}'", name),
              meant ? fmt::format("did you mean '{}'?", *meant)
                    : fmt::format("operations are {}", fmt::join(names, ", ")));
}

std::optional<ItemType> OutType(const Operation& operation, ItemType type) {
  if ((operation.takes & Types(type)) == 0) return std::nullopt;
  if ((operation.gives & Types(type)) != 0) return type;
  return static_cast<ItemType>(operation.gives & -operation.gives);  // the only one there is
}

Action Default(const Operation& operation) {
  Action action;
  action.operation = &operation;
  for (const Parameter& p : operation.parameters) action.arguments.push_back(p.default_value);
  return action;
}

const Successor& SuccessorAt(const Action& action, int number) {
  int left = number;
  const Successor* found = number < 0 ? nullptr : FindLeaf(action.successors, &left);
  CHECK(found != nullptr, "a product's successor is one of the action's");
  return *found;
}

int SuccessorFor(const Action& action, Selector::Kind kind) {
  for (size_t i = 0; i < action.successors.size(); ++i) {
    const Successor& s = action.successors[i];
    if (std::get<Selector>(s.key).kind != kind) continue;
    return s.symbol == kNil ? -1 : static_cast<int>(i);
  }
  return -1;
}

}  // namespace parti::grammar
