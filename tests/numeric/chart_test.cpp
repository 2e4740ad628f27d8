// Charts: well-formed, the same bytes each time, axes that hold every value, labels that cover nothing.
#include "numeric/output/chart.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <cmath>
#include <sstream>
#include <vector>

#include "numeric/output/chart_layout.hpp"
#include "numeric/sampling/random.hpp"

namespace {

using sh::output::axis_pieces;
using sh::output::AxisPiece;
using sh::output::Box;
using sh::output::Chart;
using sh::output::ChartScale;

Chart some_chart() {
  Chart chart;
  chart.title = "a < b & \"c\"";
  chart.legend = true;
  for (int i = 0; i < 14; ++i) {
    chart.series.push_back(
        {.name = "method " + std::to_string(i),
         .color = i,
         .marker = static_cast<sh::output::Marker>(i % sh::output::kMarkers),
         .filled = i % 2 == 0,
         .line = static_cast<sh::output::Line>(i % 3),
         .points = {{10. + i, 1e-7, "here & <there>", "one", ""}, {100, 1e-15 * (i + 1), "", "two", ""}}});
  }
  return chart;
}

TEST(Chart, IsWellFormedWithEveryTextEscaped) {
  std::istringstream text(chart_file(some_chart()));
  boost::property_tree::ptree tree;
  ASSERT_NO_THROW(boost::property_tree::read_xml(text, tree));
  EXPECT_EQ(tree.get<std::string>("svg.<xmlattr>.aria-label"), some_chart().title);
  const auto& svg = tree.get_child("svg");
  EXPECT_EQ(std::count_if(svg.begin(), svg.end(), [](const auto& child) { return child.first == "g"; }), 28);
}

TEST(Chart, AsAFileNamesItsColorsWithoutVariables) {
  EXPECT_EQ(chart_file(some_chart()).find("var("), std::string::npos);
  EXPECT_NE(chart_svg(some_chart()).find("var(--"), std::string::npos);
  EXPECT_NE(sh::output::chart_style().find("--c7:#7a6300"), std::string::npos);
}

TEST(Chart, HasTheSameBytesEachTime) { EXPECT_EQ(chart_file(some_chart()), chart_file(some_chart())); }

TEST(Chart, DrawsWhatIsNotPositiveOrNotFinite) {
  Chart chart;
  chart.series.push_back(
      {.name = "",
       .points = {{1, 0, "", "", ""}, {2, 1e-7, "", "", ""}, {3, INFINITY, "", "", ""}, {4, NAN, "", "", ""}}});
  const auto svg = chart_svg(chart);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
  EXPECT_NO_THROW(chart_svg(Chart{}));
}

TEST(Chart, AxisPiecesHoldEveryValueAndLeaveWideGapsOut) {
  const std::vector<double> values = {1.2e-15, 8e-16, 3e-7, 5e-7, 2e-7, 3e-15, 0, -1};
  const auto pieces = axis_pieces(values, 3);
  ASSERT_EQ(pieces.size(), 2);
  for (const double value : values) {
    if (value <= 0) continue;
    EXPECT_EQ(std::count_if(pieces.begin(), pieces.end(),
                            [&](const AxisPiece& piece) { return piece.lower < value && value < piece.upper; }),
              1)
        << value;
  }
  EXPECT_EQ(axis_pieces(values, 20).size(), 1);
  EXPECT_EQ(axis_pieces({}, 1).size(), 1);
  for (const auto& piece : pieces) EXPECT_GE(piece.upper / piece.lower, 9.99);
}

TEST(Chart, ScalesRiseThroughEveryPieceInBothDirections) {
  for (const double to : {100., -100.}) {
    const ChartScale scale({{1e-16, 1e-14}, {1e-8, 1e-6}}, 0, to);
    double before = -1;
    for (double value = 2e-16; value < 1e-6; value *= 1.3) {
      const double at = scale.at(value) / to;
      EXPECT_GE(at, before) << value;
      EXPECT_LE(at, 1) << value;
      before = at;
    }
    EXPECT_EQ(scale.at(0), 0);
    EXPECT_EQ(scale.at(1), to);
    EXPECT_EQ(scale.breaks().size(), 1);
    const auto ticks = scale.ticks();
    EXPECT_EQ(std::count_if(ticks.begin(), ticks.end(), [](const auto& tick) { return tick.decade; }), 6);
  }
}

bool overlap(const Box& a, const Box& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

TEST(Chart, LabelsCoverNeitherPointsNorEachOtherNorLeaveTheFrame) {
  constexpr double kSize = 11;
  const Box frame = {0, 0, 400, 300};
  sh::output::LabelPlacer placer(frame, kSize);
  sh::numeric::Random random(5);
  std::vector<Box> taken;
  std::vector<std::pair<double, double>> points;
  for (int i = 0; i < 40; ++i) {
    const double x = 200 * (random.next() + 1);
    const double y = 150 * (random.next() + 1);
    points.emplace_back(x, y);
    taken.push_back({x - 4, y - 4, x + 4, y + 4});
    placer.take(taken.back());
  }
  int placed = 0;
  for (const auto& [x, y] : points) {
    const auto place = placer.place(x, y, "some label");
    if (!place) continue;
    ++placed;
    const Box box = {place->x + 0.01, place->y - 0.8 * kSize,
                     place->x + sh::output::text_width("some label", kSize) - 0.01, place->y + 0.2 * kSize};
    EXPECT_GE(box.left, frame.left);
    EXPECT_LE(box.right, frame.right);
    EXPECT_TRUE(std::none_of(taken.begin(), taken.end(), [&](const Box& other) { return overlap(box, other); }));
    taken.push_back(box);
  }
  EXPECT_GT(placed, 20);
}

}  // namespace
