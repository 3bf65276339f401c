// Draws models on a thread of its own, so that the pen never waits for them: the newest request
// wins, finished pictures are handed over whole. Composing them with ink is Canvas's.
#pragma once

#include <condition_variable>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "render/gl_context.h"
#include "render/painted_picture.h"

namespace parti::render {

/// What to draw. The camera's size is the picture's.
struct PaintRequest {
  std::shared_ptr<const Scene> scene;
  Camera camera;
  /// The camera is being moved: a coarse picture first, then a fine one unless another request
  /// comes before.
  bool moving = false;
};

/// Owns one thread and its context. Its functions may be called from any thread, and don't wait for
/// drawing. A scene stays on the GPU for as long as requests ask for it: a moved camera uploads
/// nothing and draws no shadow anew.
class ScenePainter {
 public:
  /// `context` shares with the one that will show the pictures (GlContext::CreateShared); it must
  /// not be current. `painted` is called on the painter's thread after each picture, and after a
  /// failure. errors  kGraphics.
  static Result<std::unique_ptr<ScenePainter>> Start(std::unique_ptr<GlContext> context,
                                                     std::function<void()> painted,
                                                     const PainterParams& params = {});
  /// Waits for the piece being drawn. Pictures that are still held stay valid.
  ~ScenePainter();
  ScenePainter(const ScenePainter&) = delete;
  ScenePainter& operator=(const ScenePainter&) = delete;

  /// Coarse pictures are finished even so, as else a camera that is moved on and on would show
  /// none.
  void Request(PaintRequest request);
  /// Null before the first. Requests without a scene paint nothing.
  std::shared_ptr<const PaintedPicture> newest() const;
  /// Whether something is asked for that is not painted yet.
  bool busy() const;
  /// Why the newest request was not painted: out of memory, an invalid camera.
  std::optional<Error> failure() const;

 private:
  struct Job {
    PaintRequest request;
    bool coarse;
  };
  ScenePainter(std::function<void()> painted, const PainterParams& params)
      : painted_(std::move(painted)), params_(params) {}
  void Run(std::unique_ptr<GlContext> context, std::promise<Result<void>> started);
  std::optional<Job> NextJob();
  void Finish(const Job& job, Result<std::shared_ptr<const PaintedPicture>> picture);
  bool Unwanted(const Job& job) const;

  std::function<void()> painted_;
  PainterParams params_;
  mutable std::mutex mutex_;
  std::condition_variable asked_;
  std::optional<PaintRequest> next_;    // not yet begun
  std::optional<PaintRequest> refine_;  // painted coarsely so far
  bool painting_ = false;
  bool stop_ = false;
  std::shared_ptr<const PaintedPicture> newest_;
  std::optional<Error> failure_;
  std::thread thread_;
};

}  // namespace parti::render
