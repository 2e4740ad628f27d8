// The committed headers in both compilers, both standards, under strict warnings; and what must not compile.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

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

// Compiles a source text with `compiler`, e.g. "g++ -std=c++17".
Compiled compile(const std::string& compiler, const std::string& source) {
  const fs::path file = fs::temp_directory_path() / ("shforge-compile-" + std::to_string(::getpid()) + ".cpp");
  const fs::path log = file.string() + ".log";
  std::ofstream(file) << source;
  const std::string command =
      compiler + kStrict + "-I '" + SHFORGE_SOURCE_DIR + "' '" + file.string() + "' >'" + log.string() + "' 2>&1";
  const int status = std::system(command.c_str());
  std::ifstream stream(log);
  Compiled result{WIFEXITED(status) && WEXITSTATUS(status) == 0, {std::istreambuf_iterator<char>(stream), {}}};
  fs::remove(file);
  fs::remove(log);
  return result;
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

TEST(GeneratedHeaders, EachCompilesAlone) {
  for (const bool of_kernels : {true, false}) {
    for (const std::string& name : headers(of_kernels)) {
      const Compiled result = compile("g++ -std=c++17", include(name));
      EXPECT_TRUE(result.accepted) << name << "\n" << result.messages;
    }
  }
}

TEST(GeneratedHeaders, AllCompileTogetherInBothCompilersAndStandards) {
  std::string all;
  for (const bool of_kernels : {true, false}) {
    for (const std::string& name : headers(of_kernels)) all += include(name);
  }
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
