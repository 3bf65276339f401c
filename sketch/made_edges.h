// The edges of an operation's products: what a drawn line can stand for.
// Edges lie in the world and know nothing of views; line_match.h compares them with drawn lines.
#pragma once

#include <vector>

#include "base/error.h"
#include "base/math.h"
#include "grammar/action.h"
#include "grammar/item.h"

namespace parti::sketch {

/// Edges of all products, in the order of creation; those shared by two products come twice.
/// errors  those of grammar::Apply;  kNothingMade  the product is the item as it was.
Result<std::vector<Segment3>> AllEdges(const grammar::Action& action, const grammar::Item& item);

/// What an operation is recognised by: the edges of its products that do not lie on edges of the
/// item; all of them where it makes no others (comp). Repeated edges come once with `distinct`.
class MadeEdges {
 public:
  explicit MadeEdges(const grammar::Item& item);

  /// errors  those of AllEdges.
  Result<std::vector<Segment3>> Of(const grammar::Action& action, bool distinct = false) const;

  /// Whether the edge lies on the item: on a planar item in its plane and within its scope; always
  /// for volumes, which operations only divide.
  bool IsOnItem(const Segment3& edge) const;

  const grammar::Item& item() const { return *item_; }
  double diagonal_m() const { return diagonal_m_; }
  const std::vector<Segment3>& item_edges() const { return item_edges_; }

 private:
  // An edge of the item, ready for distances; asked for every edge that is ever made.
  struct Ray {
    Vec3 from, along;
    double per_squared;  // 1 / its squared length; 0 for one of no length
  };

  bool LiesOnItem(const Segment3& edge) const;

  const grammar::Item* item_;
  std::vector<Segment3> item_edges_;
  std::vector<Ray> rays_;
  double diagonal_m_ = 0;
  double tolerance_m_ = 0;
};

/// Diagonal of the item's scope [m].
double DiagonalOf(const grammar::Item& item);

}  // namespace parti::sketch
