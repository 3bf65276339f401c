// The rows of the operation table, one file each; operation.cc puts them in order.
// What a row is, and how callers find one, stands in operation.h.
#pragma once

#include "grammar/operation.h"

namespace parti::grammar {

extern const Operation kExtrude, kExtrudeAlong, kSplit, kRepeat, kComp, kOffset, kTag, kSymbol,
    kColor, kLayers, kSegment, kVectorial, kSetProperty;
extern const Operation kRoofHip, kRoofGable, kRoofPyramid, kRoofShed, kTaper;
extern const Operation kSetback, kShapeL, kShapeU, kShapeO, kInnerRectangle;
extern const Operation kTranslate, kRotate, kScale, kCenter, kMirror, kInsert, kCube, kSphere,
    kCylinder, kCone, kQuad, kDisk, kTexture, kSetupProjection, kProjectUv, kSetMaterial;
extern const Operation kAlignToAxes, kAlignToGeometry, kRotateScope, kMoveInWorld, kTurnInWorld,
    kCleanupGeometry, kReverseNormals, kScatter;
extern const Operation kTileUv, kScaleUv, kTranslateUv, kRotateUv, kNormalizeUv, kDeleteUv;
extern const Operation kResetMaterial, kDeleteHoles, kReport, kPrint;

/// What has a surface, and what stands in the world: all that may be moved or replaced.
inline constexpr ItemTypes kSurfaced = Types(ItemType::kVolume, ItemType::kPlanar);
inline constexpr ItemTypes kMovable =
    Types(ItemType::kVolume, ItemType::kPlanar, ItemType::kEdge, ItemType::kPoint);

/// The first successor whose selector is `kind`; -1 when there is none or it makes nothing (NIL).
/// Only for actions without repeat groups.
int SuccessorFor(const Action& action, Selector::Kind kind);

}  // namespace parti::grammar
