// comp(e), comp(fe), comp(v), CGA's selectors beyond the six sides, and what is put on the parts.
#include <gtest/gtest.h>

#include "grammar/action_text.h"
#include "tests/grammar/geometry_support.h"

namespace parti::grammar::tests {
namespace {

std::vector<Product> Parts(const std::string& text, const Item& item) {
  const auto action = ParseAction(text);
  EXPECT_TRUE(action) << FormatError(action.error());
  const auto products = Apply(*action, item);
  EXPECT_TRUE(products) << FormatError(products.error());
  return *products;
}

Item Mass() { return Apply(Extrude(3), Lot("0,0 10,0 10,8 0,8"))->front().item; }

/// A saddle roof over 10 x 8 m with its ridge along x, 3 m up, on walls of 1 m.
Item Saddle() {
  Item item = Mass();
  item.scope.size.y = 4;
  Mesh mesh;
  mesh.points = {{0, 0, 8},  {10, 0, 8}, {10, 0, 0}, {0, 0, 0}, {0, 1, 8},
                 {10, 1, 8}, {10, 1, 0}, {0, 1, 0},  {0, 4, 4}, {10, 4, 4}};
  mesh.faces = {{{0, 3, 2, 1}, {}, 0}, {{0, 1, 5, 4}, {}, 0},    {{1, 2, 6, 9, 5}, {}, 0},
                {{2, 3, 7, 6}, {}, 0}, {{3, 0, 4, 8, 7}, {}, 0}, {{4, 5, 9, 8}, {}, 0},
                {{6, 7, 8, 9}, {}, 0}};
  EXPECT_TRUE(IsClosed(mesh));
  item.mesh = std::make_shared<const Mesh>(std::move(mesh));
  return item;
}

TEST(CompEdges, AreLinesAlongTheirScopesX) {
  const auto edges = Parts("comp(e) { all: Edge }", Mass());
  ASSERT_EQ(edges.size(), 12u);
  for (const Product& p : edges) {
    const Scope& s = p.item.scope;
    EXPECT_EQ(p.item.type, ItemType::kEdge);
    EXPECT_GT(s.size.x, 0);
    EXPECT_EQ(Vec2(s.size.y, s.size.z), Vec2(0, 0));
    EXPECT_NEAR(glm::dot(glm::cross(s.x, s.y), s.z), 1, 1e-12);
    EXPECT_EQ(EdgesOf(p.item).size(), 1u);
    EXPECT_EQ(AreaOf(p.item), 0);
    EXPECT_TRUE(FacesOf(p.item).empty());
  }
}

TEST(CompEdges, OfAPlanarShapeFaceOutward) {
  const auto edges = Parts("comp(e) { front: Front | back: NIL | side: Side }", Mass());
  EXPECT_FALSE(edges.empty());
  const auto lot = Parts("comp(e) { front: Front | side: Side }", Lot("0,0 10,0 10,8 0,8"));
  ASSERT_EQ(lot.size(), 4u);
  EXPECT_EQ(lot[0].successor, 0);
  EXPECT_NEAR(glm::distance(lot[0].item.facing, Vec3(0, 0, 1)), 0, 1e-12);
  EXPECT_NEAR(glm::distance(lot[0].item.scope.y, Vec3(0, 1, 0)), 0, 1e-12);
  EXPECT_NEAR(glm::distance(lot[0].item.scope.z, lot[0].item.facing), 0, 1e-12);
}

TEST(CompEdges, KnowRoofs) {
  const Item roof = Saddle();
  EXPECT_EQ(Parts("comp(e) { ridge: R }", roof).size(), 1u);
  EXPECT_EQ(Parts("comp(e) { eave: E }", roof).size(), 2u);
  EXPECT_EQ(Parts("comp(e) { hip: H }", roof).size(), 0u);
  EXPECT_EQ(Parts("comp(e) { valley: V }", roof).size(), 0u);
  EXPECT_EQ(Parts("comp(f) { aslant: Slope }", roof).size(), 2u);
}

TEST(CompFaceEdges, GiveEachFaceItsOwn) {
  EXPECT_EQ(Parts("comp(fe) { all: E }", Mass()).size(), 24u);
}

TEST(CompCorners, ArePointsInTheShapesAxes) {
  const auto corners = Parts("comp(v) { top: Top | bottom: Bottom }", Mass());
  ASSERT_EQ(corners.size(), 0u) << "corners of a box look 35 degrees up, which is a side";
  const auto all = Parts("comp(v) { all: Corner }", Mass());
  ASSERT_EQ(all.size(), 8u);
  EXPECT_EQ(all[0].item.type, ItemType::kPoint);
  EXPECT_EQ(all[0].item.scope.size, Vec3(0, 0, 0));
  EXPECT_TRUE(EdgesOf(all[0].item).empty());
}

TEST(CompSelectors, KnowTheWorldAndTheStreet) {
  Item lot = Lot("0,0 10,0 10,8 0,8");
  lot.street_deg = 90.0f;  // to the east
  const Item mass = Apply(Extrude(3), lot)->front().item;
  const auto parts =
      Parts("comp(f) { street.front: Front | street.side: Other | world.up: Roof }", mass);
  ASSERT_EQ(parts.size(), 5u);
  int fronts = 0;
  for (const Product& p : parts) {
    if (p.successor != 0) continue;
    ++fronts;
    EXPECT_NEAR(glm::distance(p.item.facing, Vec3(1, 0, 0)), 0, 1e-9);
  }
  EXPECT_EQ(fronts, 1);
  EXPECT_EQ(Parts("comp(f) { world.south: A }", mass).size(), 1u);
}

TEST(CompSelectors, OfTheStreetGoByTheLongestSideWhereNoneIsKnown) {
  const Item mass = Apply(Extrude(3), Lot("0,0 8,0 8,20 0,20"))->front().item;
  const auto parts = Parts("comp(f) { street.front: Front }", mass);
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_NEAR(parts[0].item.scope.size.x, 20, 1e-9);
}

TEST(CompEdges, CarryWhatIsPutThere) {
  const Item edge = Parts("comp(e) { 2: E }", Mass()).front().item;
  const auto thick = Apply(*ParseAction("s('1, 0.1, 0.1)"), edge);
  ASSERT_TRUE(thick);
  EXPECT_EQ(thick->front().item.type, ItemType::kEdge);
  const auto beam = Apply(*ParseAction("primitiveCube() Beam"), thick->front().item);
  ASSERT_TRUE(beam);
  EXPECT_EQ(beam->front().item.type, ItemType::kVolume);
  EXPECT_NEAR(VolumeOf(beam->front().item), edge.scope.size.x * 0.01, 1e-9);
  const auto posts = Apply(*ParseAction("split(x) { ~2: Post }*"), edge);
  ASSERT_TRUE(posts);
  EXPECT_EQ(posts->size(), 5u);
  EXPECT_EQ(posts->front().item.type, ItemType::kEdge);
}

TEST(CompEdges, RefuseWhatNeedsASurface) {
  const Item edge = Parts("comp(e) { 0: E }", Mass()).front().item;
  const auto failed = Apply(*ParseAction("extrude(2) A"), edge);
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().code, ErrorCode::kWrongItemType);
  EXPECT_NE(failed.error().message.find("Edge"), std::string::npos);
}

}  // namespace
}  // namespace parti::grammar::tests
