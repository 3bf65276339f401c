// What holds of all panels in all states, windows, scales and themes; and under any input.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/input-event-codes.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "app/panels/theme.h"
#include "tests/app/panels_driver.h"

namespace parti::app::tests {
namespace {

/// A state of the panels: what is open, what is in hand.
struct StateCase {
  const char* name;
  void (*enter)(PanelDriver*);
};

void PrintTo(const StateCase& state, std::ostream* out) { *out << state.name; }

const StateCase kStates[] = {
    {"FirstStart", [](PanelDriver*) {}},
    {"Suggestions", [](PanelDriver* p) { p->view.session = HouseBeforePick(3); }},
    {"Rules",
     [](PanelDriver* p) {
       p->view.session = WholeHouse();
       p->Tap("Menu/Rules");
     }},
    {"RulesAsText",
     [](PanelDriver* p) {
       p->view.session = WholeHouse();
       p->Tap("Menu/Rules");
       p->Tap("Rules/As text");
     }},
    {"RuleFiles",
     [](PanelDriver* p) {
       p->view.session = LayeredHouse();
       p->Tap("Menu/Rules");
       p->Tap("Rules/As text");
     }},
    {"Layers",
     [](PanelDriver* p) {
       p->view.session = LayeredHouse(".Board");
       p->Tap("Menu/Rules");
       p->Tap("Rules/Layers");
       p->Tap("Rules/Facade.shop");
     }},
    {"Node",
     [](PanelDriver* p) {
       p->view.session = Taken(WholeHouse(), {0, 0, 0, 0});
     }},
    {"Queries",
     [](PanelDriver* p) {
       p->view.session = HouseWithTaps(2);
       p->view.tapped_px = p->view.size_px / 2.0;
     }},
    {"QueryChosen",
     [](PanelDriver* p) {
       p->view.session = Chosen(HouseWithTaps(2), ".Glass");
       p->view.tapped_px = p->view.size_px / 2.0;
     }},
    {"QueriesForANode",
     [](PanelDriver* p) {
       p->view.session = Taken(HouseWithTaps(2), {0, 0, 0, 0});
       p->view.tapped_px = p->view.size_px / 2.0;
       p->Tap("Menu/Rules");
     }},
    {"Element", [](PanelDriver* p) { HoldElement(&p->view); }},
    {"Trouble", [](PanelDriver* p) { p->view.session = InTrouble(WholeHouse()); }},
    {"Drafts",
     [](PanelDriver* p) {
       auto nothing = std::make_shared<SessionSnapshot>();
       nothing->state = std::make_shared<const SessionState>();
       p->view.session = nothing;
       for (int i = 1; i < 6; ++i) {
         p->view.files.drafts.push_back("/drafts/2026-11-0" + std::to_string(i) +
                                        " 09.30.05.parti");
       }
       p->Tap("Drafts/Throw away /drafts/2026-11-02 09.30.05.parti");
     }},
    {"Document", [](PanelDriver* p) { p->Tap("Title/Document"); }},
    {"Open",
     [](PanelDriver* p) {
       p->Tap("Title/Document");
       p->Tap("Document/Open…");
     }},
    {"SaveAs",
     [](PanelDriver* p) {
       p->Tap("Title/Document");
       p->Tap("Document/Save as…");
     }},
    {"Replacing",
     [](PanelDriver* p) {
       p->view.files = {{}, "/srv", {{"A.parti", false}}};
       p->Tap("Title/Document");
       p->Tap("Document/Save as…");
       p->Tap("Save as/A.parti");
       p->Tap("Save as/Save here");
     }},
    {"Views", [](PanelDriver* p) { p->Tap("Menu/Views"); }},
    {"Export", [](PanelDriver* p) { p->Tap("Menu/Export"); }},
    {"Settings", [](PanelDriver* p) { p->Tap("Menu/Settings"); }},
    {"Keyboard",
     [](PanelDriver* p) {
       p->view.has_keys = false;
       p->Tap("Menu/Views");
       p->Tap("Views/Keep this view as");
     }},
    {"Signs",
     [](PanelDriver* p) {
       p->view.has_keys = false;
       p->Tap("Menu/Views");
       p->Tap("Views/Keep this view as");
       p->Tap("Keyboard/Signs");
       p->Tap("Keyboard/More signs");
     }},
};

struct WindowCase {
  Vec2 size_px;
  double scale;
};
constexpr WindowCase kWindows[] = {
    {{1600, 1000}, 1}, {{3200, 2000}, 2}, {{800, 600}, 1}, {{1080, 1920}, 2}, {{2560, 1600}, 3}};

class PanelsIn : public ::testing::TestWithParam<StateCase> {
 protected:
  /// Calls check(output, used scale, size) in every window, theme and hand.
  template <typename Check>
  void Everywhere(const Check& check) {
    for (const WindowCase& window : kWindows) {
      for (const bool left : {false, true}) {
        PanelDriver panels;
        panels.view.files = {{"/srv/Old.parti"}, "/srv", {{"Studies", true}, {"A.parti", false}}};
        panels.view.size_px = window.size_px;
        panels.view.scale = window.scale;
        panels.view.settings.left_handed = left;
        panels.view.settings.theme = left ? Theme::kDark : Theme::kLight;
        GetParam().enter(&panels);
        SCOPED_TRACE(::testing::Message() << window.size_px.x << " x " << window.size_px.y
                                          << (left ? ", left-handed" : ""));
        const double used = panels::UsedScale(window.scale, window.size_px);
        check(panels.Frame(), std::floor(used * 8) / 8, window.size_px);
      }
    }
  }
};

void ExpectFingerSized(const PanelOutput& output, double scale) {
  const double least = panels::kMeasures.target * scale - 0.5;
  for (const PanelTarget& target : output.targets) {
    EXPECT_GE(target.high_px.x - target.low_px.x, least) << target.name;
    EXPECT_GE(target.high_px.y - target.low_px.y, least) << target.name;
  }
}

void ExpectWholeTexts(const PanelOutput& output) {
  const std::set<std::string> dots = {"Open…", "Save as…"};
  for (const PanelText& text : output.texts) {
    EXPECT_TRUE(!text.text.ends_with("…") || dots.contains(text.text)) << text.text;
    EXPECT_GE(text.low_px.x, text.room_low_px.x - 1) << text.text;
    EXPECT_LE(text.high_px.x, text.room_high_px.x + 1) << text.text;
    EXPECT_GE(text.low_px.y, text.room_low_px.y - 1) << text.text;
    EXPECT_LE(text.high_px.y, text.room_high_px.y + 1) << text.text;
    EXPECT_GE(panels::Contrast(text.color, text.ground), panels::kLeastContrast) << text.text;
  }
}

void ExpectSheetsWithin(const PanelOutput& output, const Vec2& size_px) {
  for (const PanelSheet& sheet : output.sheets) {
    EXPECT_TRUE(sheet.low_px.x >= 0 && sheet.low_px.y >= 0) << sheet.name;
    EXPECT_TRUE(sheet.high_px.x <= size_px.x && sheet.high_px.y <= size_px.y) << sheet.name;
    EXPECT_LT(sheet.low_px.x, sheet.high_px.x) << sheet.name;
    EXPECT_LT(sheet.low_px.y, sheet.high_px.y) << sheet.name;
  }
}

void ExpectApart(const PanelOutput& output) {
  const auto overlap = [](const PanelTarget& a, const PanelTarget& b) {
    return a.low_px.x < b.high_px.x - 1 && b.low_px.x < a.high_px.x - 1 &&
           a.low_px.y < b.high_px.y - 1 && b.low_px.y < a.high_px.y - 1;
  };
  const auto sheet_of = [](const PanelTarget& t) { return t.name.substr(0, t.name.find('/')); };
  for (const PanelTarget& a : output.targets) {
    for (const PanelTarget& b : output.targets) {
      if (&a == &b || sheet_of(a) != sheet_of(b)) continue;
      EXPECT_NE(a.name, b.name) << "two of one name";
      EXPECT_TRUE(!a.visible || !b.visible || !overlap(a, b)) << a.name << " and " << b.name;
    }
  }
}

TEST_P(PanelsIn, EveryWindowTargetsAreFingerSizedAndApartAndTextsReadableAndWhole) {
  Everywhere([](const PanelOutput& output, double scale, const Vec2& size_px) {
    ExpectFingerSized(output, scale);
    ExpectWholeTexts(output);
    ExpectSheetsWithin(output, size_px);
    ExpectApart(output);
  });
}

TEST_P(PanelsIn, TabReachesEverythingThatCanBeTapped) {
  PanelDriver panels;
  GetParam().enter(&panels);
  if (!panels.view.has_keys) return;  // there is no Tab
  std::set<std::string> wanted, reached;
  for (const PanelTarget& target : panels.Frame().targets) {
    if (target.enabled) wanted.insert(target.name);
  }
  for (size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_THAT(panels.Key(KEY_TAB), ::testing::IsEmpty());
    reached.insert(panels.last().focus);
  }
  EXPECT_EQ(reached, wanted);
}

TEST_P(PanelsIn, WithoutInputNothingIsAskedFor) {
  PanelDriver panels;
  GetParam().enter(&panels);
  for (int i = 0; i < 3; ++i) EXPECT_THAT(panels.Frame().commands, ::testing::IsEmpty());
  EXPECT_FALSE(panels.Frame().changed) << "and nothing is drawn again";
}

INSTANTIATE_TEST_SUITE_P(All, PanelsIn, ::testing::ValuesIn(kStates),
                         [](const auto& tested) { return std::string(tested.param.name); });

Vec2 AnyPlace() {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto one = rc::gen::weightedOneOf<double>(
      {{30, rc::gen::map(rc::gen::inRange(-50, 1700), [](int v) { return 1.0 * v; })},
       {1, rc::gen::element(nan, INFINITY, -INFINITY, 1e300, -1e300)}});
  const double x = *one;
  return {x, *one};
}

PanelEvent AnyEvent() {
  switch (*rc::gen::inRange(0, 10)) {
    case 0:
      return PanelPointerGone{};
    case 1:
      return PanelScroll{AnyPlace()};
    case 2:
    case 3:
      return KeyEvent{.code = *rc::gen::inRange<uint32_t>(0, 800),
                      .pressed = *rc::gen::arbitrary<bool>(),
                      .text = *rc::gen::string<std::string>(),
                      .repeat = *rc::gen::arbitrary<bool>()};
    case 4:
      return KeyEvent{.code = *rc::gen::element<uint32_t>(KEY_TAB, KEY_ENTER, KEY_ESC, KEY_DOWN,
                                                          KEY_LEFTCTRL, KEY_S, KEY_BACKSPACE),
                      .pressed = *rc::gen::arbitrary<bool>()};
    default:
      return PanelPointer{AnyPlace(), *rc::gen::arbitrary<bool>()};
  }
}

/// A view that may be anything: sizes and scales that can't be, sessions that come and go.
void AnyChange(PanelView* view) {
  static const std::vector<std::shared_ptr<const SessionSnapshot>> sessions = {
      nullptr,
      HouseBeforePick(3),
      WholeHouse(),
      Taken(WholeHouse(), {0, 0, 0, 0}),
      Taken(WholeHouse(), {7, -1, 3}),
      HouseWithTaps(2),
      InTrouble(WholeHouse())};
  view->session = *rc::gen::elementOf(sessions);
  view->size_px = *rc::gen::element(Vec2(1600, 1000), Vec2(800, 600), Vec2(1, 1), Vec2(0, -4),
                                    Vec2(std::numeric_limits<double>::quiet_NaN(), 1e9));
  view->has_keys = *rc::gen::arbitrary<bool>();
  if (*rc::gen::arbitrary<bool>()) HoldElement(view);
  view->pen.down = *rc::gen::arbitrary<bool>();
  view->settings.left_handed = *rc::gen::arbitrary<bool>();
}

bool ReadsBack(const PanelCommand& command) {
  const auto* c = std::get_if<Command>(&command);
  if (!c) return true;
  const auto read = ParseCommand(TextOf(*c));
  return read && *read == *c;
}

RC_GTEST_PROP(PanelsUnderAnyInput, NothingBreaksAndEveryCommandReadsBack, ()) {
  PanelDriver panels;
  panels.view.session = WholeHouse();
  if (*rc::gen::arbitrary<bool>()) panels.Tap("Menu/Rules");
  const int frames = *rc::gen::inRange(1, 30);
  for (int i = 0; i < frames; ++i) {
    if (*rc::gen::inRange(0, 8) == 0) AnyChange(&panels.view);
    std::vector<PanelEvent> events;
    for (int n = *rc::gen::inRange(0, 6); n > 0; --n) events.push_back(AnyEvent());
    // Taps on what is there reach further than places by chance.
    const auto& targets = panels.last_or_first().targets;
    if (!targets.empty() && *rc::gen::arbitrary<bool>()) {
      const Vec2 at = MiddleOf(*rc::gen::elementOf(targets));
      events.insert(events.end(), {PanelPointer{at, true}, PanelPointer{at, false}});
    }
    const PanelOutput& output = panels.Frame(events);
    for (const PanelCommand& command : output.commands) RC_ASSERT(ReadsBack(command));
    if (events.empty()) RC_ASSERT(output.commands.empty());
    for (const uint32_t index : output.mesh.indices) {
      RC_ASSERT(index < output.mesh.vertices.size());
    }
  }
}

TEST(PanelsTwice, TheSameCallsGiveTheSameTriangles) {
  PanelDriver one, other;
  for (PanelDriver* panels : {&one, &other}) {
    panels->view.session = Taken(WholeHouse(), {0, 0, 0});
    panels->Tap("Menu/Views");
    panels->Hover("Tools/Undo");
  }
  EXPECT_EQ(one.Frame().mesh, other.Frame().mesh);
}

}  // namespace
}  // namespace parti::app::tests
