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

ScenePreparer::ScenePreparer() : thread_([this] { Work(); }) {}

ScenePreparer::~ScenePreparer() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  asked_.notify_one();
  thread_.join();
}

void ScenePreparer::Request(std::shared_ptr<const SessionState> state) {
  {
    const std::lock_guard lock(mutex_);
    next_ = std::move(state);
  }
  asked_.notify_one();
}

PreparedScene ScenePreparer::newest() const {
  const std::lock_guard lock(mutex_);
  return newest_;
}

bool ScenePreparer::busy() const {
  const std::lock_guard lock(mutex_);
  return making_ || next_;
}

void ScenePreparer::Work() {
  std::unique_lock lock(mutex_);
  while (true) {
    asked_.wait(lock, [&] { return stop_ || next_; });
    if (stop_) return;
    const PreparedScene before = newest_;
    PreparedScene made{std::exchange(next_, nullptr), before.scene};
    making_ = true;
    lock.unlock();
    if (!before.state || !SameModel(*before.state, *made.state)) {
      made.scene = SceneOfModel(made.state->model);
    }
    lock.lock();
    newest_ = std::move(made);
    making_ = false;
    ready_.Wake();
  }
}

}  // namespace parti::app
