// Every language: the emitted file of every family at its lowest, a middle and its highest degree compiles alone.
#include <gtest/gtest.h>

#include "tests/codegen/support.hpp"

namespace sh::codegen {
namespace {

using print::Scalar;

constexpr const char* kStrict = " -fsyntax-only -Wall -Wextra -Wpedantic -Wconversion -Wdouble-promotion -Werror ";

// The commands that compile each file of a language alone, as few as the compilers allow.
struct Toolchain {
  std::string suffix;                 // of a unit, the file that is compiled
  std::string before;                 // of a unit, the text before the emitted text
  std::string after;                  // and the text after it
  std::vector<std::string> commands;  // run where the units are
};

Toolchain toolchain_of(const std::string& language) {
  const std::string fragment = "layout(location = 0) out highp vec4 color;\nvoid main() { color = vec4(0.0); }\n";
  if (language == "cpp") return {".cpp", "", "", {std::string("g++ -std=c++17") + kStrict + "*.cpp"}};
  if (language == "c99")
    return {
        ".c", "", "", {std::string("gcc -std=c99") + kStrict + "*.c", std::string("clang -std=c99") + kStrict + "*.c"}};
  if (language == "glsl") return {".frag", "#version 450 core\n", fragment, {"glslangValidator *.frag"}};
  if (language == "glsl-es") return {".frag", "#version 300 es\n", fragment, {"glslangValidator *.frag"}};
  if (language == "hlsl") {
    // The HLSL compiler takes one file at a time.
    return {".hlsl",
            "",
            "[numthreads(1, 1, 1)]\nvoid main() {}\n",
            {"ls *.hlsl | xargs -n 1 glslangValidator -D -V -S comp -e main -o /dev/null"}};
  }
  throw std::invalid_argument("no compiler known for " + language);
}

// Writes the emitted file as a unit. A header gets a unit that includes it, and a template is instantiated for both
// scalars.
void write_unit(const std::filesystem::path& folder, const Language& language, const FinishedKernel& finished,
                Scalar scalar) {
  const Toolchain toolchain = toolchain_of(language.name);
  const std::string& function = finished.kernel.name;
  const std::string name = function + (scalar == Scalar::kDouble ? "_double" : "");
  std::string unit = toolchain.before + language.print_kernel(finished, scalar) + toolchain.after;
  if (toolchain.suffix == ".cpp" || toolchain.suffix == ".c") {
    test::write_file(folder / (name + language.suffix), unit);
    unit = "#include \"" + name + language.suffix + "\"\n";
    if (language.name == "cpp") {
      unit += "template <auto kFunction>\nstruct Use {};\ntemplate struct Use<&sh::" + function +
              "<float>>;\ntemplate struct Use<&sh::" + function + "<double>>;\n";
    }
  }
  test::write_file(folder / (name + toolchain.suffix), unit);
}

}  // namespace

void test::expect_files_compile_alone(const std::string& name, const std::vector<FinishedKernel>& kernels) {
  const Language& language = find_language(name);
  const TemporaryFolder folder;
  for (const FinishedKernel& finished : kernels) {
    write_unit(folder.path(), language, finished, Scalar::kFloat);
    // A C++ header serves both; GLSL ES has no double.
    if (name != "cpp" && name != "glsl-es") write_unit(folder.path(), language, finished, Scalar::kDouble);
  }
  for (const std::string& command : toolchain_of(name).commands) {
    const auto result = test::run_command("cd " + test::quoted(folder.path()) + " && " + command);
    constexpr std::size_t kMostPrinted = 4000;
    EXPECT_EQ(result.exit_code, 0) << command << '\n' << (result.out + result.err).substr(0, kMostPrinted);
  }
}

namespace {

void expect_every_file_compiles_alone(const std::string& name) {
  test::expect_files_compile_alone(name, test::emitted_kernels());
}

TEST(EmittedFiles, OfEveryFamilyCompileAloneAsCpp) { expect_every_file_compiles_alone("cpp"); }
TEST(EmittedFiles, OfEveryFamilyCompileAloneAsC99) { expect_every_file_compiles_alone("c99"); }
TEST(EmittedFiles, OfEveryFamilyCompileAloneAsGlsl) { expect_every_file_compiles_alone("glsl"); }
TEST(EmittedFiles, OfEveryFamilyCompileAloneAsGlslEs) { expect_every_file_compiles_alone("glsl-es"); }
TEST(EmittedFiles, OfEveryFamilyCompileAloneAsHlsl) { expect_every_file_compiles_alone("hlsl"); }

TEST(EmittedFiles, AreCompiledInEveryLanguage) {
  for (const Language& language : languages()) EXPECT_NO_THROW(toolchain_of(language.name)) << language.name;
}

}  // namespace
}  // namespace sh::codegen
