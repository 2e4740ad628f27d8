// Light probes on a grid: rooms whose light is known, solids in them, walls between probes.
#include "prt/runtime/probe_grid.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <limits>
#include <numbers>

#include "tests/prt/rooms.hpp"

namespace sh::prt::test {
namespace {

constexpr CubeSize kCoarse{8, 1};

PointGrid grid_in(double half, std::uint32_t along) {
  return {{Eigen::Vector3d::Constant(-half), Eigen::Vector3d::Constant(half)}, {along, along, along}};
}

/// A room of edge 1 around the origin.
Mesh room(const Eigen::Vector3f& radiance) {
  Mesh mesh = primitive_mesh("box");
  turn_inside_out(mesh);
  shine(mesh, radiance);
  return mesh;
}

/// The room with a box of this edges in its middle, dark outside.
Mesh room_around_box(const Eigen::Vector3f& radiance, const Eigen::Vector3f& edges) {
  Mesh mesh = room(radiance);
  Mesh box = primitive_mesh("box", 1, Eigen::Affine3f(Eigen::Scaling(edges.x(), edges.y(), edges.z())));
  shine(box, Eigen::Vector3f::Zero());
  append(mesh, box);
  return mesh;
}

class Lit {
 public:
  explicit Lit(Mesh mesh)
      : mesh_(std::move(mesh)),
        tracer_(mesh_),
        sampler_(mesh_, tracer_, diffuse_surface(mesh_, mesh_.emission), {}, kCoarse) {}
  [[nodiscard]] const LightSampler& sampler() const { return sampler_; }

 private:
  Mesh mesh_;
  Tracer tracer_;
  LightSampler sampler_;
};

TEST(ProbeGrid, OfARoomOfOneRadianceIsTheSameEverywhere) {
  const Lit lit(room({1.0F, 0.5F, 0.0F}));
  const ProbeGrid probes = sample_probes(lit.sampler(), grid_in(0.4, 3), 2);
  ASSERT_EQ(probes.light.size(), 27U);
  const double whole = std::sqrt(4.0 * std::numbers::pi);
  for (std::size_t p = 0; p < probes.light.size(); ++p) {
    EXPECT_EQ(probes.valid[p], 1) << p;
    EXPECT_NEAR(probes.light[p].at(0, 0), whole, 1e-5) << p;
    EXPECT_NEAR(probes.light[p].at(1, 0), 0.5 * whole, 1e-5) << p;
    EXPECT_NEAR(probes.light[p].at(0, 2), 0.0, 1e-5) << p;
  }
  EXPECT_EQ(probes.grid.filled, 0U);
  EXPECT_NEAR(interpolated(probes, {0.1, -0.33, 0.2}).at(0, 0), whole, 1e-5);
  const ProbeErrors errors = measure_probes(lit.sampler(), probes, 10, 7);
  EXPECT_EQ(errors.points, 10U);
  EXPECT_LT(errors.largest, 1e-5);
}

TEST(ProbeGrid, InsideASolidTakesTheLightAroundIt) {
  const Lit lit(room_around_box({1.0F, 1.0F, 1.0F}, {0.5F, 0.5F, 0.5F}));
  // Probes at -0.4, -0.2, 0, 0.2, 0.4: those within 0.25 on all axes are inside.
  const ProbeGrid probes = sample_probes(lit.sampler(), grid_in(0.4, 5), 1);
  std::size_t inside = 0;
  for (std::size_t p = 0; p < probes.light.size(); ++p) {
    const bool is_inside = probes.grid.point(p).cwiseAbs().maxCoeff() < 0.25;
    EXPECT_EQ(probes.valid[p], is_inside ? 0 : 1) << p;
    inside += is_inside ? 1 : 0;
  }
  EXPECT_EQ(inside, 27U);
  EXPECT_EQ(probes.grid.filled, 26U);
  // The one in the middle has no valid probe around it.
  EXPECT_EQ(probes.light[62].at(0, 0), 0.0);
  // The one under the middle of the top side takes the nine above it.
  double mean = 0.0;
  for (const std::uint32_t x : {1, 2, 3}) {
    for (const std::uint32_t y : {1, 2, 3}) mean += probes.light[probes.grid.index({x, y, 4})].at(2, 0) / 9.0;
  }
  EXPECT_NEAR(probes.light[probes.grid.index({2, 2, 3})].at(2, 0), mean, 1e-12);
  // A corner of the box has 19 valid ones around it.
  double sum = 0.0;
  for (const std::uint32_t x : {2, 3, 4}) {
    for (const std::uint32_t y : {2, 3, 4}) {
      for (const std::uint32_t z : {2, 3, 4}) {
        if (std::max({x, y, z}) == 4) sum += probes.light[probes.grid.index({x, y, z})].at(2, 0);
      }
    }
  }
  EXPECT_NEAR(probes.light[probes.grid.index({3, 3, 3})].at(2, 0), sum / 19.0, 1e-12);
  // At a probe the interpolated light is its own.
  for (const std::size_t p : {std::size_t{3}, std::size_t{31}, std::size_t{124}}) {
    EXPECT_NEAR(interpolated(probes, probes.grid.point(p)).at(0, 2), probes.light[p].at(0, 2), 1e-6) << p;
  }
}

TEST(ProbeGrid, LeaksThroughAThinWallAndSaysSo) {
  // A wall at x = 0 divides the room; the half x > 0 is bright.
  const auto divided = [](float bright) {
    Mesh mesh = room_around_box(Eigen::Vector3f::Ones(), {0.02F, 1.0F, 1.0F});
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      if (mesh.positions[v].x() < 0.4F) mesh.emission[v].setConstant(bright);
    }
    return Lit(std::move(mesh));
  };
  const Lit lit = divided(0.0F);
  const ProbeErrors coarse = measure_probes(lit.sampler(), sample_probes(lit.sampler(), grid_in(0.4, 2), 2), 60, 3);
  const ProbeErrors fine = measure_probes(lit.sampler(), sample_probes(lit.sampler(), grid_in(0.4, 8), 2), 60, 3);
  EXPECT_GT(coarse.largest, 0.3);
  EXPECT_LT(fine.rms, 0.5 * coarse.rms);
  EXPECT_LT(std::abs(coarse.where.x()), 0.4);
}

TEST(ProbeGrid, DoesNotDependOnTheNumberOfThreads) {
  const Lit lit(room_around_box({1.0F, 1.0F, 1.0F}, {0.5F, 0.2F, 0.3F}));
  const ProbeGrid many = sample_probes(lit.sampler(), grid_in(0.4, 3), 2);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const ProbeGrid alone = sample_probes(lit.sampler(), grid_in(0.4, 3), 2);
  EXPECT_EQ(many.valid, alone.valid);
  for (std::size_t p = 0; p < many.light.size(); ++p) EXPECT_EQ(many.light[p].values, alone.light[p].values) << p;
}

TEST(ProbeGrid, RefusesGridsWithoutFreeSpaceOrWithAFlaw) {
  Mesh box = primitive_mesh("box");
  shine(box, Eigen::Vector3f::Ones());
  const Lit lit(std::move(box));
  EXPECT_THROW(sample_probes(lit.sampler(), grid_in(0.3, 2), 2), std::invalid_argument);
  EXPECT_THROW(sample_probes(lit.sampler(), grid_in(0.0, 2), 2), std::invalid_argument);
  EXPECT_THROW(sample_probes(lit.sampler(), grid_in(2.0, 1), 2), std::invalid_argument);
  EXPECT_THROW(sample_probes(lit.sampler(), grid_in(std::numeric_limits<double>::quiet_NaN(), 2), 2),
               std::invalid_argument);
  EXPECT_THROW(sample_probes(lit.sampler(), grid_in(2.0, 102), 2), std::invalid_argument);  // 1,061,208
  EXPECT_EQ(sample_probes(lit.sampler(), grid_in(2.0, 2), 0).valid, std::vector<std::uint8_t>(8, 1));
}

}  // namespace
}  // namespace sh::prt::test
