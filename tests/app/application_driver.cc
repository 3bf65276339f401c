#include "tests/app/application_driver.h"

#include <algorithm>

#include "app/play.h"
#include "tests/support/program.h"

namespace parti::app::tests {
namespace {

constexpr double kPxPerMm = 10;

}  // namespace

void ApplicationDriver::SetUp() {
  auto display = OffscreenDisplay::Create();
  ASSERT_TRUE(display) << FormatError(display.error());
  display_ = std::move(*display);
  folder_ = parti::tests::TestFolder();
  SessionThreadOptions options;
  options.folders = {folder_ + "/data", folder_ + "/state"};
  session_ = std::make_unique<SessionThread>(options);
  auto application = Application::Create(display_.get(), session_.get(), {});
  ASSERT_TRUE(application) << FormatError(application.error());
  application_ = std::move(*application);
}

void ApplicationDriver::PlugIn() {
  DeviceFacts pen, touch, mouse, keys;
  pen.has_pen = touch.has_touch = mouse.has_pointer = keys.has_keys = true;
  pen.size_mm = touch.size_mm = Vec2(160, 100);
  mouse.view_px_per_mm = kPxPerMm;
  display_->Inject(DeviceEvent{DeviceEvent::Kind::kAdded, 0, kPen, pen});
  display_->Inject(DeviceEvent{DeviceEvent::Kind::kAdded, 0, kTouch, touch});
  display_->Inject(DeviceEvent{DeviceEvent::Kind::kAdded, 0, kMouse, mouse});
  display_->Inject(DeviceEvent{DeviceEvent::Kind::kAdded, 0, kKeys, keys});
}

void ApplicationDriver::Settle() {
  const auto settled = app::Settle(application_.get());
  ASSERT_TRUE(settled) << FormatError(settled.error());
}

void ApplicationDriver::Do(const std::string& line) {
  application_->Do(PanelCommand(*ParseCommand(line)));
  Settle();
}

void ApplicationDriver::Pen(PenEvent::Kind kind, const Vec2& px) {
  PenEvent event;
  event.kind = kind;
  event.device = device_;
  event.tool = device_ == kMouse ? PenTool::kMouse : PenTool::kPen;
  event.t_s = t_s_ += 0.005;
  event.position_mm = px / kPxPerMm;
  if (device_ == kPen) event.pressure = 0.5;
  display_->Inject(event);
}

void ApplicationDriver::PressButton(uint32_t button, bool pressed, const Vec2& px) {
  PenEvent event;
  event.kind = PenEvent::Kind::kButton;
  event.device = device_;
  event.t_s = t_s_ += 0.005;
  event.position_mm = px / kPxPerMm;
  event.button = button;
  event.pressed = pressed;
  display_->Inject(event);
}

void ApplicationDriver::Key(uint32_t code) {
  display_->Inject(KeyEvent{kKeys, t_s_ += 0.01, code, true});
  display_->Inject(KeyEvent{kKeys, t_s_ += 0.01, code, false});
  Settle();
}

void ApplicationDriver::Finger(TouchEvent::Kind kind, int finger, const Vec2& px) {
  display_->Inject(TouchEvent{kind, kTouch, finger, t_s_ += 0.01, px / kPxPerMm});
}

void ApplicationDriver::Draw(const Vec2& from, const Vec2& to) {
  Pen(PenEvent::Kind::kProximityIn, from);
  DrawOn(from, to);
}

void ApplicationDriver::DrawOn(const Vec2& from, const Vec2& to) {
  Pen(PenEvent::Kind::kDown, from);
  for (int i = 1; i <= 40; ++i) Pen(PenEvent::Kind::kMotion, from + (to - from) * (i / 40.0));
}

void ApplicationDriver::Lift(const Vec2& at) {
  Pen(PenEvent::Kind::kUp, at);
  Pen(PenEvent::Kind::kProximityOut, at);
}

void ApplicationDriver::Line(const Vec2& from, const Vec2& to) {
  Draw(from, to);
  Lift(to);
  Settle();
}

void ApplicationDriver::TapAt(const Vec2& px) {
  Pen(PenEvent::Kind::kProximityIn, px);
  Pen(PenEvent::Kind::kDown, px);
  Lift(px);
  Settle();
}

void ApplicationDriver::TapOn(const std::string& target) {
  const auto& all = application_->panels().targets;
  const auto found = std::find_if(all.begin(), all.end(), [&](const PanelTarget& one) {
    return one.name.starts_with(target) && one.visible;
  });
  ASSERT_NE(found, all.end()) << "no " << target << " to tap";
  TapAt((found->low_px + found->high_px) * 0.5);
}

std::vector<std::string> ApplicationDriver::Words() const {
  std::vector<std::string> words;
  for (const PanelText& text : application_->panels().texts) words.emplace_back(text.text);
  return words;
}

render::Image ApplicationDriver::Seen() {
  auto image = application_->Screenshot();
  EXPECT_TRUE(image) << (image ? "" : FormatError(image.error()));
  return image ? std::move(*image) : render::Image{};
}

}  // namespace parti::app::tests
