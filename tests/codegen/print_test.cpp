// Printers: print -> compile -> run -> compare, and the shape of single expressions.
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <sstream>

#include "codegen/catalogue.hpp"
#include "codegen/directions.hpp"
#include "codegen/evaluate.hpp"
#include "codegen/print/cpp.hpp"
#include "codegen/print/dump.hpp"
#include "codegen/print/glsl.hpp"
#include "codegen/print/statements.hpp"
#include "tests/codegen/support.hpp"

namespace sh::codegen {
namespace {

using test::add_output;
using test::empty_kernel;
using test::quoted;
using test::run_command;

constexpr NodeId kX = 0;
constexpr NodeId kY = 1;
constexpr NodeId kZ = 2;

std::string expression_of(const Kernel& kernel) {
  return print::make_listing(kernel, {"out"}).statements.back().expression;
}

TEST(Statements, BracketsKeepTheOrderOfOperations) {
  Kernel kernel = empty_kernel();
  Builder build(kernel);
  const NodeId difference = build.sub(kY, kZ);
  const NodeId outer = build.sub(kX, difference);
  const NodeId product = build.mul(outer, build.mul(kY, kZ));
  add_output(kernel, build.neg(product));
  EXPECT_EQ(expression_of(kernel), "-((x - (y - z)) * (y * z))");
}

TEST(Statements, ValuesUsedTwiceBecomeVariablesWithTheirNames) {
  Kernel kernel = empty_kernel();
  Builder build(kernel);
  const NodeId z2 = build.mul(kZ, kZ);
  const NodeId sum = build.add(z2, kX, "s2");
  add_output(kernel, build.mul(sum, z2));
  add_output(kernel, sum);
  const print::Listing listing = print::make_listing(kernel, {"out"});
  ASSERT_EQ(listing.statements.size(), 4U);
  EXPECT_EQ(listing.statements[0].target, "z2");
  EXPECT_EQ(listing.statements[1].target, "s2");
  EXPECT_EQ(listing.statements[1].expression, "z2 + x");
  EXPECT_EQ(listing.statements[2].target, "out[1]");
  EXPECT_EQ(listing.statements[3].expression, "s2 * z2");
}

TEST(Statements, NamesNeverClashWithParametersOrEachOther) {
  Kernel kernel = empty_kernel();
  Builder build(kernel);
  const NodeId a = build.add(kX, kY, "x");
  const NodeId b = build.add(kX, kZ, "x");
  const NodeId ab = build.mul(a, b, "out");
  const NodeId squares = build.add(build.mul(ab, ab), build.mul(a, b));
  add_output(kernel, squares);
  const print::Listing listing = print::make_listing(kernel, {"out"});
  ASSERT_EQ(listing.statements.size(), 4U);
  EXPECT_EQ(listing.statements[0].target, "x_2");
  EXPECT_EQ(listing.statements[1].target, "x_3");
  EXPECT_EQ(listing.statements[2].target, "out_2");
}

TEST(Statements, RefusesFusedMultiplyAdd) {
  Kernel kernel = empty_kernel();
  add_output(kernel, Builder(kernel).fma(kX, kY, kZ));
  EXPECT_THROW(print::make_listing(kernel, {"out"}), std::invalid_argument);
}

// Compiles `main_program` with g++ and returns what it prints.
std::string compile_and_run(const std::filesystem::path& folder, const std::string& main_program,
                            const std::string& flags) {
  test::write_file(folder / "main.cpp", main_program);
  const std::string binary = quoted(folder / "main");
  const auto compiled =
      run_command("g++ " + flags + " -Wall -Wextra -Wconversion -Wdouble-promotion -Werror -O1 -ffp-contract=off -o " +
                  binary + " " + quoted(folder / "main.cpp"));
  EXPECT_EQ(compiled.exit_code, 0) << compiled.err;
  return run_command(binary).out;
}

// Prints every output of basis_l7 at the first directions as hexadecimal floats.
template <class T>
std::string evaluated(const Kernel& kernel, std::size_t count) {
  std::ostringstream text;
  Evaluator<T> evaluator(kernel);
  for (std::size_t i = 0; i < count; ++i) {
    for (const T value : evaluator(test_directions<T>()[i]))
      text << std::hexfloat << static_cast<double>(value) << '\n';
  }
  return text.str();
}

template <class T>
std::string directions_as_code(const std::string& type, std::size_t count) {
  std::ostringstream text;
  text << std::hexfloat << "const " << type << " d[][3] = {\n";
  for (std::size_t i = 0; i < count; ++i) {
    text << "{";
    for (const T v : test_directions<T>()[i]) text << type << "(" << static_cast<double>(v) << "), ";
    text << "},\n";
  }
  text << "};\n";
  return text.str();
}

constexpr std::size_t kDirections = 60;
constexpr const char* kPrintLoop = "  for (double v : out) std::printf(\"%s\\n\", hex(v).c_str());\n";
constexpr const char* kHex =
    "#include <cstdio>\n#include <ios>\n#include <sstream>\n#include <string>\n"
    "std::string hex(double v) { std::ostringstream s; s << std::hexfloat << v; return s.str(); }\n";

TEST(CppPrinter, CompiledCodeComputesTheKernelBitForBit) {
  const test::TemporaryFolder folder;
  const FinishedKernel finished = finish_kernel(find_family("basis"), 7);
  test::write_file(folder.path() / "kernel.hpp", print::cpp_kernel(finished));
  for (const std::string type : {"float", "double"}) {
    const bool is_float = type == "float";
    const std::string program =
        std::string("#include \"kernel.hpp\"\n") + kHex +
        (is_float ? directions_as_code<float>(type, kDirections) : directions_as_code<double>(type, kDirections)) +
        "int main() {\n for (const auto& p : d) {\n  " + type + " out[64];\n  sh::basis_l7(p[0], p[1], p[2], out);\n" +
        kPrintLoop + " }\n}\n";
    std::string adapted = program;
    if (is_float) adapted.replace(adapted.find("for (double v"), 13, "for (float w");
    if (is_float) adapted.replace(adapted.find("hex(v)"), 6, "hex(static_cast<double>(w))");
    const std::string expected =
        is_float ? evaluated<float>(finished.kernel, kDirections) : evaluated<double>(finished.kernel, kDirections);
    EXPECT_EQ(compile_and_run(folder.path(), adapted, "-std=c++17"), expected) << type;
  }
}

TEST(GlslPrinter, BodyComputesTheKernelBitForBit) {
  // With `out float r[64]` spelt as a C++ reference the GLSL function is C++ on float.
  const test::TemporaryFolder folder;
  const FinishedKernel finished = finish_kernel(find_family("basis"), 7);
  std::string source = print::glsl_kernel(finished);
  const std::string parameter = "out float result[64]";
  ASSERT_NE(source.find(parameter), std::string::npos);
  source.replace(source.find(parameter), parameter.size(), "float (&result)[64]");
  const std::string program =
      std::string(kHex) + source + directions_as_code<float>("float", kDirections) +
      "int main() {\n for (const auto& p : d) {\n  float out[64];\n  basis_l7(p[0], p[1], p[2], out);\n"
      "  for (float w : out) std::printf(\"%s\\n\", hex(static_cast<double>(w)).c_str());\n }\n}\n";
  EXPECT_EQ(compile_and_run(folder.path(), program, "-std=c++17 -fsingle-precision-constant"),
            evaluated<float>(finished.kernel, kDirections));
}

TEST(GlslPrinter, IsValidInDesktopAndEmbeddedGlsl) {
  const test::TemporaryFolder folder;
  for (const int degree : {0, 1, 4, 10}) {
    const std::string source = print::glsl_kernel(finish_kernel(find_family("basis"), degree));
    for (const std::string version : {"450 core", "300 es"}) {
      const std::string size = std::to_string((degree + 1) * (degree + 1));
      test::write_file(folder.path() / "kernel.frag",
                       "#version " + version + "\n" + source +
                           "layout(location = 0) out highp vec4 colour;\nvoid main() {\n    float values[" + size +
                           "];\n    basis_l" + std::to_string(degree) +
                           "(0.0, 0.6, 0.8, values);\n    colour = vec4(values[0]);\n}\n");
      const auto result = run_command("glslangValidator " + quoted(folder.path() / "kernel.frag"));
      EXPECT_EQ(result.exit_code, 0) << version << result.out;
    }
  }
}

TEST(Printers, SayWhatAReaderNeeds) {
  const FinishedKernel finished = finish_kernel(find_family("basis"), 2);
  for (const Language& language : languages()) {
    const std::string text = language.print_kernel(finished);
    for (const std::string& part :
         {"shgen emit basis --degree 2 --lang " + language.name, std::string("MIT-0"), std::string("|d| = 1"),
          std::string("Sloan"), std::string("13 multiplications, 2 additions"), std::string("rounding"),
          std::string("total"), std::string("// l=2 m=-1"), std::string("// 3/4 sqrt(5/pi)")}) {
      EXPECT_NE(text.find(part), std::string::npos) << language.name << ": " << part;
    }
  }
}

TEST(Dump, ShowsEveryNodeAndMarksDeadOnes) {
  Kernel kernel = empty_kernel();
  Builder build(kernel);
  build.mul(kX, kY, "unused");
  add_output(kernel, build.add(kZ, build.constant(symbolic::Surd::square_root(2)), "sum"));
  const std::string text = print::dump(kernel);
  EXPECT_NE(text.find("%3 = mul %0 %1         ; unused, dead"), std::string::npos) << text;
  EXPECT_NE(text.find("constant sqrt(2)"), std::string::npos) << text;
  EXPECT_NE(text.find("output 0 = %5"), std::string::npos) << text;
}

}  // namespace
}  // namespace sh::codegen
