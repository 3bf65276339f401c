// The images that faces wear, on the GPU: each decoded and uploaded once, with smaller copies of
// itself for where it is seen from afar.
// Reading files is app's, decoding texture_image.h's.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "render/gl.h"

namespace parti::render {

/// An image as its file holds it; images are told apart by where they lie, not by their bytes.
using EncodedImage = std::shared_ptr<const std::string>;

/// Used and destroyed while its context is current.
class GpuTextures {
 public:
  /// What is asked for and lies in `old` is taken over from it; call Forget when all was asked for.
  explicit GpuTextures(const Gl& gl) : gl_(&gl) {}
  GpuTextures(const Gl& gl, GpuTextures old) : gl_(&gl), old_(std::move(old.known_)) {
    old.known_.clear();
  }
  GpuTextures(GpuTextures&& other) noexcept;
  GpuTextures& operator=(GpuTextures&& other) noexcept;
  ~GpuTextures();

  /// Repeats in both directions, sRGB. 0 where the image can't be read, which is remembered, too.
  GLuint Of(const EncodedImage& image);
  /// Deletes what `old` had and nobody asked for.
  void Forget() { Delete(&old_); }

 private:
  using Textures = std::map<EncodedImage, GLuint>;
  GLuint Upload(const std::string& bytes) const;
  void Delete(Textures* textures) const;

  const Gl* gl_;
  Textures known_;
  Textures old_;
};

}  // namespace parti::render
