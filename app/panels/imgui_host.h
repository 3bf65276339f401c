// One Dear ImGui context without a backend: our events in, our triangles out.
// What is drawn in it is ui.h's and the panels'.
#pragma once

#include "app/panels/letters.h"
#include "app/panels/panel_input.h"
#include "app/panels/panel_output.h"
#include "render/ui_mesh.h"

struct ImGuiContext;

namespace parti::app::panels {

/// Owns the context; makes it the process's current one in NewFrame.
class ImGuiHost {
 public:
  ImGuiHost();
  ~ImGuiHost();
  ImGuiHost(const ImGuiHost&) = delete;
  ImGuiHost& operator=(const ImGuiHost&) = delete;

  /// The fonts to draw with; the ones before may go after this. Between frames only.
  void SetLetters(Letters letters);
  const Letters& letters() const { return letters_; }

  /// Notes an event; frames see it. Numbers that are not finite count as a pointer that is gone,
  /// keys that ImGui can't hold are passed over.
  void Feed(const PanelEvent& event);

  bool control() const;  ///< one of these keys is held

  /// size_px >= 1; step_s is clamped to what makes sense.
  void NewFrame(const Vec2& size_px, double step_s);
  /// Ends the frame; its triangles, clipped to the view. What lies in the n-th of these windows, or
  /// in a window within it, is part n.
  render::UiMesh Render(const std::vector<PanelSheet>& sheets);

 private:
  void FeedKey(const KeyEvent& key);

  ImGuiContext* context_;
  Letters letters_;
};

}  // namespace parti::app::panels
