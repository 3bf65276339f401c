// Which shapes a query selects, as outlines: of one whose card is hovered, or that the next sketch
// acts on. Found beside the thread that draws. Which query that is, the application says.
#pragma once

#include <memory>
#include <optional>

#include "app/latest_worker.h"
#include "app/overlay.h"
#include "app/session_state.h"

namespace parti::app {

/// A query, and a state with the model that it selects from; not null.
struct QueryPreview {
  std::shared_ptr<const SessionState> state;
  grammar::Query query;
  /// What is drawn or looked at on the same model changes nothing.
  bool operator==(const QueryPreview& other) const;
};

/// Outlines of what it selects, of the first kMostOutlined shapes.
/// cost  that of the query, once for each lot.
WorldMarks OutlinesOf(const QueryPreview& preview, const DrawingStyle& style = {});
inline constexpr size_t kMostOutlined = 3000;

/// Used by the thread that draws; owns one that looks for the shapes.
class QueryPreviews {
 public:
  /// The query to show in a state; nothing: none. Whether that shows something else now.
  bool Set(std::optional<grammar::Query> query, const std::shared_ptr<const SessionState>& state);
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
