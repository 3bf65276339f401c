// Trees that were derived apart become parts of one: their chunks change hands as they are, and the
// shapes in them get the numbers that they would have if one thread had derived all in order.
#include <tbb/parallel_for.h>

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "grammar/shape_tree.h"

namespace parti::grammar {
namespace {

/// Chunks of fewer shapes are not worth being kept: theirs are moved.
constexpr size_t kFewShapes = 48;

}  // namespace

/// Where a part's shapes go: its root to `at`, the others to `base` and after.
struct ShapeTree::Move {
  ShapeTree* from;
  ShapeIndex at;
  uint32_t base;
  std::vector<NameId> names;  ///< ours for each of its; empty: they are the same

  uint32_t end() const { return base + from->size_ - 1; }
  ShapeIndex Moved(ShapeIndex of_part) const {
    if (of_part == kNoShape) return kNoShape;
    return of_part == 0 ? at : base + of_part - 1;
  }
  NameId Renamed(NameId name) const {
    return names.empty() || name == kNoName ? name : names[name];
  }
  void Renumber(ShapeNode* node) const {
    node->parent = Moved(node->parent);
    node->first_child = Moved(node->first_child);
    node->last_child = Moved(node->last_child);
    node->next_sibling = Moved(node->next_sibling);
  }
  void Rename(Shape* shape) const {
    shape->symbol = Renamed(shape->symbol);
    for (NameId& tag : shape->tags) tag = Renamed(tag);
    std::sort(shape->tags.begin(), shape->tags.end());
  }
  void RenumberAll() const {
    for (uint32_t i = 0; i < from->chunks_.size(); ++i) {
      Chunk& chunk = from->WritableChunk(i);
      for (ShapeNode& node : chunk.nodes) Renumber(&node);
      if (names.empty()) continue;
      for (Shape& shape : chunk.shapes) Rename(&shape);
    }
  }
};

ShapeTree::Move ShapeTree::MoveOf(Part* part, uint32_t base) {
  CHECK(IsLeaf(part->at), "only a leaf can be spliced");
  CHECK(part->tree.size_ - 1 < kNoShape - base, "room for a part's shapes");
  Move move{&part->tree, part->at, base, {}};
  if (part->tree.names_ == names_) return move;
  for (const std::string& name : part->tree.names_->texts) move.names.push_back(Intern(name));
  return move;
}

void ShapeTree::MoveRoot(Move* move) {
  WritableShape(move->at) = std::move(move->from->WritableShape(0));
  ShapeNode& node = WritableNode(move->at);
  ShapeNode root = move->from->node(0);
  root.parent = node.parent;
  root.next_sibling = node.next_sibling;
  root.ordinal = node.ordinal;
  node = root;
}

void ShapeTree::Splice(std::vector<Part> parts) {
  std::vector<Move> moves;
  moves.reserve(parts.size());
  for (Part& part : parts) {
    moves.push_back(MoveOf(&part, moves.empty() ? size_ : moves.back().end()));
  }
  tbb::parallel_for(size_t{0}, moves.size(), [&](size_t i) { moves[i].RenumberAll(); });
  for (Move& move : moves) {
    MoveRoot(&move);
    for (size_t i = 1; i < move.from->chunks_.size(); ++i) {
      std::shared_ptr<Chunk>& chunk = move.from->chunks_[i];
      if (chunk->nodes.size() >= kFewShapes) {
        Adopt(std::move(chunk));
        continue;
      }
      for (size_t k = 0; k < chunk->nodes.size(); ++k) {
        Chunk& next = ChunkForNext();
        next.shapes.push_back(std::move(chunk->shapes[k]));
        next.nodes.push_back(chunk->nodes[k]);
      }
    }
  }
}

}  // namespace parti::grammar
