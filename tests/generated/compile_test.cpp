// The committed headers in both compilers and both standards, under strict warnings; and code that must not compile.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "tests/temporary_folder.hpp"

namespace sh {
namespace {

namespace fs = std::filesystem;

const fs::path kHeaders = fs::path(SHFORGE_SOURCE_DIR) / "generated/cpp";
constexpr const char* kStrict =
    " -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wdouble-promotion -Werror -fsyntax-only ";

struct Compiled {
  bool accepted = false;
  std::string messages;
};

// Compiles source texts, each a unit of its own, in one call of `compiler`, e.g. "g++ -std=c++17".
Compiled compile(const std::string& compiler, const std::map<std::string, std::string>& sources) {
  const test::TemporaryFolder folder;
  for (const auto& [name, source] : sources) std::ofstream(folder.path() / (name + ".cpp")) << source;
  const std::string command = "cd '" + folder.path().string() + "' && " + compiler + kStrict + "-I '" +
                              SHFORGE_SOURCE_DIR + "' *.cpp >log 2>&1";
  const int status = std::system(command.c_str());
  std::ifstream stream(folder.path() / "log");
  return {WIFEXITED(status) && WEXITSTATUS(status) == 0, {std::istreambuf_iterator<char>(stream), {}}};
}

Compiled compile(const std::string& compiler, const std::string& source) {
  return compile(compiler, {{"one", source}});
}

// The generated headers: of kernels, or of families.
std::vector<std::string> headers(bool of_kernels) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(kHeaders)) {
    const std::string name = entry.path().stem();
    // A kernel's name ends in _lDEGREE.
    const std::size_t digits = name.find_last_not_of("0123456789") + 1;
    const bool kernel = digits < name.size() && digits > 2 && name.substr(digits - 2, 2) == "_l";
    if (kernel == of_kernels) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string include(const std::string& name) { return "#include \"generated/cpp/" + name + ".hpp\"\n"; }

const std::string kUse = "template <auto kFunction>\nstruct Use {};\n";

// Instantiates the kernel for both scalars.
std::string use(const std::string& name) {
  std::string text;
  for (const std::string scalar : {"float", "double"}) {
    text.append("template struct Use<&sh::").append(name).append("<").append(scalar).append(">>;\n");
  }
  return text;
}

// The compiler and standard to use.
class GeneratedHeader : public testing::TestWithParam<std::string> {};

// Headers of families include the headers of their kernels. A missing include shows in any standard, and the test below
// compiles every combination, so each compiler and each standard occurs here once.
TEST_P(GeneratedHeader, OfEveryKernelAndFamilyCompilesAlone) {
  std::map<std::string, std::string> sources;
  for (const std::string& name : headers(false)) sources[name] = include(name);
  for (const std::string& name : headers(true)) sources[name] = include(name) + kUse + use(name);
  const Compiled result = compile(GetParam(), sources);
  constexpr std::size_t kMostPrinted = 4000;
  EXPECT_TRUE(result.accepted) << result.messages.substr(0, kMostPrinted);
}

INSTANTIATE_TEST_SUITE_P(Compilers, GeneratedHeader, testing::Values("g++ -std=c++17", "clang++ -std=c++20"),
                         [](const auto& compiler) {
                           const std::string& command = compiler.param;
                           return (command[0] == 'g' ? "gcc" : "clang") + command.substr(command.size() - 2);
                         });

TEST(GeneratedHeaders, AllCompileTogetherInBothCompilersAndStandards) {
  std::string all = kUse;
  for (const bool of_kernels : {true, false}) {
    for (const std::string& name : headers(of_kernels)) all += include(name);
  }
  for (const std::string& name : headers(true)) all += use(name);
  for (const std::string compiler : {"g++ -std=c++17", "g++ -std=c++20", "clang++ -std=c++17", "clang++ -std=c++20"}) {
    const Compiled result = compile(compiler, all);
    EXPECT_TRUE(result.accepted) << compiler << "\n" << result.messages;
  }
}

// Every degree in float, double and lanes of float.
constexpr const char* kUseFamily = R"(
#include "generated/cpp/basis.hpp"
#include <experimental/simd>
template <class T, int... kDegree>
void use(T* out, std::integer_sequence<int, kDegree...>) { (sh::basis<kDegree>(T(0), T(0), T(1), out), ...); }
using All = std::make_integer_sequence<int, 11>;
void use_all(float* f, double* d, std::experimental::native_simd<float>* v) {
  use(f, All());
  use(d, All());
  use(v, All());
}
)";

TEST(GeneratedHeaders, FamilyHeaderCompilesInBothCompilersAndStandards) {
  for (const std::string compiler : {"g++ -std=c++17", "g++ -std=c++20", "clang++ -std=c++17", "clang++ -std=c++20"}) {
    const Compiled result = compile(compiler, kUseFamily);
    EXPECT_TRUE(result.accepted) << compiler << "\n" << result.messages;
  }
}

TEST(GeneratedHeaders, DegreeOutOfRangeIsAReadableCompileError) {
  for (const std::string degree : {"-1", "11"}) {
    const Compiled result =
        compile("g++ -std=c++17", "#include \"generated/cpp/basis.hpp\"\nvoid use(float* f) { sh::basis<" + degree +
                                      ">(0.F, 0.F, 1.F, f); }\n");
    EXPECT_FALSE(result.accepted);
    EXPECT_NE(result.messages.find("Degree has to be 0 to 10"), std::string::npos) << result.messages;
  }
}

TEST(GeneratedHeaders, WiderScalarsAreAReadableCompileError) {
  // A silently rounded constant would make long double no better than double.
  for (const std::string compiler : {"g++ -std=c++17", "clang++ -std=c++17"}) {
    const Compiled result = compile(compiler,
                                    "#include \"generated/cpp/basis_l2.hpp\"\nvoid use(long double* f) "
                                    "{ sh::basis_l2(0.L, 0.L, 1.L, f); }\n");
    EXPECT_FALSE(result.accepted);
    EXPECT_NE(result.messages.find("for float and double"), std::string::npos) << result.messages;
  }
}

}  // namespace
}  // namespace sh
