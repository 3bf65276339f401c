// docs/operations: the example of every operation is derived, and makes the picture beside it.
// PARTI_UPDATE_GOLDEN=1 draws the pictures anew: look at them before committing.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "app/open_model.h"
#include "app/picture.h"
#include "app/rule_source.h"
#include "base/text_file.h"
#include "grammar/operation.h"
#include "tests/support/data.h"
#include "tests/support/golden.h"

namespace parti::tests {
namespace {

using grammar::Operation;

constexpr Vec2 kExampleSize_px{360, 270};
constexpr std::string_view kLotComment = "// lot: ";

std::string PathOf(std::string_view name) { return "docs/operations/" + std::string(name); }

/// The lot that a text's first line names.
std::string LotOf(const std::string& text) {
  if (!text.starts_with(kLotComment)) return "";
  return text.substr(kLotComment.size(), text.find('\n') - kLotComment.size());
}

bool Uses(const grammar::Body& body, const Operation& row);

bool Uses(const std::vector<grammar::SuccessorRule>& successors, const Operation& row) {
  return std::any_of(successors.begin(), successors.end(), [&](const auto& successor) {
    return Uses(successor.body, row) || Uses(successor.repeat, row);
  });
}

bool Uses(const grammar::Body& body, const Operation& row) {
  return std::any_of(body.statements.begin(), body.statements.end(), [&](const auto& statement) {
    return statement.operation == &row || Uses(statement.successors, row);
  });
}

class OperationExample : public testing::TestWithParam<std::string_view> {
 protected:
  /// As `parti derive` makes it.
  app::Model Derived() {
    app::ModelOptions options;
    options.file = SourceFile(PathOf(GetParam()) + ".cga");
    options.lot = LotOf(ReadFile(options.file).value_or(""));
    EXPECT_FALSE(options.lot.empty()) << "the first line of " << options.file << " names a lot";
    auto opened = app::OpenModel(options);
    if (opened) return std::move(opened->model);
    ADD_FAILURE() << FormatError(opened.error().front());
    return {};
  }
};

TEST_P(OperationExample, IsDerivedAndUsesTheOperation) {
  const app::Model model = Derived();
  ASSERT_EQ(model.derived.size(), 1u);
  const grammar::ShapeTree& tree = model.derived[0]->tree;
  EXPECT_GT(tree.Leaves().size(), 0u);
  app::RuleSource source;
  const auto rules = app::ReadRules(SourceFile(PathOf(GetParam()) + ".cga"), &source);
  ASSERT_TRUE(rules.has_value());
  const Operation* row = grammar::FindOperation(GetParam());
  EXPECT_TRUE(std::any_of(rules->rules.begin(), rules->rules.end(),
                          [&](const auto& rule) { return Uses(rule.body, *row); }));
  bool made = row->in_place;
  for (grammar::ShapeIndex i = 0; i < tree.size(); ++i) made |= tree[i].operation == row;
  EXPECT_TRUE(made) << "no shape is made by it";
}

TEST_P(OperationExample, MakesItsPicture) {
  app::SessionState state;
  state.model = Derived();
  ASSERT_FALSE(state.model.derived.empty());
  state.camera = app::AutoViewOf(state.model, kExampleSize_px);
  const auto picture = app::PictureOf(state);
  ASSERT_TRUE(picture.has_value()) << FormatError(picture.error());
  ExpectPicture(*picture, PathOf(GetParam()));
}

std::vector<std::string_view> Names() {
  std::vector<std::string_view> names;
  for (const Operation& row : grammar::Operations()) names.push_back(row.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Operations, OperationExample, testing::ValuesIn(Names()),
                         [](const auto& test) { return std::string(test.param); });

TEST(OperationExamples, AreThoseOfTheTableAndNoOthers) {
  std::set<std::string> wanted, found;
  for (const std::string_view name : Names()) {
    wanted.insert(std::string(name) + ".cga");
    wanted.insert(std::string(name) + ".png");
  }
  for (const auto& entry : std::filesystem::directory_iterator(SourceFile("docs/operations"))) {
    const std::string name = entry.path().filename().string();
    if (!name.ends_with(".out.png") && !name.ends_with(".diff.png")) found.insert(name);
  }
  EXPECT_EQ(found, wanted);
}

}  // namespace
}  // namespace parti::tests
