// Vertices that halving made can be left out: what is left is a mesh without cracks, and blends say what is shown between.
#include "prt/mesh/halving.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

#include "prt/mesh/weld.hpp"
#include "prt/rays/sheets.hpp"
#include "prt/scene/scene.hpp"
#include "tests/prt/meshes.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

Mesh halved(const std::string& name, float edge = 0.13F, float moved = 0.0F) {
  Mesh mesh = primitive_mesh(name, 12, Eigen::Affine3f(Eigen::Translation3f(moved, 0.0F, 0.0F)));
  tessellate(
      mesh, [edge](const Eigen::Vector3f&) { return edge; }, name);
  return mesh;
}

std::vector<std::uint8_t> some_of(const Mesh& mesh, unsigned seed, double part) {
  std::mt19937 engine(seed);
  std::vector<std::uint8_t> marks;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    marks.push_back(static_cast<double>(engine()) < part * 4294967296.0 ? 1 : 0);
  return with_ends(mesh, marks);
}

Mesh less(Mesh mesh, const std::vector<std::uint8_t>& kept) {
  keep_vertices(mesh, kept);
  return mesh;
}

TEST(Halving, KeptAsAWholeIsTheSameMesh) {
  for (const std::string name : {"box", "arch", "cone", "plane", "torus"}) {
    const Mesh mesh = halved(name);
    const Mesh same = less(mesh, std::vector<std::uint8_t>(mesh.positions.size(), 1));
    EXPECT_EQ(same.positions, mesh.positions) << name;
    EXPECT_EQ(same.geometric_normals, mesh.geometric_normals) << name;
    EXPECT_EQ(same.faces, mesh.faces) << name;
    EXPECT_EQ(reaches(same), reaches(mesh)) << name;
    EXPECT_TRUE(same.halving.empty()) << name;
  }
}

TEST(Halving, LeftOutAsAWholeIsTheMeshBefore) {
  for (const std::string name : {"box", "arch", "cone", "plane"}) {
    const Mesh before = primitive_mesh(name, 12);
    const Mesh mesh = halved(name);
    const Mesh after = less(mesh, with_ends(mesh, std::vector<std::uint8_t>(mesh.positions.size(), 0)));
    EXPECT_LT(after.positions.size(), mesh.positions.size()) << name;
    EXPECT_EQ(after.positions, before.positions) << name;
    EXPECT_EQ(after.faces, before.faces) << name;
    EXPECT_EQ(after.normals, before.normals) << name;
  }
}

TEST(Halving, OpensNoCracksWhateverIsKept) {
  for (const std::string name : {"box", "stairs", "arch", "cylinder", "cone"}) {
    const Mesh mesh = halved(name, 0.09F);
    const double volume = signed_volume(mesh);
    for (unsigned seed = 0; seed < 12; ++seed) {
      const std::vector<std::uint8_t> kept = some_of(mesh, seed, seed < 6 ? 0.02 : 0.3);
      const Mesh some = less(mesh, kept);
      EXPECT_EQ(some.positions.size(), std::count(kept.begin(), kept.end(), 1));
      EXPECT_TRUE(is_closed_surface(some)) << name << " " << seed;
      EXPECT_NEAR(signed_volume(some), volume, 1e-5) << name << " " << seed;
      std::set<std::uint32_t> used;
      for (const Face& face : some.faces) used.insert(face.begin(), face.end());
      EXPECT_EQ(used.size(), some.positions.size()) << name << ": every kept vertex has a face";
    }
  }
}

// The reach of a vertex decides how rays start and what is near: it stays that of the asked mesh.
TEST(Halving, KeepsEveryValueOfAVertexAndTheReachOfTheMeshBefore) {
  Mesh mesh = halved("box");
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const auto x = static_cast<float>(v);
    mesh.albedo[v] = {x, x + 0.25F, x + 0.5F};
    mesh.emission.emplace_back(x, 0.0F, 1.0F);
    mesh.texture.resize(mesh.positions.size());
    mesh.exponent.push_back(x);
    mesh.albedo_map.push_back(static_cast<std::uint16_t>(v));
  }
  const std::vector<float> reach = reaches(mesh);
  const std::vector<std::uint8_t> kept = some_of(mesh, 3, 0.1);
  const Mesh some = less(mesh, kept);
  std::size_t next = 0;
  for (std::size_t v = 0; v < kept.size(); ++v) {
    if (kept[v] == 0) continue;
    EXPECT_EQ(some.positions[next], mesh.positions[v]);
    EXPECT_EQ(some.albedo[next], mesh.albedo[v]);
    EXPECT_EQ(some.emission[next], mesh.emission[v]);
    EXPECT_EQ(some.exponent[next], mesh.exponent[v]);
    EXPECT_EQ(some.albedo_map[next], mesh.albedo_map[v]);
    EXPECT_EQ(reaches(some)[next], reach[v]);
    ++next;
  }
  EXPECT_EQ(next, some.positions.size());
  EXPECT_TRUE(some.mirror.empty());
  EXPECT_EQ(some.texture.size(), next);
}

TEST(Halving, OfAPartGoesOnInTheWhole) {
  const Mesh one = halved("box");
  const Mesh plain = primitive_mesh("torus", 8, Eigen::Affine3f(Eigen::Translation3f(0.0F, 5.0F, 0.0F)));
  const Mesh other = halved("arch", 0.13F, 3.0F);
  for (const bool plain_first : {false, true}) {
    Mesh mesh = plain_first ? plain : one;
    append(mesh, plain_first ? one : plain);
    append(mesh, other);
    ASSERT_EQ(mesh.halving.ends.size(), mesh.positions.size());
    const Mesh same = less(mesh, std::vector<std::uint8_t>(mesh.positions.size(), 1));
    EXPECT_EQ(same.faces, mesh.faces);
    const Mesh coarse = less(mesh, with_ends(mesh, std::vector<std::uint8_t>(mesh.positions.size(), 0)));
    EXPECT_EQ(coarse.faces.size(),
              plain.faces.size() + primitive_mesh("box", 12).faces.size() + primitive_mesh("arch", 12).faces.size());
    EXPECT_TRUE(is_closed_surface(less(mesh, some_of(mesh, 5, 0.1))));
  }
  Mesh none = plain;
  append(none, plain);
  EXPECT_TRUE(none.halving.empty());
}

Scene scene_of_json(const std::string& meshes) {
  const TemporaryFolder folder;
  const std::string file = folder.file("scene.json");
  write_all(file, R"({"meshes": [)" + meshes + "]}");
  return load_scene(file, OnFlaw::kRefuse);
}

// Rays take both sides of a thin surface for one face, so that both must be cut alike.
TEST(Halving, CutsTheBackOfATwoSidedFaceAsItsFront) {
  const Mesh mesh = scene_of_json(R"({"primitive": "plane", "max_edge": 0.09, "sides": 2},
                                     {"primitive": "box", "max_edge": 0.2, "transform": {"translate": [3, 0, 0]}})")
                        .mesh;
  ASSERT_FALSE(mesh.halving.empty());
  const Sheets all(mesh);
  ASSERT_TRUE(all.any());
  for (unsigned seed = 0; seed < 8; ++seed) {
    const Mesh some = less(mesh, some_of(mesh, seed, 0.05));
    const Sheets sheets(some);
    std::size_t on_plane = 0;
    for (const Face& face : some.faces) on_plane += some.positions[face[0]].x() < 2.0F ? 1 : 0;
    EXPECT_LT(on_plane, mesh.faces.size());
    EXPECT_EQ(sheets.without_backs(some.faces).size(), some.faces.size() - on_plane / 2) << seed;
  }
  const Mesh same = less(mesh, std::vector<std::uint8_t>(mesh.positions.size(), 1));
  EXPECT_EQ(same.faces, mesh.faces);
}

TEST(Halving, KeepsTheFacesOfEveryNode) {
  const Mesh mesh = scene_of_json(R"({"primitive": "box", "max_edge": 0.2}, {"primitive": "arch", "max_edge": 0.1},
                                     {"primitive": "plane", "sides": 2, "max_edge": 0.3})")
                        .mesh;
  const Mesh some = less(mesh, some_of(mesh, 1, 0.05));
  ASSERT_EQ(some.nodes.size(), 3U);
  std::uint32_t faces = 0;
  for (const MeshNode& node : some.nodes) {
    for (const auto& [first, count] : node.faces) {
      EXPECT_EQ(first, faces) << node.name;
      faces += count;
    }
  }
  EXPECT_EQ(faces, some.faces.size());
  for (const std::uint32_t vertex : some.remap) EXPECT_TRUE(vertex == kNoVertex || vertex < some.positions.size());
  for (std::size_t i = 0; i < some.remap.size(); ++i) {
    if (some.remap[i] == kNoVertex) continue;
    EXPECT_EQ(some.positions[some.remap[i]], mesh.positions[mesh.remap[i]]);
  }
}

TEST(Halving, BlendsAreTheLinearInterpolationOfFlatFaces) {
  const Mesh mesh = halved("plane", 0.05F);
  for (unsigned seed = 0; seed < 5; ++seed) {
    const std::vector<std::uint8_t> kept = some_of(mesh, seed, 0.05);
    std::vector<std::uint32_t> all(kept.size());
    std::iota(all.begin(), all.end(), 0U);
    const std::vector<Blend> blends = blends_of(mesh.halving, kept, all);
    std::vector<float> shown;
    for (const Eigen::Vector3f& p : mesh.positions) shown.push_back(3.0F * p.x() - 2.0F * p.y() + p.x() * p.y());
    const std::vector<float> own = shown;
    interpolate_left_out(mesh.halving, ends_first(mesh.halving), kept, shown);
    for (std::size_t v = 0; v < kept.size(); ++v) {
      Eigen::Vector3d place = Eigen::Vector3d::Zero();
      double sum = 0.0;
      double value = 0.0;
      for (const auto& [vertex, part] : blends[v]) {
        EXPECT_EQ(kept[vertex], 1);
        EXPECT_GT(part, 0.0);
        sum += part;
        place += part * mesh.positions[vertex].cast<double>();
        value += part * static_cast<double>(own[vertex]);
      }
      EXPECT_DOUBLE_EQ(sum, 1.0);
      EXPECT_LT((place - mesh.positions[v].cast<double>()).norm(), 1e-6);
      EXPECT_NEAR(value, static_cast<double>(shown[v]), 1e-5);
      EXPECT_TRUE(kept[v] == 0 || blends[v].size() == 1) << v;
    }
  }
}

TEST(Halving, OrdersEndsFirst) {
  const Mesh mesh = halved("arch");
  const std::vector<std::uint32_t> order = ends_first(mesh.halving);
  ASSERT_EQ(std::set<std::uint32_t>(order.begin(), order.end()).size(), mesh.positions.size());
  std::vector<std::size_t> place(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) place[order[i]] = i;
  for (std::size_t v = 0; v < place.size(); ++v) {
    if (!mesh.halving.is_middle(v)) continue;
    for (const std::uint32_t end : mesh.halving.ends[v]) EXPECT_LT(place[end], place[v]);
  }
}

TEST(Halving, RefusesMarksThatLeaveOutWhatIsNeeded) {
  Mesh mesh = halved("box");
  const auto said = [&](const std::vector<std::uint8_t>& kept) {
    return message_of([&] {
      Mesh copy = mesh;
      keep_vertices(copy, kept);
    });
  };
  EXPECT_NE(said({1, 1}).find("another number of vertices"), std::string::npos);
  std::vector<std::uint8_t> kept = with_ends(mesh, std::vector<std::uint8_t>(mesh.positions.size(), 0));
  EXPECT_EQ(said(kept), "");
  kept.back() = 1;  // without the ends of its edge
  EXPECT_NE(said(kept).find("without the ends"), std::string::npos);
  kept.assign(mesh.positions.size(), 1);
  kept[0] = 0;  // of the file
  EXPECT_NE(said(kept).find("without the ends"), std::string::npos);
  mesh.atlases.heads.emplace_back();
  EXPECT_NE(said(std::vector<std::uint8_t>(mesh.positions.size(), 1)).find("atlas"), std::string::npos);
}

}  // namespace
}  // namespace sh::prt::test
