// Lobes in place of BRDFs: fits of tables, and meshes and bakes that take them.
#include "prt/material/lobe_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "prt/basis.hpp"
#include "prt/material/microfacet.hpp"
#include "prt/material/tabulate.hpp"
#include "prt/mesh/fit_lobes.hpp"
#include "prt/runtime/glossy.hpp"
#include "prt/runtime/relight.hpp"
#include "tests/prt/glossy_meshes.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

using Parts = std::array<Eigen::Vector2d, kReflectionParts>;  // the diffuse share and that of the lobe

// A table of a lobe and of diffuse reflection.
ReflectanceTable table_of(double exponent, const Parts& parts) {
  ReflectanceTable table(kReflectanceTableSize, 0.0F);
  float* to = table.data();
  for (int view = 0; view < kViews; ++view) {
    const Eigen::Vector3d eye = view_direction(view);
    BasisValues about_normal;
    BasisValues about_mirrored;
    zonal_about(
        kMaxDegree, Eigen::Vector3d(0.0, 0.0, 1.0), [](int l) { return phong_factor(l, 1.0); }, about_normal.data());
    zonal_about(
        kMaxDegree, Eigen::Vector3d(-eye.x(), 0.0, eye.z()), [&](int l) { return phong_factor(l, exponent); },
        about_mirrored.data());
    for (const Eigen::Vector2d& part : parts) {
      for (int l = 0; l <= kMaxDegree; ++l) {
        for (int m = 0; m <= l; ++m) {
          const std::size_t i = coefficient_index(l, m);
          *to++ = static_cast<float>(part.x() * about_normal[i] + part.y() * about_mirrored[i]);
        }
      }
    }
  }
  return table;
}

TEST(LobeFit, OfALobeIsThatLobe) {
  const Parts colored = {Eigen::Vector2d(0.5, 0.1), {0.05, 0.25}, {0.0, 0.0}};
  const Parts channels = {Eigen::Vector2d(0.5, 0.1), {0.05, 0.25}, {0.0, 0.9}};
  for (const bool is_measured : {false, true}) {
    const Parts& parts = is_measured ? channels : colored;
    for (const double exponent : {0.0, 0.5, 4.0, 30.0}) {
      const ReflectanceTable table = table_of(exponent, parts);
      for (const int degree : {2, 4, kMaxDegree}) {
        const LobeFit fit = fit_lobe({table.data(), is_measured}, degree);
        EXPECT_NEAR(static_cast<double>(fit.exponent), exponent, 1e-3 * (1.0 + exponent)) << degree;
        EXPECT_LT(fit.error, 1e-4);
        for (std::size_t part = 0; part < kReflectionParts; ++part) {
          EXPECT_NEAR(fit.diffuse[part], parts[part].x(), 2e-3) << exponent << ' ' << degree;
          EXPECT_NEAR(fit.specular[part], parts[part].y(), 2e-3) << exponent << ' ' << degree;
        }
      }
    }
  }
}

// Exit radiance under every Y_k, as the run time has it: squares over views with the density of the cosine.
double squares_at_run_time(const Material& a, const Material& b, int degree) {
  double sum = 0.0;
  for (int view = 0; view < kViews; ++view) {
    const Eigen::Vector3d eye = view_direction(view);
    for (std::size_t k = 0; k < coefficient_count(degree); ++k) {
      std::vector<float> reaching(3 * coefficient_count(degree), 0.0F);
      for (std::size_t c = 0; c < 3; ++c) reaching[c * coefficient_count(degree) + k] = 1.0F;
      const auto sent = [&](const Material& by) {
        return exit_radiance(by, degree, reaching.data(), Eigen::Vector3f::UnitZ(), eye.cast<float>());
      };
      const Eigen::Vector3f none = Eigen::Vector3f::Zero();
      const Eigen::Vector3f apart = sent(a) - (b.brdf || !b.specular.isZero() || !b.albedo.isZero() ? sent(b) : none);
      sum += eye.z() * eye.x() * static_cast<double>(apart.squaredNorm());
    }
  }
  return sum;
}

// The parts are the channels of a measured BRDF, so that each has its own least squares.
TEST(LobeFit, OfFacetsIsTheNearestThatTheRunTimeShows) {
  constexpr int kDegree = 4;
  for (const auto& [roughness, metallic] : {std::pair(0.2F, 1.0F), {0.5F, 1.0F}, {0.9F, 1.0F}, {0.3F, 0.0F}}) {
    const Reflectance made = microfacet_reflectance(roughness, metallic);
    const Material table{.brdf = {made.table.data(), true}};
    const LobeFit fit = fit_lobe(table.brdf, kDegree);
    Material found{.exponent = fit.exponent};
    for (Eigen::Index part = 0; part < 3; ++part) {
      found.albedo[part] = static_cast<float>(fit.diffuse[static_cast<std::size_t>(part)]);
      found.specular[part] = static_cast<float>(fit.specular[static_cast<std::size_t>(part)]);
    }
    const double whole = squares_at_run_time(table, {}, kDegree);
    const double left = squares_at_run_time(table, found, kDegree);
    EXPECT_NEAR(std::sqrt(left / whole), fit.error, 0.01 * fit.error) << roughness;
    EXPECT_GT(fit.error, 0.01) << roughness;
    EXPECT_LT(fit.error, 0.4) << roughness;
    for (const float part : {0.9F, 1.1F}) {
      Material other = found;
      other.exponent *= part;
      EXPECT_GT(squares_at_run_time(table, other, kDegree), left) << roughness << " exponent " << part;
      other = found;
      other.specular *= part;
      EXPECT_GT(squares_at_run_time(table, other, kDegree), left) << roughness << " specular " << part;
      other = found;
      other.albedo = (other.albedo.array() + 0.2F * (part - 1.0F)).cwiseMax(0.0F);
      if (other.albedo != found.albedo) {
        EXPECT_GT(squares_at_run_time(table, other, kDegree), left) << roughness << " albedo " << part;
      }
    }
  }
}

// A mirror's light at any view, if not its Fresnel term.
TEST(LobeFit, OfRougherSurfacesHasADullerLobe) {
  float before = 2.0F * kMaxExponent;
  for (const float roughness : {0.0F, 0.1F, 0.3F, 0.5F, 0.8F, 1.0F}) {
    const float exponent = fit_lobe({microfacet_reflectance(roughness, 1.0F).table.data()}, 10).exponent;
    EXPECT_LT(exponent, before) << roughness;
    before = exponent;
  }
  const LobeFit mirror = fit_lobe({microfacet_reflectance(0.0F, 1.0F).table.data()}, 4);
  EXPECT_GT(mirror.exponent, 1e4F);
  EXPECT_GT(mirror.specular[0], 0.9);
  EXPECT_LT(mirror.error, 0.15) << "Fresnel's rise";
}

TEST(LobeFit, GainsNoLightAndIsNeverNegative) {
  for (const float roughness : {0.0F, 0.05F, 0.4F, 1.0F}) {
    for (const float metallic : {0.0F, 0.5F, 1.0F}) {
      const Reflectance made = microfacet_reflectance(roughness, metallic);
      for (const int degree : {0, 1, 4, kMaxDegree}) {
        for (const bool is_measured : {false, true}) {
          const LobeFit fit = fit_lobe({made.table.data(), is_measured}, degree);
          double all = 0.0;
          for (std::size_t part = 0; part < kReflectionParts; ++part) {
            EXPECT_GE(fit.diffuse[part], 0.0);
            EXPECT_GE(fit.specular[part], 0.0);
            const double one = fit.diffuse[part] + fit.specular[part];
            all += one;
            EXPECT_LE(one, 1.0 + 1e-12);
          }
          if (!is_measured) {
            EXPECT_LE(all, 1.0 + 1e-12);
          }
          EXPECT_GE(fit.exponent, 0.0F);
          EXPECT_LE(fit.exponent, kMaxExponent);
          EXPECT_TRUE(fit.error >= 0.0 && fit.error < 0.7) << roughness << ' ' << metallic << ' ' << degree;
        }
      }
    }
  }
  const Parts bright = {Eigen::Vector2d(0.9, 0.2), {0.0, 0.3}, {0.0, 0.0}};
  const LobeFit scaled = fit_lobe({table_of(9.0, bright).data()}, 4);
  EXPECT_NEAR(scaled.diffuse[0] + scaled.specular[0] + scaled.diffuse[1] + scaled.specular[1], 1.0, 1e-12);
  EXPECT_LE(scaled.error, 0.4 / 1.4 + 1e-6);
  EXPECT_GT(scaled.error, 0.25) << "of the scaled fit";
  const LobeFit measured =
      fit_lobe({table_of(9.0, {Eigen::Vector2d(0.9, 0.35), {0.1, 0.3}, {0.2, 0.0}}).data(), true}, 4);
  EXPECT_NEAR(measured.diffuse[0] + measured.specular[0], 1.0, 1e-12) << "the brightest channel";
  EXPECT_NEAR(measured.diffuse[1] + measured.specular[1], 0.4 / 1.25, 0.01);
  EXPECT_NEAR(measured.diffuse[2], 0.2 / 1.25, 0.01);
  EXPECT_EQ(fit_lobe({ReflectanceTable(kReflectanceTableSize, 0.0F).data()}, 4).error, 0.0) << "black";
}

// Two coated vertices among plain and polished ones.
TEST(FitLobes, ReplacesTablesAndNothingElse) {
  Mesh mesh = finished(primitive_mesh("box"), {0.4F, 0.2F, 0.1F}, {0.3F, 0.3F, 0.2F}, 7.0F);
  const Mesh before = mesh;
  const std::size_t gold = mesh.brdfs.number_of(microfacet_reflectance(0.3F, 1.0F));
  const std::size_t measured =
      mesh.brdfs.number_of({"measured", true, table_of(9.0, {Eigen::Vector2d(0.5, 0.1), {0.2, 0.3}, {0.1, 0.4}})});
  mesh.brdf.assign(mesh.positions.size(), 0);
  mesh.brdf[2] = static_cast<std::uint16_t>(1 + gold);
  mesh.brdf[5] = static_cast<std::uint16_t>(1 + measured);
  const LobeFit expected = fit_lobe(mesh.brdfs.table(gold), 3);
  const std::vector<FittedBrdf> fits = fit_lobes(mesh, 3);
  ASSERT_EQ(fits.size(), 2U);
  EXPECT_EQ(fits[1].name, "measured");
  EXPECT_TRUE(mesh.brdf.empty() && mesh.brdfs.heads.empty() && mesh.brdfs.rows.empty());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (v == 2 || v == 5) continue;
    EXPECT_EQ(mesh.albedo[v], before.albedo[v]);
    EXPECT_EQ(mesh.specular[v], before.specular[v]);
    EXPECT_EQ(mesh.exponent[v], 7.0F);
  }
  EXPECT_EQ(mesh.exponent[2], expected.exponent);
  const Eigen::Vector3f lobe = static_cast<float>(expected.specular[0]) * before.albedo[2] +
                               Eigen::Vector3f::Constant(static_cast<float>(expected.specular[1]));
  EXPECT_LT((mesh.specular[2] - lobe).norm(), 1e-6F);
  EXPECT_LT((mesh.albedo[5] - Eigen::Vector3f(0.5F, 0.2F, 0.1F)).norm(), 3e-3F);
  EXPECT_LT((mesh.specular[5] - Eigen::Vector3f(0.1F, 0.3F, 0.4F)).norm(), 3e-3F);
  EXPECT_NEAR(mesh.exponent[5], 9.0F, 0.05F);
  Mesh plain = primitive_mesh("plane");
  plain.brdfs.number_of(microfacet_reflectance(0.3F, 1.0F));
  plain.brdf = {0, 1, 0, 0};
  fit_lobes(plain, 3);
  ASSERT_EQ(plain.specular.size(), 4U) << "a mesh without lobes";
  ASSERT_EQ(plain.exponent.size(), 4U);
  EXPECT_EQ(plain.exponent[1], expected.exponent);
  EXPECT_EQ(plain.specular[0], Eigen::Vector3f::Zero());
  const std::vector<FittedBrdf> none = fit_lobes(mesh, 3);
  EXPECT_TRUE(none.empty());
  EXPECT_EQ(described({"clay", {.exponent = 12.5F, .error = 0.125}}),
            "BRDF `clay` as a lobe of exponent 12.5: off by 0.12 of itself (rms over views)");
}

TEST(FitLobes, IsAChoiceOfGlossyBakes) {
  Mesh mesh = finished(primitive_mesh("box"), {0.4F, 0.2F, 0.1F}, Eigen::Vector3f::Zero(), 0.0F);
  mesh.brdfs.number_of(microfacet_reflectance(0.3F, 1.0F));
  mesh.brdf.assign(mesh.positions.size(), 1);
  for (const TransferKind* kind : {&kShadowed, &kGlossyUnshadowed, &kGlossyShadowed, &kGlossyInterreflected}) {
    for (const bool fits : {false, true}) {
      Scene scene = scene_of(mesh, kind, 64, 2);
      scene.bake.fit_lobes = fits;
      std::vector<std::string> said;
      const Transfer transfer = bake(scene, nullptr, [&](const std::string& line) { said.push_back(line); });
      const bool is_fitted = fits && kind->is_glossy();
      EXPECT_EQ(transfer.mesh.brdf.empty(), is_fitted || !kind->is_glossy());
      EXPECT_EQ(transfer.mesh.exponent[0] > 1.0F, is_fitted) << kind->letters;
      EXPECT_EQ(std::count_if(said.begin(), said.end(),
                              [](const std::string& line) { return line.find("as a lobe") != std::string::npos; }),
                is_fitted ? 1 : 0);
    }
  }
}

TEST(FitLobes, IsReadFromScenes) {
  const TemporaryFolder folder;
  const auto load = [&](const std::string& value) {
    write_all(folder.file("scene.json"),
              R"({"meshes": [{"primitive": "box", "roughness": 0.5}], "bake": {"fit_lobes": )" + value + "}}");
    return load_scene(folder.file("scene.json"), OnFlaw::kRefuse).bake.fit_lobes;
  };
  EXPECT_TRUE(load("true"));
  EXPECT_FALSE(load("false"));
  EXPECT_NE(message_of([&] { load("1"); }).find("/bake/fit_lobes: expected true or false, got 1"), std::string::npos);
}

// Where the lobes of the corners differ, the radiance of all three.
TEST(GlossySurface, BetweenLobesIsTheMeanOfTheirRadiance) {
  Mesh mesh = finished(primitive_mesh("plane"), {0.4F, 0.2F, 0.1F}, {0.3F, 0.3F, 0.2F}, 7.0F);
  const Face face = mesh.faces[0];
  mesh.specular[face[1]] = {0.1F, 0.5F, 0.4F};
  mesh.exponent[face[2]] = 30.0F;
  EXPECT_FALSE(has_one_finish(mesh, face));
  const Transfer transfer = baked(mesh, &kGlossyUnshadowed, 64, 3);
  const LightCoefficients light = random_light(3, 5);
  const auto at = [&](float u, float v, bool sharp) {
    const MoreOfLobe more = [&mesh](const Hit&, std::size_t vertex, const Eigen::Vector3f& direction) {
      return (mesh.exponent[vertex] * Eigen::Vector3f(1.0F, 0.1F, direction.z())).eval();
    };
    const Surface surface =
        glossy_surface(transfer, TransferredRadiance(transfer, light), mesh.albedo, sharp ? more : MoreOfLobe());
    return surface({.face = 0, .u = u, .v = v}, Eigen::Vector3f(0.6F, 0.0F, -0.8F));
  };
  for (const bool sharp : {false, true}) {
    const Eigen::Vector3f expected =
        0.5F * at(0.0F, 0.0F, sharp) + 0.2F * at(1.0F, 0.0F, sharp) + 0.3F * at(0.0F, 1.0F, sharp);
    EXPECT_LT((at(0.2F, 0.3F, sharp) - expected).norm(), 1e-5F * expected.norm());
    EXPECT_GT((at(0.0F, 0.0F, sharp) - at(1.0F, 0.0F, sharp)).norm(), 1e-3F);
    EXPECT_GT((at(0.0F, 0.0F, sharp) - at(0.0F, 1.0F, sharp)).norm(), 1e-3F);
  }
  mesh.specular[face[1]] = mesh.specular[face[0]];
  EXPECT_FALSE(has_one_finish(mesh, face)) << "exponents";
  mesh.exponent[face[2]] = 7.0F;
  EXPECT_TRUE(has_one_finish(mesh, face));
}

}  // namespace
}  // namespace sh::prt::test
