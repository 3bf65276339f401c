#include "tests/app/soak/soak_mix.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "app/tablet_mapping.h"
#include "base/camera.h"

namespace parti::tests {
namespace {

using app::DocumentRequest;

constexpr Vec2 kTablet_mm{280, 175};
constexpr double kSampleRate = 50;  // Hz: a quarter of a real pen: the session's work is per stroke
constexpr int kTakesPen = 20;       // moments
constexpr size_t kMostNodes = 14;   // a building is given up when it has more

DeviceFacts SoakTablet() {
  DeviceFacts facts;
  facts.name = "soak";
  facts.size_mm = kTablet_mm;
  facts.has_pen = facts.has_pressure = facts.has_touch = facts.has_eraser = true;
  return facts;
}

size_t CountNodes(const std::vector<grammar::SelectionActionNode>& nodes) {
  size_t count = nodes.size();
  for (const auto& node : nodes) count += CountNodes(node.children);
  return count;
}

}  // namespace

/// What is done; the share of each in a hundred.
struct SoakMix::Share {
  int percent;
  void (SoakMix::*deed)(SoakTarget*);
};

const std::array<SoakMix::Share, 10> SoakMix::kShares = {{
    {38, &SoakMix::DrawOnBuilding},
    {6, &SoakMix::Scribble},
    {33, &SoakMix::SoundCommand},
    {6, &SoakMix::WrongCommand},
    {5, &SoakMix::BrokenEvent},
    {3, &SoakMix::Touch},
    {5, &SoakMix::Look},
    {1, &SoakMix::Resize},
    {1, &SoakMix::Document},
    {2, &SoakMix::Plug},
}};

void SoakMix::WarmUp(SoakTarget* target) {
  constexpr int kTimes = 10;
  for (int i = 0; i < kTimes; ++i) {
    for (const Share& share : kShares) Do(share, target);
  }
}

void SoakMix::Moment(SoakTarget* target) {
  int at = Below(100);
  for (const Share& share : kShares) {
    at -= share.percent;
    if (at < 0) return Do(share, target);
  }
}

void SoakMix::Do(const Share& share, SoakTarget* target) {
  ++moments_;
  clock_s_ += random_.Uniform(1, 4);
  Tidy(target);
  if (device_ < 0) Plug(target);
  (this->*share.deed)(target);
}

/// Keeps the building of a size that a person would work on, and takes the pen again when scribbles
/// have tapped another tool.
void SoakMix::Tidy(SoakTarget* target) const {
  if (moments_ % kTakesPen == 0) target->TakePen();
  const auto now = target->Newest();
  const auto& trees = now->state->model.trees();
  size_t nodes = 0;
  for (const auto& tree : trees) nodes += CountNodes(tree.nodes);
  if (now->state->model.lots().empty()) {
    target->Send(*app::ParseCommand("view eye 42 17 47 target 10 8.5 7 fov 36 size 1600 1000"));
    target->Send(*app::ParseCommand("lot rect(20,14)"));
  }
  if (nodes > kMostNodes || trees.size() > 4) target->Send(*app::ParseCommand("delete 0"));
  if (now->state->sketch.strokes.size() > 6) target->Send(*app::ParseCommand("clear"));
}

/// Unplugs the tablet, also in mid-stroke, and plugs another in.
void SoakMix::Plug(SoakTarget* target) {
  if (device_ >= 0) {
    if (Below(2) == 0) target->Feed(Pen(PenEvent::Kind::kDown, {10, 10}));
    target->Feed(DeviceEvent{DeviceEvent::Kind::kRemoved, clock_s_, device_, SoakTablet()});
  }
  device_ = devices_++;
  target->Feed(DeviceEvent{DeviceEvent::Kind::kAdded, clock_s_, device_, SoakTablet()});
}

PenEvent SoakMix::Pen(PenEvent::Kind kind, const Vec2& at_mm) {
  PenEvent event;
  event.kind = kind;
  event.device = device_;
  event.t_s = clock_s_;
  event.position_mm = at_mm;
  event.pressure = random_.Uniform();
  return event;
}

void SoakMix::DrawLine(SoakTarget* target, const Vec2& from_mm, const Vec2& to_mm) {
  target->Feed(Pen(PenEvent::Kind::kProximityIn, from_mm));
  target->Feed(Pen(PenEvent::Kind::kDown, from_mm));
  const int samples = 8 + Below(20);
  for (int i = 1; i <= samples; ++i) {
    clock_s_ += 1 / kSampleRate;
    const double s = 0.5 - 0.5 * std::cos(kPi * i / samples);  // slow, fast, slow
    const Vec2 scatter(random_.Normal() * 0.05, random_.Normal() * 0.05);
    target->Feed(Pen(PenEvent::Kind::kMotion, from_mm + (to_mm - from_mm) * s + scatter));
  }
  target->Feed(Pen(PenEvent::Kind::kUp, to_mm));
  target->Feed(Pen(PenEvent::Kind::kProximityOut, to_mm));
}

/// A line along an edge of a visible shape's box, or across it.
void SoakMix::DrawOnBuilding(SoakTarget* target) {
  const auto now = target->Newest();
  const auto shapes = app::VisibleShapes(now->state->model);
  if (shapes.empty()) return;
  const auto& ref = shapes[random_.Next() % shapes.size()];
  const auto& scope = app::ShapeAt(now->state->model, ref).item.scope;
  const auto corner = [&] {
    const double whole[] = {0, 0.3, 0.5, 1, 1.2};
    const double x = whole[Below(5)], y = whole[Below(5)], z = whole[Below(5)];
    return scope.origin + scope.x * (x * scope.size.x) + scope.y * (y * scope.size.y) +
           scope.z * (z * (scope.size.z > 0 ? scope.size.z : 8));
  };
  const View view(now->state->camera);
  const auto from = view.Project(corner()), to = view.Project(corner());
  if (!from || !to) return;
  const app::TabletMapping mapping(SoakTablet(), now->state->camera);
  DrawLine(target, mapping.ToTablet_mm(*from), mapping.ToTablet_mm(*to));
}

void SoakMix::Scribble(SoakTarget* target) {
  target->Feed(Pen(PenEvent::Kind::kDown, {140, 90}));
  for (int i = Below(40); i > 0; --i) {
    clock_s_ += 1 / kSampleRate;
    target->Feed(
        Pen(PenEvent::Kind::kMotion, {random_.Uniform(-10, 300), random_.Uniform(0, 175)}));
  }
  target->Feed(Pen(PenEvent::Kind::kUp, {140, 90}));
}

void SoakMix::BrokenEvent(SoakTarget* target) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  PenEvent event = Pen(static_cast<PenEvent::Kind>(Below(6)), {140, 90});
  switch (Below(8)) {
    case 0:
      event.position_mm.x = nan;
      break;
    case 1:
      event.position_mm = Vec2(infinite, -1e300);
      break;
    case 2:
      event.t_s = Below(2) == 0 ? nan : -5;
      break;
    case 3:
      event.pressure = Below(2) == 0 ? nan : -7;
      break;
    case 4:
      event.device = Below(2) == 0 ? 12345 : -3;
      break;
    case 5:
      event.tool = PenTool::kEraser;
      break;
    case 6:
      event.tilt_deg = Vec2(nan, 400);
      break;
    default:  // out of turn
      break;
  }
  for (int i = 1 + Below(3); i > 0; --i) target->Feed(event);
}

void SoakMix::Touch(SoakTarget* target) {
  for (int i = 1 + Below(6); i > 0; --i) {
    TouchEvent touch;
    touch.kind = static_cast<TouchEvent::Kind>(Below(4));
    touch.device = Below(8) == 0 ? 99 : device_;
    touch.finger = Below(4);
    touch.t_s = clock_s_;
    touch.position_mm = Vec2(random_.Uniform(0, 280), random_.Uniform(0, 175));
    target->Feed(touch);
  }
}

void SoakMix::SoundCommand(SoakTarget* target) {
  const auto now = target->Newest();
  const std::array lines = {
      std::string("pick 1"),
      std::string("pick 1"),
      std::string("pick 2"),
      std::string("pick 3"),
      std::string("undo"),
      std::string("undo"),
      std::string("redo"),
      std::string("clear"),
      fmt::format("set distance {}", random_.Uniform(0.5, 9)),
      std::string("query .Mass"),
      fmt::format("take 0/{}", Below(4)),
      std::string("take none"),
      fmt::format("switch 0/{} {}", Below(4), Below(2) == 0 ? "on" : "off"),
      fmt::format("delete 0/{}", Below(4)),
      fmt::format("move 0/{} to 0/{}", Below(4), Below(4)),
      fmt::format("select 0/{}", Below(6)),
      std::string("select none"),
      std::string("node .Lot --> extrude(9) Mass"),
      std::string("node .Mass --> comp(f) { all: Face }"),
      std::string("node .Face --> split(x) { ~3: Bay }*"),
      std::string("tree more"),
      fmt::format("name Mass Body{}", Below(3)),
      fmt::format("erase {}", moments_ - Below(10)),
  };
  if (const auto command = app::ParseCommand(lines[random_.Next() % lines.size()])) {
    target->Send(*command);
  }
  if (!now->state->sketch.suggestions.empty() && Below(2) == 0) {
    target->Send(*app::ParseCommand("pick 1"));
  }
}

void SoakMix::WrongCommand(SoakTarget* target) {
  std::string line = "node .Lot --> split(x) { 3: A | ~1: B }";
  for (int i = 1 + Below(4); i > 0; --i)
    line[random_.Next() % line.size()] = static_cast<char>(Below(256));
  if (const auto command = app::ParseCommand(line)) target->Send(*command);
  target->Send(app::Command(app::Pick{Below(2000) - 1000, "nothing"}));
  target->Send(app::Command(app::SetNumber{"distance", random_.Normal() * 1e300 * 1e10}));
  target->Send(app::Command(app::Delete{{Below(9) - 4, Below(9) - 4}}));
  target->Send(app::Command(app::Select{{"9/9/9", "lot-7:0", "\xff"}}));
  target->Send(app::Command(app::SetLot{Below(9) == 0 ? "rect(1e-9,0)" : "poly(0,0"}));
}

void SoakMix::Look(SoakTarget* target) {
  for (int i = 1 + Below(30); i > 0; --i) {
    app::SetView view{target->Newest()->state->camera};
    const double angle = random_.Uniform(0, 2 * kPi);
    view.camera.eye =
        Vec3(10 + 50 * std::cos(angle), random_.Uniform(2, 40), 7 + 50 * std::sin(angle));
    view.camera.target = Vec3(10, 8, 7);
    if (Below(50) == 0) view.camera.eye = view.camera.target;
    target->Send(app::Command(view));
  }
  const char* lines[] = {"keep-view one", "keep-view two", "go-view one", "drop-view two"};
  target->Send(*app::ParseCommand(lines[Below(4)]));
}

void SoakMix::Resize(SoakTarget* target) {
  target->Resize({1 + Below(4000), 1 + Below(3000)});
  target->Resize({1600, 1000});
}

void SoakMix::Document(SoakTarget* target) {
  using Kind = DocumentRequest::Kind;
  const std::string path = fmt::format("{}/{}", folder_, Below(3));
  switch (Below(7)) {
    case 0:
      return target->Send(DocumentRequest{Kind::kNew});
    case 1:
      return target->Send(DocumentRequest{Kind::kOpen, path + ".parti"});
    case 2:
    case 3:
      return target->Send(
          DocumentRequest{.kind = Kind::kSaveAs, .path = path + ".parti", .replace = true});
    case 4:
      return target->Send(DocumentRequest{.kind = Kind::kExport,
                                          .path = path + (Below(2) == 0 ? ".obj" : ".what"),
                                          .replace = true});
    case 5:
      return target->Send(
          DocumentRequest{.kind = Kind::kRecordForReport, .path = path + ".pen", .replace = true});
    default:
      return target->Send(DocumentRequest{Kind::kSaveAs, folder_ + "/no/such/folder.parti"});
  }
}

}  // namespace parti::tests
