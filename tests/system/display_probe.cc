// A display alone, without the application: shows where pens, fingers and mice touched, and writes
// down every event. For system_test.py, to tell a backend's faults from the application's.
//   parti_display_probe KIND DRAWING       KIND as in --display; ends with SIGTERM or SIGINT
// A pen's touch is a dark square, larger with its pressure; an eraser's is light, a finger's blue.
#include <fmt/format.h>
#include <poll.h>

#include <array>
#include <chrono>
#include <csignal>
#include <map>
#include <memory>

#include "app/display/open_display.h"
#include "app/tablet_mapping.h"
#include "input/drawing_recorder.h"

namespace parti::tests {
namespace {

using app::Display;
using Clock = std::chrono::steady_clock;

volatile std::sig_atomic_t stop_asked = 0;

struct Mark {
  glm::ivec2 place_px;
  int size_px = 0;
  Vec3 colour{0};
};

constexpr Vec3 kPaper(0.91, 0.85, 0.73), kPen(0.15), kEraser(1), kFinger(0.35, 0.49, 0.9);
constexpr int kFingerSize_px = 24;

/// What has been touched, and where.
class Probe {
 public:
  explicit Probe(Display* display) : display_(display) {}

  void Take(const InputEvent& event) {
    if (const auto* device = std::get_if<DeviceEvent>(&event)) {
      facts_[device->device] = device->facts;
    }
    if (const auto* pen = std::get_if<PenEvent>(&event)) Take(*pen);
    if (const auto* touch = std::get_if<TouchEvent>(&event)) {
      Add(touch->device, touch->position_mm, kFingerSize_px, kFinger);
    }
  }

  Result<void> Draw() {
    const auto start = Clock::now();
    const auto done = DrawFrame();
    slowest_ = std::max(slowest_, Clock::now() - start);
    ++frames_;
    return done;
  }

  /// "12 frames, the slowest in 34 ms".
  std::string Pace() const {
    using std::chrono::milliseconds;
    return fmt::format("{} frames, the slowest in {} ms", frames_,
                       std::chrono::duration_cast<milliseconds>(slowest_).count());
  }

 private:
  Result<void> DrawFrame() {
    const auto target = display_->BeginFrame();
    if (!target) return Fail(target);
    const render::Gl& gl = display_->gl();
    const glm::ivec2 size = display_->size_px();
    gl.BindFramebuffer(GL_FRAMEBUFFER, target->framebuffer);
    gl.Viewport(0, 0, size.x, size.y);
    gl.Disable(GL_SCISSOR_TEST);
    Clear(kPaper);
    gl.Enable(GL_SCISSOR_TEST);
    for (const Mark& mark : marks_) {
      const glm::ivec2 corner = mark.place_px - mark.size_px / 2;
      gl.Scissor(corner.x, size.y - corner.y - mark.size_px, mark.size_px, mark.size_px);
      Clear(mark.colour);
    }
    gl.Disable(GL_SCISSOR_TEST);
    const std::array<render::PixelRect, 1> all = {{{0, 0, size.x, size.y}}};
    return display_->Present(all);
  }

  void Take(const PenEvent& pen) {
    if (pen.kind == PenEvent::Kind::kDown) down_[pen.device] = true;
    if (pen.kind == PenEvent::Kind::kUp || pen.kind == PenEvent::Kind::kProximityOut) {
      down_[pen.device] = false;
    }
    if (!down_[pen.device]) return;
    constexpr double kLargest_px = 32;
    const int size_px = 2 + static_cast<int>(kLargest_px * pen.pressure.value_or(0.5));
    Add(pen.device, pen.position_mm, size_px, pen.tool == PenTool::kEraser ? kEraser : kPen);
  }

  void Add(int device, const Vec2& position_mm, int size_px, const Vec3& colour) {
    Camera camera;
    camera.width_px = display_->size_px().x;
    camera.height_px = display_->size_px().y;
    const DeviceFacts& facts = facts_[device];
    const Vec2 place_px = facts.view_px_per_mm
                              ? position_mm * *facts.view_px_per_mm
                              : app::TabletMapping(facts, camera).ToView_px(position_mm);
    marks_.push_back({glm::ivec2(place_px), size_px, colour});
  }

  void Clear(const Vec3& colour) const {
    const glm::vec3 c(colour);
    display_->gl().ClearColor(c.r, c.g, c.b, 1);
    display_->gl().Clear(GL_COLOR_BUFFER_BIT);
  }

  Display* display_;
  std::map<int, DeviceFacts> facts_;
  std::map<int, bool> down_;
  std::vector<Mark> marks_;
  Clock::duration slowest_{0};
  int frames_ = 0;
};

void Wait(const Display& display) {
  std::vector<pollfd> waiting;
  for (const int fd : display.fds()) waiting.push_back({fd, POLLIN, 0});
  constexpr int kLookUp_ms = 100;  // how long a signal may go unseen
  if (!display.HasNews()) ::poll(waiting.data(), waiting.size(), kLookUp_ms);
}

Result<void> Run(Display* display, input::DrawingRecorder* recorder) {
  Probe probe(display);
  bool changed = true;
  while (stop_asked == 0) {
    const auto news = display->Dispatch();
    if (!news) return Fail(news);
    for (const InputEvent& event : news->input) probe.Take(event);
    if (const auto fine = recorder->Add(news->input); !fine) return fine;
    if (news->close_asked) break;
    changed = changed || !news->input.empty() || news->exposed || news->shown || news->resized;
    if (changed && display->CanDraw()) {
      if (const auto drawn = probe.Draw(); !drawn) return drawn;
      changed = false;
    }
    Wait(*display);
  }
  fmt::print(stderr, "{}\n", probe.Pace());
  return recorder->Finish();
}

Result<void> Main(const std::string& kind, const std::string& drawing) {
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, [](int) { stop_asked = 1; });
  const auto which = app::DisplayKindOf(kind);
  if (!which) return Fail(which);
  auto display = app::OpenDisplay(*which);
  if (!display) return Fail(display);
  auto recorder = input::DrawingRecorder::Create(drawing);
  if (!recorder) return Fail(recorder);
  fmt::print(stderr, "{}\n", (*display)->Description());
  return Run(display->get(), &*recorder);
}

}  // namespace
}  // namespace parti::tests

int main(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(stderr, "usage: parti_display_probe KIND DRAWING\n");
    return 2;
  }
  const auto done = parti::tests::Main(argv[1], argv[2]);
  if (!done) fmt::print(stderr, "{}\n", parti::FormatError(done.error()));
  return done ? 0 : 1;
}
