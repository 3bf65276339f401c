#include "app/node_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace parti::app {
namespace {

/// Whether both stand in the same list, `path` or what it is below at or behind `place`.
bool IsShiftedBy(const NodePath& path, const NodePath& place) {
  const size_t last = place.size() - 1;
  return path.size() > last && std::equal(place.begin(), place.end() - 1, path.begin()) &&
         path[last] >= place[last];
}

}  // namespace

Result<NodePath> ParseNodePath(std::string_view text) {
  NodePath path;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (true) {
    int number = 0;
    const auto [next, code] = std::from_chars(at, end, number);
    if (code != std::errc() || number < 0) break;
    path.push_back(number);
    if (next == end) return path;
    if (*next != '/') break;
    at = next + 1;
  }
  return Fail(ErrorCode::kBadText, fmt::format("'{}' is not the path of a node", text),
              "a tree and its nodes, from 0: 0/2/1");
}

std::string PathText(const NodePath& path) { return fmt::format("{}", fmt::join(path, "/")); }

bool IsAtOrBelow(const NodePath& path, const NodePath& above) {
  return path.size() >= above.size() && std::equal(above.begin(), above.end(), path.begin());
}

std::optional<NodePath> PathAfterRemoval(NodePath path, const NodePath& removed) {
  if (IsAtOrBelow(path, removed)) return std::nullopt;
  if (IsShiftedBy(path, removed)) --path[removed.size() - 1];
  return path;
}

NodePath PathAfterInsertion(NodePath path, const NodePath& inserted) {
  if (IsShiftedBy(path, inserted)) ++path[inserted.size() - 1];
  return path;
}

}  // namespace parti::app
