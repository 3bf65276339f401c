// The shape tree: everything that was ever derived from one lot (Jesus 2018, 5.1, 5.4).
// A value: copies share their chunks, and only chunks that are written to are copied.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "base/error.h"
#include "grammar/item.h"

namespace parti::grammar {

struct Operation;

using ShapeIndex = uint32_t;
inline constexpr ShapeIndex kNoShape = 0xffffffff;
/// A symbol or tag, interned in one tree.
using NameId = uint32_t;
inline constexpr NameId kNoName = 0xffffffff;

/// What stands at a node of the tree: an item and its names.
struct Shape {
  Item item;
  const Operation* operation = nullptr;  ///< that made it; null for the lot itself
  NameId symbol = kNoName;
  bool is_hidden = false;    ///< its rule made nothing of it: it is not visible though it is a leaf
  std::vector<NameId> tags;  ///< sorted, each once
};

/// Where a shape stands. Apart from the shapes, so that walks read 24 bytes of each.
struct ShapeNode {
  ShapeIndex parent = kNoShape;
  ShapeIndex first_child = kNoShape;
  ShapeIndex last_child = kNoShape;
  ShapeIndex next_sibling = kNoShape;
  uint32_t ordinal = 0;     ///< among its parent's children, from 0
  bool is_visible = false;  ///< where it is a leaf: of a visible type, and not hidden

  bool is_leaf() const { return first_child == kNoShape; }
};

/// Shapes are numbered in creation order; a parent comes before its children; 0 is the lot.
/// cost  a copy is about one pointer per 128 shapes; a write copies at most the chunk that it lands
///       in, which holds no more.
/// Copies may be read and written by different threads.
class ShapeTree {
 public:
  explicit ShapeTree(Item lot, std::string_view symbol = "Lot");
  /// Knows the names that another tree knows, under the same numbers.
  ShapeTree(Item lot, NameId symbol, const ShapeTree& names_of);

  uint32_t size() const { return size_; }
  const Shape& operator[](ShapeIndex i) const {
    const uint32_t chunk = ChunkOf(i);
    return chunks_[chunk]->shapes[i - starts_[chunk]];
  }
  /// Where shape i stands.
  const ShapeNode& node(ShapeIndex i) const {
    const uint32_t chunk = ChunkOf(i);
    return chunks_[chunk]->nodes[i - starts_[chunk]];
  }

  /// Appends a child as its parent's last; returns its index.
  ShapeIndex Append(ShapeIndex parent, Item item, NameId symbol, const Operation* operation,
                    std::vector<NameId> tags = {});
  void SetSymbol(ShapeIndex i, NameId symbol);
  void AddTag(ShapeIndex i, NameId tag);
  void SetItem(ShapeIndex i, Item item);
  /// Not visible, whatever it is.
  void Hide(ShapeIndex i);
  /// Its symbol, and the operation that made it what it now is.
  void SetMade(ShapeIndex i, NameId symbol, const Operation* operation);
  struct Part;
  /// Puts each tree in the place of a shape: its root's values become those of the shape, the rest
  /// its descendants, in the order of the parts and of their numbers. The shapes are different
  /// leaves. cost  linear, on the threads of the caller's oneTBB arena.
  void Splice(std::vector<Part> parts);

  /// kNoName for the empty name.
  NameId Intern(std::string_view name);
  /// kNoName when no shape ever had it.
  NameId Find(std::string_view name) const;
  std::string_view Name(NameId id) const;  ///< "" for kNoName

  bool IsLeaf(ShapeIndex i) const { return node(i).is_leaf(); }
  bool IsAncestor(ShapeIndex ancestor, ShapeIndex descendant) const;  ///< not of itself
  /// Leaves in depth-first order that are visible: no layers, no 2D shapes, nothing hidden.
  std::vector<ShapeIndex> Leaves() const;
  bool HasVisibleLeaf() const;

  /// Child-index path from the lot, "0/2/5"; "." is the lot (interfaces.md, Shape ids).
  std::string IdOf(ShapeIndex i) const;
  /// errors  kBadText  not such a path;  kUnknownName  no shape there.
  Result<ShapeIndex> AtId(std::string_view id) const;

  /// True when both are the same value by sharing all of their parts: never for two trees that were
  /// built apart.
  bool SharesAllWith(const ShapeTree& other) const;

 private:
  static constexpr uint32_t kChunk = 128;
  /// The same shapes in both, and at most kChunk of them.
  struct Chunk {
    std::vector<Shape> shapes;
    std::vector<ShapeNode> nodes;
  };
  struct Names {
    std::vector<std::string> texts;
    std::unordered_map<std::string, NameId> ids;
  };
  struct Move;

  /// Most chunks are full, so that the first one looked at is nearly always the one.
  uint32_t ChunkOf(ShapeIndex i) const {
    uint32_t chunk = blocks_[i / kChunk];
    while (starts_[chunk + 1] <= i) ++chunk;
    return chunk;
  }
  Chunk& WritableChunk(uint32_t chunk);
  Shape& WritableShape(ShapeIndex i);
  ShapeNode& WritableNode(ShapeIndex i);
  Chunk& ChunkForNext();
  void PlantRoot(Item lot, NameId symbol);
  void Adopt(std::shared_ptr<Chunk> chunk);
  Move MoveOf(Part* part, uint32_t base);
  void MoveRoot(Move* move);

  std::vector<std::shared_ptr<Chunk>> chunks_;  ///< the first one holds the lot alone
  std::vector<ShapeIndex> starts_{kNoShape};    ///< first number of each chunk; then kNoShape
  std::vector<uint32_t> blocks_;                ///< the chunk of every kChunk-th number
  uint32_t size_ = 0;
  std::shared_ptr<Names> names_;
};

/// A tree that was derived apart, and the leaf that it grew from.
struct ShapeTree::Part {
  ShapeIndex at = kNoShape;
  ShapeTree tree;
};

}  // namespace parti::grammar
