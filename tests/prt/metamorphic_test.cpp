// What a change of the scene must do to its light, as properties over random scenes.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <numeric>
#include <random>

#include "prt/runtime/relight.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/random_scenes.hpp"

namespace sh::prt::test {
namespace {

// The same scenes in every run; RC_PARAMS in the environment has priority.
[[maybe_unused]] const int kFixed = setenv("RC_PARAMS", "seed=20 max_success=12", 0);

constexpr int kDegree = 3;
constexpr int kDirections = 512;
constexpr unsigned kSeed = 4;

using Radiance = std::vector<Eigen::Vector3f>;

Radiance lit(const Mesh& mesh, const TransferKind* kind, const LightCoefficients& light, int directions = kDirections) {
  return relight(baked(mesh, kind, directions, kDegree), light);
}

double rms(const Radiance& a, const Radiance& b) {
  double sum = 0.0;
  for (std::size_t v = 0; v < a.size(); ++v) sum += (a[v] - b[v]).cast<double>().squaredNorm();
  return std::sqrt(sum / static_cast<double>(a.size()));
}

LightCoefficients some_light() { return random_light(kDegree, kSeed); }

// The error of the sampler at a scene: against 16 times the directions.
double sampler_error(const Mesh& mesh, const TransferKind* kind, const LightCoefficients& light) {
  return rms(lit(mesh, kind, light), lit(mesh, kind, light, 16 * kDirections));
}

Mesh mapped(const Mesh& mesh, const Eigen::Affine3d& map) {
  Mesh out = mesh;
  std::vector<Eigen::Vector3d> points = points_of(mesh);
  for (Eigen::Vector3d& p : points) p = map * p;
  place(out, points, "test");
  const Eigen::Matrix3d turn = map.rotation();
  for (auto* normals : {&out.normals, &out.geometric_normals}) {
    for (Eigen::Vector3f& n : *normals) n = (turn * n.cast<double>()).normalized().cast<float>();
  }
  return out;
}

const TransferKind* some_kind() { return *rc::gen::element(&kShadowed, &kInterreflected); }

// ---- the same rays: the same light but for rays that graze an edge

RC_GTEST_PROP(Metamorphic, MovedScenesHaveTheSameLight, ()) {
  const Mesh mesh = mesh_of(*some_pieces());
  const TransferKind* kind = some_kind();
  const double distance = *rc::gen::element(3.0, 100.0, 1e4, 1e6, 1e9);
  const Eigen::Affine3d moved(Eigen::Translation3d(distance * Eigen::Vector3d(1.0, -0.37, 0.61)));
  RC_ASSERT(rms(lit(mapped(mesh, moved), kind, some_light()), lit(mesh, kind, some_light())) < 2e-3);
}

RC_GTEST_PROP(Metamorphic, ScaledScenesHaveTheSameLight, ()) {
  const Mesh mesh = mesh_of(*some_pieces());
  const TransferKind* kind = some_kind();
  const double scale = *rc::gen::element(0.1, 1e-6, 1e-14, 1e-29, 7.0, 1e7, 1e14, 1e29);
  const Eigen::Affine3d scaled(Eigen::Scaling(scale));
  RC_ASSERT(rms(lit(mapped(mesh, scaled), kind, some_light()), lit(mesh, kind, some_light())) < 2e-3);
}

RC_GTEST_PROP(Metamorphic, ReorderedVerticesAndFacesHaveTheSameLight, ()) {
  const Mesh mesh = mesh_of(*some_pieces());
  const TransferKind* kind = some_kind();
  std::vector<std::uint32_t> to(mesh.positions.size());  // old vertex -> new vertex
  std::iota(to.begin(), to.end(), 0U);
  std::mt19937 random(*rc::gen::inRange(0, 100));
  std::shuffle(to.begin(), to.end(), random);
  Mesh other = mesh;
  other.halving = {};  // of the old order
  for (std::size_t v = 0; v < to.size(); ++v) {
    other.positions[to[v]] = mesh.positions[v];
    other.normals[to[v]] = mesh.normals[v];
    other.geometric_normals[to[v]] = mesh.geometric_normals[v];
    other.albedo[to[v]] = mesh.albedo[v];
  }
  for (Face& face : other.faces) face = {to[face[1]], to[face[2]], to[face[0]]};
  std::shuffle(other.faces.begin(), other.faces.end(), random);
  const Radiance got = lit(other, kind, some_light());
  Radiance back(got.size());
  for (std::size_t v = 0; v < to.size(); ++v) back[v] = got[to[v]];
  RC_ASSERT(rms(back, lit(mesh, kind, some_light())) < 2e-3);
}

RC_GTEST_PROP(Metamorphic, DoubledFacesHaveTheSameLight, ()) {
  const Mesh mesh = mesh_of(*some_pieces());
  const TransferKind* kind = some_kind();
  Mesh twice = mesh;
  append(twice, mesh);
  Radiance got = lit(twice, kind, some_light());
  const Radiance expected = lit(mesh, kind, some_light());
  const Radiance second(got.begin() + static_cast<std::ptrdiff_t>(expected.size()), got.end());
  got.resize(expected.size());
  RC_ASSERT(rms(got, expected) < 2e-3);
  RC_ASSERT(rms(second, expected) < 2e-3);
}

// ---- other rays: the same light but for the error of the sampler

RC_GTEST_PROP(Metamorphic, ATurnedSceneUnderTheTurnedLightHasTheSameLight, ()) {
  const Mesh mesh = mesh_of(*some_pieces());
  const TransferKind* kind = some_kind();
  const Eigen::Vector3d axis = Eigen::Vector3d(*rc::gen::inRange(-3, 4), *rc::gen::inRange(-3, 4), 1.0).normalized();
  const Eigen::Matrix3d turn = rotation_about(axis, *rc::gen::inRange(0, 360));
  const Radiance got = lit(mapped(mesh, Eigen::Affine3d(turn)), kind, turned(some_light(), turn));
  const Radiance expected = lit(mesh, kind, some_light());
  RC_ASSERT(rms(got, expected) < 4.0 * sampler_error(mesh, kind, some_light()) + 2e-3);
}

RC_GTEST_PROP(Metamorphic, AMirroredSceneUnderTheMirroredLightHasTheSameLight, ()) {
  const Mesh mesh = mesh_of(*some_pieces());
  const TransferKind* kind = some_kind();
  Mesh mirrored = mesh;  // at the plane y = 0
  for (auto* vectors : {&mirrored.positions, &mirrored.normals, &mirrored.geometric_normals}) {
    for (Eigen::Vector3f& v : *vectors) v.y() = -v.y();
  }
  for (Face& face : mirrored.faces) std::swap(face[1], face[2]);
  mirrored.halving = {};  // of the old order of corners
  LightCoefficients light = some_light();
  for (int l = 0; l <= kDegree; ++l) {
    for (int m = -l; m < 0; ++m) {
      for (int c = 0; c < 3; ++c) light.at(c, numeric::coefficient_index(l, m)) *= -1.0;  // sin(m phi) changes its sign
    }
  }
  const double error = 4.0 * sampler_error(mesh, kind, some_light()) + 2e-3;
  RC_ASSERT(rms(lit(mirrored, kind, light), lit(mesh, kind, some_light())) < error);
}

RC_GTEST_PROP(Metamorphic, SubdividedFacesKeepTheShadowsOfTheirVertices, ()) {
  const Mesh mesh = mesh_of(*some_pieces());
  Mesh fine = mesh;
  refine(fine, 0.6F * longest_edge(mesh));
  Radiance got = lit(fine, &kShadowed, some_light());
  got.resize(mesh.positions.size());
  const double error = 4.0 * sampler_error(mesh, &kShadowed, some_light()) + 2e-3;
  RC_ASSERT(rms(got, lit(mesh, &kShadowed, some_light())) < error);
}

RC_GTEST_PROP(Metamorphic, MoreRaysComeNearer, ()) {
  const Mesh mesh = mesh_of(*some_pieces());
  const TransferKind* kind = some_kind();
  const Radiance reference = lit(mesh, kind, some_light(), 64 * kDirections);
  double before = rms(lit(mesh, kind, some_light(), kDirections / 4), reference);
  for (const int directions : {kDirections, 4 * kDirections, 16 * kDirections}) {
    const double now = rms(lit(mesh, kind, some_light(), directions), reference);
    RC_ASSERT(now < before + 1e-3);
    before = now;
  }
}

// ---- the light alone

RC_GTEST_PROP(Metamorphic, LightsAddUp, ()) {
  const Transfer transfer = baked(mesh_of(*some_pieces()), some_kind(), 64, kDegree);
  const LightCoefficients a = random_light(kDegree, 1);
  const LightCoefficients b = random_light(kDegree, 2);
  LightCoefficients sum = a;
  for (int c = 0; c < 3; ++c) {
    for (std::size_t i = 0; i < coefficient_count(kDegree); ++i) sum.at(c, i) = 3.0 * a.at(c, i) - 0.5 * b.at(c, i);
  }
  const Radiance of_a = relight(transfer, a);
  const Radiance of_b = relight(transfer, b);
  const Radiance of_sum = relight(transfer, sum);
  for (std::size_t v = 0; v < of_a.size(); ++v) RC_ASSERT((of_sum[v] - 3.0F * of_a[v] + 0.5F * of_b[v]).norm() < 1e-5F);
}

RC_GTEST_PROP(Metamorphic, AnEvenSkyGivesNoVertexMoreThanItsAlbedo, ()) {
  const Mesh mesh = mesh_of(*some_pieces());
  const Radiance shadowed = lit(mesh, &kShadowed, constant_light(kDegree));
  const Radiance bounced = lit(mesh, &kInterreflected, constant_light(kDegree));
  for (std::size_t v = 0; v < shadowed.size(); ++v) {
    RC_ASSERT(shadowed[v].minCoeff() >= 0.0F);
    RC_ASSERT(((bounced[v] - shadowed[v]).array() >= -1e-6F).all());
    RC_ASSERT(((mesh.albedo[v] - bounced[v]).array() >= -1e-5F).all());
  }
}

}  // namespace
}  // namespace sh::prt::test
