// Which of several screens is drawn on, in which mode and how large, without any screen.
#include "render/kms_output.h"

#include <gtest/gtest.h>

namespace parti::render {
namespace {

drmModeModeInfo Mode(int width, int height, int hz, bool preferred = false) {
  drmModeModeInfo mode{};
  mode.hdisplay = static_cast<uint16_t>(width);
  mode.vdisplay = static_cast<uint16_t>(height);
  mode.vrefresh = static_cast<uint32_t>(hz);
  mode.type = preferred ? DRM_MODE_TYPE_PREFERRED : 0;
  return mode;
}

KmsOutput Output(const std::string& name, const std::optional<Vec2>& size_mm,
                 bool built_in = false) {
  KmsOutput output;
  output.name = name;
  output.connected = true;
  output.built_in = built_in;
  output.size_mm = size_mm;
  output.modes = {Mode(1920, 1080, 60, true)};
  output.crtcs = {7};
  return output;
}

const std::vector<KmsOutput> kDesk = {Output("DP-1", Vec2(600, 340)),
                                      Output("eDP-1", Vec2(310, 170), true),
                                      Output("HDMI-A-1", Vec2(300, 170))};

TEST(KmsOutputs, TheBuiltInScreenComesBeforeOthers) {
  EXPECT_EQ(ChooseOutput(kDesk, "", {}), 1u);
  const std::vector<KmsOutput> two = {kDesk[0], kDesk[2]};
  EXPECT_EQ(ChooseOutput(two, "", {}), 0u);
}

TEST(KmsOutputs, ADisplayTabletsOwnScreenComesFirst) {
  const std::vector<Vec2> cintiq = {{297.76, 169.24}};
  const std::vector<KmsOutput> two = {kDesk[0], kDesk[2]};
  EXPECT_EQ(ChooseOutput(two, "", cintiq), 1u);
  const std::vector<Vec2> on_the_desk = {{216, 135}};
  EXPECT_EQ(ChooseOutput(two, "", on_the_desk), 0u);
  std::vector<KmsOutput> silent = two;
  silent[1].size_mm.reset();
  EXPECT_EQ(ChooseOutput(silent, "", cintiq), 0u);
}

TEST(KmsOutputs, ANamedOneIsTakenOrNone) {
  EXPECT_EQ(ChooseOutput(kDesk, "HDMI-A-1", {}), 2u);
  EXPECT_EQ(ChooseOutput(kDesk, "HDMI-A-2", {}), std::nullopt);
  std::vector<KmsOutput> unplugged = kDesk;
  unplugged[2].connected = false;
  EXPECT_EQ(ChooseOutput(unplugged, "HDMI-A-1", {}), std::nullopt);
}

TEST(KmsOutputs, WhatCannotShowAPictureIsLeftOut) {
  std::vector<KmsOutput> outputs = kDesk;
  outputs[1].connected = false;
  outputs[0].modes.clear();
  EXPECT_EQ(ChooseOutput(outputs, "", {}), 2u);
  outputs[2].crtcs.clear();
  EXPECT_EQ(ChooseOutput(outputs, "", {}), std::nullopt);
  EXPECT_EQ(ChooseOutput({}, "", {}), std::nullopt);
}

TEST(KmsModes, ThePreferredOneElseTheLargestAndFastest) {
  KmsOutput output;
  EXPECT_FALSE(ChooseMode(output));
  output.modes = {Mode(1280, 720, 60), Mode(1920, 1080, 50), Mode(1920, 1080, 60),
                  Mode(800, 600, 120)};
  EXPECT_EQ(ChooseMode(output)->hdisplay, 1920);
  EXPECT_EQ(ChooseMode(output)->vrefresh, 60u);
  output.modes.push_back(Mode(1024, 768, 60, true));
  EXPECT_EQ(ChooseMode(output)->hdisplay, 1024);
}

TEST(KmsScales, FollowTheDensityInQuarters) {
  EXPECT_EQ(ScaleOf({1920, 1080}, Vec2(508, 286)), 1);     // 96 px an inch
  EXPECT_EQ(ScaleOf({1920, 1080}, Vec2(294, 166)), 1.75);  // a 13" display tablet
  EXPECT_EQ(ScaleOf({3840, 2160}, Vec2(344, 194)), 3);     // a laptop of 283 px an inch
  EXPECT_EQ(ScaleOf({1024, 768}, Vec2(400, 300)), 1) << "never smaller than usual";
}

TEST(KmsSizes, AShapeIsNoSize) {
  EXPECT_EQ(SizeOf_mm(600, 340), Vec2(600, 340));
  EXPECT_EQ(SizeOf_mm(155, 87), Vec2(155, 87)) << "the smallest screens of computers";
  EXPECT_EQ(SizeOf_mm(0, 0), std::nullopt);
  for (const auto& [width, height] : {std::pair(16, 9), {16, 10}, {160, 90}, {160, 100}}) {
    EXPECT_EQ(SizeOf_mm(width, height), std::nullopt) << width << " x " << height;
  }
}

TEST(KmsScales, NonsenseCountsAsUsual) {
  EXPECT_EQ(ScaleOf({1920, 1080}, std::nullopt), 1);
  EXPECT_EQ(ScaleOf({1920, 1080}, Vec2(0, 0)), 1);
  EXPECT_EQ(ScaleOf({1920, 1080}, Vec2(16, 9)), 1) << "some screens give their shape as their size";
  EXPECT_EQ(ScaleOf({1920, 1080}, SizeOf_mm(160, 90)), 1) << "the same, counted in centimetres";
  EXPECT_EQ(ScaleOf({1920, 1080}, Vec2(1600, 900)), 1) << "a projector";
}

}  // namespace
}  // namespace parti::render
