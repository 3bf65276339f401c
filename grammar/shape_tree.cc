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

/// Whether a leaf is a part of what is seen.
bool IsSeen(const Shape& leaf) { return IsVisible(leaf.item.type) && !leaf.is_hidden; }

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
  Shape root;
  root.item = std::move(lot);
  root.symbol = Intern(symbol);
  Adopt(std::make_shared<Chunk>(1, std::move(root)));
}

ShapeTree::ShapeTree(Item lot, NameId symbol, const ShapeTree& names_of) : names_(names_of.names_) {
  Shape root;
  root.item = std::move(lot);
  root.symbol = symbol;
  Adopt(std::make_shared<Chunk>(1, std::move(root)));
}

ShapeTree::Chunk& ShapeTree::WritableChunk(uint32_t chunk) {
  if (!IsOurs(chunks_[chunk])) {
    auto shapes = std::make_shared<Chunk>();
    if (chunk + 1 == chunks_.size()) shapes->reserve(kChunk);
    shapes->insert(shapes->end(), chunks_[chunk]->begin(), chunks_[chunk]->end());
    chunks_[chunk] = std::move(shapes);
  }
  return *chunks_[chunk];
}

Shape& ShapeTree::Writable(ShapeIndex i) {
  CHECK(i < size_, "a shape of this tree");
  const uint32_t chunk = ChunkOf(i);
  return WritableChunk(chunk)[i - starts_[chunk]];
}

void ShapeTree::Push(Shape shape) {
  const auto last = static_cast<uint32_t>(chunks_.size() - 1);
  if (last == 0 || chunks_[last]->size() >= kChunk) {
    auto chunk = std::make_shared<Chunk>();
    chunk->reserve(kChunk);
    chunk->push_back(std::move(shape));
    return Adopt(std::move(chunk));
  }
  if (size_ % kChunk == 0) blocks_.push_back(last);
  WritableChunk(last).push_back(std::move(shape));
  ++size_;
}

/// A chunk of shapes with the next numbers.
void ShapeTree::Adopt(std::shared_ptr<Chunk> chunk) {
  const auto number = static_cast<uint32_t>(chunks_.size());
  starts_.back() = size_;
  starts_.push_back(kNoShape);
  size_ += static_cast<uint32_t>(chunk->size());
  while (blocks_.size() * kChunk < size_) blocks_.push_back(number);
  chunks_.push_back(std::move(chunk));
}

ShapeIndex ShapeTree::Append(ShapeIndex parent, Item item, NameId symbol,
                             const Operation* operation, std::vector<NameId> tags) {
  CHECK(size_ < kNoShape, "room for another shape");
  const ShapeIndex index = size_;
  Shape shape;
  shape.item = std::move(item);
  shape.operation = operation;
  shape.symbol = symbol;
  std::sort(tags.begin(), tags.end());
  tags.erase(std::unique(tags.begin(), tags.end()), tags.end());
  shape.tags = std::move(tags);
  shape.parent = parent;
  Shape& above = Writable(parent);
  const ShapeIndex before = above.last_child;
  above.last_child = index;
  if (before == kNoShape) {
    above.first_child = index;
  } else {
    shape.ordinal = (*this)[before].ordinal + 1;
    Writable(before).next_sibling = index;
  }
  Push(std::move(shape));
  return index;
}

void ShapeTree::SetSymbol(ShapeIndex i, NameId symbol) {
  if ((*this)[i].symbol != symbol) Writable(i).symbol = symbol;
}

void ShapeTree::AddTag(ShapeIndex i, NameId tag) {
  const std::vector<NameId>& now = (*this)[i].tags;
  if (std::binary_search(now.begin(), now.end(), tag)) return;
  std::vector<NameId>& tags = Writable(i).tags;
  tags.insert(std::lower_bound(tags.begin(), tags.end(), tag), tag);
}

void ShapeTree::SetItem(ShapeIndex i, Item item) { Writable(i).item = std::move(item); }

void ShapeTree::Hide(ShapeIndex i) { Writable(i).is_hidden = true; }

void ShapeTree::SetMade(ShapeIndex i, NameId symbol, const Operation* operation) {
  Shape& shape = Writable(i);
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
  while (i != kNoShape && i > ancestor) i = (*this)[i].parent;
  return i == ancestor && i != descendant;
}

std::vector<ShapeIndex> ShapeTree::Leaves() const {
  std::vector<ShapeIndex> leaves;
  ShapeIndex i = 0;
  while (true) {
    if (!IsLeaf(i)) {
      i = (*this)[i].first_child;
      continue;
    }
    if (IsSeen((*this)[i])) leaves.push_back(i);
    while (i != 0 && (*this)[i].next_sibling == kNoShape) i = (*this)[i].parent;
    if (i == 0) return leaves;
    i = (*this)[i].next_sibling;
  }
}

std::string ShapeTree::IdOf(ShapeIndex i) const {
  if (i == 0) return ".";
  std::vector<uint32_t> path;
  for (; i != 0; i = (*this)[i].parent) path.push_back((*this)[i].ordinal);
  return fmt::format("{}", fmt::join(path.rbegin(), path.rend(), "/"));
}

Result<ShapeIndex> ShapeTree::AtId(std::string_view id) const {
  if (id == ".") return 0;
  const auto path = PathFrom(id);
  if (!path) return Fail(path);
  ShapeIndex i = 0;
  for (const uint32_t ordinal : *path) {
    const ShapeIndex parent = i;
    i = (*this)[i].first_child;
    while (i != kNoShape && (*this)[i].ordinal != ordinal) i = (*this)[i].next_sibling;
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
