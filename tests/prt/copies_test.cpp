// Copies of nodes share a tree: which nodes count as copies, and that rays meet the same surfaces by them.
#include "prt/rays/copies.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "prt/mesh/corners.hpp"
#include "prt/rays/gather.hpp"
#include "prt/rays/tracer.hpp"
#include "prt/scene/scene.hpp"
#include "tests/prt/meshes.hpp"
#include "tests/prt/scene_of_json.hpp"

namespace sh::prt::test {
namespace {

constexpr std::size_t kAny = 1;

// One torus of 1,152 faces in each of these places.
Mesh tori(const std::vector<std::string>& places, const std::string& more = "") {
  std::string meshes;
  for (const std::string& place : places) {
    meshes += meshes.empty() ? "" : ", ";
    meshes += R"({"primitive": "torus", "segments": 32, "transform": {)" + place + "}" + more + "}";
  }
  return scene_of_json(meshes).mesh;
}

std::size_t shared_of(const Mesh& mesh) { return Tracer(mesh, 1, "", kAny).shared_faces(); }

struct Found {
  std::size_t met = 0;
  std::size_t others = 0;  // rays that meet another face
};

// Rays through the mesh from around it, by a tree of all faces and by shared ones.
Found compare_hits(const Mesh& mesh) {
  const Tracer alone(mesh, 1);
  const Tracer shared(mesh, 1, "", kAny);
  EXPECT_EQ(alone.shared_faces(), 0U);
  EXPECT_GT(shared.shared_faces(), 0U);
  const Eigen::AlignedBox3f box = bounding_box(mesh.positions);
  const float size = box.diagonal().norm();
  std::mt19937 engine(3);
  std::uniform_real_distribution<float> number(-1.0F, 1.0F);
  const auto place = [&] { return Eigen::Vector3f(number(engine), number(engine), number(engine)); };
  std::vector<Eigen::Vector3f> origins;
  std::vector<Eigen::Vector3f> directions;
  for (int k = 0; k < 20'000; ++k) {
    origins.emplace_back(box.center() + size * place().normalized());
    const Eigen::Vector3f target = box.center() + 0.5F * box.sizes().cwiseProduct(place());
    directions.push_back((target - origins.back()).normalized());
  }
  std::vector<Hit> hits(origins.size());
  std::vector<Hit> expected(origins.size());
  shared.intersect(origins, directions, hits);
  alone.intersect(origins, directions, expected);
  std::vector<ShadowRay> rays(origins.size());
  for (std::size_t k = 0; k < rays.size(); ++k) rays[k].aim(origins[k], directions[k]);
  shared.occluded(rays);
  Found found;
  for (std::size_t k = 0; k < hits.size(); ++k) {
    EXPECT_EQ(rays[k].blocked(), hits[k].face != Hit::kNothing);
    found.met += expected[k].face != Hit::kNothing ? 1 : 0;
    found.others += hits[k].face != expected[k].face ? 1 : 0;
    if (hits[k].face == Hit::kNothing || hits[k].face != expected[k].face) continue;
    EXPECT_EQ(hits[k].from_behind, expected[k].from_behind);
    EXPECT_LT((interpolated(hits[k], mesh, mesh.positions) - interpolated(expected[k], mesh, mesh.positions)).norm(),
              2e-5F * size);
    EXPECT_NEAR(hits[k].distance, expected[k].distance, 2e-5F * size);
  }
  return found;
}

TEST(Copies, AreNodesOfOneShapeMovedTurnedAndScaled) {
  const std::string here = R"("translate": [0, 0, 0])";
  const std::string turned = R"("translate": [3, 0, 1], "rotate": {"axis": [1, 2, 3], "degrees": 77})";
  EXPECT_EQ(shared_of(tori({here})), 0U);
  const std::size_t faces = tori({here}).faces.size();
  ASSERT_GE(faces, 1024U);
  EXPECT_EQ(shared_of(tori({here, turned})), faces);
  EXPECT_EQ(shared_of(tori({here, turned, R"("translate": [0, 3, 0], "scale": 0.01)"})), 2 * faces);
  EXPECT_EQ(shared_of(tori({here, R"("translate": [0, 3, 0], "scale": [1, 2, 0.5])"})), faces);
  EXPECT_EQ(shared_of(tori({here, R"("translate": [0, 3, 0], "scale": [1, -1, 1])"})), 0U) << "a mirror image";
  EXPECT_EQ(shared_of(tori({R"("scale": [1, -1, 1])", R"("translate": [0, 3, 0], "scale": [1, -1, 1])"})), faces);
  EXPECT_EQ(shared_of(tori({here, here})), faces) << "in one place";
}

TEST(Copies, AreNoNodesOfOtherShapesOrFewFaces) {
  const std::string torus = R"({"primitive": "torus", "segments": 32})";
  EXPECT_EQ(shared_of(scene_of_json(torus + R"(, {"primitive": "torus", "segments": 33})").mesh), 0U);
  EXPECT_EQ(shared_of(scene_of_json(torus + R"(, {"primitive": "sphere", "segments": 34})").mesh), 0U);
  const std::string box = R"({"primitive": "box", "transform": {"translate": [)";
  EXPECT_EQ(shared_of(scene_of_json(box + "0, 0, 0]}}, " + box + "2, 0, 0]}}").mesh), 0U) << "12 faces";
  Mesh bent = tori({R"("translate": [0, 0, 0])", R"("translate": [3, 0, 0])"});
  ASSERT_GT(shared_of(bent), 0U);
  bent.positions.back() += Eigen::Vector3f(0.0F, 0.0F, 1e-4F);
  EXPECT_EQ(shared_of(bent), 0U) << "one vertex is elsewhere";
  bent.nodes.clear();
  EXPECT_EQ(shared_of(bent), 0U) << "nothing tells what moved";
}

TEST(Copies, GiveRaysTheHitsOfTheMesh) {
  const std::vector<std::string> places = {
      R"("translate": [0, 0, 0])", R"("translate": [1.3, 0, 0.2], "rotate": {"axis": [1, 2, 3], "degrees": 77})",
      R"("translate": [0.2, 1.2, 0], "scale": 0.3)", R"("translate": [0, -1.5, 0], "scale": [1, 2, 0.5])"};
  const std::vector<std::string> far = {
      R"("translate": [1e6, 0, 0])", R"("translate": [1000001, 1, 0], "rotate": {"axis": [1, 0, 0], "degrees": 90})"};
  const std::vector<std::string> tiny = {R"("scale": 1e-20)", R"("translate": [1e-20, 0, 0], "scale": 1e-20)"};
  for (const auto& [mesh, name] :
       std::vector<std::pair<Mesh, std::string>>{{tori(places), "plain"},
                                                 {tori(places, R"(, "sides": 2)"), "sheets"},
                                                 {tori(places, R"(, "max_edge": 0.1)"), "halved"},
                                                 {tori(places, R"(, "sides": 2, "max_edge": 0.1)"), "halved sheets"},
                                                 {tori(far), "far from the origin"},
                                                 {tori(tiny), "tiny"}}) {
    const Found found = compare_hits(mesh);
    EXPECT_GT(found.met, 1000U) << name;
    EXPECT_LT(found.others, 20U) << name << ": they lie on edges";
  }
}

// A triangle and its copy, one unit above. Every corner has to be where the map puts it.
TEST(Copies, AreAlikeAtEveryCorner) {
  const std::vector<Face> faces = {{0, 1, 2}, {3, 4, 5}};
  const std::vector<RunOfNode> nodes = {{{0, 1}, Eigen::Affine3d::Identity()},
                                        {{1, 1}, Eigen::Affine3d(Eigen::Translation3d(0, 0, 1))}};
  const std::vector<Eigen::Vector3f> positions = {{2, 0, 0}, {4, 0, 0}, {2, 6, 0}, {2, 0, 1}, {4, 0, 1}, {2, 6, 1}};
  const std::vector<CopiedRun> copied = find_copies(positions, faces, nodes, 1);
  ASSERT_EQ(copied.size(), 1U);
  EXPECT_EQ(copied[0].center, Eigen::Vector3f(3, 3, 0)) << "the middle of the box";
  ASSERT_EQ(copied[0].places.size(), 2U);
  EXPECT_EQ(copied[0].places[1].first, 1U);
  EXPECT_EQ(copied[0].places[1].from_original.translation(), Eigen::Vector3f(3, 3, 1));
  EXPECT_TRUE(find_copies(positions, faces, nodes, 2).empty()) << "too few faces";
  for (std::size_t moved = 0; moved < positions.size(); ++moved) {
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<Eigen::Vector3f> other = positions;
      other[moved][axis] += 0.01F;
      EXPECT_TRUE(find_copies(other, faces, nodes, 1).empty()) << moved << ' ' << axis;
    }
  }
}

TEST(Copies, AreLookedForAmongSomeShapesOfASize) {
  std::vector<Eigen::Vector3f> positions;
  std::vector<Face> faces;
  std::vector<RunOfNode> nodes;
  for (std::uint32_t f = 0; f < 200; ++f) {  // a hundred triangles, and each of them again
    const auto shape = static_cast<float>(f % 100);
    positions.insert(positions.end(), {{0, 0, shape}, {1, 0, shape}, {0, 1 + shape, shape}});
    faces.push_back({3 * f, 3 * f + 1, 3 * f + 2});
    nodes.push_back({{f, 1}, Eigen::Affine3d::Identity()});
  }
  EXPECT_EQ(find_copies(positions, faces, nodes, 1).size(), 64U);
}

TEST(Copies, GetTheVerticesOfTheirFacesOnly) {
  const std::vector<Eigen::Vector3f> positions = {{9, 9, 9}, {2, 0, 0}, {4, 0, 0}, {2, 6, 0}, {8, 8, 8}, {4, 6, 0}};
  const std::vector<Face> faces = {{1, 2, 3}, {2, 5, 3}, {0, 4, 5}};
  Parts parts(positions, faces);
  EXPECT_EQ(parts.choose({0, 1}), 3U);
  EXPECT_EQ(parts.choose({1, 2}), 5U);
  EXPECT_EQ(parts.choose({0, 2}), 4U);
  std::array<Eigen::Vector3f, 4> written;
  std::array<Face, 2> numbered{};
  parts.write({1, 0, 0}, written.data(), numbered.data());
  for (std::size_t f = 0; f < 2; ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(written[numbered[f][k]], positions[faces[f][k]] - Eigen::Vector3f(1, 0, 0));
    }
  }
}

// Faces that nothing copied stand before, between and behind copies.
TEST(Copies, LeaveOtherFacesTheirNumbers) {
  const std::string torus = R"({"primitive": "torus", "segments": 32, "transform": {"translate": [)";
  const Mesh mesh = scene_of_json(R"({"primitive": "box"}, )" + torus + R"(1.5, 0, 0]}}, {"primitive": "cone",
      "transform": {"translate": [0, 1.5, 0]}}, )" +
                                  torus + R"(1.5, 1.5, 0]}}, )" + torus + R"(0, 0, 1.5]}},
      {"primitive": "sphere", "transform": {"translate": [1.5, 0, 1.5]}})")
                        .mesh;
  EXPECT_EQ(shared_of(mesh) % 2, 0U);
  const Found found = compare_hits(mesh);
  EXPECT_GT(found.met, 1000U);
  EXPECT_LT(found.others, 20U);
}

// No ray that starts at a sphere meets it, however its copies are placed.
TEST(Copies, DoNotBlockTheirOwnRays) {
  for (const std::string place :
       {R"("translate": [0.01, 0, 0])", R"("translate": [40, 20, 10])", R"("translate": [30, 0, 0], "scale": 0.2)",
        R"("translate": [30, 0, 0], "scale": [3, 1, 1])",
        R"("translate": [7, 11, -5], "rotate": {"axis": [3, 1, 2], "degrees": 111})"}) {
    const std::string sphere = R"({"primitive": "sphere", "segments": 200, "transform": {)";
    const Mesh mesh = scene_of_json(sphere + R"("translate": [-20, 3, 8]}}, )" + sphere + place + "}}").mesh;
    const Tracer alone(mesh, 1);
    const Tracer shared(mesh, 1, "", kAny);
    ASSERT_GT(shared.shared_faces(), 0U) << place;
    const std::vector<RayStart> starts = ray_starts(mesh);
    std::vector<ShadowRay> rays;
    for (std::size_t v = 0; v < starts.size(); ++v) {
      const Eigen::Vector3f away = mesh.geometric_normals[v];
      rays.emplace_back().aim(starts[v].origin, away);
      const Eigen::Vector3f along = away.unitOrthogonal();
      rays.emplace_back().aim(starts[v].origin, (0.05F * away + along).normalized());
    }
    std::vector<ShadowRay> same = rays;
    alone.occluded(rays);
    shared.occluded(same);
    for (std::size_t r = 0; r < rays.size(); ++r) {  // some are blocked by the other sphere
      ASSERT_EQ(same[r].blocked(), rays[r].blocked()) << place << ", ray " << r;
    }
  }
}

}  // namespace
}  // namespace sh::prt::test
