#include "grammar/rules/rule_scene.h"

#include <algorithm>
#include <deque>
#include <iterator>
#include <unordered_map>
#include <utility>

#include "grammar/layers/normalise.h"

namespace parti::grammar {
namespace {

/// Numbers of the streams of second and later pieces: far from those of children.
constexpr uint64_t kPieceStreams = uint64_t{1} << 32;

void Append(std::vector<RuleTask>* from, std::vector<RuleTask>* to) {
  std::move(from->begin(), from->end(), std::back_inserter(*to));
  from->clear();
}

/// The next shape of a walk through `root` and all below it, parents first; kNoShape at its end.
ShapeIndex NextInWalk(const ShapeTree& tree, ShapeIndex root, ShapeIndex at) {
  if (!tree.IsLeaf(at)) return tree.node(at).first_child;
  while (at != root && tree.node(at).next_sibling == kNoShape) at = tree.node(at).parent;
  return at == root ? kNoShape : tree.node(at).next_sibling;
}

/// In the depth-first order of the tree, which the order of the work need not be.
std::vector<RuleTask> InTreeOrder(std::vector<RuleTask> tasks, const ShapeTree& tree,
                                  ShapeIndex root) {
  std::unordered_map<ShapeIndex, size_t> numbers;
  for (size_t i = 0; i < tasks.size(); ++i) numbers.emplace(tasks[i].shape, i);
  std::vector<RuleTask> ordered;
  ordered.reserve(tasks.size());
  for (ShapeIndex i = root; i != kNoShape && ordered.size() < tasks.size();
       i = NextInWalk(tree, root, i)) {
    const auto found = numbers.find(i);
    if (found != numbers.end()) ordered.push_back(std::move(tasks[found->second]));
  }
  return ordered;
}

/// A shape, and the body that ran on it.
struct Place {
  ShapeIndex shape;
  const BodyPlan* body;
};

/// A planar shape's scene, and those of the deferred shapes in it, until they are planar shapes.
class Scene {
 public:
  Scene(RuleRunner* runner, std::vector<RuleTask>* next) : runner_(runner), next_(next) {}

  /// `left` is what the rule of the planar shape left.
  Result<void> Run(const Place& planar, LeftTasks left) {
    if (const auto done = Lay(planar, std::move(left)); !done) return done;
    while (!deferred_.empty()) {
      Deferred first = std::move(deferred_.front());
      deferred_.pop_front();
      if (const auto done = RunDeferred(std::move(first)); !done) return done;
    }
    AppendBackground(&runner_->tree(), uncovered_);
    return RunWaiting();
  }

 private:
  struct Deferred {
    RuleTask task;
    ShapeIndex planar;  ///< whose scene it belongs to
  };

  /// All that stays two-dimensional, depth first, then the normalisation.
  Result<void> Lay(const Place& planar, LeftTasks left) {
    std::vector<RuleTask> stack(std::make_move_iterator(left.flat.rbegin()),
                                std::make_move_iterator(left.flat.rend()));
    left.flat.clear();
    while (!stack.empty()) {
      RuleTask one = std::move(stack.back());
      stack.pop_back();
      if (const auto done = runner_->Run(std::move(one), &left); !done) return done;
      stack.insert(stack.end(), std::make_move_iterator(left.flat.rbegin()),
                   std::make_move_iterator(left.flat.rend()));
      left.flat.clear();
    }
    Append(&left.next, next_);
    for (RuleTask& task : left.deferred) deferred_.push_back({std::move(task), planar.shape});
    return Normalised(planar, std::move(left.waiting));
  }

  Result<void> Normalised(const Place& planar, std::vector<RuleTask> waiting) {
    waiting = InTreeOrder(std::move(waiting), runner_->tree(), planar.shape);
    std::vector<ShapeIndex> shapes;
    shapes.reserve(waiting.size());
    for (const RuleTask& task : waiting) shapes.push_back(task.shape);
    const LotRun& lot = runner_->lot();
    const double start = lot.normalise_s != nullptr ? lot.now_s() : 0;
    auto scene = Normalise(&runner_->tree(), planar.shape, shapes);
    if (lot.normalise_s != nullptr) lot.normalise_s->fetch_add(lot.now_s() - start);
    if (!scene) return Failed(scene.error(), planar);
    for (size_t i = 0; i < waiting.size(); ++i) GoOn(waiting[i], scene->pieces[i], &waiting_);
    std::move(scene->uncovered.begin(), scene->uncovered.end(), std::back_inserter(uncovered_));
    return {};
  }

  /// The task for each of the pieces that its shape has become.
  static void GoOn(const RuleTask& task, const std::vector<ShapeIndex>& pieces,
                   std::vector<RuleTask>* tasks) {
    for (size_t i = 0; i < pieces.size(); ++i) {
      RuleTask& piece = tasks->emplace_back(task);
      piece.shape = pieces[i];
      if (i > 0) piece.stream = Stream(StreamOf(task.stream.path, kPieceStreams + i));
    }
  }

  /// A deferred shape takes what its scene, and the scenes in it, have not covered; what its own
  /// rule does not cover is left for the next (errata 9a).
  Result<void> RunDeferred(Deferred deferred) {
    ShapeTree& tree = runner_->tree();
    const auto own =
        std::stable_partition(uncovered_.begin(), uncovered_.end(), [&](const Uncovered& one) {
          return one.planar != deferred.planar && !tree.IsAncestor(deferred.planar, one.planar);
        });
    std::vector<Uncovered> free(std::make_move_iterator(own),
                                std::make_move_iterator(uncovered_.end()));
    uncovered_.erase(own, uncovered_.end());
    const auto pieces = PlaceDeferred(&tree, deferred.task.shape, &free);
    if (!pieces) return Failed(pieces.error(), {deferred.task.shape, deferred.task.body});
    std::move(free.begin(), free.end(), std::back_inserter(uncovered_));
    std::vector<RuleTask> tasks;
    GoOn(deferred.task, *pieces, &tasks);
    for (RuleTask& task : tasks) {
      LeftTasks left;
      if (const auto done = runner_->Run(task, &left); !done) return done;
      const bool has_scene = left.has_scene;
      if (!has_scene) Append(&left.next, next_);
      if (!has_scene) continue;
      if (const auto done = Lay({task.shape, task.body}, std::move(left)); !done) return done;
    }
    return {};
  }

  /// Shapes that are now planar go on: those that become something at once, as they still belong to
  /// their parents, the others as tasks of their own.
  Result<void> RunWaiting() {
    for (RuleTask& task : waiting_) {
      if (!task.becomes) {
        next_->push_back(std::move(task));
        continue;
      }
      LeftTasks left;
      if (const auto done = runner_->Run(std::move(task), &left); !done) return done;
      Append(&left.next, next_);
    }
    return {};
  }

  tl::unexpected<Error> Failed(Error error, const Place& place) const {
    return tl::unexpected<Error>(
        runner_->Named(std::move(error), place.body->rule, place.shape, place.body->body->range));
  }

  RuleRunner* runner_;
  std::vector<RuleTask>* next_;
  std::vector<RuleTask> waiting_;
  std::deque<Deferred> deferred_;
  std::vector<Uncovered> uncovered_;
};

}  // namespace

Result<void> RunWithScene(RuleTask task, RuleRunner* runner, std::vector<RuleTask>* next) {
  LeftTasks left;
  const Place planar{task.shape, task.body};
  if (const auto done = runner->Run(std::move(task), &left); !done) return done;
  if (left.has_scene) return Scene(runner, next).Run(planar, std::move(left));
  Append(&left.next, next);
  return {};
}

}  // namespace parti::grammar
