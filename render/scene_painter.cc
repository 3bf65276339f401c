#include "render/scene_painter.h"

#include <chrono>

#include "render/picture_maker.h"

namespace parti::render {

Result<std::unique_ptr<ScenePainter>> ScenePainter::Start(std::unique_ptr<GlContext> context,
                                                          std::function<void()> painted,
                                                          const PainterParams& params) {
  std::unique_ptr<ScenePainter> painter(new ScenePainter(std::move(painted), params));
  std::promise<Result<void>> started;
  std::future<Result<void>> has_started = started.get_future();
  painter->thread_ =
      std::thread(&ScenePainter::Run, painter.get(), std::move(context), std::move(started));
  if (const Result<void> begun = has_started.get(); !begun) return Fail(begun);
  return painter;
}

ScenePainter::~ScenePainter() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  asked_.notify_all();
  thread_.join();
}

void ScenePainter::Request(PaintRequest request) {
  if (!request.scene) return;
  {
    const std::lock_guard lock(mutex_);
    next_ = std::move(request);
  }
  asked_.notify_all();
}

std::shared_ptr<const PaintedPicture> ScenePainter::newest() const {
  const std::lock_guard lock(mutex_);
  return newest_;
}

bool ScenePainter::busy() const {
  const std::lock_guard lock(mutex_);
  return next_ || refine_ || painting_;
}

std::optional<Error> ScenePainter::failure() const {
  const std::lock_guard lock(mutex_);
  return failure_;
}

void ScenePainter::Run(std::unique_ptr<GlContext> context, std::promise<Result<void>> started) {
  auto maker = PictureMaker::Create(std::move(context), params_);
  if (!maker) return started.set_value(Fail(maker));
  started.set_value({});
  while (const std::optional<Job> job = NextJob()) {
    Finish(*job, (*maker)->Make(job->request.scene, job->request.camera, job->coarse,
                                [&] { return Unwanted(*job); }));
  }
}

/// Waits for something to paint; nothing when the painter ends.
std::optional<ScenePainter::Job> ScenePainter::NextJob() {
  std::unique_lock lock(mutex_);
  const auto called = [this] { return stop_ || next_; };
  if (refine_) {
    asked_.wait_for(lock, std::chrono::duration<double>(params_.rest_s), called);
  } else {
    asked_.wait(lock, called);
  }
  if (stop_) return std::nullopt;
  painting_ = true;
  // Without a new request the camera has come to rest.
  const bool coarse = next_ && next_->moving;
  Job job{std::move(next_ ? *next_ : *refine_), coarse};
  next_.reset();
  refine_.reset();
  return job;
}

bool ScenePainter::Unwanted(const Job& job) const {
  const std::lock_guard lock(mutex_);
  return stop_ || (next_ && !job.coarse);
}

void ScenePainter::Finish(const Job& job, Result<std::shared_ptr<const PaintedPicture>> picture) {
  std::shared_ptr<const PaintedPicture> replaced;  // destroyed outside the lock
  {
    const std::lock_guard lock(mutex_);
    painting_ = false;
    failure_.reset();
    if (!picture) failure_ = picture.error();
    if (picture && !*picture) return;  // unwanted
    if (picture) replaced = std::exchange(newest_, std::move(*picture));
    if (picture && job.coarse) refine_ = job.request;
  }
  painted_();
}

}  // namespace parti::render
