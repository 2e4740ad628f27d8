// What pictures are made of: functions, mappings, colors, marks and surfaces.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <numbers>
#include <numeric>

#include "numeric/oracle/basis.hpp"
#include "numeric/plot/lobes.hpp"
#include "numeric/plot/map.hpp"
#include "numeric/sampling/random.hpp"
#include "tests/temporary_folder.hpp"

namespace sh::numeric::plot {
namespace {

constexpr double kPi = std::numbers::pi;

Vector3 random_direction(Random& random) {
  const double z = random.next();
  const double s = std::sqrt(1 - z * z);
  const double phi = kPi * random.next();
  return Vector3(s * std::cos(phi), s * std::sin(phi), z).normalized();
}

std::vector<double> random_coefficients(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<double> out(count);
  for (double& c : out) c = random.next();
  return out;
}

double distance(const Vector3& a, const Vector3& b) { return (a - b).norm(); }

TEST(PlotFunction, SumsTheOraclesBasisInEachChannel) {
  for (const int degree : {0, 1, 7, 64}) {
    const auto count = static_cast<std::size_t>(coefficient_count(degree));
    const auto c = random_coefficients(3 * count, 5);
    const auto f = function_of_coefficients(c);
    ASSERT_EQ(f.channels, 3);
    ASSERT_EQ(f.degree, degree);
    Random random(6);
    for (int i = 0; i < 50; ++i) {
      // Repeated z: the ring that is kept must be the right one.
      const Vector3 s = i % 3 == 0 ? direction(1.0, i) : random_direction(random);
      const auto y = basis(degree, s[0], s[1], s[2]);
      const auto values = f.value(s);
      for (std::size_t channel = 0; channel < 3; ++channel) {
        const double wanted = std::inner_product(y.begin(), y.end(), c.begin() + std::ptrdiff_t(channel * count), 0.0);
        EXPECT_NEAR(std::ldexp(values[channel], f.exponent), wanted, 1e-12 * (1 + degree)) << degree;
      }
    }
  }
}

TEST(PlotFunction, FindsTheLargestMagnitudeOfZonalFunctionsAtThePole) {
  for (const int degree : {0, 1, 2, 5, 20, 64}) {
    const auto largest = largest_magnitude(basis_function(degree, 0));
    EXPECT_NEAR(std::ldexp(largest.magnitude, 1), std::sqrt((2 * degree + 1) / (4 * kPi)), 1e-13 * (degree + 1));
    if (degree > 0) {
      EXPECT_NEAR(std::abs(largest.where[2]), 1, 1e-15);
    }
  }
  // Y_(1,1) = sqrt(3 / 4 pi) x, turned so that its peak is on no node of a grid.
  const Vector3 peak = Vector3(0.3, -0.5, 0.77).normalized();
  const auto largest = largest_magnitude(function_of_coefficients(std::vector<double>{0, peak[1], peak[2], peak[0]}));
  EXPECT_LT(distance(largest.where, peak) * distance(largest.where, -1 * peak), 1e-7);
  EXPECT_EQ(largest_magnitude(function_of_coefficients(std::vector<double>(9))).magnitude, 0);
}

TEST(PlotFunction, KeepsAnyMagnitude) {
  for (const double scale : {1e-320, 1e-300, 1.0, 1e300, 1.7e308}) {
    const auto f = function_of_coefficients(std::vector<double>{scale, 0, scale, 0});
    const auto largest = largest_magnitude(f);
    EXPECT_GT(largest.magnitude, 0.3);
    EXPECT_LT(largest.magnitude, 1);
    const double sum = (std::sqrt(1 / (4 * kPi)) + std::sqrt(3 / (4 * kPi)));
    const long double shown = std::stold(format_value(largest.magnitude, f.exponent));
    EXPECT_NEAR(static_cast<double>(shown / static_cast<long double>(scale)), sum, 0.01);
  }
  EXPECT_EQ(format_value(-0.0, 0), "0");
  EXPECT_EQ(format_value(-0.5, 3), "-4");
}

TEST(PlotFunction, RefusesWhatIsNoVectorOfCoefficients) {
  for (const std::size_t count : {0U, 2U, 5U, 6U, 15U, 4226U, 4356U, 3U * 4356U}) {
    EXPECT_THROW(function_of_coefficients(std::vector<double>(count)), std::invalid_argument) << count;
  }
  for (const std::size_t count : {1U, 3U, 4U, 12U, 4225U, 3U * 4225U}) {
    EXPECT_EQ(function_of_coefficients(std::vector<double>(count)).channels, count % 3 == 0 ? 3 : 1) << count;
  }
  EXPECT_THROW(function_of_coefficients(std::vector<double>{NAN}), std::invalid_argument);
  EXPECT_THROW(function_of_coefficients(std::vector<double>{1, 2, INFINITY, 3}), std::invalid_argument);
}

TEST(PlotCoefficients, AreReadFromAListOrAFileWithComments) {
  const test::TemporaryFolder folder;
  const auto file = folder.file("c.txt");
  std::ofstream(file) << "# header, 7 8 9\n0.5, -1e-3\t+2 # rest\r\n\n.25,,";
  const std::vector<double> wanted{0.5, -1e-3, 2, 0.25};
  EXPECT_EQ(numbers_from("c", file), wanted);
  EXPECT_EQ(numbers_from("c", "0.5,-1e-3 +2\n.25"), wanted);
}

std::map<std::string, Vector3> axes() {
  return {{"+x", {1, 0, 0}},  {"-x", {-1, 0, 0}}, {"+y", {0, 1, 0}},
          {"-y", {0, -1, 0}}, {"+z", {0, 0, 1}},  {"-z", {0, 0, -1}}};
}

constexpr auto kMappings = {ImageMapping::kLatLong,         ImageMapping::kAngularMap,    ImageMapping::kMirrorBall,
                            ImageMapping::kHorizontalCross, ImageMapping::kVerticalCross, ImageMapping::kCubeStrip};

TEST(PlotMapping, PutsTheAxesWhereThePictureSays) {
  const auto lat_long = panels_of(ImageMapping::kLatLong).front();
  const std::vector<std::pair<Point, std::string>> places{{{0.5, 0.5}, "+x"}, {{0.25, 0.5}, "+y"}, {{0.75, 0.5}, "-y"},
                                                          {{0, 0.5}, "-x"},   {{1, 0.5}, "-x"},    {{0.3, 0}, "+z"},
                                                          {{0.3, 1}, "-z"}};
  for (const auto& [place, axis] : places) {
    EXPECT_LT(distance(lat_long.direction(place).value(), axes().at(axis)), 1e-15) << axis;
  }
  const std::map<std::pair<int, int>, std::string> kCross{{{1, 0}, "+z"}, {{0, 1}, "+y"}, {{1, 1}, "+x"},
                                                          {{2, 1}, "-y"}, {{3, 1}, "-x"}, {{1, 2}, "-z"}};
  const auto faces = panels_of(ImageMapping::kHorizontalCross);
  ASSERT_EQ(faces.size(), 6U);
  for (const auto& face : faces) {
    const auto label = kCross.at({face.face->column, face.face->row});
    EXPECT_LT(distance(face.direction({0.5, 0.5}).value(), axes().at(label)), 1e-15) << label;
    EXPECT_EQ(axis_name(face.face->forward), label);
  }
}

TEST(PlotMapping, PlacesEachDirectionInOnePanelAndBack) {
  for (const auto mapping : kMappings) {
    const auto panels = panels_of(mapping);
    Random random(1);
    for (int i = 0; i < 1000; ++i) {
      const Vector3 s = random_direction(random);
      int found = 0;
      for (const auto& panel : panels) {
        const auto place = panel.place(s);
        if (!place) continue;
        ++found;
        EXPECT_LT(distance(panel.direction(*place).value(), s), 5e-14);
      }
      EXPECT_EQ(found, 1);
    }
  }
}

TEST(PlotMapping, FacesOfTheCrossMeetAtTheirEdges) {
  const auto faces = panels_of(ImageMapping::kHorizontalCross);
  int meetings = 0;
  for (const auto& a : faces) {
    for (const auto& b : faces) {
      const bool beside = a.face->row == b.face->row && a.face->column + 1 == b.face->column;
      const bool below = a.face->column == b.face->column && a.face->row + 1 == b.face->row;
      if (!beside && !below) continue;
      for (const double t : {0.0, 0.3, 1.0}) {
        const Vector3 from = a.direction(beside ? Point{1, t} : Point{t, 1}).value();
        const Vector3 to = b.direction(beside ? Point{0, t} : Point{t, 0}).value();
        EXPECT_LT(distance(from, to), 1e-15) << axis_name(a.face->forward) << axis_name(b.face->forward);
        ++meetings;
      }
    }
  }
  EXPECT_EQ(meetings, 3 * 5);
}

TEST(PlotMapping, DrawsAGraticuleOfWholeMultiples) {
  const auto off_multiple = [](double radians) {
    const double degrees = radians * 180 / kPi;
    return std::abs(degrees - 30 * std::round(degrees / 30));
  };
  for (const auto mapping : kMappings) {
    for (const auto& panel : panels_of(mapping)) {
      const auto lines = graticule(panel, 30);
      EXPECT_GE(lines.size(), 6U);
      for (const auto& line : lines) {
        for (std::size_t i = 0; i < line.size(); ++i) {
          const Vector3 s = panel.direction(line[i]).value();
          EXPECT_LT(std::min(off_multiple(std::acos(s[2])), off_multiple(std::atan2(s[1], s[0]))), 1e-5)
              << name_of(mapping);  // discs end 1e-6 of the radius inside the rim
          if (i > 0) {
            EXPECT_LT(std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y), 0.04) << name_of(mapping);
          }
        }
      }
    }
  }
}

double luminance(const Color& c) {
  const auto linear = decode(c);
  return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2];
}

TEST(PlotColor, DarkensEvenlyAwayFromZeroAndTellsTheSigns) {
  for (double t = 0.02; t <= 1; t += 0.02) {
    EXPECT_LT(luminance(diverging(t)), luminance(diverging(t - 0.02))) << t;
    EXPECT_LT(luminance(diverging(-t)), luminance(diverging(0.02 - t))) << t;
    EXPECT_GT(diverging(t).red, diverging(t).blue) << t;
    EXPECT_LT(diverging(-t).red, diverging(-t).blue) << t;
  }
  EXPECT_EQ(diverging(3), diverging(1));
  EXPECT_EQ(diverging(0), (Color{247, 247, 247}));
}

// A lat-long picture of `f` and its values at the centers of the pixels.
struct Field {
  Raster picture;
  std::vector<double> values;
  double largest;
};

Field paint(const SphereFunction& f, int width, int height) {
  const auto panel = panels_of(ImageMapping::kLatLong).front();
  const double largest = largest_magnitude(f).magnitude;
  const Sampler sampler = [&](const Point& p) { return f.value(panel.direction(p).value()); };
  Field field{paint_field(sampler, {0, 0, width, height}, 1, {f.channels, largest}), {}, largest};
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const auto v = sampler({(column + 0.5) / width, (row + 0.5) / height});
      field.values.push_back(f.channels == 1 ? v[0] : std::min({v[0], v[1], v[2]}));
    }
  }
  return field;
}

// Whether all pixels within two of this one have the same sign, and the value is not so small that a zero line which
// the function only comes near (it is placed by value and slope) could be drawn here.
bool away_from_zero(const Field& field, int column, int row) {
  const int width = field.picture.width;
  const auto value = [&](int c, int r) {
    return field.values[static_cast<std::size_t>(r) * static_cast<std::size_t>(width) + static_cast<std::size_t>(c)];
  };
  for (int r = std::max(0, row - 2); r <= std::min(field.picture.height - 1, row + 2); ++r) {
    for (int c = std::max(0, column - 2); c <= std::min(width - 1, column + 2); ++c) {
      if ((value(c, r) < 0) != (value(column, row) < 0)) return false;
    }
  }
  if (std::abs(value(column, row)) < 0.01 * field.largest) return false;
  return row > 2 && row < field.picture.height - 3;  // a function may vanish at the poles
}

// Pixels away from zero, and how many of them have another color than plain(column, row): [0] where the function is
// positive, [1] where it is negative.
struct Marks {
  std::array<int, 2> pixels{};
  std::array<int, 2> marked{};
};

template <class Plain>
Marks count_marks(const Field& field, Plain plain) {
  Marks marks;
  for (int row = 0; row < field.picture.height; ++row) {
    for (int column = 0; column < field.picture.width; ++column) {
      if (!away_from_zero(field, column, row)) continue;
      const int negative = field.values[row * field.picture.width + column] < 0 ? 1 : 0;
      ++marks.pixels[negative];
      marks.marked[negative] += field.picture.at(column, row) == plain(column, row) ? 0 : 1;
    }
  }
  return marks;
}

TEST(PlotField, HatchesWhereTheFunctionIsNegativeAndOnlyThere) {
  const auto field = paint(function_of_coefficients(random_coefficients(25, 9)), 240, 120);
  const auto [pixels, marked] = count_marks(field, [&](int column, int row) {
    const Color plain = diverging(field.values[row * 240 + column] / field.largest);
    const Color shown = field.picture.at(column, row);
    EXPECT_TRUE(shown == plain || luminance(shown) < luminance(plain));
    return plain;
  });
  EXPECT_GT(pixels[0], 5000);
  EXPECT_EQ(marked[0], 0);
  EXPECT_GT(pixels[1], 5000);
  EXPECT_GT(marked[1], pixels[1] / 8);
  EXPECT_LT(marked[1], pixels[1] / 2);
}

TEST(PlotField, MarksAnyNegativeChannelOfAPictureOfLight) {
  auto c = random_coefficients(27, 4);
  c[0] = c[9] = c[18] = 1.5;
  const auto f = function_of_coefficients(c);
  const auto field = paint(f, 240, 120);
  const auto panel = panels_of(ImageMapping::kLatLong).front();
  const auto [pixels, marked] = count_marks(field, [&](int column, int row) {
    auto v = f.value(panel.direction({(column + 0.5) / 240, (row + 0.5) / 120}).value());
    for (double& channel : v) channel /= field.largest;
    return encode(v);
  });
  EXPECT_GT(pixels[0], 2000);
  EXPECT_EQ(marked[0], 0);
  EXPECT_GT(pixels[1], 2000);
  EXPECT_GT(marked[1], pixels[1] / 8);
}

TEST(PlotField, DrawsTheZeroLineWhereTheSignChanges) {
  const auto field = paint(basis_function(1, 0), 240, 120);  // zero between the rows 59 and 60
  for (int column = 0; column < 240; ++column) {
    EXPECT_LT(luminance(field.picture.at(column, 59)), 0.4);
    EXPECT_LT(luminance(field.picture.at(column, 60)), 0.4);
    EXPECT_GT(luminance(field.picture.at(column, 56)), 0.7);
  }
}

TEST(PlotSurface, HasTheNormalsOfASphereEverywhere) {
  Surface surface;
  add_lobes(surface, basis_function(0, 0), 1, 8);
  for (const auto& v : surface.vertices) EXPECT_GT(v.normal.dot(v.position.normalized()), 0.97) << v.position[2];
}

// Facets of one sign: their corners have that sign of f, or lie at the origin.
TEST(PlotSurface, CutsLobesAtTheirZeros) {
  const auto f = function_of_coefficients(random_coefficients(36, 2));
  Surface surface;
  add_lobes(surface, f, 1, 40);
  const auto positive = decode(kPositive);
  for (const auto& facet : surface.facets) {
    const double sign = facet.paint == positive ? 1 : -1;
    for (int k = 0; k < facet.count; ++k) {
      const Vector3 p = surface.vertices[facet.corners[k]].position;
      const double radius = p.norm();
      if (radius > 0) {
        EXPECT_NEAR(sign * f.value(p.normalized())[0], radius, 1e-12);
      }
    }
  }
}

// A closed surface with its normals outwards: the divergence theorem gives the volume, the integral of |f|^3 / 3.
TEST(PlotSurface, EnclosesTheVolumeOfItsLobes) {
  const auto f = basis_function(1, 0);
  Surface surface;
  add_lobes(surface, f, std::ldexp(1, f.exponent), 200);
  double volume = 0;
  for (const auto& facet : surface.facets) {
    const auto p = [&](int k) { return surface.vertices[facet.corners[k]].position; };
    for (int k = 1; k + 1 < facet.count; ++k) volume += p(0).dot(p(k).cross(p(k + 1))) / 6;
  }
  // Two spheres of diameter sqrt(3 / 4 pi).
  EXPECT_NEAR(volume, 2 * kPi / 6 * std::pow(3 / (4 * kPi), 1.5), 1e-4);
}

}  // namespace
}  // namespace sh::numeric::plot
