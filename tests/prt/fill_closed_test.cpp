// Vertices inside something and under something take the light of their neighbors, continuously: no vertex changes much
// because of one ray.
#include "prt/bake/fill_closed.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "prt/bake/row_tracer.hpp"
#include "tests/prt/rooms.hpp"

namespace sh::prt::test {
namespace {

Mesh fine_plane(float edge) {
  Mesh mesh = primitive_mesh("plane");
  refine(mesh, edge);
  return mesh;
}

/// Sights with random closed parts, about a third of them 0 and a third 1.
std::vector<Sight> random_sights(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(-1.0F, 2.0F);
  std::vector<Sight> sights(count);
  for (Sight& sight : sights) sight.buried = std::clamp(uniform(random), 0.0F, 1.0F);
  return sights;
}

std::vector<double> filled(const Mesh& mesh, const std::vector<Sight>& sights, std::vector<double> own) {
  Fill(closed_vertices(mesh, sights)).apply(own.data(), 1, 1);
  return own;
}

TEST(Fill, SolvesItsEquationAndIsAMeanOfOwnLight) {
  const Mesh mesh = fine_plane(0.1F);
  const std::size_t count = mesh.positions.size();
  for (unsigned seed = 0; seed < 8; ++seed) {
    const std::vector<Sight> sights = random_sights(count, seed);
    std::mt19937 random(seed + 100);
    std::uniform_real_distribution<double> uniform(0.25, 4.0);
    std::vector<double> own(count);
    for (double& value : own) value = uniform(random);
    const std::vector<double> x = filled(mesh, sights, own);
    const auto closed = closed_vertices(mesh, sights);
    std::vector<std::uint8_t> is_closed(count, 0);
    for (const ClosedVertex& v : closed) {
      double mean = 0.0;
      for (const std::uint32_t u : v.neighbors) mean += x[u] / static_cast<double>(v.neighbors.size());
      const double c = std::min(static_cast<double>(v.closed), 1.0 - 1e-4);
      EXPECT_NEAR(x[v.vertex], (1.0 - c) * own[v.vertex] + c * mean, 1e-12);
      is_closed[v.vertex] = 1;
    }
    for (std::size_t v = 0; v < count; ++v) {
      EXPECT_TRUE(x[v] >= 0.25 && x[v] <= 4.0) << v;
      if (is_closed[v] == 0) {
        EXPECT_EQ(x[v], own[v]);
      }
    }
  }
}

// Every column alone, whatever their number, their distance and what lies beside them.
TEST(Fill, TreatsEachOfManyColumnsAsIfItWereAlone) {
  const Mesh mesh = fine_plane(0.3F);
  const std::size_t count = mesh.positions.size();
  const std::vector<Sight> sights = random_sights(count, 1);
  const Fill fill(closed_vertices(mesh, sights));
  constexpr std::size_t kStride = 24;
  for (const std::size_t columns : {1U, 7U, 8U, 9U, 16U, 19U}) {
    std::vector<double> table(count * kStride + 1);
    for (std::size_t i = 0; i < table.size(); ++i) table[i] = std::sin(static_cast<double>(i)) + 1.0;
    std::vector<double> expected = table;
    for (std::size_t k = 0; k < columns; ++k) {
      std::vector<double> own(count);
      for (std::size_t v = 0; v < count; ++v) own[v] = table[v * kStride + k];
      own = filled(mesh, sights, own);
      for (std::size_t v = 0; v < count; ++v) expected[v * kStride + k] = own[v];
    }
    std::vector<float> singles(table.begin(), table.end());
    fill.apply(table.data(), kStride, columns);
    EXPECT_EQ(table, expected) << columns;
    fill.apply(singles.data(), kStride, columns);
    for (std::size_t i = 0; i < table.size(); ++i) EXPECT_NEAR(static_cast<double>(singles[i]), table[i], 1e-6) << i;
  }
}

TEST(Fill, WithoutClosedVerticesChangesNothing) {
  std::vector<float> own = {1.0F, 2.0F};
  const Fill none(closed_vertices(primitive_mesh("plane"), std::vector<Sight>(4)));
  none.apply(own.data(), 1, 1);
  EXPECT_EQ(own, (std::vector<float>{1.0F, 2.0F}));
  EXPECT_EQ(none.condition(), 0.0);
  EXPECT_NEAR(Fill({{0, 1.0F, {1}}}).condition(), 2e4, 2.0) << "a vertex keeps at least 1e-4 of its own light";
}

// Closed for 0.6: 1, 2, 4, 5, 7, 8 are buried, 6 is covered; exactly a half is not closed.
//   0 sound - 1 - 2    0 - 6 - 7    3 (a half) - 8    4 - 5 see nobody else
TEST(Fill, ReachesBuriedVerticesFromSoundOnesOverClosedOnes) {
  std::vector<Sight> sights(9);
  for (const std::size_t v : {1U, 2U, 4U, 5U, 7U, 8U}) sights[v].buried = 0.6F;
  sights[3].buried = 0.5F;
  sights[6].covered = 0.6F;
  sights[6].buried = 0.5F;
  const std::vector<std::pair<std::uint32_t, std::uint32_t>> edges = {{0, 1}, {1, 2}, {0, 6}, {6, 7}, {3, 8}, {4, 5}};
  std::vector<ClosedVertex> closed;
  for (std::uint32_t v = 1; v < 9; ++v) {
    closed.push_back({v, sights[v].closed(), {}});
    for (const auto& [a, b] : edges) {
      if (a == v || b == v) closed.back().neighbors.push_back(a == v ? b : a);
    }
  }
  for (int order = 0; order < 2; ++order) {
    const BuriedCount count = count_buried(closed, sights);
    EXPECT_EQ(count.buried, 6U);
    EXPECT_EQ(count.filled, 4U);
    std::reverse(closed.begin(), closed.end());
  }
}

TEST(Fill, ChangesLittleWhereClosedPartsChangeLittle) {
  const Mesh mesh = fine_plane(0.1F);
  const std::size_t count = mesh.positions.size();
  std::vector<double> own(count);
  for (std::size_t v = 0; v < count; ++v) own[v] = v % 3 == 0 ? 1.0 : 0.0;
  for (unsigned seed = 0; seed < 8; ++seed) {
    std::vector<Sight> sights = random_sights(count, seed);
    const std::vector<double> before = filled(mesh, sights, own);
    for (Sight& sight : sights) sight.buried = std::clamp(sight.buried + 1e-5F, 0.0F, 1.0F);  // also of sound vertices
    const std::vector<double> after = filled(mesh, sights, own);
    for (std::size_t v = 0; v < count; ++v) EXPECT_NEAR(after[v], before[v], 1e-3) << v;
  }
}

TEST(Fill, LetsAPartThatIsClosedAsAWholeKeepItsMean) {
  const Mesh mesh = fine_plane(0.3F);
  const std::size_t count = mesh.positions.size();
  std::vector<Sight> sights(count);
  for (Sight& sight : sights) sight.covered = 1.0F;
  const std::vector<double> x = filled(mesh, sights, std::vector<double>(count, 0.5));
  for (const double value : x) EXPECT_NEAR(value, 0.5, 1e-9);
  const BuriedCount covered = count_buried(closed_vertices(mesh, sights), sights);
  EXPECT_EQ(covered.buried, 0U);
  for (Sight& sight : sights) sight.buried = 1.0F;
  EXPECT_EQ(count_buried(closed_vertices(mesh, sights), sights).buried, count);
  EXPECT_EQ(count_buried(closed_vertices(mesh, sights), sights).filled, 0U);
  sights[0] = Sight();
  EXPECT_EQ(count_buried(closed_vertices(mesh, sights), sights).filled, count - 1);
}

/// A plane through the middle of a box with a square hole in its top; vertex 0 of the plane lies under the hole.
Mesh plane_through_box_with_hole(float hole) {
  Mesh mesh = fine_plane(0.3F);
  Soup box = make_primitive("box", 24);
  transform(box, Eigen::Affine3d(Eigen::Scaling(0.5)));
  std::erase_if(box.faces, [&](const Face& face) {
    return std::all_of(face.begin(), face.end(), [&](std::uint32_t v) { return box.positions[v].z() > 0.2; });
  });
  const float h = hole / 2.0F;
  const auto corner = [](float x, float y) { return Eigen::Vector3f(x, y, 0.25F); };
  add_quad(box, {corner(-0.25F, -0.25F), corner(0.25F, -0.25F), corner(0.25F, -h), corner(-0.25F, -h)});
  add_quad(box, {corner(-0.25F, h), corner(0.25F, h), corner(0.25F, 0.25F), corner(-0.25F, 0.25F)});
  if (hole > 0.0F) {
    add_quad(box, {corner(-0.25F, -h), corner(-h, -h), corner(-h, h), corner(-0.25F, h)});
    add_quad(box, {corner(h, -h), corner(0.25F, -h), corner(0.25F, h), corner(h, h)});
  }
  box.albedo.clear();
  box.albedo.assign(box.positions.size(), Eigen::Vector3f::Constant(0.5F));
  append(mesh, weld(box, box.positions.size()));
  return mesh;
}

/// The part of the sky at the middle of the plane, after the fill.
float sky_in_the_middle(float hole, int directions) {
  const Mesh mesh = plane_through_box_with_hole(hole);
  testing::internal::CaptureStderr();
  const Transfer transfer = baked(mesh, &kShadowed, directions, 0);
  testing::internal::GetCapturedStderr();
  const auto lower = [&](const Eigen::Vector3f& a, const Eigen::Vector3f& b) { return a.norm() < b.norm(); };
  const auto middle = std::min_element(mesh.positions.begin(), mesh.positions.end(), lower);
  EXPECT_LT(middle->norm(), 1e-3F);
  return transfer.row(static_cast<std::size_t>(middle - mesh.positions.begin()))[0] * kRoot4Pi;
}

TEST(BuriedVertices, ChangeContinuouslyAsAHoleOpens) {
  float before = sky_in_the_middle(0.0F, 4096);
  EXPECT_GT(before, 0.3F) << "inside, and filled from outside";
  float steepest = 0.0F;
  for (float hole = 0.0025F; hole < 0.16F; hole += 0.0025F) {
    const float now = sky_in_the_middle(hole, 4096);
    steepest = std::max(steepest, std::abs(now - before));
    before = now;
  }
  EXPECT_LT(steepest, 0.12F) << "one ray through the hole decides";
  EXPECT_LT(before, 0.2F) << "a wide hole is a window, and the vertex is lit by it alone";
}

TEST(BuriedVertices, ConvergeAsRaysGrow) {
  const float hole = 0.03F;  // 5e-3 of the cosine: none to forty rays
  const float reference = sky_in_the_middle(hole, 65536);
  EXPECT_GT(reference, 0.3F) << "hardly any light comes in";
  for (int directions = 128; directions <= 32768; directions *= 4) {
    EXPECT_NEAR(sky_in_the_middle(hole, directions), reference, directions < 1024 ? 0.1F : 0.02F) << directions;
  }
}

TEST(BuriedVertices, TakeBouncedLightFromTheirNeighborsToo) {
  Mesh mesh = fine_plane(0.1F);
  append(mesh, primitive_mesh("box", 24, Eigen::Affine3f(Eigen::Scaling(0.5F))));
  Mesh lamp = primitive_mesh("sphere", 24, Eigen::Translation3f(0.0F, 0.0F, 3.0F) * Eigen::Scaling(3.0F));
  shine(mesh, Eigen::Vector3f::Zero());
  shine(lamp, Eigen::Vector3f::Constant(5.0F));
  append(mesh, lamp);
  testing::internal::CaptureStderr();
  const Transfer transfer = baked(mesh, &kInterreflected, 2048, 1);
  testing::internal::GetCapturedStderr();
  float least = 1e9F;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (mesh.positions[v].z() == 0.0F && mesh.normals[v].z() > 0.5F) least = std::min(least, transfer.emitted[v].x());
  }
  EXPECT_GT(least, 0.1F);
}

}  // namespace
}  // namespace sh::prt::test
