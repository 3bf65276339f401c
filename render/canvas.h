// What the ink thread shows: the model's picture, ink, marks and panels, composed so that only what
// changed is drawn. Knows no scene, no window and no pen: it is told what to show, and where to.
#pragma once

#include <deque>
#include <memory>
#include <span>

#include "render/ink_layer.h"
#include "render/mark_layer.h"
#include "render/picture_cells.h"
#include "render/ui_layer.h"

namespace parti::render {

/// A picture of the model, finished by whoever drew it.
struct CanvasPicture {
  GLuint texture = 0;        ///< GL_SRGB8_ALPHA8, rows from the bottom
  glm::ivec2 size_px{1, 1};  ///< of the texture
  /// Where in the picture (pixels of view_px, y down, homogeneous) a pixel of the canvas lies: the
  /// identity, unless the camera has moved since.
  glm::dmat3 picture_from_canvas{1};
  glm::dvec2 view_px{1, 1};  ///< the size of the camera's view that fills the texture
  /// What the texture shows, where known: only what differs from the picture before is damaged.
  PictureCells cells;
  /// Released once no frame needs the texture any more, on the thread that draws.
  std::shared_ptr<const void> keep;
};

/// Layers from back to front: picture, ink, marks below panels, panels, marks above panels. All
/// functions are called by one thread. Those that return a Result, and the destructor, need the
/// context to be current; the others only note what is wanted. Draw does the work: O(pixels damaged
/// + samples, triangles and marks that are new or in them).
///
/// Pixels count from the top left, y down. Targets are GL_RGBA8 or a window's framebuffer (bytes
/// are written as sRGB; a target that converts by itself would do so twice), of the canvas's size,
/// with the bottom row first, as GL has it.
/// Property: (1) whatever the sequence of calls, a target repaired according to its age has the
/// same pixels as one drawn whole, but for rounding by 2 of 255 where ink of several colours lies.
class Canvas {
 public:
  /// `gl` must outlive it. size: at least 1 x 1.
  /// errors  kGraphics  larger than the device can, a shader that fails.
  static Result<std::unique_ptr<Canvas>> Create(const Gl& gl, const glm::ivec2& size);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  /// Everything stays where it is, from the top left. errors  as Create; the canvas is as before.
  Result<void> Resize(const glm::ivec2& size);
  const glm::ivec2& size() const { return size_; }

  /// The newest picture; the one before is kept until frames that show it are finished.
  void SetPicture(CanvasPicture picture);
  /// Where there is no picture. sRGB.
  void SetPaper(const Vec3f& color);

  /// See InkStrokes for these six.
  void SetStrokes(const std::vector<InkStroke>& strokes);
  void BeginStroke(uint64_t id, const Vec4f& color);
  void AddSamples(std::span<const Vec2f> points, std::span<const float> widths_px);
  void SetPrediction(std::span<const Vec2f> points, std::span<const float> widths_px);
  void EndStroke();
  void CancelStroke();

  /// All of them, each time.
  void SetMarksBelowPanels(std::vector<Mark> marks);
  void SetMarksAbovePanels(std::vector<Mark> marks);

  /// All panels, each time; what stayed the same is not drawn again. O(indices).
  void SetPanels(const UiMesh& mesh);
  /// How much is seen of each part of the panels, by its number, [0, 1]; 1 for parts without one.
  /// Triangles stay where they are: no mesh is made or sent. O(commands).
  void SetPanelOpacities(std::span<const float> opacities);
  /// See UiLayer; panels are damaged.
  Result<void> SetPanelTexture(uint32_t id, const Image& image);

  /// Everything has to be drawn again: a frame was lost, a display woke up.
  void DamageAll();
  /// Whether anything changed since the last Draw.
  bool NeedsDraw() const;

  /// Draws what changed into a target that shows the frame `age` frames ago (1: the last one drawn;
  /// 0: unknown). Returns what differs from the last frame, to be presented.
  /// errors  kGraphics; what was damaged stays so.
  Result<Damage> Draw(GLuint framebuffer, int age);

 private:
  struct Retired {
    std::shared_ptr<const void> keep;
    GLsync drawn = nullptr;  ///< signalled once no frame reads it; null until the next Draw
  };
  struct Programs {
    GlProgram picture, picture_and_ink;
  };
  struct Layers {
    InkLayer ink;
    MarkLayer marks;
  };
  Canvas(const Gl& gl, const glm::ivec2& size, Programs programs, UiLayer panels, Layers layers);
  static Result<Layers> CreateLayers(const Gl& gl, const glm::ivec2& size);
  void SetMarks(std::vector<Mark> marks, std::vector<Mark>* held, std::vector<MarkGroup>* groups);
  void Compose(const Damage& repair, GLuint framebuffer) const;
  void BindPicture(const GlProgram& program) const;
  void BindInk() const;
  void WatchRetired();
  void ReleaseRetired();
  void SendPanels();

  const Gl* gl_;
  glm::ivec2 size_;
  Programs programs_;
  FullScreenTriangle full_screen_;
  UiLayer panels_;
  Layers layers_;
  InkStrokes strokes_;
  CanvasPicture picture_;
  Vec3f paper_;
  std::vector<Mark> marks_below_, marks_above_;
  std::vector<MarkGroup> groups_below_, groups_above_;
  std::vector<UiShape> panel_shapes_;
  UiMesh mesh_;
  std::vector<float> panel_opacities_;
  bool mesh_sent_ = true;
  Damage fresh_;  ///< since the last Draw, but for ink
  DamageHistory history_;
  std::deque<Retired> retired_;
};

}  // namespace parti::render
