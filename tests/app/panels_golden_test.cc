// Pictures of every panel in both themes at 1x and 2x, as docs/panels.md shows them.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <linux/input-event-codes.h>

#include "tests/app/panels_driver.h"
#include "tests/app/panels_picture.h"
#include "tests/support/golden.h"

namespace parti::app::tests {
namespace {

using parti::tests::ExpectGolden;

/// Theme and scale of a picture.
struct PictureCase {
  Theme theme;
  double scale;
  std::string name() const {
    return fmt::format("{}-{}x", theme == Theme::kLight ? "light" : "dark", scale);
  }
};

class PanelsGolden : public ::testing::TestWithParam<PictureCase> {
 protected:
  void SetUp() override {
    panels_.view.settings.theme = GetParam().theme;
    panels_.view.scale = GetParam().scale;
    Resize({1280, 800});
    panels_.view.files = {{"/srv/models/Courtyard.parti", "/srv/models/Town house.parti"},
                          "/srv/models",
                          {{"Studies", true},
                           {"Courtyard.parti", false},
                           {"House.parti", false},
                           {"Town house.parti", false}}};
  }
  /// In the panels' units.
  void Resize(const Vec2& size) { panels_.view.size_px = size * GetParam().scale; }
  /// A name is being given to a view, where there is no keyboard.
  void TypeOnTheScreen() {
    panels_.view.session = WholeHouse();
    panels_.view.has_keys = false;
    Resize({800, 600});
    panels_.Tap("Menu/Views");
    panels_.Tap("Views/Keep this view as");
  }
  /// Of the whole window, or of the sheets named.
  void Look(const std::string& name, const std::vector<std::string>& sheets = {},
            double margin = 14) {
    const PanelOutput& output = panels_.Frame();
    // Parts, and all at 2x, are shown on paper: the house is large as a picture, and always the
    // same.
    const bool house = sheets.empty() && GetParam().scale == 1;
    const auto* session = house ? panels_.view.session.get() : nullptr;
    const auto image = PictureWith(output, session, panels_.view.size_px);
    ExpectGolden(AroundSheets(image, output, sheets, margin * GetParam().scale),
                 "../../docs/panels/" + name + "-" + GetParam().name());
  }
  PanelDriver panels_;
};

TEST_P(PanelsGolden, FirstStart) { Look("first-start"); }

TEST_P(PanelsGolden, Suggestions) {
  panels_.view.session = HouseBeforePick(3);
  panels_.Hover("Suggestions/1");
  Look("suggestions");
}

TEST_P(PanelsGolden, RulesAndTheNodeInHand) {
  panels_.view.session = Taken(WholeHouse(), {0, 0, 0, 0});
  panels_.Tap("Menu/Rules");
  panels_.Frame({PanelPointerGone{}});
  Look("rules", {"Rules", "Node", "Menu"});
}

TEST_P(PanelsGolden, RulesAsText) {
  panels_.view.session = WholeHouse();
  Resize({1280, 1000});
  panels_.Tap("Menu/Rules");
  panels_.Tap("Rules/As text");
  panels_.Tap("Rules/Line 4");
  panels_.Type(".Facade --> splt(y) { 4.1: Ground | ~1: CenterFloors | 3: TopFloor } {");
  panels_.Key(KEY_ENTER);
  panels_.Frame({PanelPointerGone{}});
  Look("rules-text", {"Rules", "Menu"});
}

TEST_P(PanelsGolden, RuleFilesAsText) {
  panels_.view.session = LayeredHouse();
  Resize({1280, 1460});
  panels_.Tap("Menu/Rules");
  panels_.Tap("Rules/As text");
  panels_.Tap("Rules/house.cga 12");
  panels_.Type("Storey --> segment(x) { ~1: NIL | 1.2: Windw | ~1: NIL }* colour(2)");
  panels_.Key(KEY_ENTER);
  panels_.Frame({PanelPointerGone{}});
  Look("rule-files", {"Rules", "Menu"});
}

TEST_P(PanelsGolden, LayersOfTheFaceInHand) {
  panels_.view.session = LayeredHouse(".Board");
  panels_.Tap("Menu/Rules");
  panels_.Tap("Rules/Layers");
  panels_.Tap("Rules/Facade.shop");
  panels_.Frame({PanelPointerGone{}});
  Look("layers");
}

TEST_P(PanelsGolden, Queries) {
  panels_.view.session = Chosen(HouseWithTaps(2), ".Glass");
  panels_.view.mode = PointerMode::kSelect;
  panels_.Tap("Menu/Rules");
  panels_.view.tapped_px = Vec2(520, 420) * GetParam().scale;
  Look("queries");
}

TEST_P(PanelsGolden, QueriesForANode) {
  panels_.view.session = Taken(HouseWithTaps(2), {0, 0, 0, 0});
  panels_.view.mode = PointerMode::kSelect;
  panels_.Tap("Menu/Rules");
  panels_.view.tapped_px = Vec2(520, 420) * GetParam().scale;
  Look("queries-node", {"Queries"});
}

TEST_P(PanelsGolden, WhatTheNextSketchActsOn) {
  panels_.view.session = Chosen(WholeHouse(), ".Glass");
  Look("chosen", {"Status"});
}

TEST_P(PanelsGolden, AnElementInHand) {
  HoldElement(&panels_.view);
  Look("element", {"Element"});
}

TEST_P(PanelsGolden, Drafts) {
  auto nothing = std::make_shared<SessionSnapshot>();
  nothing->state = std::make_shared<const SessionState>();
  panels_.view.session = nothing;
  for (const char* name : {"2026-11-22 09.30.05", "2026-11-20 17.02.44", "2026-11-03 11.15.00"}) {
    panels_.view.files.drafts.push_back("/drafts/" + std::string(name) + ".parti");
  }
  panels_.Tap("Drafts/Throw away /drafts/2026-11-20 17.02.44.parti");
  Look("drafts", {"Drafts"});
}

TEST_P(PanelsGolden, Document) {
  panels_.view.session = WholeHouse();
  panels_.Tap("Title/Document");
  Look("document", {"Title", "Document"});
}

TEST_P(PanelsGolden, Open) {
  panels_.view.session = WholeHouse();
  panels_.Tap("Title/Document");
  panels_.Tap("Document/Open…");
  Look("open", {"Title", "Open"});
}

TEST_P(PanelsGolden, SaveAs) {
  panels_.view.session = WholeHouse();
  panels_.Tap("Title/Document");
  panels_.Tap("Document/Save as…");
  Look("save-as", {"Title", "Save as"});
}

TEST_P(PanelsGolden, Replacing) {
  panels_.view.session = WholeHouse();
  panels_.Tap("Title/Document");
  panels_.Tap("Document/Save as…");
  panels_.Key(KEY_ENTER);
  panels_.Tap("Save as/Courtyard.parti");
  panels_.Tap("Save as/Save here");
  panels_.Frame({PanelPointerGone{}});
  Look("replace", {"Title", "Save as"});
}

TEST_P(PanelsGolden, Views) {
  panels_.view.session = WholeHouse();
  panels_.Tap("Menu/Views");
  Look("views", {"Menu", "Views"});
}

TEST_P(PanelsGolden, Export) {
  panels_.view.session = WholeHouse();
  panels_.Tap("Menu/Export");
  Look("export", {"Menu", "Export"});
}

TEST_P(PanelsGolden, Settings) {
  panels_.view.session = WholeHouse();
  panels_.Tap("Menu/Settings");
  Look("settings", {"Menu", "Settings"});
}

TEST_P(PanelsGolden, Tools) {
  panels_.view.session = WholeHouse();
  panels_.view.mode = PointerMode::kOrbit;
  panels_.Hover("Tools/Undo");
  Look("tools", {"Title", "Tools"}, 40);
}

TEST_P(PanelsGolden, Trouble) {
  panels_.view.session = InTrouble(WholeHouse());
  Look("trouble", {"Status"});
}

TEST_P(PanelsGolden, Keyboard) {
  TypeOnTheScreen();
  panels_.Tap("Keyboard/s");
  Look("keyboard");
}

TEST_P(PanelsGolden, Signs) {
  TypeOnTheScreen();
  panels_.Tap("Keyboard/Signs");
  panels_.Tap("Keyboard/More signs");
  Look("signs", {"Keyboard"});
}

TEST_P(PanelsGolden, Portrait) {
  panels_.view.session = Taken(WholeHouse(), {0, 0, 0});
  Resize({540, 960});
  panels_.Tap("Menu/Rules");
  Look("portrait");
}

TEST_P(PanelsGolden, LeftHanded) {
  panels_.view.settings.left_handed = true;
  panels_.view.session = HouseBeforePick(6);
  Look("left-handed");
}

INSTANTIATE_TEST_SUITE_P(Both, PanelsGolden,
                         ::testing::Values(PictureCase{Theme::kLight, 1},
                                           PictureCase{Theme::kLight, 2},
                                           PictureCase{Theme::kDark, 1},
                                           PictureCase{Theme::kDark, 2}),
                         [](const auto& tested) {
                           std::string words = tested.param.name();
                           std::replace(words.begin(), words.end(), '-', '_');
                           return words;
                         });

}  // namespace
}  // namespace parti::app::tests
