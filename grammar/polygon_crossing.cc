#include "grammar/polygon_crossing.h"

#include <algorithm>

namespace parti::grammar {
namespace {

struct Edge {
  Vec2 a, b;
  size_t ring, index, count;  ///< count: edges in its ring
  double low_x() const { return std::min(a.x, b.x); }
  double high_x() const { return std::max(a.x, b.x); }
};

Vec2 NearestOn(const Edge& edge, const Vec2& p) {
  const Vec2 d = edge.b - edge.a;
  const double t = std::clamp(glm::dot(p - edge.a, d) / glm::dot(d, d), 0.0, 1.0);
  return edge.a + d * t;
}

bool AreNeighbours(const Edge& e, const Edge& f) {
  return e.ring == f.ring &&
         ((e.index + 1) % e.count == f.index || (f.index + 1) % f.count == e.index);
}

/// Where e's inside and f's inside cross properly.
std::optional<Vec2> Crossing(const Edge& e, const Edge& f) {
  const Vec2 d = e.b - e.a;
  const double fa = Cross(d, f.a - e.a), fb = Cross(d, f.b - e.a);
  const Vec2 g = f.b - f.a;
  const double ea = Cross(g, e.a - f.a), eb = Cross(g, e.b - f.a);
  if ((fa > 0) == (fb > 0) || (ea > 0) == (eb > 0)) return std::nullopt;
  return f.a + g * (fa / (fa - fb));
}

/// Where an end of one edge lies on the other. Of neighbours, the corner they share is left out.
std::optional<Vec2> Touch(const Edge& e, const Edge& f, double tolerance) {
  const bool e_before_f = AreNeighbours(e, f) && (e.index + 1) % e.count == f.index;
  const bool f_before_e = AreNeighbours(e, f) && !e_before_f;
  const auto touches = [&](const Edge& edge, const Vec2& p) {
    return glm::distance(NearestOn(edge, p), p) <= tolerance;
  };
  if (!f_before_e && touches(f, e.a)) return e.a;
  if (!e_before_f && touches(f, e.b)) return e.b;
  if (!e_before_f && touches(e, f.a)) return f.a;
  if (!f_before_e && touches(e, f.b)) return f.b;
  return std::nullopt;
}

std::optional<Contact> ContactOf(const Edge& e, const Edge& f, double tolerance) {
  Contact contact{e.ring, e.index, f.ring, f.index, {}, false};
  if (const auto at = Touch(e, f, tolerance)) {
    contact.at = *at;
    return contact;
  }
  if (AreNeighbours(e, f)) return std::nullopt;
  const auto at = Crossing(e, f);
  if (!at) return std::nullopt;
  contact.at = *at;
  contact.crosses = true;
  return contact;
}

std::vector<Edge> EdgesOf(const std::vector<Ring>& rings) {
  std::vector<Edge> edges;
  for (size_t r = 0; r < rings.size(); ++r) {
    const size_t n = rings[r].size();
    for (size_t i = 0; i < n; ++i) edges.push_back({rings[r][i], rings[r][(i + 1) % n], r, i, n});
  }
  std::stable_sort(edges.begin(), edges.end(),
                   [](const Edge& e, const Edge& f) { return e.low_x() < f.low_x(); });
  return edges;
}

}  // namespace

std::optional<Contact> FindContact(const std::vector<Ring>& rings, double tolerance_m) {
  const std::vector<Edge> edges = EdgesOf(rings);
  std::vector<size_t> open;  // edges that reach to the right of the current one's left end
  std::optional<Contact> touch;
  for (size_t i = 0; i < edges.size(); ++i) {
    const Edge& e = edges[i];
    std::erase_if(open, [&](size_t j) { return edges[j].high_x() < e.low_x() - tolerance_m; });
    for (const size_t j : open) {
      const Edge& f = edges[j];
      if (std::max(e.a.y, e.b.y) < std::min(f.a.y, f.b.y) - tolerance_m) continue;
      if (std::max(f.a.y, f.b.y) < std::min(e.a.y, e.b.y) - tolerance_m) continue;
      const auto contact = ContactOf(f, e, tolerance_m);
      if (contact && contact->crosses) return contact;
      if (contact && !touch) touch = contact;
    }
    open.push_back(i);
  }
  return touch;
}

}  // namespace parti::grammar
