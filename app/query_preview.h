// Which shapes a query would select, as outlines: found beside the pen while a card is hovered.
// Which queries are offered is grammar/generalise.h's.
#pragma once

#include <memory>
#include <optional>

#include "app/latest_worker.h"
#include "app/overlay.h"
#include "app/session_state.h"

namespace parti::app {

/// A query of a state's Selection::candidates, by its index.
struct QueryPreview {
  std::shared_ptr<const SessionState> state;
  size_t candidate = 0;
  bool operator==(const QueryPreview&) const = default;
};

/// Outlines of what it selects, of the first kMostOutlined shapes; none where there is no such
/// candidate. cost  that of the query, once for each lot.
WorldMarks OutlinesOf(const QueryPreview& preview, const DrawingStyle& style = {});
inline constexpr size_t kMostOutlined = 3000;

/// Used by the thread that draws; owns one that looks for the shapes.
class QueryPreviews {
 public:
  /// The candidate to show in a state; nothing: none. Whether it is another one now.
  bool Set(std::optional<size_t> candidate, const std::shared_ptr<const SessionState>& state);
  /// What has been found of it; null while it is looked for.
  const WorldMarks* marks();
  bool busy() const { return worker_.busy(); }
  const WakeFd& ready() const { return worker_.ready(); }  ///< woken by each answer

 private:
  struct Found {
    QueryPreview preview;
    WorldMarks marks;
  };
  std::optional<QueryPreview> shown_;
  std::shared_ptr<const Found> found_;
  LatestWorker<QueryPreview, std::shared_ptr<const Found>> worker_{[](const QueryPreview& preview) {
    return std::make_shared<const Found>(Found{preview, OutlinesOf(preview)});
  }};
};

}  // namespace parti::app
