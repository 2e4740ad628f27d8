// What plans of glossy transfer measure: from where they look, and what coarse bakes and probes tell.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "numeric/oracle/zonal.hpp"
#include "prt/basis.hpp"
#include "prt/light/light.hpp"
#include "prt/plan/plan.hpp"
#include "prt/plan/views.hpp"
#include "prt/transfer/storage.hpp"
#include "tests/prt/begun_plan.hpp"
#include "tests/prt/glossy_meshes.hpp"
#include "tests/prt/lobed_scenes.hpp"
#include "tests/prt/plan_promise.hpp"

namespace sh::prt::test {
namespace {

std::vector<std::uint32_t> all_vertices(const Mesh& mesh) {
  std::vector<std::uint32_t> all(mesh.positions.size());
  std::iota(all.begin(), all.end(), 0U);
  return all;
}

TEST(Views, LieAboveTheHorizonWithTheDensityOfTheCosine) {
  const Mesh mesh = box_in_square();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double squares = 0.0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    double cosines = 0.0;
    for (std::size_t eye = 0; eye < Views::kEyes; ++eye) {
      const Eigen::Vector3f direction = Views::to_eye(mesh, v, eye);
      const auto cosine = static_cast<double>(direction.dot(mesh.geometric_normals[v]));
      EXPECT_NEAR(direction.norm(), 1.0F, 1e-6F);
      EXPECT_GT(cosine, 0.0);
      cosines += cosine / Views::kEyes;
      squares += cosine * cosine / static_cast<double>(Views::kEyes * mesh.positions.size());
      sum += direction.cast<double>() - cosine * mesh.geometric_normals[v].cast<double>();
    }
    EXPECT_NEAR(cosines, 2.0 / 3.0, 0.01) << "integral of cos^2 over that of cos";
  }
  EXPECT_NEAR(squares, 0.5, 1e-3);
  EXPECT_LT(sum.norm() / static_cast<double>(Views::kEyes * mesh.positions.size()), 0.02) << "all around";
  EXPECT_FALSE(Views::to_eye(mesh, 0, 0).isApprox(Views::to_eye(mesh, 1, 0), 0.1F)) << "of one plane";
}

TEST(Views, SeeTheExitRadianceOfTheRunTime) {
  Mesh mesh = lobed();
  mesh.brdfs.heads.push_back({"measured", true});
  mesh.brdfs.rows.resize(kReflectanceTableSize);
  std::mt19937 random(3);
  for (float& value : mesh.brdfs.rows) value = std::uniform_real_distribution<float>(-1.0F, 1.0F)(random);
  mesh.brdf.assign(mesh.positions.size(), 0);
  mesh.brdf[5] = 1;
  const LightCoefficients light = random_light(3, 8);
  const std::vector<float> reaching(light.values.begin(), light.values.end());
  for (const std::size_t v : {0U, 4U, 5U}) {
    const auto seen = Views(mesh, v, 3).radiance(reaching.data());
    for (std::size_t eye = 0; eye < Views::kEyes; ++eye) {
      const Eigen::Vector3f expected = exit_radiance(material_of(mesh, v, mesh.albedo[v]), 3, reaching.data(),
                                                     mesh.normals[v], Views::to_eye(mesh, v, eye));
      EXPECT_LT((seen[eye] - expected.cast<double>()).norm(), 1e-5) << v << " " << eye;
    }
  }
  double largest = 0.0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    for (const Eigen::Vector3d& seen : Views(mesh, v, 3).radiance(reaching.data())) {
      largest = std::max(largest, seen.maxCoeff());
    }
  }
  EXPECT_EQ(largest_glossy_radiance(mesh, light), largest);
  EXPECT_EQ(largest_reflectance(mesh), 1.0F) << "a BRDF";
  EXPECT_FLOAT_EQ(largest_reflectance(lobed()), 0.75F) << "blue";
}

TEST(HemisphereBound, HoldsForAnyVisibilityAndIsMetByTheHemisphere) {
  std::mt19937 random(5);
  constexpr int kDegree = 6;
  const std::vector<Eigen::Vector3f> directions = make_directions(Sampler::kFibonacci, 20000);
  std::vector<std::array<double, coefficient_count(kDegree)>> basis(directions.size());
  for (std::size_t j = 0; j < directions.size(); ++j) {
    const Eigen::Vector3d d = directions[j].cast<double>();
    evaluate_basis(kDegree, d.x(), d.y(), d.z(), basis[j].data());
  }
  std::array<double, kDegree + 1> most{};
  for (int trial = 0; trial < 40;
       ++trial) {  // the visibility that a random function of a band likes best, and all of it
    const int band = trial % (kDegree + 1);
    std::array<double, coefficient_count(kDegree)> liked{}, sum{};
    for (int i = band * band; i < (band + 1) * (band + 1); ++i) liked[i] = std::normal_distribution<double>()(random);
    for (std::size_t j = 0; j < directions.size(); ++j) {
      const double value = std::inner_product(liked.begin(), liked.end(), basis[j].begin(), 0.0);
      if (directions[j].z() <= 0.0F || (trial >= kDegree + 1 && value <= 0.0)) continue;
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += basis[j][i] * 4.0 * std::numbers::pi / 20000.0;
    }
    for (int l = 0; l <= kDegree; ++l) {
      double squares = 0.0;
      for (int i = l * l; i < (l + 1) * (l + 1); ++i) squares += sum[i] * sum[i];
      const double bound = transfer_band_bound(kGlossyShadowed, false, l);
      EXPECT_LE(std::sqrt(squares), (1.0 + 1e-6) * bound) << l;
      most[l] = std::max(most[l], std::sqrt(squares) / bound);
      if (trial > 0) continue;
      EXPECT_NEAR(std::sqrt(squares), hemisphere_band_norm(l), 2e-3) << l;
    }
  }
  EXPECT_NEAR(most[0], 1.0, 1e-3) << "an open vertex";
  for (const double part : most) EXPECT_GT(part, 0.4);
}

// Closed vertices take light from their neighbors, which the part has, too.
TEST(Rehearsal, HasTheVisibilityOfABake) {
  const Mesh mesh = lobed();
  const BakeOptions asked{.degree = 2, .directions = 300, .seed = 5, .kind = &kGlossyShadowed};
  const Rehearsal rehearsal(scene_of(mesh, asked), "");
  const auto is_closed = [&](std::uint32_t v) { return rehearsal.sight(0)[v].closed() > 0.0F; };
  Scene scene = scene_of(mesh, asked);
  const Transfer whole = bake(scene);
  const std::vector<float> rows = rehearsal.rows(asked, {mesh, all_vertices(mesh), is_closed}, {});
  ASSERT_EQ(rows.size(), whole.coefficients.size());
  for (std::size_t i = 0; i < rows.size(); ++i) ASSERT_NEAR(rows[i], whole.coefficients[i], 1e-6F) << i;
}

/// The radiance that reaches every vertex by the mean of the coarse bakes, under Y_k in all channels.
std::vector<float> reaching_in_coarse(const Rehearsal& rehearsal, const Mesh& mesh, const BakeOptions& asked,
                                      std::size_t k) {
  LightCoefficients light = LightCoefficients::zero(asked.degree);
  for (std::size_t c = 0; c < 3; ++c) light.at(c, k) = 1.0;
  std::vector<float> sum(mesh.positions.size() * 3 * light.bands_squared(), 0.0F);
  for (const std::uint32_t half : {0U, 1U}) {
    Scene scene = scene_of(mesh, asked);
    scene.bake.directions = Rehearsal::kCoarseDirections;
    scene.bake.sampler = Sampler::kSobol;
    scene.bake.seed = half + 1;
    scene.bake.bounces.tolerance = 1e-2;
    const Transfer coarse = bake(scene);
    EXPECT_EQ(coarse.coefficients, rehearsal.coarse(half));
    const TransferredRadiance reaching(coarse, light);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += 0.5F * reaching.at(0)[i];
  }
  return sum;
}

// Ray by ray, with what the run time says of the light that leaves a hit.
TEST(Rehearsal, GathersWhatLobesSendByTheCoarseBakes) {
  Mesh mesh = finished(bowl({0.3F, 0.4F, 0.2F}), {0.3F, 0.4F, 0.2F}, {0.5F, 0.2F, 0.3F}, 6.0F);
  const BakeOptions asked{.degree = 2, .directions = 200, .kind = &kGlossyInterreflected};
  const Rehearsal rehearsal(scene_of(mesh, asked), "");
  const std::vector<std::uint32_t> wanted = {7, 20};
  const auto never = [](std::uint32_t) { return false; };
  const std::vector<float> rows = rehearsal.rows(asked, {mesh, wanted, never}, {});
  const RowShape shape(*asked.kind, mesh, 2);
  ASSERT_EQ(rows.size(), wanted.size() * (25 + 3 * 81));
  const RaySetup setup(mesh, asked, 1, "");
  Gatherer gatherer(mesh, setup.starts, setup.tracer, setup.directions);
  for (std::size_t k = 0; k < 9; k += 4) {
    const std::vector<float> reaching = reaching_in_coarse(rehearsal, mesh, asked, k);
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      std::array<Eigen::Vector3d, 9> expected;
      expected.fill(Eigen::Vector3d::Zero());
      for (const BlockedAt& ray : rays_to_fronts(gatherer, wanted[i])) {
        std::array<float, 9> basis;
        evaluate_basis(2, ray.direction.x(), ray.direction.y(), ray.direction.z(), basis.data());
        const Face& face = mesh.faces[ray.hit.face];
        const std::array<float, 3> parts = {1.0F - ray.hit.u - ray.hit.v, ray.hit.u, ray.hit.v};
        for (std::size_t corner = 0; corner < 3; ++corner) {
          const Eigen::Vector3f sent =
              parts[corner] * exit_radiance(material_of(mesh, face[corner], mesh.albedo[face[corner]]), 2,
                                            reaching.data() + face[corner] * std::size_t{27},
                                            mesh.normals[face[corner]], -ray.direction);
          for (std::size_t r = 0; r < 9; ++r) {
            expected[r] += (sent * basis[r]).cast<double>() * 4.0 * std::numbers::pi / 200.0;
          }
        }
      }
      const float* matrix = rows.data() + i * shape.length() + 25;
      for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t r = 0; r < 9; ++r) {
          EXPECT_NEAR(static_cast<double>(matrix[c * 81 + r * 9 + k]), expected[r][static_cast<Eigen::Index>(c)], 1e-5);
        }
      }
    }
  }
  BakeOptions low = asked;
  low.degree = 1;
  const std::vector<float> cut = rehearsal.rows(low, {mesh, wanted, never}, {});
  ASSERT_EQ(cut.size(), rows.size()) << "of the asked degree";
  EXPECT_EQ(cut[25 + 8], 0.0F) << "column 8 of row 0";
  EXPECT_EQ(cut[25 + 8 * 9], 0.0F) << "row 8";
  EXPECT_NE(cut[25 + 3], 0.0F);
  std::vector<std::uint8_t> open(mesh.positions.size(), 0);
  open[20] = 1;
  const std::vector<float> some = rehearsal.rows(asked, {mesh, wanted, never}, open);
  EXPECT_TRUE(std::equal(some.begin(), some.begin() + 268, rows.begin()));
  EXPECT_TRUE(std::all_of(some.begin() + 268 + 25, some.end(), [](float value) { return value == 0.0F; }));
}

TEST(Rehearsal, MeasuresHowMuchLobesSpreadDifferences) {
  const auto spread = [](float reflectance, const TransferKind* kind) {
    const Mesh mesh = polished(bowl({0.5F, 0.5F, 0.5F}), 0.5F * reflectance, 0.5F * reflectance, 4.0F);
    return Rehearsal(scene_of(mesh, kind, 64, 2), "").spread({random_light(2, 3), random_light(2, 4)});
  };
  EXPECT_EQ(spread(0.9F, &kGlossyShadowed), 1.0) << "no bounces";
  EXPECT_EQ(spread(0.0F, &kGlossyInterreflected), 1.0) << "black";
  const double bright = spread(0.9F, &kGlossyInterreflected);
  EXPECT_GT(bright, 1.02);
  EXPECT_LT(bright, 4.0);
  EXPECT_GE(bright, spread(0.4F, &kGlossyInterreflected));
}

TEST(Measurement, HasTheRadiancesOfGlossyRelightingOverTheUnit) {
  for (const TransferKind* kind : {&kGlossyShadowed, &kGlossyInterreflected}) {
    const Scene scene = glossy_scene(kind);
    const LightCoefficients light = random_light(2, 7);
    const Measurement measurement(scene, light, LightTurns::kAboutZ, 2.5, "");
    const Transfer whole = full_bake(scene);
    const std::size_t vertices = scene.mesh.positions.size();
    ASSERT_EQ(measurement.probe().vertices.size(), vertices);
    const RowShape asked(*kind, scene.mesh, 2);
    std::vector<float> rows;
    for (std::size_t v = 0; v < vertices; ++v) {
      rows.insert(rows.end(), whole.row(v), whole.row(v) + 25);
      const std::size_t size = whole.indirect_shape.length();
      if (asked.matrices) rows.insert(rows.end(), &whole.indirect[v * size], &whole.indirect[v * size] + size);
    }
    for (const int degree : {2, 1}) {
      const RowShape shape(*kind, scene.mesh, degree);
      const std::vector<float> kept = measurement.kept(rows, shape);
      ASSERT_EQ(kept.size(), vertices * shape.length());
      const Measurement::Radiances seen = measurement.radiances(kept, shape);
      ASSERT_EQ(seen.size(), 24 * vertices * Views::kEyes * 3);
      // The lower bands, by hand.
      Transfer low = Transfer::of(*kind, degree);
      low.mesh = scene.mesh;
      const std::size_t count = coefficient_count(degree);
      for (std::size_t v = 0; v < vertices; ++v) {
        low.coefficients.insert(low.coefficients.end(), whole.row(v), whole.row(v) + coefficient_count(2 * degree));
        for (std::size_t i = 0; asked.matrices && i < 3 * 81; ++i) {
          if (i % 9 < count && i / 9 % 9 < count) low.indirect.push_back(whole.indirect[v * 243 + i]);
        }
      }
      if (asked.matrices) low.indirect_shape = *shape.matrices;
      if (asked.matrices) low.indirect = decode(encode(low.indirect, low.indirect_shape), low.indirect_shape);
      for (const std::size_t t : {0U, 7U}) {
        const LightCoefficients now =
            turned(light, rotation_about(Eigen::Vector3d::UnitZ(), 15.0 * static_cast<double>(t)));
        const TransferredRadiance reaching(low, first_bands(now, degree));
        for (std::size_t v = 0; v < vertices; ++v) {
          const auto expected = Views(scene.mesh, v, degree).radiance(reaching.at(v));
          for (std::size_t i = 0; i < Views::kEyes * 3; ++i) {
            EXPECT_NEAR(seen[(t * vertices + v) * Views::kEyes * 3 + i],
                        expected[i / 3][static_cast<Eigen::Index>(i % 3)] / 2.5, 1e-6);
          }
        }
      }
    }
  }
}

TEST(Measurement, StatesTheMeanOverEyesOfTheLoudestChannelAndTheWorstTurn) {
  const Scene scene = glossy_scene(&kGlossyShadowed);
  const std::size_t vertices = scene.mesh.positions.size();
  const Measurement measurement(scene, random_light(2, 7), LightTurns::kAboutZ, 2.5, "");
  Measurement::Radiances difference(24 * vertices * Views::kEyes * 3, 0.0);
  EXPECT_EQ(measurement.error(difference), 0.0);
  const std::size_t turn = 5 * vertices * Views::kEyes * 3;
  for (std::size_t i = 0; i < vertices * Views::kEyes; ++i) {
    difference[turn + 3 * i] = 1.0;
    difference[turn + 3 * i + i % 3] = -4.0;
  }
  EXPECT_NEAR(measurement.error(difference), 4.0, 1e-12) << "the same for all eyes";
  for (std::size_t i = 0; i < vertices * Views::kEyes; i += 2) {
    for (std::size_t c = 0; c < 3; ++c) difference[turn + 3 * i + c] = 0.0;
  }
  // Half of the eyes see 16, the other half nothing: variance 64 16/15 of one eye.
  const double variance = static_cast<double>(vertices) * 64.0 / 15.0;
  const double expected = 8.0 + Probe::kDeviations * std::sqrt(variance) / static_cast<double>(vertices);
  EXPECT_NEAR(measurement.error(difference), std::sqrt(expected), 1e-9);
}

TEST(StatedError, CountsTheVarianceOfSquaresThatAreMeans) {
  const Probe probe{{0, 1}, {0.5, 0.25}};
  const double variance = 0.5 * std::pow(1.0 / 0.5, 2) + 0.75 * std::pow(3.0 / 0.25, 2) + 2.0 / 0.5 + 5.0 / 0.25;
  EXPECT_NEAR(stated_error(probe, {1.0, 3.0}, 8, {2.0, 5.0}),
              std::sqrt((1.0 / 0.5 + 3.0 / 0.25 + Probe::kDeviations * std::sqrt(variance)) / 8.0), 1e-12);
}

}  // namespace
}  // namespace sh::prt::test
