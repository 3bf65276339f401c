// Bytes that are gathered without knowing how many will come, by the gigabyte.
// What they mean, and where they lie in a file, is the exporters'.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace parti::app {

/// A vector would copy all of it whenever it grows, and hold it twice meanwhile. Blocks stay where
/// they are; each is given back to the system as soon as it has been moved into a text.
class ByteBlocks {
 public:
  /// Copies them.
  void Append(const void* data, size_t size) {
    const char* at = static_cast<const char*>(data);
    while (size > 0) {
      if (blocks_.empty() || blocks_.back().size() == blocks_.back().capacity()) AddBlock();
      std::vector<char>& last = blocks_.back();
      const size_t part = std::min(size, last.capacity() - last.size());
      last.insert(last.end(), at, at + part);
      size_ += part;
      size -= part;
      at += part;
    }
  }

  /// Takes the blocks, and copies no byte.
  void Append(ByteBlocks other) {
    size_ += other.size_;
    blocks_.insert(blocks_.end(), std::make_move_iterator(other.blocks_.begin()),
                   std::make_move_iterator(other.blocks_.end()));
  }

  /// Empties it. Without copies of `text` where that has reserved enough.
  void MoveTo(std::string* text) {
    for (std::vector<char>& block : blocks_) {
      text->append(block.data(), block.size());
      block = std::vector<char>();
    }
    blocks_.clear();
    size_ = 0;
  }

  size_t size() const { return size_; }

 private:
  /// Each doubles what there is. From 32 MiB on glibc takes blocks from the system and gives them
  /// back to it one by one; what is not yet filled costs no memory.
  void AddBlock() {
    constexpr size_t kLeast = 256, kMost = size_t{64} << 20;
    blocks_.emplace_back().reserve(std::clamp(size_, kLeast, kMost));
  }

  std::vector<std::vector<char>> blocks_;
  size_t size_ = 0;
};

}  // namespace parti::app
