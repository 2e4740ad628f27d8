// Printers: print -> compile -> run -> compare, and the shape of single expressions.
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <sstream>

#include "codegen/choose/catalogue.hpp"
#include "codegen/ir/evaluate.hpp"
#include "codegen/measure/directions.hpp"
#include "codegen/print/describe.hpp"
#include "codegen/print/files.hpp"
#include "codegen/print/statements.hpp"
#include "tests/codegen/support.hpp"

namespace sh::codegen {
namespace {

using test::quoted;
using test::run_command;

class Statements : public test::SmallKernel {};
class Dump : public test::SmallKernel {};
class CppPrinter : public test::SmallKernel {};

std::vector<std::string> statements_of(const Kernel& kernel) {
  std::vector<std::string> texts;
  for (const print::Statement& s : print::make_listing(kernel, print::cpp_dialect()).statements)
    texts.push_back(s.text);
  return texts;
}

TEST_F(Statements, BracketsKeepTheOrderOfOperations) {
  const NodeId difference = build.sub(kY, kZ);
  const NodeId outer = build.sub(kX, difference);
  const NodeId product = build.mul(outer, build.mul(kY, kZ));
  output(build.neg(product));
  EXPECT_EQ(statements_of(kernel).back(), "out[0] = -((x - (y - z)) * (y * z));");
}

TEST_F(Statements, ValuesUsedTwiceBecomeVariablesWithTheirNames) {
  const NodeId z2 = build.mul(kZ, kZ);
  const NodeId sum = build.add(z2, kX, "s2");
  output(build.mul(sum, z2));
  output(sum);
  EXPECT_EQ(statements_of(kernel), (std::vector<std::string>{"const T z2 = z * z;", "const T s2 = z2 + x;",
                                                             "out[1] = s2;", "out[0] = s2 * z2;"}));
}

TEST_F(Statements, NamesNeverClashWithParametersOrEachOther) {
  const NodeId a = build.add(kX, kY, "x");
  const NodeId b = build.add(kX, kZ, "x");
  const NodeId ab = build.mul(a, b, "out");
  const NodeId squares = build.add(build.mul(ab, ab), build.mul(a, b));
  output(squares);
  EXPECT_EQ(statements_of(kernel),
            (std::vector<std::string>{"const T x_2 = x + y;", "const T x_3 = x + z;", "const T out_2 = x_2 * x_3;",
                                      "out[0] = out_2 * out_2 + x_2 * x_3;"}));
}

TEST_F(Statements, RefusesFusedMultiplyAdd) {
  output(build.fma(kX, kY, kZ));
  EXPECT_THROW(print::make_listing(kernel, print::cpp_dialect()), std::invalid_argument);
}

// a and b of three numbers each; out[i] = a[2 - i] * b[i].
Kernel reversing_kernel() {
  Kernel kernel;
  kernel.name = "reversed";
  kernel.parameters = {{"a", {3}}, {"b", {3}}};
  kernel.results = {{"out", {3}}};
  Builder build(kernel);
  std::vector<NodeId> inputs;
  for (int i = 0; i < 6; ++i) inputs.push_back(build.input(i, ""));
  for (std::size_t i = 0; i < 3; ++i) kernel.outputs.push_back({build.mul(inputs[2 - i], inputs[3 + i]), ""});
  return kernel;
}

TEST_F(Statements, LoadsAnElementBeforeAStoreMayOverwriteIt) {
  const print::Listing listing = print::make_listing(reversing_kernel(), print::cpp_dialect());
  const std::vector<std::string> expected{"  const T a2 = a[2];", "  const T a0 = a[0];", "  out[0] = a2 * b[0];",
                                          "  out[1] = a[1] * b[1];", "  out[2] = a0 * b[2];"};
  EXPECT_EQ(print::statement_lines(listing, print::cpp_dialect()), expected);
}

TEST(Functions, ReturnAScalarAndUpdateInPlace) {
  Kernel kernel = reversing_kernel();
  kernel.results = {{"value", {}}};
  kernel.outputs.resize(1);
  EXPECT_EQ(print::signature(kernel, print::glsl_dialect()), "float a[3], float b[3]");
  EXPECT_NE(print::function(kernel, print::glsl_dialect()).find("    return a[2] * b[0];"), std::string::npos);
  kernel = reversing_kernel();
  kernel.results[0].name = "b";
  EXPECT_EQ(print::signature(kernel, print::cpp_dialect()), "const T* a, T* b");
  EXPECT_EQ(print::signature(kernel, print::glsl_dialect()), "float a[3], inout float b[3]");
  EXPECT_EQ(print::arguments(kernel, print::cpp_dialect()), "a, b");
}

// Compiles `main_program` with g++ and returns its output.
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

constexpr std::size_t kDirections = 60;

FinishedKernel fastest(int degree) { return test::fastest("basis", degree); }

template <class T>
std::vector<std::array<T, 3>> first_directions() {
  std::vector<std::array<T, 3>> directions;
  for (const auto& d : test_directions()) {
    if (directions.size() == kDirections) break;
    directions.push_back({static_cast<T>(d[0]), static_cast<T>(d[1]), static_cast<T>(d[2])});
  }
  return directions;
}

// Every output of the kernel at the first directions, evaluated here, as hexadecimal floats.
template <class T>
std::string evaluated(const Kernel& kernel) {
  std::ostringstream text;
  text << std::hexfloat;
  Evaluator<T> evaluator(kernel);
  for (const auto& d : first_directions<T>()) {
    for (const T value : evaluator(d)) text << static_cast<double>(value) << '\n';
  }
  return text.str();
}

// A program that prints the same by calling `call` ("sh::basis_l7") at directions written into it.
template <class T>
std::string program_for(const std::string& type, const std::string& call) {
  std::ostringstream text;
  text << std::hexfloat << "#include <ios>\n#include <iostream>\nint main() {\n  const " << type << " d[][3] = {\n";
  for (const auto& d : first_directions<T>()) {
    text << "      {";
    for (const T v : d) text << type << "(" << static_cast<double>(v) << "), ";
    text << "},\n";
  }
  text << "  };\n  std::cout << std::hexfloat;\n  for (const auto& p : d) {\n    " << type << " out[64];\n    " << call
       << "(p[0], p[1], p[2], out);\n    for (auto v : out) std::cout << static_cast<double>(v) << '\\n';\n  }\n}\n";
  return text.str();
}

TEST_F(CppPrinter, CompiledCodeComputesTheKernelBitForBit) {
  const test::TemporaryFolder folder;
  const FinishedKernel finished = fastest(7);
  test::write_file(folder.path() / "kernel.hpp", print::cpp_kernel(finished, print::Scalar::kFloat));
  const std::string include = "#include \"kernel.hpp\"\n";
  const std::string flags = "-std=c++17";
  EXPECT_EQ(compile_and_run(folder.path(), include + program_for<float>("float", "sh::basis_l7"), flags),
            evaluated<float>(finished.kernel));
  EXPECT_EQ(compile_and_run(folder.path(), include + program_for<double>("double", "sh::basis_l7"), flags),
            evaluated<double>(finished.kernel));
}

TEST(GlslPrinter, BodyComputesTheKernelBitForBit) {
  // With `out float result[64]` spelt as a C++ reference the GLSL function is C++ on float.
  const test::TemporaryFolder folder;
  const FinishedKernel finished = fastest(7);
  std::string source = print::glsl_kernel(finished, print::Scalar::kFloat);
  const std::string parameter = "out float result[64]";
  ASSERT_NE(source.find(parameter), std::string::npos);
  source.replace(source.find(parameter), parameter.size(), "float (&result)[64]");
  const std::string program = source + program_for<float>("float", "basis_l7");
  EXPECT_EQ(compile_and_run(folder.path(), program, "-std=c++17 -fsingle-precision-constant"),
            evaluated<float>(finished.kernel));
}

TEST_F(CppPrinter, DivisionRootAndSelectionCompileAndAgree) {
  const test::TemporaryFolder folder;
  const NodeId square = build.add(build.mul(kX, kX), build.mul(kY, kY));
  const NodeId length = build.sqrt(square);
  for (int i = 0; i < 64; ++i) {
    const NodeId sum = build.add(length, build.constant(symbolic::Surd(i + 1)));
    output(build.select(kZ, kX, build.div(kY, sum), length));
  }
  FinishedKernel finished = fastest(0);
  finished.kernel = kernel;
  finished.cost = cost(kernel);
  test::write_file(folder.path() / "kernel.hpp", print::cpp_kernel(finished, print::Scalar::kFloat));
  EXPECT_EQ(compile_and_run(folder.path(), "#include \"kernel.hpp\"\n" + program_for<float>("float", "sh::probe"),
                            "-std=c++17"),
            evaluated<float>(finished.kernel));
}

// A fragment shader that calls one basis kernel.
std::string shader(const std::string& version, int degree) {
  std::ostringstream text;
  text << "#version " << version << '\n'
       << print::glsl_kernel(fastest(degree), print::Scalar::kFloat)
       << "layout(location = 0) out highp vec4 color;\nvoid main() {\n    float values[" << (degree + 1) * (degree + 1)
       << "];\n    basis_l" << degree << "(0.0, 0.6, 0.8, values);\n    color = vec4(values[0]);\n}\n";
  return text.str();
}

TEST(GlslPrinter, IsValidInDesktopAndEmbeddedGlsl) {
  const test::TemporaryFolder folder;
  const std::string file = folder.path() / "kernel.frag";
  const std::string validate = "glslangValidator " + quoted(file);
  for (const int degree : {0, 1, 4, 10}) {
    for (const std::string version : {"450 core", "300 es"}) {
      test::write_file(file, shader(version, degree));
      const auto result = run_command(validate);
      EXPECT_EQ(result.exit_code, 0) << version << result.out;
    }
  }
}

TEST(Printers, SayWhatAReaderNeeds) {
  const FinishedKernel finished = fastest(2);
  for (const Language& language : languages()) {
    const std::string text = language.print_kernel(finished, print::Scalar::kFloat);
    for (const std::string& part :
         {"shgen emit basis --degree 2 --lang " + language.name, std::string("MIT-0"), std::string("|d| = 1"),
          std::string("Sloan"), std::string("13 multiplications, 2 additions"), std::string("rounding"),
          std::string("total"), std::string("// l=2 m=-1"), std::string("// 3/4 sqrt(5/pi)")}) {
      EXPECT_NE(text.find(part), std::string::npos) << language.name << ": " << part;
    }
  }
}

TEST_F(Dump, ShowsEveryNodeAndMarksDeadOnes) {
  build.mul(kX, kY, "unused");
  output(build.add(kZ, build.constant(symbolic::Surd::square_root(2)), "sum"));
  const std::string text = print::dump(kernel);
  EXPECT_NE(text.find("%3 = mul %0 %1         ; unused, dead"), std::string::npos) << text;
  EXPECT_NE(text.find("constant sqrt(2)"), std::string::npos) << text;
  EXPECT_NE(text.find("output 0 = %5"), std::string::npos) << text;
}

}  // namespace
}  // namespace sh::codegen
