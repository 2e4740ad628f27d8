// The tool as its users run it: exit codes, one-line errors, the list of kernels, the faults that it finds in changed code.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "tests/numeric/shcheck_tool.hpp"

namespace sh::numeric {
namespace {

using test::read;
namespace fs = std::filesystem;

class Shcheck : public test::ShcheckTool {
 protected:
  [[nodiscard]] fs::path copy_of_generated() const {
    auto copy = folder_ / "generated";
    fs::create_directories(copy);
    fs::copy(fs::path(SHFORGE_SOURCE_DIR) / "generated" / "glsl", copy / "glsl");
    return copy;
  }
};

// The names and operations of the kernels that generated/MANIFEST lists as written in C++ and in GLSL.
struct Manifest {
  std::map<std::string, std::pair<int, int>> operations;  // mul, add; by kernel
  std::set<std::string> files;                            // without endings: cpp/basis_l4, glsl/basis_l4
};

int number_after(const std::string& line, const std::string& key) {
  return std::stoi(line.substr(line.find(key) + key.size()));
}

Manifest read_manifest() {
  Manifest manifest;
  std::ifstream file(fs::path(SHFORGE_SOURCE_DIR) / "generated" / "MANIFEST");
  std::string line;
  while (std::getline(file, line)) {
    std::istringstream files(line.substr(std::min(line.size(), line.find("files=") + 6)));
    for (std::string name; line[0] != '#' && files >> name;) {
      if (name == "-") continue;
      const std::string kernel = fs::path(name).stem();
      manifest.files.insert(fs::path(name).replace_extension().string());
      manifest.operations[kernel] = {number_after(line, "mul="), number_after(line, "add=")};
    }
  }
  return manifest;
}

// The kernels' files without endings: FOLDER/NAME_lDEGREE.
std::set<std::string> kernel_files() {
  std::set<std::string> files;
  for (const char* folder : {"cpp", "glsl"}) {
    for (const auto& entry : fs::directory_iterator(fs::path(SHFORGE_SOURCE_DIR) / "generated" / folder)) {
      const std::string name = entry.path().stem();
      if (std::regex_match(name, std::regex(".*_l[0-9]+"))) files.insert(std::string(folder) + "/" + name);
    }
  }
  return files;
}

TEST_F(Shcheck, EveryKernelInEveryLanguageAndScalarPasses) {
  const auto file = folder_ / "report.json";
  const auto outcome = run("kernels --json " + file.string());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(read(file));
  const auto manifest = read_manifest();
  std::set<std::string> seen;
  for (const auto& k : json.at("kernels")) {
    const std::string kernel = k.at("kernel");
    const std::string name = kernel + " " + std::string(k.at("language")) + " " + std::string(k.at("scalar"));
    EXPECT_TRUE(seen.insert(name).second) << name << " is there twice";
    EXPECT_NE(outcome.out.find(kernel + " "), std::string::npos);
    EXPECT_GT(k.at("inputs"), 0) << name;
    EXPECT_GE(k.at("total").at("absolute").at("max"), 0.999 * double{k.at("total").at("absolute").at("rms")}) << name;
    EXPECT_NE(k.at("total").at("worst").at("input"), "") << name;
    EXPECT_EQ(k.contains("bits"), k.at("language") != "c++") << name;
    EXPECT_EQ(k.contains("nanoseconds"), k.at("language") == "c++") << name;
    const auto& operations = k.at("operations");
    ASSERT_TRUE(manifest.operations.contains(kernel)) << name;
    EXPECT_EQ(operations.at("mul"), manifest.operations.at(kernel).first) << name;
    EXPECT_EQ(operations.at("add"), manifest.operations.at(kernel).second) << name;
  }
  std::set<std::string> wanted;
  for (const fs::path file_of_kernel : manifest.files) {
    const bool is_glsl = file_of_kernel.parent_path() == "glsl";
    wanted.insert(file_of_kernel.stem().string() + (is_glsl ? " glsl 450 float" : " c++ float"));
    wanted.insert(file_of_kernel.stem().string() + (is_glsl ? " glsl es 300 float" : " c++ double"));
  }
  EXPECT_EQ(seen, wanted);
  EXPECT_EQ(manifest.files, kernel_files());
  EXPECT_TRUE(json.at("failures").empty());
}

TEST_F(Shcheck, ShowsOneFamilyWithALineForEachLanguageAndScalar) {
  const auto outcome = run("kernels --family basis");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* line : {"basis_l3 +c\\+\\+ +float ", "basis_l3 +c\\+\\+ +double ",
                           "basis_l3 +glsl 450 +float .* same", "basis_l3 +glsl es 300 +float .* same"}) {
    EXPECT_TRUE(std::regex_search(outcome.out, std::regex(line))) << line;
  }
  EXPECT_EQ(outcome.out.find("rotate_l"), std::string::npos);
}

TEST_F(Shcheck, FindsAChangedDigitInAGlslKernel) {
  const auto generated = copy_of_generated();
  const auto file = generated / "glsl" / "basis_l3.glsl";
  std::string text = read(file);
  const auto digit = text.find("0.48860252");
  ASSERT_NE(digit, std::string::npos);
  text[digit + 9] = '9';
  std::ofstream(file) << text;
  const auto outcome = run("kernels --family basis --generated " + generated.string());
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("basis_l3 glsl 450 float: "), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("basis_l3 glsl es 300 float: "), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.err.find("basis_l4 glsl"), std::string::npos) << outcome.err;
}

TEST_F(Shcheck, RefusesAGlslKernelThatIsMissingOrDoesNotCompile) {
  const auto generated = copy_of_generated();
  std::ofstream(generated / "glsl" / "basis_l0.glsl") << "void basis_l0(";
  auto outcome = run("kernels --family basis --generated " + generated.string());
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("basis_l0.glsl: does not compile as GLSL: "), std::string::npos) << outcome.err;
  fs::remove(generated / "glsl" / "basis_l0.glsl");
  outcome = run("kernels --family basis --generated " + generated.string());
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("basis_l0.glsl: cannot read"), std::string::npos) << outcome.err;
}

TEST_F(Shcheck, LooksAtTheReportsPlaceBeforeItChecksAnything) {
  expect_refused("kernels --json " + (folder_ / "missing" / "report.json").string(),
                 "report.json: cannot write: No such file or directory");
  EXPECT_FALSE(fs::exists(folder_ / "missing"));
}

TEST_F(Shcheck, SaysItsVersionAndTakesFiniteNumbersOnly) {
  EXPECT_EQ(run("--version").out, "shcheck 0.1.0\n");
  for (const std::string number : {"nan", "inf"}) {
    expect_refused("rotation-matrix x --tolerance " + number, "--tolerance: expected a finite number, got " + number);
    expect_refused("advise --task basis --degree 2 --error " + number, "expected a finite number, got " + number);
  }
}

TEST_F(Shcheck, EvaluatesAReferenceValueToAThousandDigits) {
  const auto outcome = run("eval --degree 3 --order -2 --direction -0.1,0.2,-3e-1 --digits 1000");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  // Y_(3,-2) = sqrt(105 / 4 pi) x y z / r^3 = sqrt(105 / 4 pi) * 0.006 / 0.14^(3/2)
  EXPECT_EQ(outcome.out.substr(0, 20), "3.310921731627339260");
  EXPECT_EQ(outcome.out.size(), std::string("3.e-01\n").size() + 999);
}

TEST_F(Shcheck, PrintsTheComponentsOfAGradientALineEach) {
  // r Y_(1,-1) = sqrt(3 / 4 pi) y.
  const auto outcome = run("eval --degree 1 --order -1 --direction 1,2,3 --digits 12 --gradient");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out, "0\n4.88602511903e-01\n0\n");
}

TEST_F(Shcheck, RefusesBadInputInOneLineWithExitTwo) {
  const std::string good = "--degree 2 --order 1 --digits 9 --direction ";
  expect_refused("eval " + good + "0,0,0", "expected a vector that is not zero");
  expect_refused("eval " + good + "nan,0,1", "direction x: expected a decimal number such as -0.5 or 1e-3, got 'nan'");
  expect_refused("eval " + good + "0,inf,1", "direction y: expected a decimal number such as -0.5 or 1e-3, got 'inf'");
  expect_refused("eval " + good + "0,1", "x,y,z");
  expect_refused("eval " + good + "0,1,2,3", "x,y,z");
  expect_refused("eval " + good + "0,1,2x", "direction z: expected a decimal number such as -0.5 or 1e-3, got '2x'");
  expect_refused("eval --degree 2 --order 3 --digits 9 --direction 0,0,1", "order: expected -2 to 2, got 3");
  expect_refused("eval --degree 10001 --order 3 --digits 9 --direction 0,0,1", "expected 0 to 10000, got 10001");
  expect_refused("eval --gradient " + good + "0,0,0", "expected a vector that is not zero");
  expect_refused("identify /dev/zero", "/dev/zero: larger than 1000 MB");
  expect_refused("eval --degree x --order 3 --digits 9 --direction 0,0,1", "--degree");
  expect_refused("eval --degree 2 --order 1 --direction 0,0,1", "--digits");
  expect_refused("", "subcommand");
  expect_refused("frobnicate", "");
  expect_refused("kernels --bogus", "--bogus");
  expect_refused("kernels --family bassis", "--family: expected one of basis");
}

TEST_F(Shcheck, IdentifiesAConventionAndFindsAFlippedSign) {
  const auto example = fs::path(SHFORGE_SOURCE_DIR) / "tests" / "data" / "identify_example.csv";
  auto outcome = run("identify " + example.string());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("presets directxmath, unreal, gaussian-splatting"), std::string::npos) << outcome.out;
  const auto spoiled = folder_ / "spoiled.csv";
  std::ofstream(spoiled) << std::regex_replace(read(example), std::regex(",0\\.282094806,"), ",-0.282094806,");
  outcome = run("identify --json " + spoiled.string());
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json.at("first_wrong").at("index"), 0);
  EXPECT_EQ(json.at("first_wrong").at("reason"), "sign flipped");
  expect_refused("identify", "identify: expected FILE or --directions N");
  expect_refused("identify --directions 0", "--directions: expected 1 to 1000000, got 0");
  expect_refused("identify missing.csv", "missing.csv: cannot read: No such file or directory");
  std::ofstream(spoiled) << "0,0,1,0.3\n0,0,1.5,0.3\n";
  expect_refused("identify " + spoiled.string(), "spoiled.csv:2: expected a direction of length 1 to within 1e-05");
}

TEST_F(Shcheck, PrintsReferencesOfLegendreFunctionsCapsAndGauntCoefficients) {
  EXPECT_EQ(run("legendre --degree 1 --order 1 --z 0.6 --digits 9").out, "2.76395320e-01\n");
  EXPECT_EQ(run("legendre --degree 3 --order 2 --theta 0 --digits 9").out, "0\n");
  EXPECT_EQ(run("cap --degree 3 --angle 1e-8 --digits 9").out, "2.34473605e-16\n");
  EXPECT_EQ(run("cap --degree 0 --one-minus-cos 2 --digits 9").out, "3.54490770e+00\n");
  EXPECT_EQ(run("gaunt --degrees 2,2,2 --orders 0,0,0 --digits 9").out, "1/7 * sqrt(5) / sqrt(pi)\n1.80223752e-01\n");
  EXPECT_EQ(run("gaunt --degrees 1,1,1 --orders 0,0,0 --digits 9").out, "0\n0\n");
  EXPECT_EQ(run("gaunt --degrees 2,1,1 --orders 0,1,-1 --digits 9 --complex").out,
            "1/10 * sqrt(5) / sqrt(pi)\n1.26156626e-01\n");
}

TEST_F(Shcheck, PrintsReferencesOfRotations) {
  const std::string about_z = "rotation --degree 1 --axis 0,0,1 --angle 0.3 --digits 5";
  EXPECT_EQ(run(about_z).out, "9.5534e-01 0 2.9552e-01\n0 1.0000e+00 0\n-2.9552e-01 0 9.5534e-01\n");
  EXPECT_EQ(run(about_z + " --format csv").out, "9.5534e-01,0,2.9552e-01\n0,1.0000e+00,0\n-2.9552e-01,0,9.5534e-01\n");
  const auto json = nlohmann::json::parse(run(about_z + " --format json").out);
  EXPECT_EQ(json.at("matrix").at(0).at(2), "2.9552e-01");
  EXPECT_EQ(run(about_z + " --row 1 --column -1").out, "-2.9552e-01\n");
  EXPECT_EQ(run("rotation --degree 1000 --row 0 --column 0 --quaternion 1,1,1,1 --digits 9").out, "2.52250182e-02\n");
  const auto projected =
      run("rotation --degree 1 --matrix 0.6001,-0.8,0,0.8,0.6,0,0,0,1 --digits 5 --row 0 --column 0");
  EXPECT_EQ(projected.out, "1.0000e+00\n");
  EXPECT_EQ(projected.err, "shcheck: --matrix is 8.25e-05 from the nearest rotation, which is taken\n");
}

TEST_F(Shcheck, RefusesBadRotationsInOneLineWithExitTwo) {
  const std::string start = "rotation --degree 2 --digits 9 ";
  expect_refused(start, "expected one of --matrix, --quaternion, --euler");
  expect_refused(start + "--quaternion 1,0,0,0 --euler 1,2,3", "expected one of --matrix, --quaternion, --euler");
  expect_refused(start + "--axis 1,0,0", "expected --axis and --angle together");
  expect_refused(start + "--quaternion 1,0,0",
                 "--quaternion: expected four numbers w,x,y,z separated by commas, got '1,0,0'");
  expect_refused(start + "--matrix 1,0,0,0,1,0,0,0,-1", "--matrix: expected a rotation, determinant 1");
  expect_refused(start + "--matrix 1,0,0,0,1,0,0,0,2", "--matrix: expected a rotation, |R R^T - 1|");
  expect_refused(start + "--euler 1,2,3 --row 1", "expected --row and --column together");
  expect_refused(start + "--euler 1,2,3 --row 1 --column 5", "column: expected -2 to 2, got 5");
  expect_refused("rotation --degree 101 --digits 9 --euler 1,2,3",
                 "degree: expected 0 to 100 for the whole matrix, got 101");
  expect_refused(start + "--euler 1,2,3 --format xml", "--format");
}

TEST_F(Shcheck, RefusesBadReferencesInOneLineWithExitTwo) {
  expect_refused("legendre --degree 2 --order 1 --digits 9", "expected one of --z and --theta, got neither");
  expect_refused("legendre --degree 2 --order 1 --z 2 --digits 9", "--z: expected -1 to 1, got 2");
  expect_refused("legendre --degree 2 --order 1 --z 0.5 --digits 10001", "digits: expected 1 to 10000, got 10001");
  expect_refused("cap --degree 2 --angle 1 --one-minus-cos 1 --digits 9",
                 "expected one of --angle and --one-minus-cos, got both");
  expect_refused("cap --degree 2 --angle 1e --digits 9",
                 "--angle: expected a decimal number such as -0.5 or 1e-3, got '1e'");
  expect_refused("gaunt --degrees 2,2 --orders 0,0,0 --digits 9",
                 "--degrees: expected three integers separated by commas");
  expect_refused("gaunt --degrees 2,2,2.5 --orders 0,0,0 --digits 9",
                 "--degrees: expected an integer up to 10000, got '2.5'");
  expect_refused("gaunt --degrees 2,2,2 --orders 0,0,3 --digits 9", "order: expected -2 to 2, got 3");
  expect_refused("gaunt --degrees 2,2,2 --orders 0,0,0 --digits 0", "digits: expected 1 to 10000, got 0");
  expect_refused("gaunt --degrees 2,99999999999,2 --orders 0,0,0 --digits 9",
                 "--degrees: expected an integer up to 10000, got '99999999999'");
}

TEST_F(Shcheck, ChecksRotationMatricesAndSuggestsRotations) {
  const auto example = fs::path(SHFORGE_SOURCE_DIR) / "tests" / "data" / "rotation_matrix_example.csv";
  auto outcome = run("rotation-matrix " + example.string());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("every rotation is within the limit"), std::string::npos) << outcome.out;
  outcome = run("rotation-matrix --tolerance 1e-8 --json " + example.string());
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  EXPECT_EQ(nlohmann::json::parse(outcome.out).at("passes"), false);
  outcome = run("rotation-matrix --rotations 40");
  EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 42);
  EXPECT_NE(outcome.out.find("  # identity\n"), std::string::npos);
  expect_refused("rotation-matrix", "rotation-matrix: expected FILE or --rotations N");
  expect_refused("rotation-matrix --rotations 1", "--rotations: expected 2 to ");
  expect_refused("rotation-matrix missing.csv", "missing.csv: cannot read: No such file or directory");
  expect_refused("rotation-matrix --tolerance -1 " + example.string(), "--tolerance");
}

TEST_F(Shcheck, ExplainsItself) {
  const auto outcome = run("--help");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_NE(outcome.out.find("kernels"), std::string::npos);
  EXPECT_EQ(outcome.err, "");
}

TEST_F(Shcheck, WorstShowsAnInputOfEachKernelAndScalar) {
  const auto outcome = run("worst --family basis --degree 7 --evaluations 50");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const std::string start : {"basis_l7 +float", "basis_l7 +double", "basis_accurate_l7 +float"}) {
    EXPECT_TRUE(std::regex_search(outcome.out,
                                  std::regex(start + " +[0-9.]+ eps  out l=[0-7] m=-?[0-7] at( -?[0-9.e-]+){3}\n")))
        << outcome.out;
  }
  EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 4) << outcome.out;
}

TEST_F(Shcheck, WorstRefusesWhatThereIsNot) {
  expect_refused("worst --family nope", "worst: expected a kernel that `shcheck kernels` lists");
  expect_refused("worst --family basis --degree 11", "worst: expected a kernel that `shcheck kernels` lists");
  expect_refused("worst --family basis --exhaustive", "expected a kernel of one variable");
  expect_refused("worst --evaluations 0", "--evaluations");
}

}  // namespace
}  // namespace sh::numeric
