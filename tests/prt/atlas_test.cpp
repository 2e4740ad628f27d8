// Texels of an atlas as receivers: where they lie, what is refused, that they are what vertices at the same places are, and
// how light is read between them.
#include "prt/mesh/atlas.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>
#include <set>

#include "prt/rays/receivers_at.hpp"
#include "prt/runtime/glossy.hpp"
#include "prt/runtime/relight.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/little_scene.hpp"
#include "tests/prt/square_with_texels.hpp"
#include "tests/prt/temporary_folder.hpp"
#include "tests/prt/transfer_bytes.hpp"

namespace sh::prt::test {
namespace {

// One triangle in z = 0 whose places in the atlas are its x and y, or their mirror image.
Mesh triangle(const std::array<Eigen::Vector2f, 3>& corners, bool mirrored = false) {
  Mesh mesh;
  for (const Eigen::Vector2f& at : corners) {
    mesh.positions.emplace_back(at.x(), at.y(), 0.0F);
    mesh.normals.emplace_back(Eigen::Vector3f::UnitZ());
    mesh.albedo.emplace_back(0.5F, 0.25F, 0.75F);
    mesh.chart.emplace_back(mirrored ? 1.0F - at.x() : at.x(), at.y());
  }
  mesh.faces = {{0, 1, 2}};
  set_geometric_normals(mesh);
  return mesh;
}

// Above a square of so many texels, off its middle.
Mesh with_box_above(Mesh mesh) {
  append(mesh, primitive_mesh("box", 24, Eigen::Translation3f(0.1F, -0.05F, 0.2F) * Eigen::Scaling(0.2F)));
  return mesh;
}

TEST(Atlas, HasATexelForEveryPixelThatAFaceTouches) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> uniform(0.0F, 1.0F);
  for (int trial = 0; trial < 200; ++trial) {
    const int size = 1 + trial % 13;
    std::array<Eigen::Vector2f, 3> corners;
    for (Eigen::Vector2f& corner : corners) corner = {uniform(random), uniform(random)};
    Mesh mesh = triangle(corners);
    const std::vector<std::uint32_t> faces = add_atlas(mesh, 1, size, "t");
    EXPECT_EQ(faces, std::vector<std::uint32_t>(mesh.atlases.heads[0].count, 0));
    const std::set<std::uint32_t> pixels(mesh.atlases.pixels.begin(), mesh.atlases.pixels.end());
    ASSERT_EQ(pixels.size(), mesh.atlases.pixels.size());
    for (int sample = 0; sample < 500; ++sample) {
      float u = uniform(random);
      float v = uniform(random);
      if (u + v > 1.0F) std::tie(u, v) = std::pair(1.0F - u, 1.0F - v);
      const Eigen::Vector2f at = corners[0] + u * (corners[1] - corners[0]) + v * (corners[2] - corners[0]);
      const int column = std::min(static_cast<int>(at.x() * static_cast<float>(size)), size - 1);
      const int row = std::min(static_cast<int>((1.0F - at.y()) * static_cast<float>(size)), size - 1);
      ASSERT_TRUE(pixels.count(static_cast<std::uint32_t>(row * size + column)) == 1) << at.transpose() << " " << size;
    }
  }
}

TEST(Atlas, LaysTexelsOnTheirFaceInsideOfTheirPixel) {
  std::mt19937 random(4);
  std::uniform_real_distribution<float> uniform(0.0F, 1.0F);
  for (int trial = 0; trial < 200; ++trial) {
    const int size = 1 + trial % 17;
    std::array<Eigen::Vector2f, 3> corners;
    for (Eigen::Vector2f& corner : corners) corner = {uniform(random), uniform(random)};
    Mesh mesh = triangle(corners);
    add_atlas(mesh, 1, size, "t");
    const Atlases::Head& atlas = mesh.atlases.heads[0];
    for (std::uint32_t i = 0; i < atlas.count; ++i) {
      const Eigen::Vector3f& place = mesh.positions[atlas.first + i];
      const Eigen::Vector2f center = center_of_pixel(atlas, mesh.atlases.pixels[i]);
      EXPECT_EQ(center, mesh.chart[atlas.first + i]);
      const float from_center = (place.head<2>() - center).cwiseAbs().maxCoeff() * static_cast<float>(size);
      EXPECT_LE(from_center, 0.5F + 1e-3F);
      EXPECT_EQ(place.z(), 0.0F);
      EXPECT_NEAR(mesh.atlases.reach[i], 0.5F / static_cast<float>(size), 1e-4F / static_cast<float>(size));
    }
  }
}

// In texels of an atlas, how far a point lies inside of the edges of a triangle; negative outside.
double depth_of(const std::array<Eigen::Vector2f, 3>& corners, const Eigen::Vector2f& at, int size) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector2d a = corners[k].cast<double>();
    const Eigen::Vector2d along = (corners[(k + 1) % 3].cast<double>() - a).normalized();
    Eigen::Vector2d inwards(-along.y(), along.x());
    if (inwards.dot(corners[(k + 2) % 3].cast<double>() - a) < 0.0) inwards = -inwards;
    least = std::min(least, size * inwards.dot(at.cast<double>() - a));
  }
  return least;
}

TEST(Atlas, LaysTexelsAtTheirCenterWhereItsFaceHasRoom) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> uniform(0.0F, 1.0F);
  int at_center = 0;
  int moved = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const int size = 1 + trial % 40;
    std::array<Eigen::Vector2f, 3> corners;
    for (Eigen::Vector2f& corner : corners) corner = {uniform(random), uniform(random)};
    Mesh mesh = triangle(corners);
    add_atlas(mesh, 1, size, "t");
    for (std::size_t v = 3; v < mesh.positions.size(); ++v) {
      const Eigen::Vector2f place = mesh.positions[v].head<2>();
      if (depth_of(corners, mesh.chart[v], size) > 0.0101) {
        EXPECT_LT((place - mesh.chart[v]).norm(), 1e-6F);
        ++at_center;
      } else if ((place - mesh.chart[v]).norm() < 0.2F / static_cast<float>(size)) {
        // There is room beside the edge for what is a little outside or on it, but for corners of faces.
        EXPECT_GE(depth_of(corners, place, size), -1e-5);
        moved += depth_of(corners, place, size) > 0.0099 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(at_center, 10000);
  EXPECT_GT(moved, 100);
}

// What lies between the corners, at the place where the texel is.
TEST(Atlas, TexelsTakeWhatLiesBetweenTheCornersOfTheirFace) {
  Mesh mesh = triangle({Eigen::Vector2f(0.1F, 0.2F), {0.9F, 0.1F}, {0.3F, 0.8F}});
  mesh.albedo = {{0.1F, 0.9F, 0.5F}, {0.7F, 0.2F, 0.5F}, {0.3F, 0.4F, 1.0F}};
  mesh.normals = {Eigen::Vector3f(0.6F, 0.0F, 0.8F), {0.0F, -0.6F, 0.8F}, {0.0F, 0.0F, 1.0F}};
  mesh.texture = {{-3.0F, 5.0F}, {2.0F, 1.0F}, {0.5F, 0.25F}};
  mesh.emission = {{9.0F, 0.0F, 1.0F}, {0.0F, 3.0F, 1.0F}, {1.0F, 1.0F, 1.0F}};
  mesh.tint = {{1.0F, 0.25F, 0.5F}, {0.5F, 0.75F, 0.5F}, {0.0F, 0.5F, 0.125F}};
  mesh.exponent.assign(3, 7.0F);
  const Mesh before = mesh;
  add_atlas(mesh, 1, 6, "t");
  const Face& face = mesh.faces[0];
  Eigen::Matrix3f corners;
  for (int k = 0; k < 3; ++k) corners.col(k) << mesh.positions[face[k]].head<2>(), 1.0F;
  ASSERT_GT(mesh.positions.size(), 12U);
  for (std::size_t v = 3; v < mesh.positions.size(); ++v) {
    const Eigen::Vector3f place(mesh.positions[v].x(), mesh.positions[v].y(), 1.0F);
    const Eigen::Vector3f part = corners.inverse() * place;
    EXPECT_GT(part.minCoeff(), 0.0F);
    const auto expect_between = [&](const auto& values, const auto& corner_values, bool is_unit = false) {
      auto expected = (part[0] * corner_values[0] + part[1] * corner_values[1] + part[2] * corner_values[2]).eval();
      if (is_unit) expected.normalize();
      EXPECT_LT((values[v] - expected).norm(), 1e-5F) << v;
    };
    expect_between(mesh.albedo, before.albedo);
    expect_between(mesh.normals, before.normals, true);
    expect_between(mesh.texture, before.texture);
    expect_between(mesh.emission, before.emission);
    expect_between(mesh.tint, before.tint);
    EXPECT_EQ(mesh.exponent[v], 7.0F);
    EXPECT_EQ(mesh.geometric_normals[v], Eigen::Vector3f::UnitZ());
  }
}

TEST(Atlas, TexelsOfABackHaveTheSideOfTheirNormals) {
  const std::array<Eigen::Vector2f, 3> corners = {Eigen::Vector2f(0.1F, 0.2F), {0.9F, 0.15F}, {0.4F, 0.8F}};
  const auto texels = [&](const Eigen::Vector3f& normal) {
    Mesh mesh = triangle(corners);
    mesh.normals.assign(3, normal);
    add_atlas(mesh, 1, 4, "t");
    return mesh;
  };
  const Mesh back = texels(-Eigen::Vector3f::UnitZ());
  const Mesh without = texels(Eigen::Vector3f::Zero());  // as normals that cancel
  for (std::size_t v = 3; v < back.positions.size(); ++v) {
    EXPECT_EQ(back.normals[v], -Eigen::Vector3f::UnitZ());
    EXPECT_EQ(back.geometric_normals[v], -Eigen::Vector3f::UnitZ());
    EXPECT_EQ(without.normals[v], Eigen::Vector3f::UnitZ());
    EXPECT_EQ(without.geometric_normals[v], Eigen::Vector3f::UnitZ());
  }
}

// The centroid of what a face covers of a pixel whose center it leaves out, where that is known.
TEST(Atlas, LaysTexelsOfABorderInTheMiddleOfWhatIsCovered) {
  const auto place = [](const std::array<Eigen::Vector2f, 3>& corners, std::uint32_t pixel) {
    Mesh mesh = triangle(corners);
    add_atlas(mesh, 1, 4, "t");
    const auto& pixels = mesh.atlases.pixels;
    const auto found = std::find(pixels.begin(), pixels.end(), pixel);
    EXPECT_NE(found, pixels.end());
    const Eigen::Vector3f at = mesh.positions[3 + static_cast<std::size_t>(found - pixels.begin())];
    return Eigen::Vector2f(4.0F * at.x(), 4.0F * at.y());  // in texels, from below
  };
  // A whole triangle within a pixel: a third of the way along.
  const std::array<Eigen::Vector2f, 3> little = {
      Eigen::Vector2f(0.5F, 0.5F), {0.5F + 0.09F, 0.5F}, {0.5F, 0.5F + 0.09F}};
  EXPECT_LT((place(little, 4 + 2) - Eigen::Vector2f(2.12F, 2.12F)).norm(), 1e-5F);
  // What is left of an edge at x, in texels, and below a diagonal: a strip of the last column.
  const auto left_of = [&](float x) {
    return place({Eigen::Vector2f(0.0F, 0.0F), {x / 4.0F, 0.0F}, {x / 4.0F, 1.0F}}, 12 + 3);
  };
  EXPECT_LT((left_of(3.4F) - Eigen::Vector2f(3.2F, 0.5F)).norm(), 1e-5F);
  // An edge 0.004 texels beside the center: the texel moves away from it to a distance of 0.01, and no further.
  EXPECT_LT((left_of(3.504F) - Eigen::Vector2f(3.494F, 0.5F)).norm(), 1e-5F);
}

TEST(Atlas, ShowsTheFaceThatCoversMostWhereNoneCoversTheCenter) {
  // Two triangles at the left and right border of one pixel; the right one is wider.
  Mesh mesh = triangle({Eigen::Vector2f(0.0F, 0.0F), {0.3F, 0.0F}, {0.0F, 1.0F}});
  append(mesh, triangle({Eigen::Vector2f(1.0F, 0.0F), {1.0F, 1.0F}, {0.6F, 0.0F}}));
  append(mesh, triangle({Eigen::Vector2f(0.0F, 1.0F), {0.2F, 1.0F}, {0.0F, 0.7F}}));
  EXPECT_EQ(add_atlas(mesh, 3, 1, "t"), std::vector<std::uint32_t>{1});
}

// The pairs of a lattice: each once, the one to the right and the one below of every texel in order.
TEST(Atlas, NeighborsOnASquareAreThoseOfALattice) {
  const Mesh mesh = square_with_texels(4);
  std::vector<std::array<std::uint32_t, 2>> expected;
  for (std::uint32_t i = 0; i < 16; ++i) {
    if (i % 4 != 3) expected.push_back({4 + i, 5 + i});
    if (i < 12) expected.push_back({4 + i, 8 + i});
  }
  EXPECT_EQ(neighboring_texels(mesh), expected);
  Mesh two = mesh;
  append(two, mesh);
  const std::size_t vertices = mesh.positions.size();
  for (std::size_t i = 0; i < 24; ++i) {
    expected.push_back({expected[i][0] + std::uint32_t(vertices), expected[i][1] + std::uint32_t(vertices)});
  }
  EXPECT_EQ(neighboring_texels(two), expected);
}

TEST(Atlas, TexelsBesideEachOtherThatLieFarApartAreNoNeighbors) {
  const auto pairs = [](float gap) {  // of two halves of an atlas, of eight texels each, so far apart
    Mesh mesh;
    for (int half = 0; half < 2; ++half) {
      Mesh part = primitive_mesh("plane", 1, Eigen::Affine3f(Eigen::Scaling(0.5F, 1.0F, 1.0F)));
      for (Eigen::Vector3f& p : part.positions) {
        part.chart.emplace_back(p.x() + 0.25F + 0.5F * static_cast<float>(half), p.y() + 0.5F);
        p.x() += (0.5F + gap) * static_cast<float>(half);
      }
      if (half == 0) {
        mesh = std::move(part);
      } else {
        append(mesh, part);
      }
    }
    add_atlas(mesh, mesh.faces.size(), 4, "t");
    return neighboring_texels(mesh).size();
  };
  EXPECT_EQ(pairs(0.0F), 24U);
  // A texel is 1/4 wide: kFarthest times both reaches, of 1/8 each, is 1.
  EXPECT_EQ(pairs(0.74F), 24U);
  EXPECT_EQ(pairs(0.76F), 20U);
  EXPECT_EQ(pairs(100.0F), 20U);
}

// The pixel of the first texel of the second atlas is the one beside the last texel of the first.
TEST(Atlas, TexelsOfDifferentAtlasesAreNoNeighbors) {
  Mesh mesh;
  mesh.positions.assign(2, Eigen::Vector3f::Zero());
  mesh.atlases.heads = {{4, 4, 0, 1}, {4, 4, 1, 1}};
  mesh.atlases.pixels = {0, 1};
  mesh.atlases.reach = {1.0F, 1.0F};
  EXPECT_TRUE(neighboring_texels(mesh).empty());
  mesh.atlases.heads = {{4, 4, 0, 2}};
  EXPECT_EQ(neighboring_texels(mesh).size(), 1U);
}

// Every pixel of an atlas stands for one of the nearest texels.
TEST(Atlas, PixelsWithoutATexelStandForTheNearestOne) {
  std::mt19937 random(8);
  std::uniform_real_distribution<float> uniform(0.0F, 1.0F);
  for (int trial = 0; trial < 40; ++trial) {
    const int size = 1 + trial % 9;
    Mesh mesh = triangle({Eigen::Vector2f(uniform(random), uniform(random)),
                          {uniform(random), uniform(random)},
                          {uniform(random), uniform(random)}});
    add_atlas(mesh, 1, size, "t");
    const std::vector<std::uint32_t> stands = SurfaceReceivers(mesh).pixels(0);
    const auto distance = [&](std::uint32_t a, std::uint32_t b) {
      const auto n = static_cast<std::uint32_t>(size);
      return std::max(std::abs(int(a % n) - int(b % n)), std::abs(int(a / n) - int(b / n)));
    };
    for (std::uint32_t pixel = 0; pixel < stands.size(); ++pixel) {
      int nearest = size;
      for (const std::uint32_t texel : mesh.atlases.pixels) nearest = std::min(nearest, distance(pixel, texel));
      ASSERT_GE(stands[pixel], 3U);
      EXPECT_EQ(distance(pixel, mesh.atlases.pixels[stands[pixel] - 3]), nearest) << size << " " << pixel;
    }
  }
}

// An atlas of three columns and two rows, as a file may hold one.
TEST(Atlas, WiderThanHighIsReadBetweenItsTexels) {
  Mesh mesh;
  mesh.positions.assign(6, Eigen::Vector3f::Zero());
  mesh.atlases.heads = {{3, 2, 0, 6}};
  mesh.atlases.pixels = {0, 1, 2, 3, 4, 5};
  const SurfaceReceivers receivers(mesh);
  const std::vector<float> values = {1.0F, 10.0F, 100.0F, 1000.0F, 10000.0F, 100000.0F};
  const auto at = [&](float x, float y) {  // in pixels, from the upper left corner
    return receivers.in_atlas(0, {x / 3.0F, 1.0F - y / 2.0F}).mean(values);
  };
  for (int row = 0; row < 2; ++row) {
    for (int column = 0; column < 3; ++column) {
      const float value = at(static_cast<float>(column) + 0.5F, static_cast<float>(row) + 0.5F);
      EXPECT_NEAR(value / values[static_cast<std::size_t>(3 * row + column)], 1.0F, 1e-5F);
    }
  }
  EXPECT_NEAR(at(1.0F, 0.5F), 5.5F, 1e-4F);
  EXPECT_NEAR(at(1.75F, 0.5F), 32.5F, 1e-4F);
  EXPECT_NEAR(at(0.5F, 1.25F), 750.25F, 1e-3F);
  EXPECT_NEAR(at(2.0F, 1.0F), 27527.5F, 0.05F);
  EXPECT_EQ(at(0.0F, 0.0F), 1.0F);
  EXPECT_EQ(at(3.0F, 2.0F), 100000.0F);
  EXPECT_EQ(at(0.0F, 2.0F), 1000.0F);
}

TEST(Atlas, IsTheSameForMirroredCoordinates) {
  // In 64ths, whose mirror image is exact.
  const std::array<Eigen::Vector2f, 3> corners = {
      Eigen::Vector2f(0.109375F, 0.203125F), {0.890625F, 0.15625F}, {0.40625F, 0.796875F}};
  Mesh mesh = triangle(corners);
  Mesh mirrored = triangle(corners, true);
  add_atlas(mesh, 1, 8, "t");
  add_atlas(mirrored, 1, 8, "t");
  ASSERT_EQ(mesh.positions.size(), mirrored.positions.size());
  for (std::size_t i = 0; i < mesh.atlases.pixels.size(); ++i) {
    const std::uint32_t other = mesh.atlases.pixels[i] / 8 * 8 + 7 - mesh.atlases.pixels[i] % 8;
    const auto found = std::find(mirrored.atlases.pixels.begin(), mirrored.atlases.pixels.end(), other);
    ASSERT_NE(found, mirrored.atlases.pixels.end());
    const auto k = static_cast<std::size_t>(found - mirrored.atlases.pixels.begin());
    EXPECT_LT((mesh.positions[3 + i] - mirrored.positions[3 + k]).norm(), 1e-6F);
    EXPECT_EQ(mirrored.geometric_normals[3 + k], Eigen::Vector3f::UnitZ());
  }
}

TEST(Atlas, RefusesCoordinatesThatAreNoChart) {
  const auto said = [](Mesh mesh, std::size_t faces = 1) {
    return message_of([&] { add_atlas(mesh, faces, 8, "a.gltf"); });
  };
  const std::array<Eigen::Vector2f, 3> corners = {Eigen::Vector2f(0.1F, 0.2F), {0.9F, 0.15F}, {0.4F, 0.8F}};
  Mesh mesh = triangle(corners);
  mesh.chart[1].x() = 1.5F;
  EXPECT_EQ(said(mesh),
            "a.gltf: texels need texture coordinates from 0 to 1, got 1.5 0.15; expected a second set that covers each "
            "place of the surface once");
  mesh.chart[1].x() = -0.25F;
  EXPECT_NE(said(mesh).find("from 0 to 1, got -0.25 0.15;"), std::string::npos);
  mesh.chart[1].x() = std::numeric_limits<float>::quiet_NaN();
  EXPECT_NE(said(mesh).find("a face has none"), std::string::npos);
  mesh.chart.clear();
  EXPECT_NE(said(mesh).find("the mesh has none"), std::string::npos);
  Mesh twice = triangle(corners);
  append(twice, triangle(corners));
  EXPECT_EQ(said(twice, 2),
            "a.gltf: its texture coordinates overlap: faces 0 and 1 cover 0.4375 0.6875; expected a second set that "
            "covers each place of the surface once");
  Mesh flat = triangle(corners);
  flat.chart.assign(3, Eigen::Vector2f(0.5F, 0.5F));
  EXPECT_NE(said(flat).find("cover no texel of 8 x 8"), std::string::npos);
}

TEST(Atlas, OfFacesThatMeetAtAnEdgeThroughCentersIsNoOverlap) {
  const Mesh mesh = square_with_texels(9);  // the diagonal runs through nine centers
  EXPECT_EQ(mesh.atlases.heads[0].count, 81U);
  EXPECT_EQ(mesh.positions.size(), 4U + 81U);
}

TEST(Atlas, OfOneTexelStandsForTheWholeSurface) {
  const Mesh mesh = square_with_texels(1);
  ASSERT_EQ(mesh.atlases.heads[0].count, 1U);
  const SurfaceReceivers receivers(mesh);
  for (const auto& [u, v] : {std::pair(0.0F, 0.0F), {1.0F, 0.0F}, {0.0F, 1.0F}, {0.2F, 0.3F}}) {
    const ReceiversAt place = receivers.at({0, u, v, 1.0F});
    for (std::size_t k = 0; k < place.count; ++k) EXPECT_EQ(place.receiver[k], 4U);
    EXPECT_NEAR(place.part[0] + place.part[1] + place.part[2] + place.part[3], 1.0F, 1e-6F);
  }
}

TEST(Atlas, InterpolatesALinearFunctionExactlyBetweenTexels) {
  const Mesh mesh = square_with_texels(16);
  const SurfaceReceivers receivers(mesh);
  const auto function = [](const Eigen::Vector3f& p) {
    return Eigen::Vector3f(1.0F + p.x(), 2.0F * p.y(), p.x() - p.y());
  };
  std::vector<Eigen::Vector3f> values;
  for (const Eigen::Vector3f& p : mesh.positions) values.push_back(function(p));
  for (std::uint32_t f = 0; f < 2; ++f) {
    for (const auto& [u, v] : {std::pair(0.2F, 0.3F), {0.5F, 0.25F}, {0.1F, 0.8F}, {1.0F / 3.0F, 1.0F / 3.0F}}) {
      const Hit hit{f, u, v, 1.0F};
      EXPECT_LT((receivers.at(hit).mean(values) - function(interpolated(hit, mesh, mesh.positions))).norm(), 2e-3F);
    }
  }
}

// A lattice of vertices at the centers of the texels, over the same square.
TEST(Atlas, TexelsSeeWhatVerticesAtTheirPlacesSee) {
  constexpr int kSize = 8;
  const Mesh texels = with_box_above(square_with_texels(kSize));
  Mesh vertices = primitive_mesh("plane");
  const auto first = static_cast<std::uint32_t>(vertices.positions.size());
  const Atlases::Head& atlas = texels.atlases.heads[0];
  for (std::uint32_t i = 0; i < atlas.count; ++i) {  // each with a little face of its own, as wide as a texel
    const auto v = static_cast<std::uint32_t>(vertices.positions.size());
    for (const Eigen::Vector3f& more : {Eigen::Vector3f(0, 0, 0), {0.06F, 0, 0}, {0, 0.06F, 0}}) {
      vertices.positions.emplace_back(texels.positions[atlas.first + i] + more);
      vertices.normals.emplace_back(Eigen::Vector3f::UnitZ());
      vertices.albedo.emplace_back(texels.albedo[atlas.first + i]);
    }
    vertices.faces.push_back({v, v + 1, v + 2});
  }
  set_geometric_normals(vertices);
  for (const TransferKind* kind : {&kUnshadowed, &kShadowed, &kGlossyShadowed}) {
    const Transfer a = baked(texels, kind, 2048);
    const Transfer b = baked(with_box_above(vertices), kind, 2048);
    double difference = 0.0;
    double squares = 0.0;
    for (std::uint32_t i = 0; i < atlas.count; ++i) {
      for (std::size_t k = 0; k < a.shape.length(); ++k) {
        const auto own = static_cast<double>(a.row(atlas.first + i)[k]);
        difference += std::pow(own - static_cast<double>(b.row(first + 3 * i)[k]), 2);
        squares += own * own;
      }
    }
    EXPECT_LT(std::sqrt(difference / squares), 2e-3) << kind->letters;
  }
}

TEST(Atlas, OfAnOpenSquareIsUnshadowedToTheBit) {
  const Transfer open = baked(square_with_texels(5), &kShadowed, 256);
  const Transfer closed_form = baked(square_with_texels(5), &kUnshadowed, 256);
  EXPECT_EQ(open.coefficients, closed_form.coefficients);
}

TEST(Atlas, BouncesReadLightFromTexels) {
  // Two big faces under a box: with texels the box's underside sees the dark ground below it, with corners it does not.
  Mesh coarse = with_box_above(primitive_mesh("plane"));
  Mesh fine = primitive_mesh("plane");
  refine(fine, 0.04F);
  fine = with_box_above(fine);
  Mesh texels = with_box_above(square_with_texels(40));
  const auto under_box = [](Mesh& mesh) {
    paint(mesh, {0.8F, 0.8F, 0.8F});
    const Transfer transfer = baked(mesh, &kInterreflected, 2048, 1);
    double sum = 0.0;
    for (std::size_t v = mesh.positions.size() - 24; v < mesh.positions.size(); ++v) {
      if (mesh.normals[v].z() < -0.9F) sum += static_cast<double>(transfer.row(v)[0]);
    }
    return sum;
  };
  const double with_texels = under_box(texels);
  const double with_vertices = under_box(fine);
  EXPECT_NEAR(with_texels / with_vertices, 1.0, 0.02);
  EXPECT_GT(std::abs(under_box(coarse) / with_vertices - 1.0), 0.05);
}

// Four texels shine differently. A plate sees their bilinear mean at every hit, as vertices on a fine lattice shine.
TEST(Atlas, BouncesInterpolateBetweenFourTexels) {
  const auto shining = [](const Eigen::Vector3f& at) {
    const float x = std::clamp(2.0F * at.x() + 0.5F, 0.0F, 1.0F);
    const float y = std::clamp(2.0F * at.y() + 0.5F, 0.0F, 1.0F);
    return Eigen::Vector3f(1.0F + 2.0F * x + 4.0F * y, x, 8.0F * x * y);
  };
  const auto at_plate = [&](Mesh mesh) {
    mesh.albedo.assign(mesh.positions.size(), Eigen::Vector3f::Zero());
    mesh.emission.clear();
    for (const Eigen::Vector3f& position : mesh.positions) mesh.emission.push_back(shining(position));
    Mesh plate = primitive_mesh("plane", 24,
                                Eigen::Translation3f(0.15F, -0.2F, 0.15F) *
                                    Eigen::AngleAxisf(std::numbers::pi_v<float>, Eigen::Vector3f::UnitX()) *
                                    Eigen::Scaling(0.02F));
    paint(plate, {1.0F, 1.0F, 1.0F});
    append(mesh, plate);
    return baked(mesh, &kInterreflected, 4096, 0).emitted.back();
  };
  Mesh fine = primitive_mesh("plane");
  refine(fine, 0.03F);
  const Eigen::Vector3f expected = at_plate(fine);
  const Eigen::Vector3f seen = at_plate(square_with_texels(2));
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[c] / expected[c], 1.0F, 0.01F) << c;
}

TEST(Atlas, CoveredTexelsTakeTheLightOfTheirNeighbors) {
  Mesh mesh = square_with_texels(20);
  append(mesh, primitive_mesh("box", 24, Eigen::Translation3f(0.0F, 0.0F, 0.151F) * Eigen::Scaling(0.3F)));
  const Transfer transfer = baked(mesh, &kShadowed, 512);
  const Atlases::Head& atlas = mesh.atlases.heads[0];
  for (std::uint32_t i = 0; i < atlas.count; ++i) EXPECT_GT(transfer.row(atlas.first + i)[0], 0.05F) << i;
}

class AtlasFile : public testing::Test {
 protected:
  static Transfer textured() {
    Mesh mesh = square_with_texels(4);
    mesh.albedo_map.assign(mesh.positions.size(), 1);
    mesh.tint.assign(mesh.positions.size(), Eigen::Vector3f(0.5F, 0.25F, 1.0F));
    mesh.texture.assign(mesh.positions.size(), Eigen::Vector2f(0.5F, 0.5F));
    mesh.albedo_maps.number_of({"a.png", "not a picture, of seven and more bytes"});
    return baked(mesh, &kShadowed, 64);
  }
  std::string refusal(const std::string& bytes) {
    write_all(folder_.file("t"), with_checksums(bytes));
    return message_of([&] { read_transfer(folder_.file("t")); });
  }
  TemporaryFolder folder_;
};

TEST_F(AtlasFile, IsReadAsItWasWritten) {
  const Transfer made = textured();
  write_transfer(folder_.file("t"), made);
  const Transfer read = read_transfer(folder_.file("t"));
  EXPECT_EQ(read.mesh.chart, made.mesh.chart);
  EXPECT_EQ(read.mesh.atlas, made.mesh.atlas);
  EXPECT_EQ(read.mesh.atlases.pixels, made.mesh.atlases.pixels);
  ASSERT_EQ(read.mesh.atlases.heads.size(), 1U);
  EXPECT_EQ(read.mesh.atlases.heads[0].first, 4U);
  EXPECT_EQ(read.mesh.atlases.heads[0].count, 16U);
  EXPECT_EQ(read.mesh.tint, made.mesh.tint);
  EXPECT_EQ(read.mesh.albedo_map, made.mesh.albedo_map);
  EXPECT_EQ(read.mesh.albedo_maps.at(0), made.mesh.albedo_maps.at(0));
  EXPECT_EQ(read.coefficients, made.coefficients);
}

TEST_F(AtlasFile, WithHostileValuesIsRefused) {
  write_transfer(folder_.file("t"), textured());
  const std::string bytes = read_all(folder_.file("t"));
  const auto with = [&](std::string_view section, std::size_t offset, auto value) {
    std::string changed = bytes;
    std::memcpy(&changed[place_of(bytes, section) + offset], &value, sizeof value);
    return refusal(changed);
  };
  EXPECT_EQ(refusal(bytes), "");
  const std::pair<std::string, std::string> flaws[] = {
      {with("texel", 60, 16U), "the texels of an atlas are not in order, or beyond its size"},
      {with("texel", 4, 0U), "the texels of an atlas are not in order, or beyond its size"},
      {with("atlas", 0, std::uint16_t{2}), "it names an atlas that is not there"},
      {with("chart", 0, 1.5F), "a place in an atlas is not from 0 to 1"},
      {with("chart", 0, std::numeric_limits<float>::quiet_NaN()), "a place in an atlas is not from 0 to 1"},
      {with("tint", 0, 2.0F), "a tint is not from 0 to 1"},
      {with("albmap", 0, std::uint16_t{2}), "it names a picture of the albedo that is not there"},
      {with("texture", 0, std::numeric_limits<float>::infinity()), "a texture coordinate is not finite"}};
  for (const auto& [said, expected] : flaws)
    EXPECT_NE(said.find(expected), std::string::npos) << said << "; " << expected;
  for (const auto& [from, to, expected] :
       {std::tuple<std::string, std::string, std::string>(R"("first": 4)", R"("first": 9)",
                                                          "names texels that are not"),
        {R"("texels": 16)", R"("texels": 17)", "names texels that are not there"},
        {R"("texels": 16)", R"("texels": 15)", "it names an atlas that is not there"},
        {R"("bytes": 38)", R"("bytes": 37)", "it names a picture of the albedo that is not there"},
        {R"("width": 4)", R"("width": 3)", "not in order, or beyond its size"},
        {R"("width": 4)", R"("width": 0)", "expected a whole number from 1"}}) {
    std::string changed = bytes;
    const std::size_t place = changed.find(from);
    ASSERT_NE(place, std::string::npos) << from;
    changed.replace(place, from.size(), to);
    const std::string said = refusal(changed);
    EXPECT_NE(said.find(expected), std::string::npos) << said << "; " << expected;
  }
}

}  // namespace
}  // namespace sh::prt::test
