// The part of lobes above the degree of a transfer, against functions of one band and against integrals.
#include "prt/runtime/sharp_layer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/quadrature.hpp"
#include "prt/bake/compress.hpp"
#include "prt/basis.hpp"
#include "prt/light/light.hpp"
#include "prt/material/lobe.hpp"
#include "prt/material/microfacet.hpp"
#include "prt/mesh/corners.hpp"
#include "prt/runtime/glossy.hpp"
#include "tests/prt/glossy_meshes.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

const std::vector<Eigen::Vector3d> kDirections = {{0.0, 0.0, 1.0},   {0.0, 0.0, -1.0},   {1.0, 0.0, 0.0},
                                                  {-1.0, 1e-4, 0.0}, {-1.0, -1e-4, 0.0}, {0.36, -0.48, 0.8},
                                                  {0.01, 0.02, -0.9}};

Mesh ball(float exponent) { return polished(primitive_mesh("sphere", 8), 0.1F, 0.8F, exponent); }

TEST(SharpLayer, OfOneBandIsTheBandTimesTheFactorOfTheLobe) {
  for (const auto& [l, m] : {std::pair(4, 2), {5, 0}, {5, -5}, {8, -3}, {10, 10}, {20, 7}}) {
    const auto band = [l = l, m = m](const Eigen::Vector3d& s) {
      if (l > kMaxDegree) return numeric::basis_value<double>(l, m, s.x(), s.y(), s.z());
      BasisValues basis;
      evaluate_basis(kMaxDegree, s.x(), s.y(), s.z(), basis.data());
      return basis[coefficient_index(l, m)];
    };
    const SkyRadiance sky = [&](const Eigen::Vector3d& s) -> Eigen::Vector3f {
      return Eigen::Vector3d(band(s), -2.0 * band(s), 0.0).cast<float>();
    };
    const SharpLayer layer(sky, 4, ball(50.0F));
    const double factor = l > 4 ? phong_factor(l, 50.0) : 0.0;
    for (const Eigen::Vector3d& direction : kDirections) {
      const Eigen::Vector3d s = direction.normalized();
      const Eigen::Vector3f found = layer.at(50.0F, s.cast<float>());
      // Between the nodes of the map the highest bands lose a little.
      const double off = 1e-5 + 6e-5 * l * l * factor;
      EXPECT_NEAR(static_cast<double>(found.x()), factor * band(s), off) << l << ' ' << m;
      EXPECT_NEAR(static_cast<double>(found.y()), -2.0 * factor * band(s), 2.0 * off) << l << ' ' << m;
      EXPECT_NEAR(found.z(), 0.0F, 1e-6F);
    }
  }
}

// Without shadows the bands of the transfer and the layer make the whole lobe.
TEST(SharpLayer, AndTheTransferAreTheLobe) {
  const Eigen::Vector3d center = Eigen::Vector3d(1.0, -2.0, 2.0).normalized();
  const double least = std::cos(0.35);
  const auto soft_cap = [&](const Eigen::Vector3d& s) {
    return 1.0 / (1.0 + std::exp(60.0 * (least - s.dot(center))));
  };
  const auto nodes = numeric::sphere_rule<double>(200);
  for (const float exponent : {4.0F, 60.0F, 400.0F}) {
    const Mesh mesh = ball(exponent);
    const SharpLayer layer(
        [&](const Eigen::Vector3d& s) { return Eigen::Vector3f::Constant(static_cast<float>(soft_cap(s))).eval(); }, 2,
        mesh);
    std::vector<float> light(3 * coefficient_count(2), 0.0F);
    for (const auto& node : nodes) {
      BasisValues basis;
      evaluate_basis(2, node.x, node.y, node.z, basis.data());
      for (std::size_t i = 0; i < light.size(); ++i) {
        light[i] +=
            static_cast<float>(node.weight * soft_cap({node.x, node.y, node.z}) * basis[i % coefficient_count(2)]);
      }
    }
    const Material material{.specular = Eigen::Vector3f::Ones(), .exponent = exponent};
    for (const Eigen::Vector3d& about :
         {center, Eigen::Vector3d(0.5, -2.0, 2.5).normalized(), Eigen::Vector3d(0, 0, 1)}) {
      double expected = 0.0;
      for (const auto& node : nodes) {
        const Eigen::Vector3d s(node.x, node.y, node.z);
        const auto e = static_cast<double>(exponent);
        expected +=
            node.weight * soft_cap(s) * (e + 1.0) / (2.0 * std::numbers::pi) * std::pow(std::max(0.0, s.dot(about)), e);
      }
      const Eigen::Vector3f axis = about.cast<float>();
      const float low = exit_radiance(material, 2, light.data(), axis, axis).x();
      EXPECT_NEAR(static_cast<double>(low + layer.at(exponent, axis).x()), expected, 3e-3) << exponent;
    }
  }
}

TEST(SharpLayer, OfAMeshWithoutLobesIsNothing) {
  Mesh mesh = primitive_mesh("box");
  const SkyRadiance sky = [](const Eigen::Vector3d&) { return Eigen::Vector3f::Ones().eval(); };
  EXPECT_EQ(SharpLayer(sky, 4, mesh).at(5.0F, Eigen::Vector3f::UnitX()), Eigen::Vector3f::Zero());
  mesh = ball(20.0F);
  for (const Eigen::Vector3d& s : kDirections) {
    EXPECT_LT(SharpLayer(sky, 0, mesh).at(20.0F, s.normalized().cast<float>()).norm(), 1e-5F) << "a constant sky";
  }
}

TEST(SharpLayer, RefusesWhatItCannotHold) {
  const SkyRadiance sky = [](const Eigen::Vector3d&) { return Eigen::Vector3f::Ones().eval(); };
  Mesh mesh = primitive_mesh("sphere", 16);
  mesh = polished(mesh, 0.1F, 0.8F, 0.0F);
  for (std::size_t v = 0; v < mesh.exponent.size(); ++v) mesh.exponent[v] = static_cast<float>(v);
  EXPECT_NE(message_of([&] { SharpLayer(sky, 4, mesh); }).find("more than 64 different exponents"), std::string::npos);
  const SkyRadiance bad = [](const Eigen::Vector3d& s) {
    constexpr float kInfinite = std::numeric_limits<float>::infinity();
    const Eigen::Vector3f radiance = Eigen::Vector3f::Ones();
    return s.z() > 0.99 ? Eigen::Vector3f::Constant(kInfinite).eval() : radiance;
  };
  EXPECT_NE(message_of([&] { SharpLayer(bad, 4, ball(9.0F)); }).find("expected finite radiance"), std::string::npos);
}

TEST(VisibilityTowards, IsThatOfTheRowsCutToZeroAndOne) {
  const Mesh mesh = ball(9.0F);
  Transfer transfer = baked(mesh, &kGlossyShadowed, 1024, 4);
  const auto at = [&](const Transfer& of, const Eigen::Vector3f& direction) {
    return visibility_towards(of, {0, 0.2F, 0.3F, 1.0F}, direction);
  };
  const Eigen::Vector3f normal = interpolated({0, 0.2F, 0.3F, 1.0F}, mesh, mesh.normals).normalized();
  EXPECT_GT(at(transfer, normal), 0.9F);
  EXPECT_LT(at(transfer, -normal), 0.1F);
  for (const Eigen::Vector3d& s : kDirections) {
    const float seen = at(transfer, s.normalized().cast<float>());
    EXPECT_TRUE(seen >= 0.0F && seen <= 1.0F);
  }
  EXPECT_EQ(at(baked(mesh, &kGlossyUnshadowed, 64, 4), -normal), 1.0F);
  Transfer clustered = transfer;
  compress(clustered, {8, 12});
  EXPECT_NEAR(at(clustered, normal), at(transfer, normal), 0.05F);
}

// A picture with the layer, where the light turns: that of turned lights.
TEST(SharpLayer, IsShownByTheSurface) {
  const Mesh mesh = ball(80.0F);
  const Transfer transfer = baked(mesh, &kGlossyUnshadowed, 64, 2);
  const TransferredRadiance reaching(transfer, random_light(2, 3));
  const MoreOfLobe more = [&](const Hit& hit, std::size_t vertex, const Eigen::Vector3f& direction) -> Eigen::Vector3f {
    EXPECT_EQ(vertex, mesh.faces[2][0]);
    EXPECT_NEAR(direction.norm(), 1.0F, 1e-5F);
    return Eigen::Vector3f(1.0F, 2.0F, static_cast<float>(hit.face));
  };
  const Eigen::Vector3f towards = Eigen::Vector3f(0.3F, -0.4F, -0.5F).normalized();
  const Hit hit{2, 0.2F, 0.3F, 1.0F};
  const Eigen::Vector3f plain = glossy_surface(transfer, reaching, mesh.albedo)(hit, towards);
  const Eigen::Vector3f sharp = glossy_surface(transfer, reaching, mesh.albedo, more)(hit, towards);
  EXPECT_LT((sharp - plain - Eigen::Vector3f(1.0F, 2.0F, 2.0F)).norm(), 1e-5F);
}

TEST(SharpLayer, OfAVertexHasTheColorAndTheExponentOfItsLobe) {
  Mesh mesh = ball(30.0F);
  mesh.specular[3] = {0.1F, 0.2F, 0.4F};
  mesh.exponent[3] = 60.0F;
  mesh.specular[4].setZero();
  const SkyRadiance sky = [](const Eigen::Vector3d& s) {
    return Eigen::Vector3f::Constant(s.z() > 0.9 ? 1.0F : 0.0F).eval();
  };
  const SharpLayer layer(sky, 2, mesh);
  const Eigen::Vector3f up = Eigen::Vector3f::UnitZ();
  EXPECT_GT(layer.at(30.0F, up).x(), 0.01F);
  EXPECT_EQ(layer.at(std::size_t{3}, up), mesh.specular[3].cwiseProduct(layer.at(60.0F, up)));
  EXPECT_GT(layer.at(60.0F, up).x(), layer.at(30.0F, up).x() + 0.01F);
  EXPECT_EQ(layer.at(std::size_t{4}, up), Eigen::Vector3f::Zero());
  EXPECT_TRUE(layer.fits().empty());
}

// Rough metal at degree 2 with the layer, against degree 10, which holds nearly all of it.
TEST(SharpLayer, InPlaceOfABrdfIsThatOfTheNearestLobe) {
  Mesh mesh = finished(primitive_mesh("sphere", 12), {0.9F, 0.7F, 0.3F}, Eigen::Vector3f::Zero(), 0.0F);
  mesh.brdfs.number_of(microfacet_reflectance(0.45F, 1.0F));
  mesh.brdf.assign(mesh.positions.size(), 1);
  const LightSpec disc{.type = LightType::kCap, .direction = kSlanted, .one_minus_cos = 0.05};
  const std::vector<Light> lights = load_lights({disc}, OnFlaw::kRefuse);
  const SharpLayer layer([&](const Eigen::Vector3d& s) { return radiance(lights, s); }, 2, mesh);
  ASSERT_EQ(layer.fits().size(), 1U);
  const MoreOfLobe more = [&layer](const Hit&, std::size_t vertex, const Eigen::Vector3f& direction) {
    return layer.at(vertex, direction);
  };
  const Transfer low = baked(mesh, &kGlossyUnshadowed, 1, 2);
  const Transfer high = baked(mesh, &kGlossyUnshadowed, 1, kMaxDegree);
  const Surface plain = glossy_surface(low, {low, project(lights, 2)}, mesh.albedo);
  const Surface sharp = glossy_surface(low, {low, project(lights, 2)}, mesh.albedo, more);
  const Surface whole = glossy_surface(high, {high, project(lights, kMaxDegree)}, mesh.albedo);
  double off = 0.0;
  double off_with_layer = 0.0;
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    const Hit hit{f, 0.3F, 0.3F, 1.0F};
    const Eigen::Vector3f towards = -interpolated(hit, mesh, mesh.normals).normalized();
    const Eigen::Vector3f along = (towards + Eigen::Vector3f(0.3F, -0.2F, 0.1F)).normalized();
    const Eigen::Vector3f expected = whole(hit, along);
    off += static_cast<double>((plain(hit, along) - expected).squaredNorm());
    off_with_layer += static_cast<double>((sharp(hit, along) - expected).squaredNorm());
  }
  EXPECT_LT(std::sqrt(off_with_layer), 0.3 * std::sqrt(off));
}

}  // namespace
}  // namespace sh::prt::test
