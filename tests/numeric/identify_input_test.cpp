// Tables as text: their values, and refusals with file and line.
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "tests/numeric/identify_data.hpp"

namespace sh::numeric::identify {
namespace {

std::vector<Samples> read(const std::string& text, bool normalize = false) {
  return read_samples(parse_table("my.csv", text), normalize);
}

void expect_refused(const std::string& text, const std::string& start, const std::string& part) {
  expect_refusal([&] { (void)identify(read(text)); }, start, part);
}

std::string text_of(double value) {
  std::ostringstream stream;
  stream.precision(17);
  stream << value;
  return stream.str();
}

// The table as a file; complex values by `cell`.
template <class Cell>
std::string write(const Samples& samples, const Cell& cell) {
  std::string text;
  for (std::size_t row = 0; row < samples.lines.size(); ++row) {
    const auto& d = samples.directions[row];
    text += text_of(d[0]) + "," + text_of(d[1]) + "," + text_of(d[2]);
    for (const auto& column : samples.columns) text.append(",").append(cell(column[row]));
    text += "\n";
  }
  return text;
}

std::string real_cell(const std::complex<double>& v) { return text_of(v.real()); }
std::string pair_of_cells(const std::complex<double>& v) { return text_of(v.real()) + "," + text_of(v.imag()); }
std::string python_cell(const std::complex<double>& v) {
  std::string text = "(";
  text.append(text_of(v.real())).append(v.imag() < 0 ? "" : "+").append(text_of(v.imag())).append("j)");
  return text;
}

TEST(IdentifyInput, ReadsHeadersCommentsBlankLinesAndSpaces) {
  const auto ways = read("\xEF\xBB\xBF# directions\r\n\r\nx, y, z, v0\r\n 0,0,1 , +0.25 # pole\n1,0,0,.25\n");
  ASSERT_EQ(ways.size(), 1);
  EXPECT_EQ(ways[0].degree, 0);
  EXPECT_EQ(ways[0].lines, (std::vector<int>{4, 5}));
  EXPECT_EQ(ways[0].columns[0], (Values{0.25, 0.25}));
}

TEST(IdentifyInput, ReadsComplexCellsAndPairsOfColumns) {
  const auto table = parse_table("t", "0,1,0,1+2i,(3-4j),-5e-1i,6\n");
  EXPECT_EQ(std::vector(table.rows[0].cells.begin() + 3, table.rows[0].cells.end()),
            (Values{{1, 2}, {3, -4}, {0, -0.5}, 6}));
  const Preset& scipy = preset_named("scipy");
  const auto samples = make_samples(scipy.convention, 2);
  for (const auto& text : {write(samples, python_cell), write(samples, pair_of_cells)}) {
    const auto result = identify(read(text));
    EXPECT_TRUE(result.recognized());
    EXPECT_TRUE(holds(result.readings.front().presets.own, "scipy"));
  }
}

TEST(IdentifyInput, TellsAnArrayWithHolesFromPairsOfColumns) {
  const Preset& shtools = preset_named("shtools");
  const auto result = identify(read(write(make_samples(shtools.convention, 2), real_cell)));
  EXPECT_TRUE(result.recognized());
  EXPECT_TRUE(holds(result.readings.front().presets.own, "shtools"));
}

TEST(IdentifyInput, ScalesDirectionsOnRequest) {
  const auto ways = read("0,0,2,0.28209479177387814\n3,0,4,0.28209479177387814\n", true);
  EXPECT_EQ(ways[0].directions[1], (std::array<double, 3>{0.6, 0, 0.8}));
  EXPECT_TRUE(identify(ways).recognized());
}

TEST(IdentifyInput, RefusesWhatIsNotATable) {
  expect_refused("", "my.csv: ", "expected a row of numbers, got none");
  expect_refused("x,y,z,v0\n# nothing\n", "my.csv: ", "expected a row of numbers, got none");
  expect_refused("x,y,z,v0\n0,0,1,0.3\n0,0,1\n", "my.csv:3: ", "expected 4 columns as on line 2, got 3");
  expect_refused("0,0,1,0.3\n0,0,1,0.3,0.4\n", "my.csv:2: ", "got 5");
  expect_refused("0,0,1,0.3\n0,0,1,abc\n",
                 "my.csv:2: ", "column 4: expected a number such as -0.5 or 0.5+0.25i, got 'abc'");
  expect_refused("0,0,1,0.3\n0,0,1,\n", "my.csv:2: ", "got ''");
  expect_refused("0,0,1,0.3x\n", "my.csv:1: ", "got '0.3x'");
  expect_refused("0 0 1 0.3\n", "my.csv", "");
  expect_refused("0,0,1,nan\n", "my.csv:1: ", "expected a finite number such as -0.5 or 0.5+0.25i, got 'nan'");
  expect_refused("0,0,1,1e999\n", "my.csv:1: ", "got '1e999'");
  expect_refused("0,0,1,1-infi\n", "my.csv:1: ", "expected a finite number");
}

TEST(IdentifyInput, RefusesColumnsAndDirectionsThatDoNotFit) {
  expect_refused("0,0,1\n", "my.csv:1: ", "(L+1)^2 values");
  expect_refused("0,0,1,1,2,3\n", "my.csv:1: ", "got 6 columns");
  expect_refused("0,0,1,1\n0,0,1.1,1\n",
                 "my.csv:2: ", "expected a direction of length 1 to within 1e-05, got 1.1 (--normalize");
  expect_refused("0,0,0,1\n", "my.csv:1: ", "zero vector");
  expect_refused("0,0,1i,1\n", "my.csv:1: ", "expected a real direction");
  expect_refused("0,0,1,1,2,3,4\n",
                 "my.csv: ", "expected at least 4 directions in general position to decide degree 1");
  std::string equator;
  for (int i = 0; i < 9; ++i) equator += i % 2 == 0 ? "1,0,0,1,2,3,4\n" : "0,1,0,1,2,3,4\n";
  expect_refused(equator, "my.csv: ", "got 9 that tell 2 functions apart");
}

TEST(IdentifyInput, RefusesFilesThatCannotBeRead) {
  const std::vector<std::string> files = {"/nonexistent/my.csv", std::filesystem::temp_directory_path().string()};
  for (const std::string& file : files) {
    try {
      (void)read_table(file);
      ADD_FAILURE() << file;
    } catch (const std::runtime_error& error) {
      EXPECT_EQ(std::string(error.what()).find(file + ": cannot read: "), 0) << error.what();
    }
  }
}

TEST(IdentifyInput, SuggestsDirectionsThatSuffice) {
  for (const int count : {1, 20, 100, 600}) {
    const auto table = parse_table("suggested", suggested_directions(count));
    EXPECT_EQ(table.rows.size(), static_cast<std::size_t>(count));
    const int degree = std::min(kMaxDegree, static_cast<int>(std::sqrt(count - std::min(count / 4, 100))) - 1);
    std::string text;
    for (const Row& row : table.rows) {
      for (const auto& cell : row.cells) text += text_of(cell.real()) + ",";
      text += "1";
      for (int i = 1; i < coefficient_count(degree); ++i) text += ",0";
      text += "\n";
    }
    EXPECT_NO_THROW((void)read(text)) << count;
  }
  EXPECT_THROW((void)suggested_directions(0), std::invalid_argument);
}

}  // namespace
}  // namespace sh::numeric::identify
