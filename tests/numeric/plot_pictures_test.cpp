// Finished pictures: they show the function at the right places, are whole and the same each time; refusals of bad input.
#include <gtest/gtest.h>
#include <png.h>

#include <fstream>
#include <regex>
#include <tuple>

#include "numeric/plot/lobes.hpp"
#include "numeric/plot/map.hpp"
#include "tests/numeric/shcheck_tool.hpp"

namespace sh::numeric::plot {
namespace {

Raster decode_png(const std::string& bytes) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  EXPECT_NE(png_image_begin_read_from_memory(&header, bytes.data(), bytes.size()), 0) << header.message;
  header.format = PNG_FORMAT_RGB;
  Raster picture(static_cast<int>(header.width), static_cast<int>(header.height));
  EXPECT_NE(png_image_finish_read(&header, nullptr, picture.rgb.data(), 0, nullptr), 0) << header.message;
  return picture;
}

// Well-formed XML of the kind that SVG canvases write: elements closed in order, attributes quoted, no loose & or <.
bool is_well_formed(const std::string& text) {
  static const std::regex kTag(R"(<(/?)([A-Za-z]+)((?: [A-Za-z-]+="[^"<]*")*)(/?)>)");
  static const std::regex kText("([^<>&]|&(amp|lt|gt|quot);)*");
  std::vector<std::string> open;
  std::size_t at = 0;
  while (at < text.size()) {
    const auto next = std::min(text.find('<', at), text.size());
    const std::string words = text.substr(at, next - at);
    if (!std::regex_match(words, kText) || (open.empty() && words.find_first_not_of('\n') != std::string::npos))
      return false;
    if (next == text.size()) break;
    const auto end = text.find('>', next);
    if (end == std::string::npos) return false;
    std::string tag = text.substr(next, end + 1 - next);
    const auto data = tag.find("base64,");
    if (data != std::string::npos) tag.erase(data, tag.find('"', data) - data);  // std::regex is slow on long texts
    std::smatch match;
    if (!std::regex_match(tag, match, kTag)) return false;
    if (match[1].length() > 0) {
      if (open.empty() || open.back() != match[2]) return false;
      open.pop_back();
      if (open.empty()) return text.substr(end + 1) == "\n";
    } else if (match[4].length() == 0) {
      open.push_back(match[2]);
    }
    at = end + 1;
  }
  return false;
}

// Pixels of the two colors in a part of the picture; letters and legends are left out by the caller.
struct Counts {
  int positive = 0, negative = 0;
};

Counts count_colors(const Raster& picture, int x0, int y0, int x1, int y1) {
  Counts counts;
  for (int row = y0; row < y1; ++row) {
    for (int column = x0; column < x1; ++column) {
      const auto c = picture.at(column, row);
      counts.positive += c.red > c.blue + 40 ? 1 : 0;
      counts.negative += c.blue > c.red + 40 ? 1 : 0;
    }
  }
  return counts;
}

// The middle of the lobes' box, in a picture 1000 pixels wide.
constexpr int kMiddleX = 500;
constexpr int kMiddleY = 452;

TEST(PlotPicture, ShowsTheLobesOfTheFirstBandOnTheirAxes) {
  const Figure figure{"t", Format::kPng, 1000};
  // z, seen level: positive up.
  auto picture = decode_png(draw_lobes(basis_function(1, 0), {35, 0}, figure));
  EXPECT_EQ(picture.width, 1000);
  auto up = count_colors(picture, 0, 60, 1000, kMiddleY - 1);
  auto down = count_colors(picture, 0, kMiddleY + 1, 1000, 840);
  EXPECT_GT(up.positive, 50000);
  EXPECT_EQ(up.negative, 0);
  EXPECT_EQ(down.positive, 0);
  EXPECT_NEAR(down.negative, up.positive, 0.02 * up.positive);
  // x, seen from +y: positive on the left; from -y: on the right. y, seen from +x: positive on the right.
  const std::vector<std::tuple<int, double, bool>> kSides = {{1, 90, true}, {1, -90, false}, {-1, 0, false}};
  for (const auto& [order, azimuth, positive_left] : kSides) {
    picture = decode_png(draw_lobes(basis_function(1, order), {azimuth, 0}, figure));
    const auto left = count_colors(picture, 0, 60, kMiddleX - 1, 840);
    const auto right = count_colors(picture, kMiddleX + 1, 60, 1000, 840);
    EXPECT_GT(positive_left ? left.positive : right.positive, 50000);
    EXPECT_GT(positive_left ? right.negative : left.negative, 50000);
    EXPECT_EQ((positive_left ? left.negative : right.negative) + (positive_left ? right.positive : left.positive), 0);
  }
  // From above, +z hides -z.
  picture = decode_png(draw_lobes(basis_function(1, 0), {0, 90}, figure));
  const auto top = count_colors(picture, 0, 60, 1000, 840);
  EXPECT_GT(top.positive, 50000);
  EXPECT_EQ(top.negative, 0);
}

// The facets of lobes in an SVG, in the order of painting: whether the facet is positive, and the height of a corner.
std::vector<std::pair<bool, double>> facets_of(const std::string& svg) {
  static const std::regex kFacet(R"re(<path color="#(..)..(..)" d="M[-0-9.]+[ ]?([-0-9.]+)l)re");
  std::vector<std::pair<bool, double>> facets;
  for (auto it = std::sregex_iterator(svg.begin(), svg.end(), kFacet); it != std::sregex_iterator(); ++it) {
    const int difference = std::stoi((*it)[1], nullptr, 16) - std::stoi((*it)[2], nullptr, 16);
    if (std::abs(difference) >= 30) facets.emplace_back(difference > 0, std::stod((*it)[3]));  // else an axis
  }
  return facets;
}

TEST(PlotPicture, ShowsTheSameLobesInSvg) {
  const auto svg = draw_lobes(basis_function(1, 0), {35, 0}, {"t", Format::kSvg, 1000});
  EXPECT_EQ(svg.find("<image"), std::string::npos);
  const auto facets = facets_of(svg);
  for (const auto& [positive, y] : facets) EXPECT_EQ(positive, y < kMiddleY + (positive ? 1 : -1)) << y;
  EXPECT_GT(facets.size(), 3000U);
}

// From above, the positive lobe hides the negative one: it is painted later.
TEST(PlotPicture, PaintsFacetsFromBackToFront) {
  const auto facets = facets_of(draw_lobes(basis_function(1, 0), {35, 80}, {"t", Format::kSvg, 1000}));
  ASSERT_GT(facets.size(), 1000U);
  EXPECT_FALSE(facets.front().first);
  EXPECT_TRUE(facets.back().first);
}

TEST(PlotPicture, ShowsTheSignsOfAMapAtTheAxes) {
  // x - y + z / 2: positive at +x, -y, +z.
  const auto f = function_of_coefficients(std::vector<double>{0, -1, 0.5, 1});
  const auto lat_long = decode_png(draw_map(f, ImageMapping::kLatLong, {"t", Format::kPng, 1000}));
  const auto sign_near = [](const Raster& picture, int x, int y) {
    const auto counts = count_colors(picture, x - 6, y - 6, x + 6, y + 6);
    return counts.positive > 100 ? 1 : counts.negative > 100 ? -1 : 0;
  };
  const auto cube = decode_png(draw_map(f, ImageMapping::kHorizontalCross, {"t", Format::kPng, 1000}));
  struct Axis {
    const char* name;
    int sign, x, y;   // in the box of the lat-long picture: left 78, top 58, 784 by 392
    int column, row;  // of the face
  };
  for (const Axis& axis :
       {Axis{"+x", 1, 392, 196, 1, 1}, Axis{"+y", -1, 196, 196, 0, 1}, Axis{"-y", 1, 588, 196, 2, 1},
        Axis{"-x", -1, 10, 196, 3, 1}, Axis{"+z", 1, 700, 10, 1, 0}, Axis{"-z", -1, 100, 382, 1, 2}}) {
    EXPECT_EQ(sign_near(lat_long, 78 + axis.x, 58 + axis.y), axis.sign) << axis.name;
    EXPECT_EQ(sign_near(cube, 155 + 205 * axis.column, 173 + 205 * axis.row), axis.sign) << axis.name;
  }
}

TEST(PlotPicture, IsWellFormedAndUnderAMegabyteInSvgAtAnyDegree) {
  std::vector<std::string> pictures;
  for (const int degree : {0, 5, 14, 15, 20}) {
    pictures.push_back(draw_lobes(basis_function(degree, degree / 2), {}, {"a < b & \"c\"", Format::kSvg, 1000}));
  }
  for (const int degree : {0, 1, 3}) pictures.push_back(draw_basis_grid(degree, {}, {"grid", Format::kSvg, 1000}));
  pictures.push_back(draw_map(basis_function(3, 2), ImageMapping::kLatLong, {"m", Format::kSvg, 1000}));
  pictures.push_back(draw_map(basis_function(3, 2), ImageMapping::kHorizontalCross, {"m", Format::kSvg, 1000}));
  for (const auto& svg : pictures) {
    EXPECT_TRUE(is_well_formed(svg)) << svg.substr(0, 300);
    EXPECT_LT(svg.size(), 1'000'000U) << svg.substr(0, 300);
    EXPECT_EQ(svg.find("http", svg.find('>')), std::string::npos) << "refers to something outside";
  }
  EXPECT_FALSE(is_well_formed("<svg><g></svg>\n"));
  EXPECT_FALSE(is_well_formed("<svg>a & b</svg>\n"));
}

TEST(PlotPicture, HasTheSameBytesEachTime) {
  for (const auto format : {Format::kSvg, Format::kPng}) {
    const auto f = basis_function(5, -3);
    const Figure figure{"t", format, 300};
    EXPECT_EQ(draw_lobes(f, {}, figure), draw_lobes(f, {}, figure));
    EXPECT_EQ(draw_basis_grid(2, {}, figure), draw_basis_grid(2, {}, figure));
    EXPECT_EQ(draw_map(f, ImageMapping::kLatLong, figure), draw_map(f, ImageMapping::kLatLong, figure));
    EXPECT_EQ(draw_map(f, ImageMapping::kHorizontalCross, figure), draw_map(f, ImageMapping::kHorizontalCross, figure));
  }
}

TEST(PlotPicture, LooksTheSameAtAnyMagnitude) {
  const Figure figure{"t", Format::kPng, 400};
  const auto center = [&](double scale) {
    const auto f = function_of_coefficients(std::vector<double>{scale, -scale, 0, scale / 2});
    const auto map = decode_png(draw_map(f, ImageMapping::kLatLong, figure));
    std::vector<Color> colors;
    for (int row = 30; row < 170; ++row) colors.push_back(map.at(100, row));
    return colors;
  };
  EXPECT_EQ(center(0x1p-1000), center(1));
  EXPECT_EQ(center(0x1p1000), center(1));
}

TEST(PlotPicture, TakesAnyCallableAndSaysWhenItIsZero) {
  const SphereFunction step{1, 10, [](const Vector3& s) { return Channels{s[2] > 0.5 ? 1.0 : -1.0}; }, 0};
  EXPECT_TRUE(is_well_formed(draw_map(step, ImageMapping::kHorizontalCross, {"step", Format::kSvg, 200})));
  const auto zero = function_of_coefficients(std::vector<double>(9));
  for (const auto& svg : {draw_map(zero, ImageMapping::kLatLong, {"0", Format::kSvg, 200}),
                          draw_map(zero, ImageMapping::kHorizontalCross, {"0", Format::kSvg, 200}),
                          draw_lobes(zero, {}, {"0", Format::kSvg, 200})}) {
    EXPECT_NE(svg.find(">zero function<"), std::string::npos);
    EXPECT_TRUE(is_well_formed(svg));
  }
}

class ShcheckPlot : public test::ShcheckTool {};

TEST_F(ShcheckPlot, WritesThePicturesThatItIsAskedFor) {
  std::ofstream(folder_ / "rgb.txt") << "# light\n1 0.5 0 -0.5\n0.8,0,0,0.2\n0.3 0 0.1 0\n";
  const auto cd = [&](const std::string& name) { return " -o " + (folder_ / name).string(); };
  for (const auto& arguments :
       {"lobes --degree 3 --order -2 --size 64" + cd("a.png"),
        "lobes --basis-grid 2 --size 64 --view -30,20" + cd("b.png"),
        "map --coefficients -0.5,0,1e-3,2 --size 64" + cd("c.png"),
        "map --coefficients " + (folder_ / "rgb.txt").string() + " --projection cube-map --size 64" + cd("d.png"),
        "lobes --coefficients " + (folder_ / "rgb.txt").string() + " --size 64" + cd("e.png"),
        "map --degree 64 --order 64 --size 16" + cd("f.png"),
        "map --degree 3 --projection mirror-ball --size 64" + cd("g.png")}) {
    const auto outcome = run("plot " + arguments);
    EXPECT_EQ(outcome.exit_code, 0) << arguments << outcome.err;
    EXPECT_EQ(outcome.out + outcome.err, "");
  }
  for (const char letter : std::string("abcdefg")) {
    const std::string name = std::string(1, letter) + ".png";
    EXPECT_EQ(decode_png(test::read(folder_ / name)).width, letter == 'f' ? 16 : 64) << name;
  }
  EXPECT_EQ(run("plot map --degree 2" + cd("a.svg")).exit_code, 0);
  EXPECT_TRUE(is_well_formed(test::read(folder_ / "a.svg")));
}

TEST_F(ShcheckPlot, RefusesBadInputAndWritesNothing) {
  std::ofstream(folder_ / "bad.txt") << "1 2 # a\n3\nfoo 4\n";
  std::ofstream(folder_ / "five.txt") << "1 2 # a\n3\n4 5\n";
  std::ofstream(folder_ / "empty.txt") << "# nothing\n";
  const std::string file = " --coefficients " + folder_.string() + "/";
  const std::string out = " -o " + folder_.string() + "/x.svg";
  expect_refused("plot map" + file + "bad.txt" + out, "bad.txt:3: expected a number such as -0.5 or 1e-3, got 'foo'");
  expect_refused("plot map" + file + "five.txt" + out, "five.txt: expected bands^2 numbers");
  expect_refused("plot map" + file + "empty.txt" + out, "empty.txt: expected numbers, got none");
  expect_refused("plot map" + file + "missing.txt" + out, "missing.txt: cannot read: No such file or directory");
  expect_refused("plot map" + file + out, "/: cannot read: Is a directory");
  expect_refused("plot map --coefficients /dev/zero" + out, "/dev/zero: larger than 4 MB");
  expect_refused("plot map --coefficients 1,2" + out, "1,2: expected bands^2 numbers");
  expect_refused("plot map --coefficients 1,2,x,4" + out,
                 "--coefficients: expected a number such as -0.5 or 1e-3, got 'x'");
  expect_refused("plot map --coefficients 1,2,nan,4" + out, "got 'nan'");
  expect_refused("plot map --coefficients inf" + out, "got 'inf'");
  expect_refused("plot map --coefficients 1e999" + out, "expected a number in the range of a double");
  expect_refused("plot map --coefficients ''" + out, "--coefficients: expected numbers, got ''");
  expect_refused("plot map --degree 65" + out, "--degree: expected 0 to 64, got 65");
  expect_refused("plot map --degree -1" + out, "--degree: expected 0 to 64, got -1");
  expect_refused("plot map --degree 2 --order -3" + out, "--order: expected -2 to 2, got -3");
  expect_refused("plot map --degree x" + out, "--degree");
  expect_refused("plot map --coefficients 1 --order 0" + out, "--order: expected --degree too");
  expect_refused("plot map --degree 2 --coefficients 1" + out, "plot: expected one of --degree, --coefficients, got 2");
  expect_refused("plot lobes" + out, "expected one of --degree, --coefficients, --basis-grid, got 0");
  expect_refused("plot lobes --basis-grid 13" + out, "--basis-grid: expected 0 to 12, got 13");
  expect_refused("plot lobes --degree 1 --view 1" + out, "--view: expected azimuth,elevation");
  expect_refused("plot lobes --degree 1 --view 0,91" + out, "within 360 and 90, got '0,91'");
  expect_refused("plot lobes --degree 1 --view a,b" + out, "--view: expected a number such as -0.5 or 1e-3, got 'a'");
  expect_refused("plot lobes --degree 1 --size 15" + out, "--size: expected 16 to 8192, got 15");
  expect_refused("plot lobes --degree 1 --size 8193" + out, "--size: expected 16 to 8192, got 8193");
  expect_refused("plot map --degree 1 --projection mercator" + out,
                 "--projection: expected lat-long, cube-map, angular-map");
  expect_refused("plot map --degree 1 -o " + folder_.string() + "/x.jpg", "x.jpg: expected the ending .svg or .png");
  expect_refused("plot map --degree 1 -o " + folder_.string() + "/no/x.png", "no/x.png: cannot write");
  expect_refused("plot map --degree 1", "--output");
  expect_refused("plot", "subcommand");
  EXPECT_EQ(scratch_.entries(), 3U);
}

}  // namespace
}  // namespace sh::numeric::plot
