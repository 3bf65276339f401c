// Listing 4.9 to the letter, as the driver is held against it: one priority queue over all shapes
// of a lot, with a normalisation token. Slow, and without deferred items or limits.
#pragma once

#include <algorithm>
#include <deque>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

#include "grammar/layers/normalise.h"
#include "grammar/rules/rule_derivation.h"
#include "grammar/rules/rule_runner.h"

namespace parti::grammar {

/// Child numbers from the lot.
inline std::vector<uint32_t> PathTo(const ShapeTree& tree, ShapeIndex i) {
  std::vector<uint32_t> path;
  for (; i != 0; i = tree.node(i).parent) path.push_back(tree.node(i).ordinal);
  std::reverse(path.begin(), path.end());
  return path;
}

/// The rules on one lot, the first of its seed.
inline Result<ShapeTree> DeriveByQueue(const RuleSet& rules, const RuleSettings& settings,
                                       const Item& lot) {
  const RuleProgram program = ProgramOf(rules, *StartSymbol(rules, settings));
  const auto attributes = AttributesFor(rules, settings, lot, 0);
  const LotRun run{program, lot, *attributes, settings.limits, settings.seed, nullptr, nullptr,
                   nullptr, 0,   {}};
  ShapeTree tree(lot, program.names[0].symbol, program.names);
  RuleRunner runner(run, &tree, nullptr);
  // Priority 3, 2 and 0 of (4.23): what stays flat, the token with what waits for it, the rest.
  std::deque<RuleTask> flat, rest;
  std::vector<RuleTask> waiting;
  std::vector<ShapeIndex> scenes;
  RuleTask root;
  root.body = &program.bodies[program.start];
  root.stream = Stream(LotPath(settings.seed, 0));
  rest.push_back(std::move(root));
  const auto planar_of = [&](ShapeIndex i) {
    while (!IsVisible(tree[i].item.type)) i = tree.node(i).parent;
    return i;
  };
  while (!flat.empty() || !scenes.empty() || !rest.empty()) {
    if (flat.empty() && !scenes.empty()) {
      // The token: every scene that is open.
      std::map<ShapeIndex, std::vector<RuleTask>> by_scene;
      for (const ShapeIndex scene : scenes) by_scene[scene];
      for (RuleTask& task : waiting) by_scene[planar_of(task.shape)].push_back(std::move(task));
      waiting.clear();
      scenes.clear();
      for (auto& [planar, tasks] : by_scene) {
        // Normalise wants them in the order of the tree.
        std::sort(tasks.begin(), tasks.end(), [&](const RuleTask& a, const RuleTask& b) {
          return PathTo(tree, a.shape) < PathTo(tree, b.shape);
        });
        std::vector<ShapeIndex> shapes;
        for (const RuleTask& task : tasks) shapes.push_back(task.shape);
        const auto scene = Normalise(&tree, planar, shapes);
        if (!scene) return Fail(scene);
        AppendBackground(&tree, scene->uncovered);
        for (size_t i = 0; i < tasks.size(); ++i) {
          for (size_t k = 0; k < scene->pieces[i].size(); ++k) {
            RuleTask piece = tasks[i];
            piece.shape = scene->pieces[i][k];
            if (k > 0) piece.stream = Stream(StreamOf(piece.stream.path, (uint64_t{1} << 32) + k));
            rest.push_back(std::move(piece));
          }
        }
      }
      continue;
    }
    auto& queue = flat.empty() ? rest : flat;
    RuleTask task = std::move(queue.front());
    queue.pop_front();
    LeftTasks left;
    const ShapeIndex shape = task.shape;
    if (const auto done = runner.Run(std::move(task), &left); !done) return Fail(done);
    if (left.has_scene && IsVisible(tree[shape].item.type)) scenes.push_back(shape);
    std::move(left.flat.begin(), left.flat.end(), std::back_inserter(flat));
    std::move(left.waiting.begin(), left.waiting.end(), std::back_inserter(waiting));
    std::move(left.next.begin(), left.next.end(), std::back_inserter(rest));
  }
  return tree;
}

}  // namespace parti::grammar
