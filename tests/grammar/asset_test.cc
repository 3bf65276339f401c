// Assets: read from OBJ and glTF, whole and damaged; inserted and fitted.
#include "grammar/asset.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <set>

#include "base/random.h"
#include "base/text_file.h"
#include "grammar/action_text.h"
#include "grammar/asset_library.h"
#include "grammar/item_surface.h"
#include "tests/grammar/geometry_support.h"

namespace parti::grammar::tests {
namespace {

using testing::HasSubstr;

const std::string kModels = std::string(PARTI_SOURCE_DIR) + "/assets/models/";

Result<std::string> FromModels(const std::string& name) { return ReadFile(kModels + name); }
Result<std::string> NoFile(const std::string& name) {
  return Fail(ErrorCode::kFile, name + " is not there");
}

Asset Model(const std::string& name) {
  const auto bytes = FromModels(name);
  EXPECT_TRUE(bytes) << name;
  auto asset = AssetFrom(*bytes, name, FromModels);
  EXPECT_TRUE(asset) << FormatError(asset.error());
  return std::move(*asset);
}

Error ObjError(const std::string& text) {
  const auto asset = AssetFromObj(text, "x.obj", NoFile);
  EXPECT_FALSE(asset) << text;
  return asset ? Error{ErrorCode::kBadText, ""} : asset.error();
}

/// i(file) on an item, with what the models' folder holds.
Item Insert(const std::string& text, const Item& item) {
  auto action = ParseAction(text);
  EXPECT_TRUE(action) << FormatError(action.error());
  AssetLibrary library(FromModels);
  const auto resolved = ResolveAssets("", &library, &*action);
  EXPECT_TRUE(resolved) << FormatError(resolved.error());
  const auto products = Apply(*action, item);
  EXPECT_TRUE(products) << FormatError(products.error());
  return products->front().item;
}

Item Facade() {
  const Item mass = Apply(Extrude(3), Lot("0,0 10,0 10,8 0,8"))->front().item;
  return FacesOf(mass)[2];
}

TEST(Asset, WindowHasItsMaterialsInMetres) {
  const Asset window = Model("window.obj");
  EXPECT_NEAR(window.size.x, 1.32, 1e-9);
  EXPECT_NEAR(window.low.x, -0.06, 1e-9);
  std::set<std::string> names;
  for (const Paint& paint : window.mesh->paints) names.insert(paint.material->name);
  EXPECT_EQ(names, (std::set<std::string>{"frame", "glass", "sill"}));
  EXPECT_FALSE(window.mesh->closed) << "panes are single faces";
}

TEST(Asset, DoorWearsItsImage) {
  const Asset door = Model("door.gltf");
  int wooden = 0;
  for (const Paint& paint : door.mesh->paints) {
    if (!paint.material->image) continue;
    ++wooden;
    EXPECT_EQ(paint.material->image->name, "planks.png");
    EXPECT_TRUE(paint.map);
  }
  EXPECT_GT(wooden, 0);
}

TEST(Asset, BalconyOfClosedBodiesIsClosed) {
  const Asset balcony = Model("balcony.glb");
  EXPECT_NEAR(balcony.size.y, 1.1, 1e-6);
  EXPECT_TRUE(balcony.mesh->closed);
  EXPECT_GT(balcony.mesh->faces.size(), 100u);
}

TEST(Asset, QuadsOfAnObjStayWholeAndConcaveOnesAreCovered) {
  const auto quad = AssetFromObj("v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nf 1 2 3 4\n", "q", NoFile);
  ASSERT_TRUE(quad);
  EXPECT_EQ(quad->mesh->faces.size(), 1u);
  EXPECT_EQ(quad->size, Vec3(2, 1, 0));
  const auto ell = AssetFromObj(
      "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nf -6 -5 -4 -3 -2 -1\n", "l", NoFile);
  ASSERT_TRUE(ell);
  Item item = Facade();
  item.type = ItemType::kVolume;
  item.mesh = ell->mesh;
  item.mesh_is_unit = true;
  item.scope.size = Vec3(2, 2, 0);
  EXPECT_NEAR(AreaOf(item), 3, 1e-9);
}

TEST(Asset, TwistedQuadsBecomeTriangles) {
  const auto quad = AssetFromObj("v 0 0 0\nv 2 0 0\nv 2 1 1\nv 0 1 0\nf 1 2 3 4\n", "q", NoFile);
  ASSERT_TRUE(quad);
  EXPECT_EQ(quad->mesh->faces.size(), 2u);
}

TEST(Asset, DamagedObjSaysWhereAndWhy) {
  EXPECT_EQ(ObjError("v 0 0\n").code, ErrorCode::kDamagedFile);
  const Error bad = ObjError("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
  EXPECT_EQ(bad.code, ErrorCode::kDamagedFile);
  ASSERT_TRUE(bad.place);
  EXPECT_EQ(bad.place->line, 4);
  EXPECT_EQ(ObjError("v 0 0 zero\n").place->line, 1);
  EXPECT_EQ(ObjError("f 1 2 3\n").code, ErrorCode::kDamagedFile);
  EXPECT_EQ(ObjError("f 0 0 0\n").code, ErrorCode::kDamagedFile);
  EXPECT_EQ(ObjError("").code, ErrorCode::kDamagedFile);
  EXPECT_EQ(ObjError("mtllib gone.mtl\n").code, ErrorCode::kFile);
  EXPECT_EQ(ObjError("v 0 0 0\nv 0 0 0\nv 0 0 0\nf 1 2 3\n").code, ErrorCode::kDamagedFile);
  EXPECT_EQ(ObjError("v nan 0 0\n").code, ErrorCode::kDamagedFile);
}

TEST(Asset, UnknownEndingsAndDamagedImagesAreRefused) {
  EXPECT_EQ(AssetFrom("x", "a.fbx", NoFile).error().code, ErrorCode::kUnknownName);
  EXPECT_EQ(AssetFrom("x", "a.png", NoFile).error().code, ErrorCode::kDamagedFile);
  const std::string png = *FromModels("bricks.png");
  EXPECT_TRUE(AssetFrom(png, "bricks.png", NoFile));
  EXPECT_THAT(AssetFrom(png.substr(0, 100), "bricks.png", NoFile).error().message,
              HasSubstr("cut short"));
}

TEST(Asset, MissingImageOfAGltfIsNamed) {
  const auto asset = AssetFromGltf(*FromModels("door.gltf"), "door.gltf", NoFile);
  ASSERT_FALSE(asset);
  EXPECT_EQ(asset.error().code, ErrorCode::kFile);
  EXPECT_THAT(asset.error().message, HasSubstr("planks.png"));
}

/// What is cut short anywhere is an error or an asset, never a crash.
class AssetCut : public testing::TestWithParam<const char*> {};

TEST_P(AssetCut, NeverCrashes) {
  const std::string bytes = *FromModels(GetParam());
  for (size_t length = 0; length < bytes.size(); length += 1 + bytes.size() / 200) {
    const auto asset = AssetFrom(bytes.substr(0, length), GetParam(), FromModels);
    EXPECT_TRUE(asset || !asset.error().message.empty());
  }
}

TEST_P(AssetCut, NeverCrashesWhereBytesAreChanged) {
  Random random(7);
  const std::string bytes = *FromModels(GetParam());
  for (int run = 0; run < 200; ++run) {
    std::string damaged = bytes;
    for (int i = 0; i < 3; ++i) {
      const auto at = static_cast<size_t>(random.Uniform(0, static_cast<double>(bytes.size())));
      damaged[std::min(at, bytes.size() - 1)] = static_cast<char>(random.Uniform(0, 255));
    }
    const auto asset = AssetFrom(damaged, GetParam(), FromModels);
    if (!asset) continue;
    for (const Vec3& p : asset->mesh->points) EXPECT_TRUE(IsFinite(p));
  }
}

INSTANTIATE_TEST_SUITE_P(Models, AssetCut,
                         testing::Values("window.obj", "door.gltf", "balcony.glb"));

TEST(AssetLibrary, ReadsEachFileOnceAndSharesIt) {
  std::atomic<int> reads = 0;
  AssetLibrary library([&](const std::string& name) {
    ++reads;
    return FromModels(name);
  });
  const auto first = library.Get("balcony.glb"), second = library.Get("balcony.glb");
  ASSERT_TRUE(first);
  EXPECT_EQ(*first, *second);
  EXPECT_EQ(reads, 1);
  EXPECT_FALSE(library.Get("gone.obj"));
  EXPECT_FALSE(library.Get("gone.obj"));
  EXPECT_EQ(reads, 2) << "failures are kept, too";
}

TEST(AssetLibrary, FindsFilesBesideTheRulesAndBesideTheAsset) {
  EXPECT_EQ(PathBeside("rules/a", "b.obj"), "rules/a/b.obj");
  EXPECT_EQ(PathBeside("", "b.obj"), "b.obj");
  EXPECT_EQ(PathBeside("rules", "/b.obj"), "/b.obj");
  AssetLibrary library(ReadFile);
  auto action = *ParseAction("split(x) { 1: tag(\"a\") A }");
  EXPECT_TRUE(ResolveAssets(kModels, &library, &action));
  auto insert = *ParseAction("i(\"models/window.obj\") Window");
  ASSERT_TRUE(ResolveAssets(std::string(PARTI_SOURCE_DIR) + "/assets", &library, &insert));
  EXPECT_TRUE(insert.asset->mesh);
}

TEST(AssetLibrary, LooksInTheFoldersAboveTheNearestFirst) {
  const auto near = PathsFor("a/b", "x.obj");
  ASSERT_EQ(near.size(), kMostFolders);
  EXPECT_THAT(std::vector(near.begin(), near.begin() + 5),
              testing::ElementsAre("a/b/x.obj", "a/x.obj", "x.obj", "../x.obj", "../../x.obj"));
  EXPECT_THAT(PathsFor("/a/b", "c/x.obj"),
              testing::ElementsAre("/a/b/c/x.obj", "/a/c/x.obj", "/c/x.obj"));
  EXPECT_THAT(PathsFor("/", "x.obj"), testing::ElementsAre("/x.obj"));
  EXPECT_EQ(PathsFor("..", "x.obj").at(1), "../../x.obj");
  EXPECT_THAT(PathsFor("/a/b", "/x.obj"),
              testing::ElementsAre("/x.obj", "/a/b/x.obj", "/a/x.obj", "/x.obj"));
}

TEST(AssetLibrary, AssetsOfAFolderAboveAreFound) {
  AssetLibrary library(ReadFile);
  auto insert = *ParseAction("i(\"models/window.obj\") Window");
  const std::string deep = std::string(PARTI_SOURCE_DIR) + "/assets/models/rules/houses";
  ASSERT_TRUE(ResolveAssets(deep, &library, &insert));
  EXPECT_TRUE(insert.asset->mesh);
  auto missing = *ParseAction("i(\"nowhere.obj\") Window");
  const auto failed = ResolveAssets(deep, &library, &missing);
  ASSERT_FALSE(failed);
  EXPECT_THAT(failed.error().message, HasSubstr(deep + "/nowhere.obj"));
}

TEST(AssetLibrary, ADamagedAssetIsNotPassedOver) {
  AssetLibrary library([](const std::string& path) -> Result<std::string> {
    return path == "rules/a.obj" ? "f 1 2 9\n" : "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  });
  auto insert = *ParseAction("i(\"a.obj\") A");
  EXPECT_FALSE(ResolveAssets("rules", &library, &insert));
  EXPECT_TRUE(ResolveAssets("", &library, &insert));
}

TEST(Insert, CityEnginesCubesNeedNoFile) {
  const Item lot = Lot("0,0 10,0 10,8 0,8");
  const Item mass = Apply(Extrude(3), lot)->front().item;
  for (const char* text : {R"~(i("builtin:cube") A)~", R"~(i("builtin:cube:notex") A)~"}) {
    auto insert = *ParseAction(text);
    AssetLibrary library(NoFile);
    const auto resolved = ResolveAssets("rules", &library, &insert);
    ASSERT_TRUE(resolved) << FormatError(resolved.error());
    const Item box = Apply(insert, mass)->front().item;
    EXPECT_EQ(FacesOf(box).size(), 6u) << text;
    EXPECT_NEAR(box.scope.size.x * box.scope.size.y * box.scope.size.z, 240, 1e-9);
    EXPECT_NEAR(Apply(insert, lot)->front().item.scope.size.y, 9, 1e-9)
        << "its own proportions, by the mean of the others";
  }
  AssetLibrary library(NoFile);
  auto other = *ParseAction("i(\"builtin:cub\") A");
  const auto refused = ResolveAssets("", &library, &other);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kUnknownName);
  EXPECT_THAT(refused.error().hint, HasSubstr("builtin:cube"));
}

TEST(Insert, FillsTheScopeAndStretchesItsDepth) {
  const Item window = Insert("i(\"window.obj\") W", Facade());
  EXPECT_EQ(window.type, ItemType::kVolume);
  EXPECT_NEAR(window.scope.size.x, 10, 1e-9);
  EXPECT_NEAR(window.scope.size.y, 3, 1e-9);
  const Asset asset = Model("window.obj");
  const double scale = (10 / asset.size.x + 3 / asset.size.y) / 2;
  EXPECT_NEAR(window.scope.size.z, asset.size.z * scale, 1e-9);
  const double wall = Facade().scope.ToLocal(window.scope.origin).z;
  EXPECT_NEAR(wall, asset.low.z * scale, 1e-9) << "its z = 0 lies in the wall";
}

TEST(Insert, KeepsItsOwnSizeWhereTheScopeHasNone) {
  const Asset asset = Model("balcony.glb");
  const Item kept = Insert("i(\"balcony.glb\", yUp, keepSizeAndPosition) B", Facade());
  EXPECT_NEAR(glm::distance(kept.scope.size, asset.size), 0, 1e-9);
  const Item aligned = Insert("i(\"balcony.glb\", yUp, keepSizeAlignPosition) B", Facade());
  EXPECT_NEAR(glm::distance(aligned.scope.size, asset.size), 0, 1e-9);
  const double middle = Facade().scope.ToLocal(aligned.scope.origin).x + asset.size.x / 2;
  EXPECT_NEAR(middle, 5, 1e-9);
}

TEST(Insert, StandsUprightOnALot) {
  const Item lot = Lot("0,0 10,0 10,8 0,8");
  const Item door = Insert("i(\"door.gltf\") D", lot);
  EXPECT_NEAR(door.scope.y.y, 1, 1e-12);
  EXPECT_NEAR(door.scope.size.x, 10, 1e-9);
  EXPECT_NEAR(door.scope.size.z, 8, 1e-9);
}

TEST(Insert, TurnsWhatHasItsZUp) {
  const Asset asset = Model("balcony.glb");
  const Item turned = Insert("i(\"balcony.glb\", zUp, keepSizeAndPosition) B", Facade());
  EXPECT_NEAR(turned.scope.size.y, asset.size.z, 1e-9);
  EXPECT_NEAR(turned.scope.size.z, asset.size.y, 1e-9);
  EXPECT_EQ(turned.mesh->closed, asset.mesh->closed);
  EXPECT_NEAR(AreaOf(turned),
              AreaOf(Insert("i(\"balcony.glb\", yUp, keepSizeAndPosition) B", Facade())), 1e-9);
}

TEST(Insert, SharesOneMeshAmongAllOfItsItems) {
  auto action = *ParseAction("i(\"window.obj\") W");
  AssetLibrary library(FromModels);
  ASSERT_TRUE(ResolveAssets("", &library, &action));
  const Item a = Apply(action, Facade())->front().item;
  const Item b = Apply(action, Lot("0,0 3,0 3,2 0,2"))->front().item;
  EXPECT_EQ(a.mesh, b.mesh);
}

TEST(Insert, CanBeSplitAndTakenApart) {
  const Item window = Insert("i(\"window.obj\") W", Facade());
  const auto halves = Apply(*ParseAction("split(x) { ~1: A | ~1: B }"), window);
  ASSERT_TRUE(halves);
  ASSERT_EQ(halves->size(), 2u);
  EXPECT_NEAR(AreaOf((*halves)[0].item) + AreaOf((*halves)[1].item), AreaOf(window), 1e-6);
  const auto faces = Apply(*ParseAction("comp(f) { all: F }"), window);
  ASSERT_TRUE(faces);
  double area = 0;
  for (const Product& p : *faces) area += AreaOf(p.item);
  EXPECT_NEAR(area, AreaOf(window), 1e-6);
}

TEST(Insert, WithoutItsFileSaysSo) {
  const auto failed = Apply(*ParseAction("i(\"window.obj\") W"), Facade());
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().code, ErrorCode::kFile);
  EXPECT_THAT(failed.error().message, HasSubstr("window.obj"));
}

}  // namespace
}  // namespace parti::grammar::tests
