#include "app/scene_preparer.h"

#include <utility>

#include "app/scene_from_model.h"

namespace parti::app {
namespace {

std::shared_ptr<const render::Scene> SceneOfModel(const Model& model) {
  auto scene = std::make_shared<render::Scene>();
  std::vector<const grammar::ShapeTree*> trees;
  for (const auto& derivation : model.derived) trees.push_back(&derivation->tree);
  AddModels(trees, scene.get());
  return scene;
}

}  // namespace

bool SameModel(const SessionState& a, const SessionState& b) {
  return a.model.derived == b.model.derived;
}

ScenePreparer::ScenePreparer()
    : LatestWorker([made = PreparedScene()](std::shared_ptr<const SessionState> state) mutable {
        const bool same = made.state && SameModel(*made.state, *state);
        made.state = std::move(state);
        if (!same) {
          made.scene = SceneOfModel(made.state->model);
          made.bounds = render::BoundsOf(*made.scene, false);
        }
        return made;
      }) {}

}  // namespace parti::app
