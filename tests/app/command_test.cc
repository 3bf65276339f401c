#include "app/command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace parti::app {
namespace {

using ::testing::HasSubstr;

TEST(CommandTest, EveryCommandReadsBackAsWritten) {
  for (const char* line : {"lot rect(20,14)",
                           "lot poly(0,0 10,0 10,8)",
                           "view eye 30.1 14 40 target 10 5 7 fov 40 size 1600 1000",
                           "pick 2",
                           "pick 1 split",
                           "name B CenterFloors",
                           "query .Facade:north / .Floor:even",
                           "set sizes[1] 2.75",
                           "node .Glass --> color(\"#7f9db5\")",
                           "rewrite tree house { .Lot --> extrude(9) Mass }",
                           R"~(rule-text {"file":"a b.cga","text":"// ü\nLot --> extrude(9)\n"})~",
                           "layers {}",
                           R"(layers {"off":["F.a"],"order":[["F",["a"]]],"rules":[["F.a","B"]]})",
                           "layer Facade.door off",
                           "layer Facade.door on",
                           "layer roof.Flat.a b up",
                           "layer off down",
                           "layer Facade.door gets Gate",
                           "layer a gets as-written",
                           "layer Facade.door as-written",
                           "place Door left 16.5 bottom 1.22",
                           "place A door width 0.1 height 2",
                           "place left left 3",
                           "clear",
                           "undo",
                           "redo",
                           "rename-symbol B Floors",
                           "take 0/1",
                           "take none",
                           "switch 0/2/1 off",
                           "switch 1 on",
                           "move 0/2 to 0/0/1",
                           "delete 0/1",
                           "tree street furniture",
                           "rename-tree 1 street furniture",
                           "keep-view street corner",
                           "go-view street corner",
                           "drop-view street corner",
                           "erase 3 4",
                           "select 0/2/5 lot-1:0/3 .",
                           "select none",
                           "query 2",
                           "query none"}) {
    const auto command = ParseCommand(line);
    ASSERT_TRUE(command) << line << ": " << command.error().message;
    EXPECT_EQ(TextOf(*command), line);
  }
}

TEST(CommandTest, ViewsComeBackToTheLastBit) {
  Camera camera;
  camera.eye = {1.0 / 3, 0.1, 1e-7};
  camera.vertical_fov = Angle::Degrees(36.6);
  const auto back = ParseCommand(TextOf(SetView{camera}));
  ASSERT_TRUE(back);
  EXPECT_EQ(std::get<SetView>(*back).camera, camera);
}

TEST(CommandTest, SpaceAroundWordsIsNotPartOfThem) {
  const auto command = ParseCommand("  node   .A --> tag(\"x y\") \t");
  ASSERT_TRUE(command);
  EXPECT_EQ(std::get<AddNode>(*command).text, ".A --> tag(\"x y\")");
}

TEST(CommandTest, AMisspeltCommandIsAnsweredWithTheOneMeant) {
  const auto command = ParseCommand("pikc 1");
  ASSERT_FALSE(command);
  EXPECT_EQ(command.error().code, ErrorCode::kUnknownName);
  EXPECT_THAT(command.error().hint, HasSubstr("'pick'"));
}

TEST(CommandTest, IncompleteCommandsShowAnExample) {
  for (const char* line : {"lot",          "view eye 1 2 3",  "pick",
                           "name A",       "query",           "set x",
                           "node",         "rename-symbol A", "take",
                           "take 0 1",     "switch 0/1",      "switch 0/1 maybe",
                           "move 0/1 0/2", "move 0/1",        "delete",
                           "tree",         "rename-tree 1",   "rename-tree 0/1 x",
                           "keep-view",    "go-view",         "drop-view",
                           "erase",        "select",          "rule-text",
                           "rule-text {}", "rule-text 3",     "layers",
                           "place",        "place Door",      "place Door 4",
                           "place left 4", "place Door left", "layer",
                           "layer off",    "layer F.a",       "layer gets A"}) {
    const auto command = ParseCommand(line);
    ASSERT_FALSE(command) << line;
    EXPECT_EQ(command.error().code, ErrorCode::kBadText) << line;
    EXPECT_THAT(command.error().hint, HasSubstr("for example")) << line;
  }
}

TEST(CommandTest, ATextComesBackAsItWasOnOneLine) {
  const SetRuleText command{"house.cga", "Lot -->\t\"a\\b\"\r\n\n \x01 // 窓 "};
  const std::string line = TextOf(command);
  EXPECT_EQ(line.find('\n'), std::string::npos);
  const auto back = ParseCommand(line);
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(std::get<SetRuleText>(*back), command);
}

TEST(CommandTest, LayersThatAreNoLayersAreRefused) {
  for (const char* line : {"layers 3", "layers {\"of\":[]}", "layers {\"off\":\"Facade.door\"}",
                           "layers {\"order\":[[\"Facade\"]]}", "layers {\"rules\":[[1,2]]}",
                           "layers {\"off\"", "rule-text {\"file\":\"a\",\"text\":3}"}) {
    const auto command = ParseCommand(line);
    ASSERT_FALSE(command) << line;
    EXPECT_EQ(command.error().code, ErrorCode::kBadText) << line;
  }
}

TEST(CommandTest, PathsThatAreNoneAreRefused) {
  for (const char* line : {"take 0/", "take /1", "take 0//1", "take x", "take -1", "take 0/-1",
                           "delete 99999999999999", "move 0/1 to y", "switch 0.1 on"}) {
    const auto command = ParseCommand(line);
    ASSERT_FALSE(command) << line;
    EXPECT_EQ(command.error().code, ErrorCode::kBadText) << line;
    EXPECT_THAT(command.error().hint, HasSubstr("0/2/1")) << line;
  }
}

TEST(CommandTest, LengthsAreTypedWithTheirUnits) {
  const auto metres = [](const char* line) {
    const auto command = ParseCommand(line);
    EXPECT_TRUE(command) << line;
    return command ? std::get<SetNumber>(*command).value : 0;
  };
  EXPECT_EQ(metres("set distance 3.5 m"), 3.5);
  EXPECT_EQ(metres("set sizes[1] 350cm"), 3.5);
  EXPECT_DOUBLE_EQ(metres("set distance 12ft 6in"), 12.5 * 0.3048);
}

TEST(CommandTest, NumbersThatAreNoneAreRefused) {
  for (const char* line :
       {"erase -1", "erase 1.5", "erase 3 x", "pick one", "pick 0", "pick 1.5", "set distance nan",
        "set distance 12x", "view eye inf 14 40 target 10 5 7 fov 40 size 1600 1000",
        "view eye 1 1 1 target 1 1 1 fov 40 size 1600 1000",
        "view eye 0 9 0 target 0 0 0 fov 40 size 1600 1000",
        "view eye 30 14 40 target 10 5 7 fov 190 size 1600 1000"}) {
    const auto command = ParseCommand(line);
    ASSERT_FALSE(command) << line;
    EXPECT_EQ(command.error().code, ErrorCode::kBadNumber) << line;
  }
}

TEST(CommandTest, AnEmptyLineIsNoCommand) {
  EXPECT_FALSE(ParseCommand(""));
  EXPECT_FALSE(ParseCommand("   "));
}

}  // namespace
}  // namespace parti::app
