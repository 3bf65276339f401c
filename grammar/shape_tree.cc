#include "grammar/shape_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <charconv>

#include "base/check.h"

namespace parti::grammar {
namespace {

/// Whether nobody else holds the value, so that it may be written to.
template <typename T>
bool IsOurs(const std::shared_ptr<T>& value) {
  if (value.use_count() != 1) return false;
  // use_count() is a relaxed read: what the last other holder did must be seen before we write.
  std::atomic_thread_fence(std::memory_order_acquire);
  return true;
}

/// "0/2/5" as numbers.
Result<std::vector<uint32_t>> PathFrom(std::string_view id) {
  std::vector<uint32_t> path;
  for (size_t from = 0; from <= id.size();) {
    const size_t slash = std::min(id.find('/', from), id.size());
    const char* end = id.data() + slash;
    const auto [stop, error] = std::from_chars(id.data() + from, end, path.emplace_back());
    if (error != std::errc() || stop != end) {
      return Fail(ErrorCode::kBadText, fmt::format("'{}' is not a shape id", id),
                  "child numbers from the lot, as in 0/2/5; . is the lot");
    }
    from = slash + 1;
  }
  return path;
}

}  // namespace

ShapeTree::ShapeTree(Item lot, std::string_view symbol) : names_(std::make_shared<Names>()) {
  PlantRoot(std::move(lot), Intern(symbol));
}

ShapeTree::ShapeTree(Item lot, NameId symbol, const ShapeTree& names_of) : names_(names_of.names_) {
  PlantRoot(std::move(lot), symbol);
}

void ShapeTree::PlantRoot(Item lot, NameId symbol) {
  auto chunk = std::make_shared<Chunk>();
  chunk->nodes.emplace_back().is_visible = IsVisible(lot.type);
  Shape& root = chunk->shapes.emplace_back();
  root.item = std::move(lot);
  root.symbol = symbol;
  Adopt(std::move(chunk));
}

ShapeTree::Chunk& ShapeTree::WritableChunk(uint32_t chunk) {
  if (!IsOurs(chunks_[chunk])) {
    const Chunk& shared = *chunks_[chunk];
    auto own = std::make_shared<Chunk>();
    if (chunk + 1 == chunks_.size()) {
      own->shapes.reserve(kChunk);
      own->nodes.reserve(kChunk);
    }
    own->shapes.insert(own->shapes.end(), shared.shapes.begin(), shared.shapes.end());
    own->nodes.insert(own->nodes.end(), shared.nodes.begin(), shared.nodes.end());
    chunks_[chunk] = std::move(own);
  }
  return *chunks_[chunk];
}

Shape& ShapeTree::WritableShape(ShapeIndex i) {
  CHECK(i < size_, "a shape of this tree");
  const uint32_t chunk = ChunkOf(i);
  return WritableChunk(chunk).shapes[i - starts_[chunk]];
}

ShapeNode& ShapeTree::WritableNode(ShapeIndex i) {
  CHECK(i < size_, "a shape of this tree");
  const uint32_t chunk = ChunkOf(i);
  return WritableChunk(chunk).nodes[i - starts_[chunk]];
}

/// Where the next shape and its node go; they are counted already.
ShapeTree::Chunk& ShapeTree::ChunkForNext() {
  if (chunks_.size() == 1 || chunks_.back()->nodes.size() >= kChunk) {
    auto chunk = std::make_shared<Chunk>();
    chunk->shapes.reserve(kChunk);
    chunk->nodes.reserve(kChunk);
    Adopt(std::move(chunk));
  }
  const auto last = static_cast<uint32_t>(chunks_.size() - 1);
  if (size_ % kChunk == 0) blocks_.push_back(last);
  ++size_;
  return WritableChunk(last);
}

/// A chunk whose shapes, if it has any, get the next numbers.
void ShapeTree::Adopt(std::shared_ptr<Chunk> chunk) {
  const auto number = static_cast<uint32_t>(chunks_.size());
  starts_.back() = size_;
  starts_.push_back(kNoShape);
  size_ += static_cast<uint32_t>(chunk->nodes.size());
  while (blocks_.size() * kChunk < size_) blocks_.push_back(number);
  chunks_.push_back(std::move(chunk));
}

ShapeIndex ShapeTree::Append(ShapeIndex parent, Item item, NameId symbol,
                             const Operation* operation, std::vector<NameId> tags) {
  CHECK(size_ < kNoShape, "room for another shape");
  const ShapeIndex index = size_;
  ShapeNode node;
  node.parent = parent;
  node.is_visible = IsVisible(item.type);
  ShapeNode& above = WritableNode(parent);
  const ShapeIndex before = above.last_child;
  above.last_child = index;
  if (before == kNoShape) {
    above.first_child = index;
  } else {
    ShapeNode& sibling = WritableNode(before);
    sibling.next_sibling = index;
    node.ordinal = sibling.ordinal + 1;
  }
  std::sort(tags.begin(), tags.end());
  tags.erase(std::unique(tags.begin(), tags.end()), tags.end());
  Chunk& chunk = ChunkForNext();
  chunk.nodes.push_back(node);
  Shape& shape = chunk.shapes.emplace_back();
  shape.item = std::move(item);
  shape.operation = operation;
  shape.symbol = symbol;
  shape.tags = std::move(tags);
  return index;
}

void ShapeTree::SetSymbol(ShapeIndex i, NameId symbol) {
  if ((*this)[i].symbol != symbol) WritableShape(i).symbol = symbol;
}

void ShapeTree::AddTag(ShapeIndex i, NameId tag) {
  const std::vector<NameId>& now = (*this)[i].tags;
  if (std::binary_search(now.begin(), now.end(), tag)) return;
  std::vector<NameId>& tags = WritableShape(i).tags;
  tags.insert(std::lower_bound(tags.begin(), tags.end(), tag), tag);
}

void ShapeTree::SetItem(ShapeIndex i, Item item) {
  Shape& shape = WritableShape(i);
  shape.item = std::move(item);
  WritableNode(i).is_visible = IsVisible(shape.item.type) && !shape.is_hidden;
}

void ShapeTree::Hide(ShapeIndex i) {
  WritableShape(i).is_hidden = true;
  WritableNode(i).is_visible = false;
}

void ShapeTree::SetMade(ShapeIndex i, NameId symbol, const Operation* operation) {
  Shape& shape = WritableShape(i);
  shape.symbol = symbol;
  shape.operation = operation;
}

NameId ShapeTree::Intern(std::string_view name) {
  if (name.empty()) return kNoName;
  if (const NameId known = Find(name); known != kNoName) return known;
  if (!IsOurs(names_)) names_ = std::make_shared<Names>(*names_);
  const auto id = static_cast<NameId>(names_->texts.size());
  names_->texts.emplace_back(name);
  names_->ids.emplace(name, id);
  return id;
}

NameId ShapeTree::Find(std::string_view name) const {
  const auto found = names_->ids.find(std::string(name));
  return found == names_->ids.end() ? kNoName : found->second;
}

std::string_view ShapeTree::Name(NameId id) const {
  return id < names_->texts.size() ? std::string_view(names_->texts[id]) : std::string_view();
}

bool ShapeTree::IsAncestor(ShapeIndex ancestor, ShapeIndex descendant) const {
  // Parents have smaller indices, so the walk may stop before the lot.
  ShapeIndex i = descendant;
  while (i != kNoShape && i > ancestor) i = node(i).parent;
  return i == ancestor && i != descendant;
}

std::vector<ShapeIndex> ShapeTree::Leaves() const {
  std::vector<ShapeIndex> leaves;
  ShapeIndex i = 0;
  while (true) {
    const ShapeNode* at = &node(i);
    if (!at->is_leaf()) {
      i = at->first_child;
      continue;
    }
    if (at->is_visible) leaves.push_back(i);
    while (at->next_sibling == kNoShape && at->parent != kNoShape) at = &node(at->parent);
    if (at->parent == kNoShape) return leaves;
    i = at->next_sibling;
  }
}

bool ShapeTree::HasVisibleLeaf() const {
  for (ShapeIndex i = 0; i < size_; ++i) {
    if (const ShapeNode& at = node(i); at.is_leaf() && at.is_visible) return true;
  }
  return false;
}

std::string ShapeTree::IdOf(ShapeIndex i) const {
  if (i == 0) return ".";
  std::vector<uint32_t> path;
  for (; i != 0; i = node(i).parent) path.push_back(node(i).ordinal);
  return fmt::format("{}", fmt::join(path.rbegin(), path.rend(), "/"));
}

Result<ShapeIndex> ShapeTree::AtId(std::string_view id) const {
  if (id == ".") return 0;
  const auto path = PathFrom(id);
  if (!path) return Fail(path);
  ShapeIndex i = 0;
  for (const uint32_t ordinal : *path) {
    const ShapeIndex parent = i;
    i = node(i).first_child;
    while (i != kNoShape && node(i).ordinal != ordinal) i = node(i).next_sibling;
    if (i != kNoShape) continue;
    return Fail(ErrorCode::kUnknownName, fmt::format("there is no shape '{}': '{}' has no child {}",
                                                     id, IdOf(parent), ordinal));
  }
  return i;
}

bool ShapeTree::SharesAllWith(const ShapeTree& other) const {
  return size_ == other.size_ && names_ == other.names_ && chunks_ == other.chunks_;
}

}  // namespace parti::grammar
