// The committed headers in both compilers, both standards, under strict warnings; and what must not compile.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

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

// A program that includes one header and instantiates its kernel.
std::string use_kernel(const std::string& name) {
  return "#include \"generated/cpp/" + name + ".hpp\"\n" + "template <class T> void use(T* out) { sh::" + name +
         "(T(0), T(0), T(1), out); }\ntemplate void use(float*);\ntemplate void use(double*);\n";
}

TEST(GeneratedHeaders, EachCompilesAloneInBothCompilersAndStandards) {
  for (const auto& entry : fs::directory_iterator(kHeaders)) {
    const std::string name = entry.path().stem();
    if (name.find("_l") == std::string::npos) continue;
    for (const std::string compiler : {"g++ -std=c++17", "clang++ -std=c++17", "clang++ -std=c++20"}) {
      const Compiled result = compile(compiler, use_kernel(name));
      EXPECT_TRUE(result.accepted) << compiler << " " << name << "\n" << result.messages;
    }
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
