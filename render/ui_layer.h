// Panels on the GPU: their textures, sent once, and the triangles of the newest mesh.
// Knows nothing of what panels mean; where they changed, ui_damage.h says.
#pragma once

#include <unordered_map>

#include "render/damage.h"
#include "render/gl_program.h"
#include "render/image.h"
#include "render/ui_damage.h"

namespace parti::render {

/// Used and destroyed while its context is current.
class UiLayer {
 public:
  /// errors  kGraphics.
  static Result<UiLayer> Create(const Gl& gl);
  UiLayer(UiLayer&& other) noexcept;
  UiLayer& operator=(UiLayer&&) = delete;
  ~UiLayer();

  /// Straight alpha. An id that was used before gets another picture.
  /// errors  kGraphics  larger than the device can;  kBadNumber  size and pixels don't agree.
  Result<void> SetTexture(uint32_t id, const Image& image);
  /// Sends the triangles. `shapes` are the mesh's.
  void SetMesh(const UiMesh& mesh, const std::vector<UiShape>& shapes);
  /// Draws what lies in `repair` into the bound framebuffer of this size. Commands whose texture
  /// was never set draw nothing. opacities: of parts, as OpacityOf reads them.
  void Draw(const Damage& repair, std::span<const float> opacities) const;

 private:
  UiLayer(const Gl& gl, GlProgram program);
  void DrawCommand(const UiCommand& command, const PixelRect& rect, int height_px) const;

  const Gl* gl_;
  GlProgram program_;
  GLuint array_ = 0, vertices_ = 0, indices_ = 0;
  std::unordered_map<uint32_t, GLuint> textures_;
  std::vector<UiCommand> commands_;
  std::vector<PixelRect> pixels_;  ///< of each command
};

}  // namespace parti::render
