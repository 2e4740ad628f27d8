// Vertices that halving made can be left out: what is left is a mesh without cracks, and blends say what is shown between.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

#include "prt/mesh/corners.hpp"
#include "prt/mesh/keep_vertices.hpp"
#include "prt/mesh/weld.hpp"
#include "prt/rays/tracer.hpp"
#include "prt/rays/whole_faces.hpp"
#include "prt/scene/scene.hpp"
#include "tests/prt/meshes.hpp"
#include "tests/prt/scene_of_json.hpp"

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
    EXPECT_EQ(same.halving.ends, mesh.halving.ends) << name;
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

// Rays take both sides of a thin surface for one face, so that both must be cut alike.
TEST(Halving, CutsTheBackOfATwoSidedFaceAsItsFront) {
  const Mesh mesh = scene_of_json(R"({"primitive": "plane", "max_edge": 0.09, "sides": 2},
                                     {"primitive": "box", "max_edge": 0.2, "transform": {"translate": [3, 0, 0]}})")
                        .mesh;
  ASSERT_FALSE(mesh.halving.empty());
  const Sheets all(mesh.positions, mesh.faces);
  ASSERT_TRUE(all.any());
  for (unsigned seed = 0; seed < 8; ++seed) {
    const Mesh some = less(mesh, some_of(mesh, seed, 0.05));
    const Sheets sheets(some.positions, some.faces);
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

// The weights of a place in the plane of a face.
std::array<double, 3> weights_of(const Mesh& mesh, const Face& face, const Eigen::Vector3d& place) {
  const Eigen::Vector3d a = mesh.positions[face[0]].cast<double>();
  Eigen::Matrix<double, 3, 2> edges;
  edges << mesh.positions[face[1]].cast<double>() - a, mesh.positions[face[2]].cast<double>() - a;
  const Eigen::Vector2d along = edges.colPivHouseholderQr().solve(place - a);
  return {1.0 - along.sum(), along[0], along[1]};
}

Eigen::Vector3d place_in(const Mesh& mesh, const Face& face, const std::array<double, 3>& weights) {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < 3; ++k) place += weights[k] * mesh.positions[face[k]].cast<double>();
  return place;
}

TEST(Halving, FindsTheFaceOfEveryPlace) {
  std::set<CutForm> forms;
  for (const std::string name : {"box", "stairs", "arch", "cone", "cylinder"}) {
    for (const double part : {0.03, 0.5, 1.0}) {
      const Mesh whole = halved(name, 0.07F);
      const Mesh mesh = less(whole, some_of(whole, 7, part));
      const Halving& halving = mesh.halving;
      for (const FaceCut& cut : halving.cuts) forms.insert(cut.form);
      std::uint32_t next = 0;
      visit_wholes(halving, mesh.faces, [&](const Halving::Whole& one) {
        ASSERT_EQ(halving.first_face(one.part), next) << name;
        for (; next < end_of_faces(halving.cuts, one.part); ++next) {
          for (const std::array<double, 3>& inside :
               {std::array{0.3, 0.3, 0.4}, {0.9, 0.05, 0.05}, {0.02, 0.9, 0.08}}) {
            const Eigen::Vector3d place = place_in(mesh, mesh.faces[next], inside);
            const PlaceInFace found = located(halving.cuts, one.part, weights_of(mesh, one.corners, place));
            ASSERT_EQ(found.face, next) << name;
            for (std::size_t k = 0; k < 3; ++k) ASSERT_NEAR(found.weights[k], inside[k], 1e-3) << name;
          }
        }
      });
      EXPECT_EQ(next, mesh.faces.size());
    }
  }
  EXPECT_EQ(forms.size(), 4U) << "every form of a cut";
}

// Rays are traced against the faces before halving; hits are those of the mesh, whatever was halved, kept and two-sided.
TEST(Halving, LeavesRaysTheHitsOfTheMesh) {
  const std::string thin = R"({"primitive": "plane", "max_edge": 0.05, "sides": 2},
                              {"primitive": "box", "max_edge": 0.1, "transform": {"translate": [0.4, 0.2, -0.8]}})";
  const std::string some = R"({"primitive": "torus", "segments": 20},
      {"primitive": "box", "max_edge": 0.2}, {"primitive": "box", "transform": {"translate": [1.2, 0, 0]}},
      {"primitive": "plane", "max_edge": 0.3, "sides": 2, "transform": {"scale": 3, "translate": [0, 0, -0.6]}},
      {"primitive": "sphere", "segments": 30, "transform": {"scale": 0.5, "translate": [0, 0, 0.9]}})";
  std::vector<Mesh> meshes = {halved("arch", 0.05F), halved("cone", 0.1F), halved("plane", 0.003F),
                              scene_of_json(thin).mesh, scene_of_json(some).mesh};
  for (std::size_t i = 0; i < 5; ++i) meshes.push_back(less(meshes[i], some_of(meshes[i], 3, 0.2)));
  std::mt19937 engine(5);
  std::uniform_real_distribution<float> number(-1.0F, 1.0F);
  for (const Mesh& mesh : meshes) {
    Mesh plain = mesh;
    plain.halving = {};
    ASSERT_FALSE(mesh.halving.empty());
    const Tracer by_wholes(mesh, 1);
    const Tracer by_faces(plain, 1);
    std::vector<Eigen::Vector3f> origins;
    std::vector<Eigen::Vector3f> directions;
    for (int k = 0; k < 4000; ++k) {
      origins.emplace_back(3.0F * Eigen::Vector3f(number(engine), number(engine), number(engine)).normalized());
      const Eigen::Vector3f target = 0.6F * Eigen::Vector3f(number(engine), number(engine), number(engine));
      directions.push_back((target - origins.back()).normalized());
    }
    std::vector<Hit> hits(origins.size());
    std::vector<Hit> expected(origins.size());
    by_wholes.intersect(origins, directions, hits);
    by_faces.intersect(origins, directions, expected);
    std::vector<Hit> met(origins.size());
    by_wholes.meet(origins, directions, met);
    std::size_t others = 0;
    std::size_t both = 0;
    for (std::size_t k = 0; k < hits.size(); ++k) {
      if (hits[k].face == Hit::kNothing || expected[k].face == Hit::kNothing) {
        others += hits[k].face == expected[k].face ? 0 : 1;
        continue;
      }
      ++both;
      others += hits[k].face == expected[k].face ? 0 : 1;
      const Eigen::Vector3f place = interpolated(hits[k], mesh, mesh.positions);
      EXPECT_LT((place - interpolated(expected[k], mesh, mesh.positions)).norm(), 1e-4F);
      EXPECT_NEAR(hits[k].distance, expected[k].distance, 1e-4F) << "grazing rays";
      const float along = face_normal(mesh.positions, mesh.faces[hits[k].face]).dot(directions[k]);
      if (std::abs(along) > 1e-3F) {
        EXPECT_EQ(hits[k].from_behind, along > 0.0F);
      }
      EXPECT_EQ(met[k].face != Hit::kNothing, hits[k].face != Hit::kNothing);
      EXPECT_EQ(met[k].distance, hits[k].distance);
      EXPECT_EQ(met[k].from_behind, hits[k].from_behind);
      EXPECT_GT(face_normal(mesh.positions, mesh.faces[hits[k].face])
                    .dot(face_normal(mesh.positions, mesh.faces[expected[k].face])),
                0.0F);
    }
    EXPECT_GT(both, 500U);
    EXPECT_LT(others, hits.size() / 100) << "they lie on edges";
  }
}

TEST(Halving, GivesRaysNoFaceThatIsMuchLargerThanItsParts) {
  const Mesh mesh = halved("plane", 0.003F);  // halved nine times
  const std::vector<Halving::Whole> traced = faces_for_rays(mesh.halving);
  EXPECT_EQ(mesh.halving.faces.size(), 2U);
  EXPECT_EQ(traced.size(), 8U);
  std::uint32_t next = 0;
  double area = 0.0;
  for (const Halving::Whole& face : traced) {
    EXPECT_EQ(mesh.halving.first_face(face.part), next);
    next += static_cast<std::uint32_t>(mesh.faces.size() / traced.size());
    const auto at = [&](std::size_t k) { return mesh.positions[face.corners[k]].cast<double>().eval(); };
    area += 0.5 * (at(1) - at(0)).cross(at(2) - at(0)).norm();
  }
  EXPECT_NEAR(area, 1.0, 1e-6);
  const Mesh arch = halved("arch", 0.05F);
  EXPECT_EQ(WholeFaces(arch).traced(arch.faces).size(), primitive_mesh("arch", 12).faces.size());
}

// Traced faces are those before halving, in their order; the faces of meshes that nobody halved stay.
TEST(Halving, CountsTheFacesThatRaysSee) {
  const std::string boxes = R"({"primitive": "torus", "segments": 20}, {"primitive": "box", "max_edge": 0.2},
      {"primitive": "cone", "segments": 9}, {"primitive": "box", "max_edge": 0.1, "sides": 2},
      {"primitive": "sphere", "segments": 30})";
  const Mesh mesh = scene_of_json(boxes).mesh;
  const WholeFaces wholes(mesh);
  const std::vector<Face> traced = wholes.traced(mesh.faces);
  std::vector<std::uint32_t> first;  // (traced faces) of the mesh
  visit_wholes(mesh.halving, mesh.faces,
               [&](const Halving::Whole& one) { first.push_back(mesh.halving.first_face(one.part)); });
  ASSERT_EQ(traced.size(), first.size());
  EXPECT_EQ(mesh.halving.faces.size(), 12U + 24U) << "faces of boxes";
  EXPECT_EQ(wholes.count_before(static_cast<std::uint32_t>(mesh.faces.size())), traced.size());
  for (std::uint32_t t = 0; t < traced.size(); ++t) {
    EXPECT_EQ(wholes.count_before(first[t]), t);
    const Hit hit = wholes.hit_of_mesh({t, 0.25F, 0.25F, 2.0F});
    EXPECT_GE(hit.face, first[t]);
    EXPECT_LT(hit.face, t + 1 < traced.size() ? first[t + 1] : mesh.faces.size());
    const Eigen::Vector3f place = interpolated(hit, mesh, mesh.positions);
    Mesh before = mesh;
    before.faces = traced;
    EXPECT_LT((place - interpolated({t, 0.25F, 0.25F, 2.0F}, before, mesh.positions)).norm(), 1e-6F);
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
