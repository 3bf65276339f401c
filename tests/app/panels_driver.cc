#include "tests/app/panels_driver.h"

#include <gtest/gtest.h>
#include <linux/input-event-codes.h>

#include <algorithm>
#include <functional>
#include <map>

#include "app/picture.h"
#include "app/replay.h"
#include "app/session.h"
#include "base/text_file.h"
#include "input/drawing.h"
#include "tests/support/data.h"

namespace parti::app::tests {

PanelDriver::PanelDriver() {
  auto panels = Panels::Create();
  EXPECT_TRUE(panels) << FormatError(panels.error());
  panels_ = std::move(*panels);
}

const PanelOutput& PanelDriver::Frame(std::vector<PanelEvent> events) {
  now_s_ += 0.1;
  last_ = &panels_->Frame(view, {now_s_, std::move(events)});
  return *last_;
}

bool PanelDriver::Shows(const std::string& name) {
  const auto& targets = Frame().targets;
  return std::any_of(targets.begin(), targets.end(), [&](const PanelTarget& t) {
    return t.name.ends_with(name) || t.name.starts_with(name);
  });
}

PanelTarget PanelDriver::Find(const std::string& name) {
  std::string all;
  for (const PanelTarget& target : Frame().targets) {
    if (target.name.ends_with(name) || target.name.starts_with(name)) return target;
    all += target.name + ", ";
  }
  ADD_FAILURE() << "no " << name << " among " << all;
  return {};
}

Vec2 MiddleOf(const PanelTarget& target) { return (target.low_px + target.high_px) / 2.0; }

std::vector<PanelCommand> PanelDriver::Done() { return last_->commands; }

std::vector<PanelCommand> PanelDriver::Tap(const std::string& name) {
  const Vec2 at = MiddleOf(Find(name));
  Frame({PanelPointer{at, true}, PanelPointer{at, false}, PanelPointerGone{}});
  return Done();
}

const PanelOutput& PanelDriver::Hover(const std::string& name) {
  return Frame({PanelPointer{MiddleOf(Find(name)), false}});
}

std::vector<PanelCommand> PanelDriver::Drag(const std::string& name, const Vec2& way_px) {
  const Vec2 from = MiddleOf(Find(name));
  Frame({PanelPointer{from, true}});
  for (int i = 1; i <= 8; ++i) Frame({PanelPointer{from + way_px * (i / 8.0), true}});
  Frame({PanelPointer{from + way_px, false}});
  return Done();
}

std::vector<PanelCommand> PanelDriver::Key(uint32_t code, const std::string& text) {
  Frame({KeyEvent{.code = code, .pressed = true, .text = text},
         KeyEvent{.code = code, .pressed = false}});
  return Done();
}

std::vector<PanelCommand> PanelDriver::Type(const std::string& text) {
  std::vector<PanelEvent> events;
  for (const char c : text) {
    events.emplace_back(KeyEvent{.code = KEY_UNKNOWN, .pressed = true, .text = std::string(1, c)});
    events.emplace_back(KeyEvent{.code = KEY_UNKNOWN, .pressed = false});
  }
  Frame(std::move(events));
  return Done();
}

std::vector<PanelCommand> PanelDriver::TypeOver(const std::string& line, const std::string& text) {
  Tap(line);
  Type(text);
  return Key(KEY_ENTER);
}

bool PanelDriver::Says(const std::string& text) {
  const auto& texts = Frame().texts;
  return std::any_of(texts.begin(), texts.end(),
                     [&](const PanelText& t) { return t.text.find(text) != std::string::npos; });
}

std::vector<PanelCommand> PanelDriver::PressByKeys(const std::string& name) {
  const std::string full = Find(name).name;
  for (size_t i = 0; i < last_->targets.size() + 2; ++i) {
    Key(KEY_TAB);
    if (last_->focus == full) return Key(KEY_ENTER);
  }
  ADD_FAILURE() << "Tab does not reach " << name;
  return {};
}

namespace {

std::shared_ptr<const SessionSnapshot> SnapshotOf(const SessionState& state) {
  auto snapshot = std::make_shared<SessionSnapshot>();
  snapshot->state = std::make_shared<const SessionState>(state);
  snapshot->document = {.path = "House.parti", .named = true};
  snapshot->can_undo = true;
  return snapshot;
}

constexpr const char* kStop = "as far as asked for";

/// Plays the house until `stop` says so, before a command.
Session Played(const std::function<bool(const Command&)>& stop) {
  const auto text = ReadFile(parti::tests::SourceFile("assets/drawings/house.pen"));
  EXPECT_TRUE(text);
  Session session;
  ReplayReport report;
  report.before_command = [&](const Command& command) -> Result<void> {
    if (stop(command)) return Fail(ErrorCode::kNothingMade, kStop);
    return {};
  };
  const auto played = Replay(input::ReadDrawing(*text).drawing, &session, &report);
  EXPECT_TRUE(played || played.error().message.ends_with(kStop));
  return session;
}

/// Played once for all tests: it takes a moment.
const Session& House() {
  static const Session session = Played([](const Command&) { return false; });
  return session;
}

}  // namespace

std::shared_ptr<const SessionSnapshot> HouseBeforePick(int pick) {
  static std::map<int, std::shared_ptr<const SessionSnapshot>> played;
  auto& snapshot = played[pick];
  if (snapshot) return snapshot;
  int picks = 0;
  const Session session = Played([&picks, pick](const Command& command) {
    return std::holds_alternative<Pick>(command) && ++picks == pick;
  });
  return snapshot = SnapshotOf(session.state());
}

std::shared_ptr<const SessionSnapshot> WholeHouse() { return SnapshotOf(House().state()); }

std::shared_ptr<const SessionSnapshot> HouseWithTaps(int taps) {
  Session session = House();
  const Model& model = session.state().model;
  const auto glass = grammar::ProductOf(*grammar::ParseQuery(".Glass"), model.derived[0]->tree);
  EXPECT_TRUE(glass);
  for (size_t i = 0; i < static_cast<size_t>(taps); ++i) {
    EXPECT_TRUE(session.Execute(Select{{IdOf(model, {0, (*glass)[i]})}}));
  }
  return SnapshotOf(session.state());
}

namespace {

constexpr const char* kLayered = R"(// A house with a shop
import roof : "roof.cga"
attr height = 10

Lot --> extrude(height) Mass
Mass --> comp(f) { front: Facade | side: Wall | top: roof.Flat }

Facade --> layers("floors", "shop", "sign")
  { Floors | Shop | Sign }
Floors --> segment(y, 3.4, ~1) { NIL | Storeys }
Storeys --> segment(y) { ~3: Storey }*
Storey --> segment(x) { ~1: NIL | 1.2: Window | ~1: NIL }*
Window --> extrude(-0.2) Glass
Shop --> segment(y, 0.4, 2.6, ~1) { NIL | Panes | NIL }
Panes --> segment(x, ~1, 5, ~1) { NIL | Window | NIL }
Sign --> segment(y, 3.2, 0.6, ~1) { NIL | Board | NIL }
Board --> extrude(0.1) color("#7a3b2e")
Door --> segment(x, 1, 1.2, ~1) { NIL | Leaf | NIL }
Leaf --> extrude(0.1)
)";

Session Layered() {
  auto source = std::make_shared<RuleSource>();
  source->files = {{"house.cga", kLayered}, {"roof.cga", "Flat --> extrude(0.3) Slab\n"}};
  auto ground = GroundOf(*ParseLots("rect(12,8)"), source);
  EXPECT_TRUE(ground) << FormatError(ground.error());
  auto model = Derived(std::move(*ground), std::make_shared<const grammar::Trees>(), nullptr);
  EXPECT_TRUE(model);
  const Camera camera = AutoViewOf(*model, {1600, 1000});
  return Session(std::move(*model), camera);
}

}  // namespace

std::shared_ptr<const SessionSnapshot> LayeredHouse(const std::string& tapped) {
  Session session = Layered();
  const Model& model = session.state().model;
  if (tapped.empty()) return SnapshotOf(session.state());
  const auto found = grammar::ProductOf(*grammar::ParseQuery(tapped), model.derived[0]->tree);
  EXPECT_TRUE(found && !found->empty()) << tapped;
  EXPECT_TRUE(session.Execute(Select{{IdOf(model, {0, found->front()})}}));
  return SnapshotOf(session.state());
}

std::shared_ptr<const SessionSnapshot> Taken(const std::shared_ptr<const SessionSnapshot>& session,
                                             const NodePath& path) {
  SessionState state = *session->state;
  state.in_hand = path;
  auto taken = std::make_shared<SessionSnapshot>(*session);
  taken->state = std::make_shared<const SessionState>(std::move(state));
  return taken;
}

std::shared_ptr<const SessionSnapshot> Chosen(const std::shared_ptr<const SessionSnapshot>& session,
                                              const std::string& query) {
  SessionState state = *session->state;
  state.sketch.query = *grammar::ParseQuery(query);
  auto chosen = std::make_shared<SessionSnapshot>(*session);
  chosen->state = std::make_shared<const SessionState>(std::move(state));
  return chosen;
}

std::shared_ptr<const SessionSnapshot> InTrouble(
    const std::shared_ptr<const SessionSnapshot>& session) {
  auto troubled = std::make_shared<SessionSnapshot>(*session);
  troubled->document.trouble =
      Error{ErrorCode::kFile, "can't write House.parti: the disk is full",
            "free some space, or save elsewhere; nothing is lost while the program runs"};
  troubled->last_error = FailedRequest{
      3, {ErrorCode::kBadNumber, "distance 20000 is outside its range", "from -10000 to 10000"}};
  return troubled;
}

namespace {

SeenElement SeenFrom(const Vec2& low, const Vec2& high) {
  const Vec2 middle = (low + high) / 2.0;
  SeenElement seen{low, high, {}};
  for (const double x : {low.x, middle.x, high.x}) {
    for (const double y : {low.y, middle.y, high.y}) {
      if (Vec2(x, y) != middle) seen.handles_px.emplace_back(x, y);
    }
  }
  return seen;
}

}  // namespace

void HoldElement(PanelView* view) {
  view->session = LayeredHouse(".Board");
  view->mode = PointerMode::kSelect;
  const Vec2 middle = view->size_px / 2.0;
  const auto seen = [&](const Vec2& low, const Vec2& high) {
    return SeenFrom(middle + low * view->scale, middle + high * view->scale);
  };
  view->elements = {seen({-60, 20}, {0, 120}), seen({-90, -120}, {160, -10})};
  view->tapped_px = middle + Vec2(120, 40) * view->scale;
  ElementInHand door;
  door.layer = {"Door", "DoorElement", 0, 4, 1.5, 2.5};
  door.by = "Windows";
  door.by_others = true;
  door.changes = {true, true, true, true, true, true, false};
  door.low_px = view->elements[0].low_px;
  door.high_px = view->elements[0].high_px;
  view->element = door;
}

}  // namespace parti::app::tests
