// Lightmaps: the values of their pixels, the seams between charts, and their EXR files.
#include "prt/runtime/lightmap.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "prt/image/exr_writer.hpp"
#include "prt/image/image.hpp"
#include "prt/rays/receivers_at.hpp"
#include "prt/runtime/glossy.hpp"
#include "prt/runtime/relight.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/little_scene.hpp"
#include "tests/prt/square_with_texels.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

TEST(Lightmap, HoldsTheIrradianceOfConstantLightInEveryDirection) {
  const Transfer transfer = baked(square_with_texels(3), &kGlossyUnshadowed, 64);
  const auto e = directional_irradiance(transfer, TransferredRadiance(transfer, constant_light(2)));
  for (std::size_t v = 0; v < transfer.mesh.positions.size(); ++v) {
    EXPECT_NEAR(e[0][v].x(), std::numbers::pi_v<float>, 1e-5F);
    for (std::size_t k = 1; k < 4; ++k) EXPECT_NEAR(e[k][v].norm(), 0.0F, 1e-5F);
  }
}

TEST(Lightmap, OfABlackSurfaceIsZeroAndFinite) {
  Mesh mesh = square_with_texels(3);
  paint(mesh, {0.0F, 0.5F, 1.0F});
  const Transfer transfer = baked(mesh, &kShadowed, 64);
  const auto irradiance = irradiance_of(transfer, relight(transfer, constant_light(2)), transfer.mesh.albedo);
  for (const Eigen::Vector3f& e : irradiance) {
    EXPECT_EQ(e.x(), 0.0F);
    EXPECT_NEAR(e.y(), std::numbers::pi_v<float>, 1e-4F);
    EXPECT_NEAR(e.z(), std::numbers::pi_v<float>, 1e-4F);
  }
}

TEST(Lightmap, KeepsTheChannelsOfItsLightApart) {
  for (const int degree : {0, 1, 3}) {
    const Transfer transfer = baked(square_with_texels(2), &kGlossyUnshadowed, 64, degree);
    LightCoefficients light = constant_light(degree);
    for (std::size_t c = 0; c < 3; ++c) light.at(c, 0) *= static_cast<double>(c + 1);
    const auto e = directional_irradiance(transfer, TransferredRadiance(transfer, light));
    for (const Eigen::Vector3f& value : e[0]) {
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(value[c], std::numbers::pi_v<float> * float(c + 1), 2e-5F) << degree;
    }
    for (std::size_t k = 1; k < 4; ++k) {
      for (const Eigen::Vector3f& value : e[k]) EXPECT_LT(value.norm(), 2e-5F) << degree << " " << k;
    }
  }
}

// Wider than high, and higher than the 16 rows that are compressed together; largest, least and denormal numbers.
TEST(ExrWriter, WritesWhatIsRead) {
  const TemporaryFolder folder;
  for (const auto& [width, height] : {std::pair{1, 1}, {7, 3}, {3, 40}}) {
    std::vector<ExrChannel> channels = {{"R", {}}, {"G", {}}, {"B", {}}};
    for (std::size_t c = 0; c < 3; ++c) {
      for (int i = 0; i < width * height; ++i) channels[c].values.push_back(1000.0F * float(c) + float(i) + 0.1F);
    }
    channels[0].values.back() = std::numeric_limits<float>::max();
    channels[1].values.back() = std::numeric_limits<float>::denorm_min();
    channels[2].values.back() = -2.5F;
    write_all(folder.file("a.exr"), exr_bytes(width, height, channels));
    const Image image = read_exr(folder.file("a.exr"), OnFlaw::kRefuse);
    ASSERT_EQ(image.width, width);
    ASSERT_EQ(image.height, height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
      for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(image.pixels[i][Eigen::Index(c)], channels[c].values[i]) << i;
    }
  }
}

TEST(Lightmap, HasThreeChannelsWithTheValuesOfItsPixels) {
  const Mesh mesh = square_with_texels(3);
  const SurfaceReceivers receivers(mesh);
  std::vector<Eigen::Vector3f> values;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) values.emplace_back(float(v), 100.0F + float(v), -float(v));
  const std::vector<ExrChannel> channels = channels_of(receivers, 0, values, "e1.");
  ASSERT_EQ(channels.size(), 3U);
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_EQ(channels[c].name, std::string("e1.") + "RGB"[c]);
    ASSERT_EQ(channels[c].values.size(), 9U);
    for (std::size_t pixel = 0; pixel < 9; ++pixel) {
      EXPECT_EQ(channels[c].values[pixel], values[4 + pixel][Eigen::Index(c)]);
    }
  }
}

// Faces with one texel each, in atlases of their own.
struct Patches {
  // A face whose first edge runs from one place to another, with the value of its texel.
  void add(const Eigen::Vector3f& from, const Eigen::Vector3f& to, const Eigen::Vector3f& value) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const auto number = static_cast<float>(first);
    for (const Eigen::Vector3f& at : {from, to, Eigen::Vector3f(number, number + 1.0F, 9.0F)}) {
      mesh.positions.push_back(at);
      mesh.normals.emplace_back(Eigen::Vector3f::UnitZ());
      mesh.atlas.push_back(static_cast<std::uint16_t>(mesh.atlases.heads.size() + 1));
      values.emplace_back(Eigen::Vector3f::Zero());
    }
    for (const Eigen::Vector2f& at : {Eigen::Vector2f(0.25F, 0.5F), {0.75F, 0.5F}, {0.5F, 1.0F}}) {
      mesh.chart.push_back(at);
    }
    mesh.faces.push_back({first, first + 1, first + 2});
    texels.push_back({value});
    mesh.atlases.heads.emplace_back(Atlases::Head{1, 1, 0, 1});
  }
  [[nodiscard]] Seams seams() {
    std::vector<Eigen::Vector3f> all = values;
    Mesh whole = mesh;
    for (std::size_t a = 0; a < texels.size(); ++a) {
      Atlases::Head& head = whole.atlases.heads[a];
      head = {static_cast<int>(texels[a].size()), 1, static_cast<std::uint32_t>(all.size()),
              static_cast<std::uint32_t>(texels[a].size())};
      for (std::uint32_t i = 0; i < head.count; ++i) whole.atlases.pixels.push_back(i);
      all.insert(all.end(), texels[a].begin(), texels[a].end());
    }
    return measure_seams(whole, SurfaceReceivers(whole), all);
  }
  Mesh mesh;
  std::vector<Eigen::Vector3f> values;               // of vertices: nobody reads them
  std::vector<std::vector<Eigen::Vector3f>> texels;  // (atlases), in a row
};

const Eigen::Vector3f kOrigin(0.0F, 0.0F, 0.0F);
const Eigen::Vector3f kThree(0.0F, 3.0F, 0.0F);
const Eigen::Vector3f kOne(1.0F, 0.0F, 0.0F);

Patches one_seam() {
  Patches patches;
  patches.add(kOrigin, kThree, {1.0F, 2.0F, 2.0F});
  patches.add(kThree, kOrigin, {1.0F, 2.0F, 0.0F});
  return patches;
}

TEST(Lightmap, SeamsCountByTheirLengths) {
  Patches patches = one_seam();
  EXPECT_EQ(patches.seams().edges, 1U);
  EXPECT_NEAR(patches.seams().difference, 2.0, 1e-6);
  EXPECT_NEAR(patches.seams().value, std::sqrt(7.0), 1e-6);
  patches.add(kOne, kOne + Eigen::Vector3f::UnitY(), {0.0F, 0.0F, 4.0F});  // a second one, a third as long
  patches.add(kOne + Eigen::Vector3f::UnitY(), kOne, {0.0F, 0.0F, 0.0F});
  EXPECT_EQ(patches.seams().edges, 2U);
  EXPECT_NEAR(patches.seams().difference, std::sqrt((3.0 * 4.0 + 16.0) / 4.0), 1e-6);
  EXPECT_NEAR(patches.seams().value, std::sqrt((3.0 * 7.0 + 8.0) / 4.0), 1e-6);
}

TEST(Lightmap, SeamsAreReadAlongTheirEdge) {
  Patches patches = one_seam();
  patches.texels = {{Eigen::Vector3f::Zero()}, {Eigen::Vector3f::Zero(), Eigen::Vector3f::UnitX()}};
  // From 0 to 1, at the middles of eighths: the mean of their squares.
  EXPECT_NEAR(patches.seams().difference, std::sqrt(680.0 / 2048.0), 1e-6);
  EXPECT_NEAR(patches.seams().value, std::sqrt(340.0 / 2048.0), 1e-6);
  patches.texels[0] = {Eigen::Vector3f::UnitX(), Eigen::Vector3f::Zero()};  // it runs the other way
  EXPECT_NEAR(patches.seams().difference, 0.0, 1e-6);
}

TEST(Lightmap, SeamsAreEdgesThatTheAtlasPartsAndTheSurfaceDoesNot) {
  const auto edges = [](const auto& change) {
    Patches patches = one_seam();
    change(patches);
    const Seams seams = patches.seams();
    EXPECT_TRUE(std::isfinite(seams.difference) && std::isfinite(seams.value));
    return seams.edges;
  };
  const auto join = [](Patches& p) {  // both in the first atlas, one end at the same place
    for (std::size_t v = 3; v < 6; ++v) p.mesh.atlas[v] = 1;
    p.mesh.chart[4] = p.mesh.chart[0];
  };
  EXPECT_EQ(edges(join), 1U) << "the seam opens from one end";
  EXPECT_EQ(edges([&](Patches& p) {
              join(p);
              p.mesh.chart[3] = p.mesh.chart[1];
            }),
            0U);
  EXPECT_EQ(edges([&](Patches& p) {
              join(p);
              p.mesh.chart[3] = p.mesh.chart[1];
              for (std::size_t v = 3; v < 6; ++v) p.mesh.atlas[v] = 2;
            }),
            1U)
      << "the same places of different atlases";
  for (const std::size_t v : {0U, 1U, 3U, 4U}) {
    const auto turn = [&](double degrees) {
      return edges([&](Patches& p) {
        p.mesh.normals[v] =
            Eigen::AngleAxisf(static_cast<float>(degrees * std::numbers::pi / 180.0), Eigen::Vector3f::UnitX()) *
            p.mesh.normals[v];
      });
    };
    EXPECT_EQ(turn(4.9), 1U) << v;
    EXPECT_EQ(turn(5.1), 0U) << v << ": an edge of the surface";
  }
  EXPECT_EQ(edges([](Patches& p) { std::swap(p.mesh.positions[3], p.mesh.positions[4]); }), 0U) << "faces that overlap";
  EXPECT_EQ(edges([](Patches& p) { p.add(kThree, kOrigin, {}); }), 1U) << "a third face has no partner";
  EXPECT_EQ(edges([](Patches& p) { p.mesh.positions[3].z() = 1e-6F; }), 0U);
  EXPECT_EQ(edges([](Patches& p) { p.mesh.atlas.assign(6, 0); }), 0U);
  EXPECT_EQ(edges([](Patches& p) { p.mesh.atlas.clear(); }), 0U);
}

// A cylinder's side goes once around: u = 0 and u = 1 are one edge.
Seams seams_of_cylinder(int size) {
  Soup soup = make_primitive("sphere", 48);
  soup.chart = soup.texture;
  Mesh mesh = weld(soup);
  add_atlas(mesh, mesh.faces.size(), size, "sphere");
  const Transfer transfer = baked(mesh, &kUnshadowed, 64);
  return measure_seams(mesh, SurfaceReceivers(mesh), relight(transfer, random_light(2, 5)));
}

TEST(Lightmap, SeamsCloseWithTheSizeOfTexels) {
  const Seams coarse = seams_of_cylinder(32);
  const Seams fine = seams_of_cylinder(128);
  EXPECT_GT(coarse.edges, 10U);
  EXPECT_EQ(coarse.edges, fine.edges);
  EXPECT_GT(coarse.difference, 0.0);
  EXPECT_LT(fine.difference, 0.4 * coarse.difference);
  EXPECT_LT(fine.difference, 0.05 * fine.value);
  EXPECT_EQ(measure_seams(square_with_texels(4), SurfaceReceivers(square_with_texels(4)), {}).edges, 0U);
}

}  // namespace
}  // namespace sh::prt::test
