// The application in the hand: one loop between a display, the session's thread, panels and the
// canvas. Every step in it is a value passed on: what hands do (hands.h) becomes ink (ink_desk.h),
// looking (looking.h), or commands; snapshots of the session become pictures, marks and panels.
// Not responsible for opening displays or documents (commands/open_command.cc).
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "app/display/display.h"
#include "app/folder_list.h"
#include "app/hovering.h"
#include "app/ink_desk.h"
#include "app/looking.h"
#include "app/model_picture.h"
#include "app/overlay.h"
#include "app/panels/panels.h"
#include "app/placing/placing.h"
#include "app/query_preview.h"
#include "app/session_thread.h"
#include "app/settings.h"
#include "app/shortcuts.h"
#include "app/stepping_aside.h"
#include "app/trial.h"

namespace parti::app {

/// What an application begins with.
struct ApplicationOptions {
  Settings settings;
  std::string settings_path;  ///< "": changes are not kept
  UserFolders folders = {};   ///< of drafts and recent files; "" for none
  SteppingAsideParams stepping_aside = {};
  std::function<void(const SessionSnapshot&)> on_snapshot;  ///< told of each; may be empty
  /// Whether a signal asks for the end, as a window's cross does; asked in each turn; may be empty.
  std::function<bool()> end_asked;
  int end_fd = -1;  ///< readable when it does
};

/// Used by one thread. Never derives, infers, or touches a file.
class Application {
 public:
  /// `display` and `session` must outlive it. errors  kGraphics.
  static Result<std::unique_ptr<Application>> Create(Display* display, SessionThread* session,
                                                     ApplicationOptions options);
  ~Application();
  Application(const Application&) = delete;
  Application& operator=(const Application&) = delete;

  /// Waits until something happens or one of `also` (fds) is readable, at most so long; handles
  /// what happened, and draws a frame if anything is to be seen of it.
  /// errors  kDevice, kGraphics  the display is gone for good; the session is whole.
  Result<void> Turn(double wait_s, std::span<const int> also = {});

  /// As if a device of the display had sent it, now; handled by the next Turn.
  void Feed(const InputEvent& event) { fed_.push_back(event); }
  /// Whether what is fed is a recording: its strokes go to the drawing, wherever panels lie now.
  void SetPlaying(bool playing) { playing_ = playing; }
  /// As if a panel had sent it.
  void Do(const PanelCommand& command);

  /// Whether a person, the display or a signal asked for the end.
  bool close_asked() const { return close_asked_; }
  /// As if every pen, finger and button were lifted: the program is about to end, and what is being
  /// drawn is to be kept.
  void PutDown();
  /// What the display shows, drawn anew. errors  kGraphics.
  Result<render::Image> Screenshot();

  /// Nothing is being executed, saved, painted or waits to be drawn: what is on the display is all
  /// there is to see.
  bool Settled() const;

  const Settings& settings() const { return settings_; }
  const Camera& camera() const { return looking_.camera(); }
  const SessionSnapshot& snapshot() const { return *snapshot_; }
  const PanelOutput& panels() const { return *panel_output_; }

 private:
  Application(Display* display, SessionThread* session, ApplicationOptions options);
  Result<void> Start();

  void Wait(double wait_s, std::span<const int> also) const;
  void TakeEnd();
  void Take(const DisplayNews& news);
  void TakeSnapshot();
  void Resized();
  void SettingsChanged();

  void Take(const DragAct& act);
  void Take(const HoverAct& act);
  void Take(const HoverEndAct&);
  void Take(const WheelAct& act);
  void Take(const PanelAct& act);
  void Take(const input::OrbitGesture& gesture);
  void Take(const input::PanZoomGesture& gesture);
  void Take(const input::TapGesture& tap);
  void TakeAll(const std::vector<Act>& acts);

  void Do(ViewRequest view);
  void Do(ElementCommand command);
  bool TakeShortcut(const KeyEvent& key);
  ActedOn ActedOnByKeys() const;
  void SelectUnder(const Vec2& px);
  void SweepSelect(const DragAct& drag);
  /// Whether the drag places an element by hand.
  bool PlaceByHand(const DragAct& drag);
  /// What is drawn is read with one camera, and what is dragged moves in one.
  void HoldStill(const DragAct& drag);
  void Looked(bool changed);
  void LookFrom(const Camera& camera);
  /// Tells the session where the camera is, if it does not know.
  void SyncView();
  uint64_t Post(SessionRequest request);

  bool OverPanel(const Vec2& px);
  std::optional<PanelEvent> ForPanels(const PanelEvent& event);
  void SetPenWord(std::string word);
  void RunPanels(std::vector<PanelEvent> events);
  PanelView ViewForPanels() const;
  std::optional<grammar::Query> QueryShown() const;
  void ShowMarks();
  Result<void> DrawFrame();
  Vec3 PointTouched(const Camera& camera, const Vec2& px) const;

  Display* display_;
  SessionThread* session_;
  ApplicationOptions options_;
  Settings settings_;
  Hands hands_;
  Looking looking_;
  Shortcuts shortcuts_;
  std::unique_ptr<render::Canvas> canvas_;
  std::unique_ptr<ModelPicture> picture_;
  std::unique_ptr<Panels> panels_;
  std::unique_ptr<InkDesk> ink_;
  LatestWorker<FolderRequest, PanelFiles> folders_;
  LatestWorker<Settings, Result<void>> keeper_;
  Trials trials_;
  QueryPreviews queries_;
  Placing placing_;

  std::shared_ptr<const SessionSnapshot> snapshot_;
  const PanelOutput* panel_output_ = nullptr;
  std::shared_ptr<const render::Image> letters_;
  FolderRequest listed_;  // the folder that the document sheet shows; drafts thrown away so far
  std::vector<InputEvent> fed_;
  std::vector<PanelEvent> panel_events_;  // since the last frame of panels
  bool panels_stale_ = true;
  bool word_stale_ = false;  // the one beside the pen moved or changed
  bool drag_begun_ = false;  // since then
  SteppingAside aside_;
  bool pointer_is_panels_ = false;  // what they were told last
  PointerMode mode_ = PointerMode::kDraw;
  PanelPen pen_;
  std::optional<Vec2> tapped_px_;
  Hovering hovering_;
  std::optional<size_t> preview_;
  std::vector<std::string> swept_;  // shapes that a selecting drag has passed
  std::vector<WorldMarks> overlay_;
  bool overlay_stale_ = true, marks_stale_ = true;
  Camera told_;  // the view that the session knows of
  std::optional<double> sync_at_s_;
  uint64_t posted_ = 0;
  bool playing_ = false;
  bool close_asked_ = false;
};

}  // namespace parti::app
