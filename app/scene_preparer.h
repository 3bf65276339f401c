// Makes scenes of models beside the thread that draws: triangles and crease lines of a large model
// take longer than a frame.
#pragma once

#include <memory>

#include "app/latest_worker.h"
#include "app/session_state.h"
#include "render/bounds.h"
#include "render/scene.h"

namespace parti::app {

/// A scene, and the state whose model it shows. Ids of faces are those of SceneOf's models: 1 +
/// shape, lot after lot (see AddModel).
struct PreparedScene {
  std::shared_ptr<const SessionState> state;
  std::shared_ptr<const render::Scene> scene;
  render::Bounds bounds = {};  ///< of its faces
};

/// Whether two states show the same model, without comparing shapes: derivations are shared.
bool SameModel(const SessionState& a, const SessionState& b);

/// See LatestWorker. States with the model of the scene made before keep that scene.
class ScenePreparer : public LatestWorker<std::shared_ptr<const SessionState>, PreparedScene> {
 public:
  ScenePreparer();
};

}  // namespace parti::app
