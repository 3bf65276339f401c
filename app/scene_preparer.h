// Makes scenes of models beside the thread that draws: triangles and crease lines of a large model
// take longer than a frame. The newest model wins; one that nobody waits for any more is skipped.
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>

#include "app/session_state.h"
#include "app/wake_fd.h"
#include "render/scene.h"

namespace parti::app {

/// A scene, and the state whose model it shows. Ids of faces are those of SceneOf's models: 1 +
/// shape, lot after lot (see AddModel).
struct PreparedScene {
  std::shared_ptr<const SessionState> state;
  std::shared_ptr<const render::Scene> scene;
};

/// Whether two states show the same model, without comparing shapes: derivations are shared.
bool SameModel(const SessionState& a, const SessionState& b);

/// Owns one thread, which ends with it. All functions may be called from any thread and don't wait
/// for scenes being made.
class ScenePreparer {
 public:
  ScenePreparer();
  ~ScenePreparer();
  ScenePreparer(const ScenePreparer&) = delete;
  ScenePreparer& operator=(const ScenePreparer&) = delete;

  /// Asks for a scene of the state's model. States with the model of the newest scene keep that.
  void Request(std::shared_ptr<const SessionState> state);

  /// The newest scene; both null before the first.
  PreparedScene newest() const;
  /// Whether a scene has been asked for that is not made yet.
  bool busy() const;
  const WakeFd& ready() const { return ready_; }  ///< woken by each new scene

 private:
  void Work();

  mutable std::mutex mutex_;
  std::condition_variable asked_;
  std::shared_ptr<const SessionState> next_;  // the request not yet begun
  bool making_ = false;
  bool stop_ = false;
  PreparedScene newest_;
  WakeFd ready_;
  std::thread thread_;
};

}  // namespace parti::app
