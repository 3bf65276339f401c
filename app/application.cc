#include "app/application.h"

#include <linux/input-event-codes.h>
#include <poll.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "app/picking.h"
#include "app/view_request.h"
#include "render/gl_framebuffer.h"
#include "render/read_image.h"

namespace parti::app {
namespace {

using input::DragPhase;
using input::PenAct;

constexpr double kRest_s = 0.3;  ///< after which a wheel is taken to have stopped

double Now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// What a new user looks at: a plot of 30 m.
render::Bounds FirstGround() {
  render::Bounds bounds;
  bounds.Add({-15, 0, -15});
  bounds.Add({15, 4, 15});
  return bounds;
}

PenAct ActOf(PointerMode mode) {
  switch (mode) {
    case PointerMode::kDraw:
      return PenAct::kDraw;
    case PointerMode::kErase:
      return PenAct::kErase;
    case PointerMode::kSelect:
      return PenAct::kSelect;
    case PointerMode::kOrbit:
      return PenAct::kOrbit;
    case PointerMode::kPan:
      return PenAct::kPan;
    case PointerMode::kZoom:
      return PenAct::kZoom;
  }
  return PenAct::kDraw;
}

/// Whether it moves the camera.
bool Moves(PenAct act) {
  return act == PenAct::kOrbit || act == PenAct::kPan || act == PenAct::kZoom;
}

}  // namespace

Application::Application(Display* display, SessionThread* session, ApplicationOptions options)
    : display_(display),
      session_(session),
      options_(std::move(options)),
      settings_(options_.settings),
      folders_([folders = options_.folders](const FolderRequest& request) {
        return ListOf(request, folders);
      }),
      keeper_([path = options_.settings_path](const Settings& settings) -> Result<void> {
        if (path.empty()) return {};
        return WriteSettings(settings, path);
      }),
      snapshot_(session->Newest()),
      aside_(options_.stepping_aside) {}

Application::~Application() {
  // What is drawn with a context goes while it is current.
  static_cast<void>(display_->context().MakeCurrent());
  ink_.reset();
  picture_.reset();
  canvas_.reset();
}

Result<std::unique_ptr<Application>> Application::Create(Display* display, SessionThread* session,
                                                         ApplicationOptions options) {
  auto application =
      std::unique_ptr<Application>(new Application(display, session, std::move(options)));
  if (auto started = application->Start(); !started) return Fail(started);
  return application;
}

Result<void> Application::Start() {
  auto shared = display_->CreateSharedContext();
  if (!shared) return Fail(shared);
  if (auto current = display_->context().MakeCurrent(); !current) return current;
  auto canvas = render::Canvas::Create(display_->gl(), display_->size_px());
  if (!canvas) return Fail(canvas);
  canvas_ = std::move(*canvas);
  auto picture = ModelPicture::Create(std::move(*shared));
  if (!picture) return Fail(picture);
  picture_ = std::move(*picture);
  auto panels = Panels::Create();
  if (!panels) return Fail(panels);
  panels_ = std::move(*panels);
  ink_ = std::make_unique<InkDesk>(canvas_.get(),
                                   [this](SessionRequest r) { return Post(std::move(r)); });
  folders_.Ask(listed_);
  SettingsChanged();
  placing_.SetState(snapshot_->state, snapshot_->executed);
  picture_->SetState(snapshot_->state);  // without a lot, too: what is drawn first needs its ground
  told_ = snapshot_->state->camera;
  looking_.Set(told_);
  if (told_ == Camera{}) looking_.Set(ViewFor(ViewRequest::kFit, told_, FirstGround()));
  Resized();
  RunPanels({});
  return {};
}

Result<void> Application::Turn(double wait_s, std::span<const int> also) {
  Wait(wait_s, also);
  auto news = display_->Dispatch();
  if (!news) return Fail(news);
  if (auto current = display_->context().MakeCurrent(); !current) return current;
  news->input.insert(news->input.end(), fed_.begin(), fed_.end());
  fed_.clear();
  Take(*news);
  TakeEnd();
  TakeSnapshot();
  if (folders_.ready().Clear()) panels_stale_ = true;
  if (queries_.ready().Clear()) marks_stale_ = true;
  if (placing_.Update()) marks_stale_ = panels_stale_ = true;
  if (auto tried = trials_.TakeNewest()) picture_->SetState(std::move(tried));
  picture_->Update(canvas_.get());
  if (sync_at_s_ && Now_s() >= *sync_at_s_) SyncView();
  // While a line is being drawn, panels wait.
  const bool stale = panels_stale_ || word_stale_;
  if (!panel_events_.empty() || (stale && !ink_->drawing())) RunPanels({});
  if (aside_.Step(Now_s())) canvas_->SetPanelOpacities(aside_.opacities());
  if (auto drawn = DrawFrame(); !drawn) return drawn;
  // What its beginning changes, a word that goes or a sheet that closes, comes after its first ink.
  if (drag_begun_) RunPanels({});
  return {};
}

bool Application::Settled() const {
  const DocumentStatus& document = snapshot_->document;
  const bool saving =
      !document.read_only && !document.trouble && snapshot_->acknowledged < snapshot_->executed;
  return snapshot_->executed >= posted_ && !snapshot_->busy && snapshot_->doing.empty() &&
         !saving && !picture_->busy() && !canvas_->NeedsDraw() && !sync_at_s_ &&
         !((panels_stale_ || word_stale_) && !ink_->drawing()) && !drag_begun_ &&
         !aside_.next_s() && !display_->HasNews() && fed_.empty() && !folders_.busy() &&
         !trials_.busy() && !queries_.busy() && !placing_.busy();
}

void Application::Wait(double wait_s, std::span<const int> also) const {
  if (display_->HasNews() || !fed_.empty() || (canvas_->NeedsDraw() && display_->CanDraw()))
    wait_s = 0;
  for (const auto& due_s : {sync_at_s_, aside_.next_s()}) {
    if (due_s) wait_s = std::min(wait_s, std::max(0.0, *due_s - Now_s()));
  }
  std::vector<pollfd> fds;
  for (const int fd : display_->fds()) fds.push_back({fd, POLLIN, 0});
  for (const int fd : picture_->fds()) fds.push_back({fd, POLLIN, 0});
  fds.push_back({session_->ready().fd(), POLLIN, 0});
  fds.push_back({folders_.ready().fd(), POLLIN, 0});
  fds.push_back({trials_.ready().fd(), POLLIN, 0});
  fds.push_back({queries_.ready().fd(), POLLIN, 0});
  fds.push_back({placing_.ready().fd(), POLLIN, 0});
  if (options_.end_fd >= 0) fds.push_back({options_.end_fd, POLLIN, 0});
  for (const int fd : also) fds.push_back({fd, POLLIN, 0});
  poll(fds.data(), fds.size(), static_cast<int>(std::ceil(wait_s * 1000)));
}

void Application::Take(const DisplayNews& news) {
  close_asked_ |= news.close_asked;
  if (news.resized) Resized();
  if (news.exposed || news.shown) canvas_->DamageAll();
  for (const InputEvent& event : news.input) {
    const auto* touch = std::get_if<TouchEvent>(&event);
    const bool lands = touch && touch->kind == TouchEvent::Kind::kDown;
    marks_stale_ |= lands && placing_.CancelOf(touch->device);
    TakeAll(hands_.Feed(event, [this](const Vec2& px) { return OverPanel(px); }));
    if (std::holds_alternative<DeviceEvent>(event)) panels_stale_ = true;
  }
  if (news.hidden || news.close_asked) PutDown();
}

void Application::TakeEnd() {
  if (close_asked_ || !options_.end_asked || !options_.end_asked()) return;
  close_asked_ = true;
  PutDown();
}

void Application::PutDown() { TakeAll(hands_.LiftAll()); }

void Application::TakeAll(const std::vector<Act>& acts) {
  for (const Act& act : acts) {
    std::visit([this](const auto& a) { Take(a); }, act);
  }
}

void Application::TakeSnapshot() {
  session_->ready().Clear();
  auto newest = session_->Newest();
  if (newest == snapshot_) return;
  if (newest->document.path != snapshot_->document.path) folders_.Ask(listed_);
  snapshot_ = std::move(newest);
  // Not only since the last snapshot: that one may have been busy with what came after the view.
  const bool other_view = !(snapshot_->state->camera == told_);
  if (options_.on_snapshot) options_.on_snapshot(*snapshot_);
  // A bookmark, an opened document: the session looks from elsewhere, and nobody has moved since.
  if (other_view && snapshot_->executed >= posted_ && !looking_.moving()) {
    told_ = snapshot_->state->camera;
    if (!looking_.held()) LookFrom(told_);
  }
  if (!trials_.going_on()) picture_->SetState(snapshot_->state);
  placing_.SetState(snapshot_->state, snapshot_->executed);
  ink_->Show(*snapshot_, looking_.camera());
  overlay_stale_ = panels_stale_ = true;
}

void Application::Resized() {
  const glm::ivec2 size = display_->size_px();
  // A size that the device can't draw is reported by the next frame.
  static_cast<void>(canvas_->Resize(size));
  LookFrom(looking_.camera());
  panels_stale_ = true;
}

void Application::LookFrom(const Camera& camera) {
  Camera seen = camera;
  seen.width_px = display_->size_px().x;
  seen.height_px = display_->size_px().y;
  looking_.Set(seen);
  hands_.SetView(seen, {settings_.left_handed, display_->outputs()});
  Looked(true);
}

void Application::SettingsChanged() {
  hands_.SetFingerDraws(settings_.finger_draws);
  hands_.SetView(looking_.camera(), {settings_.left_handed, display_->outputs()});
  display_->SetLeftHanded(settings_.left_handed);
  const auto table = settings_.bindings.empty()
                         ? Result<input::BindingTable>(input::DefaultBindings())
                         : input::ReadBindings(settings_.bindings);
  hands_.SetBindings(table ? *table : input::DefaultBindings());
  panels_stale_ = true;
}

uint64_t Application::Post(SessionRequest request) {
  if (!std::holds_alternative<Command>(request) ||
      !std::holds_alternative<SetView>(std::get<Command>(request))) {
    SyncView();
  }
  return posted_ = session_->Post(std::move(request));
}

void Application::SyncView() {
  sync_at_s_.reset();
  if (looking_.camera() == told_) return;
  told_ = looking_.camera();
  Post(Command(SetView{told_}));
}

void Application::Looked(bool changed) {
  picture_->Look(looking_.camera(), looking_.moving());
  if (!changed) return;
  ink_->Show(*snapshot_, looking_.camera());
  marks_stale_ = true;
  hovering_.End();
  placing_.HoverEnd();
  SetPenWord("");
  // Looking around in an empty document is no reason to begin one on the disk.
  if (posted_ > 0 || !snapshot_->state->model.lots().empty()) sync_at_s_ = Now_s() + kRest_s;
}

Vec3 Application::PointTouched(const Camera& camera, const Vec2& px) const {
  const auto ref = picture_->ShapeUnder(px);
  if (!ref) return PointUnder(camera, px);
  return PointUnder(camera, px, PlaneAt(picture_->shown_state()->model, *ref, camera, px));
}

void Application::Take(const input::OrbitGesture& gesture) {
  Looked(
      looking_.Take(gesture, [this](const auto& c, const auto& p) { return PointTouched(c, p); }));
}

void Application::Take(const input::PanZoomGesture& gesture) {
  Looked(
      looking_.Take(gesture, [this](const auto& c, const auto& p) { return PointTouched(c, p); }));
}

void Application::Take(const WheelAct& act) {
  Looked(looking_.Take(act, [this](const auto& c, const auto& p) { return PointTouched(c, p); }));
}

void Application::Take(const input::TapGesture& tap) {
  if (tap.fingers == 1) SelectUnder(tap.position_px);
  if (tap.fingers == 2) Post(Command(Undo{}));
  if (tap.fingers == 3) Post(Command(Redo{}));
}

void Application::Take(const HoverAct& act) {
  pen_.position_px = act.px;
  // What would be placed goes before what would be selected.
  const View view(looking_.camera());
  marks_stale_ |= act.would == PenAct::kSelect ? placing_.HoverAt(act.px, view, display_->scale())
                                               : placing_.HoverEnd();
  const std::string placed = placing_.word();
  marks_stale_ |= placed.empty()
                      ? hovering_.At(act.px, *picture_, looking_.camera(), display_->scale())
                      : hovering_.End();
  SetPenWord(placed.empty() ? hovering_.word() : placed);
}

void Application::Take(const HoverEndAct&) {
  pen_.position_px.reset();
  marks_stale_ |= hovering_.End();
  marks_stale_ |= placing_.HoverEnd();
  SetPenWord("");
}

/// The word follows the pen; without one panels need not be made anew as it moves.
void Application::SetPenWord(std::string word) {
  word_stale_ |= !word.empty() || !pen_.word.empty();
  pen_.word = std::move(word);
}

void Application::Take(const PanelAct& act) {
  const auto* key = std::get_if<KeyEvent>(&act.event);
  if (!key) {
    if (auto event = ForPanels(act.event)) panel_events_.push_back(std::move(*event));
    return;
  }
  if (key->pressed && key->code == KEY_ESC && placing_.Cancel()) {
    marks_stale_ = true;
    return;
  }
  RunPanels({act.event});  // only they know whether it was theirs: a field, the focus, a sheet
  if (!panel_output_->takes_keys) static_cast<void>(TakeShortcut(*key));
}

void Application::HoldStill(const DragAct& drag) {
  if (Moves(drag.act)) return;
  const bool held = drag.phase == DragPhase::kBegin || drag.phase == DragPhase::kMove;
  if (held == looking_.held()) return;
  looking_.Hold(held);
  Looked(false);  // what a gesture has left coarse
}

void Application::Take(const DragAct& act) {
  pen_.position_px = act.px;
  pen_.down = act.phase == DragPhase::kBegin || act.phase == DragPhase::kMove;
  if (act.phase != DragPhase::kMove) panels_stale_ = true;
  if (act.phase == DragPhase::kBegin) {
    SetPenWord("");
    drag_begun_ = true;
  }
  if (pen_.down) {
    aside_.PenAt(act.px, panel_output_->reach_px, display_->scale(), Now_s());
  } else {
    aside_.PenLifted(Now_s());
  }
  HoldStill(act);
  switch (act.act) {
    case PenAct::kDraw:
      if (act.phase == DragPhase::kBegin) SyncView();
      if (const auto tapped = ink_->Draw(act, display_->scale())) SelectUnder(*tapped);
      break;
    case PenAct::kErase:
      ink_->Erase(act, display_->scale(), *snapshot_->state, looking_.camera());
      break;
    case PenAct::kSelect:
      if (!PlaceByHand(act)) SweepSelect(act);
      break;
    case PenAct::kOrbit:
    case PenAct::kPan:
    case PenAct::kZoom:
      Looked(
          looking_.Take(act, [this](const auto& c, const auto& p) { return PointTouched(c, p); }));
      break;
    case PenAct::kNone:
      break;
  }
}

void Application::SelectUnder(const Vec2& px) {
  const auto ref = picture_->ShapeUnder(px);
  tapped_px_ = px;
  if (ref) {
    Post(Command(Select{{IdOf(picture_->shown_state()->model, *ref)}}));
  } else if (!snapshot_->state->selection.shapes.empty()) {
    Post(Command(Select{}));
  }
}

void Application::SweepSelect(const DragAct& drag) {
  if (drag.phase == DragPhase::kBegin) swept_.clear();
  if (drag.phase == DragPhase::kCancel) return;
  if (const auto ref = picture_->ShapeUnder(drag.px)) {
    const std::string id = IdOf(picture_->shown_state()->model, *ref);
    if (std::find(swept_.begin(), swept_.end(), id) == swept_.end()) swept_.emplace_back(id);
  }
  if (drag.phase != DragPhase::kEnd) return;
  tapped_px_ = drag.px;
  if (!swept_.empty() || !snapshot_->state->selection.shapes.empty()) {
    Post(Command(Select{swept_}));
  }
}

bool Application::PlaceByHand(const DragAct& drag) {
  PlacingStep step = placing_.Take(drag, View(looking_.camera()), display_->scale());
  if (!step.taken) return false;
  marks_stale_ = true;
  SetPenWord(placing_.word());
  if (step.tapped) SelectUnder(drag.px);
  if (step.command) placing_.Await(Post(Command(std::move(*step.command))));
  return true;
}

void Application::Do(ElementCommand command) {
  if (auto change = placing_.Do(command)) placing_.Await(Post(Command(std::move(*change))));
  marks_stale_ = true;
}

ActedOn Application::ActedOnByKeys() const {
  const SessionState& state = *snapshot_->state;
  const Sketch& sketch = state.sketch;
  // What is not executed yet may bring what the snapshot lacks.
  const bool more = snapshot_->executed < posted_ || sketch.query;
  return {panel_output_->node_shown ? state.in_hand : NodePath(),
          more || !state.selection.shapes.empty(),
          more || !sketch.strokes.empty() || !sketch.unread.empty()};
}

bool Application::TakeShortcut(const KeyEvent& key) {
  const auto meant = shortcuts_.Feed(key, ActedOnByKeys());
  if (!meant) return false;
  if (const auto* turn = std::get_if<TurnView>(&*meant)) {
    if (looking_.held()) return true;
    looking_.Set(OrbitAbout(looking_.camera(), looking_.camera().target, turn->delta_px));
    Looked(true);
  } else {
    Do(std::get<PanelCommand>(*meant));
  }
  return true;
}

void Application::Do(const PanelCommand& command) {
  if (const auto* said = std::get_if<Command>(&command)) {
    Post(*said);
  } else if (const auto* request = std::get_if<DocumentRequest>(&command)) {
    Post(*request);
  } else if (const auto* folder = std::get_if<ListFolder>(&command)) {
    listed_.folder = folder->path;
    folders_.Ask(listed_);
  } else if (const auto* draft = std::get_if<ThrowAway>(&command)) {
    // All of them each time: a request may be overtaken by the next.
    listed_.throw_away.emplace_back(draft->path);
    folders_.Ask(listed_);
  } else if (const auto* view = std::get_if<ViewRequest>(&command)) {
    Do(*view);
  } else if (const auto* element = std::get_if<ElementCommand>(&command)) {
    Do(*element);
  } else if (const auto* mode = std::get_if<PointerMode>(&command)) {
    mode_ = *mode;
    hands_.SetMode(ActOf(mode_));
  } else if (const auto* settings = std::get_if<Settings>(&command)) {
    settings_ = *settings;
    keeper_.Ask(settings_);
    SettingsChanged();
  }
  panels_stale_ = true;
}

void Application::Do(ViewRequest view) {
  if (looking_.held()) return;
  LookFrom(ViewFor(view, looking_.camera(), picture_->bounds()));
}

bool Application::OverPanel(const Vec2& px) {
  if (playing_) return false;
  if (panels_stale_ || !panel_events_.empty()) RunPanels({});
  return panel_output_->holds_pointer || aside_.IsOverSheet(px);
}

/// What panels are to be told. A pointer that hovers beside them is gone, and once is enough: what
/// comes up later where they saw it last is not hovered.
std::optional<PanelEvent> Application::ForPanels(const PanelEvent& event) {
  const auto* pointer = std::get_if<PanelPointer>(&event);
  if (std::holds_alternative<PanelScroll>(event)) return event;
  const bool was_theirs =
      std::exchange(pointer_is_panels_, pointer && (pointer->down || OverPanel(pointer->px)));
  if (pointer_is_panels_) return event;
  return was_theirs ? std::optional<PanelEvent>(PanelPointerGone{}) : std::nullopt;
}

PanelView Application::ViewForPanels() const {
  PanelView view;
  view.session = snapshot_;
  view.files = folders_.newest().value_or(PanelFiles{});
  view.settings = settings_;
  view.scale = settings_.scale > 0 ? settings_.scale : display_->scale();
  view.mode = mode_;
  view.size_px = Vec2(display_->size_px());
  view.pen = pen_;
  view.tapped_px = tapped_px_;
  const View seen(looking_.camera());
  view.elements = placing_.Seen(seen);
  view.element = placing_.InHand(seen);
  view.has_keys = hands_.has_keys();
  return view;
}

void Application::RunPanels(std::vector<PanelEvent> events) {
  std::vector<PanelEvent> all = std::move(panel_events_);
  panel_events_.clear();
  all.insert(all.end(), events.begin(), events.end());
  panels_stale_ = word_stale_ = drag_begun_ = false;
  panel_output_ = &panels_->Frame(ViewForPanels(), {Now_s(), std::move(all)});
  if (panel_output_->letters != letters_ && panel_output_->letters) {
    letters_ = panel_output_->letters;
    static_cast<void>(canvas_->SetPanelTexture(0, *letters_));
  }
  if (panel_output_->changed) canvas_->SetPanels(panel_output_->mesh);
  aside_.SetSheets(panel_output_->sheets);
  canvas_->SetPanelOpacities(aside_.opacities());
  if (!(panel_output_->preview == preview_)) overlay_stale_ = true;
  preview_ = panel_output_->preview;
  overlay_stale_ |= queries_.Set(QueryShown(), snapshot_->state);
  if (trials_.Set(panel_output_->trial, snapshot_->state) && !trials_.going_on()) {
    picture_->SetState(snapshot_->state);
  }
  // Commands may change what the panels show: they are copied, and done after the frame.
  const std::vector<PanelCommand> commands = panel_output_->commands;
  for (const PanelCommand& command : commands) Do(command);
}

/// The one whose card is hovered, else the one that the next sketch acts on.
std::optional<grammar::Query> Application::QueryShown() const {
  const auto& candidates = snapshot_->state->selection.candidates;
  const auto hovered = panel_output_->query_preview;
  if (hovered && *hovered < candidates.size()) return candidates[*hovered].query;
  return snapshot_->state->sketch.query;
}

void Application::ShowMarks() {
  if (overlay_stale_) overlay_ = OverlayOf(*snapshot_->state, preview_);
  const View view(looking_.camera());
  std::vector<render::Mark> marks;
  Project(overlay_, view, &marks);
  if (const WorldMarks* selected = queries_.marks()) Project({*selected}, view, &marks);
  placing_.AddMarks(view, &marks);
  hovering_.AddMarks(*picture_, view, &marks);
  canvas_->SetMarksBelowPanels(std::move(marks));
  overlay_stale_ = marks_stale_ = false;
}

Result<void> Application::DrawFrame() {
  if ((overlay_stale_ || marks_stale_) && !ink_->drawing()) ShowMarks();
  if (!canvas_->NeedsDraw() || !display_->CanDraw()) return {};
  auto target = display_->BeginFrame();
  if (!target) return Fail(target);
  auto damage = canvas_->Draw(target->framebuffer, target->age);
  if (!damage) return Fail(damage);
  return display_->Present(damage->rects());
}

Result<render::Image> Application::Screenshot() {
  if (auto current = display_->context().MakeCurrent(); !current) return Fail(current);
  const glm::ivec2 size = display_->size_px();
  auto target = render::GlFramebuffer::Create(display_->gl(), {size.x, size.y, GL_RGBA8});
  if (!target) return Fail(target);
  if (auto drawn = canvas_->Draw(target->id(), 0); !drawn) return Fail(drawn);
  canvas_->DamageAll();  // the display has not seen that frame
  return render::ReadImage(display_->gl(), target->id(), size);
}

}  // namespace parti::app
