// Every language: an emitted file of each family compiles alone; C99 is run and gives the kernel's own bits.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "codegen/catalogue.hpp"
#include "codegen/evaluate.hpp"
#include "codegen/print/c99.hpp"
#include "codegen/print/function.hpp"
#include "tests/codegen/support.hpp"

namespace sh::codegen {
namespace {

using print::Scalar;
using test::quoted;
using test::run_command;

constexpr const char* kStrict = " -Wall -Wextra -Wpedantic -Wconversion -Wdouble-promotion -Werror ";

// What compiles a file of the language, and what has to stand around it.
struct Compiler {
  std::string suffix;
  std::string before;
  std::string after;
  std::string command;  // the file's name follows
};

Compiler compiler_of(const std::string& language) {
  const std::string fragment = "layout(location = 0) out highp vec4 colour;\nvoid main() { colour = vec4(0.0); }\n";
  if (language == "cpp")
    return {".hpp", "", "", std::string("g++ -std=c++17 -fsyntax-only") + kStrict + "-x c++ /dev/null -include "};
  if (language == "c99")
    return {".c", "", "", std::string("gcc -std=c99 -fsyntax-only -Wno-unused-function") + kStrict};
  if (language == "glsl") return {".frag", "#version 450 core\n", fragment, "glslangValidator "};
  if (language == "glsl-es") return {".frag", "#version 300 es\n", fragment, "glslangValidator "};
  if (language == "hlsl")
    return {".hlsl", "", "[numthreads(1, 1, 1)]\nvoid main() {}\n",
            "glslangValidator -D -V -S comp -e main -o /dev/null "};
  throw std::invalid_argument("no compiler known for " + language);
}

// The smallest degree from 2 on that the family has.
int usual_degree(const Family& family) {
  int degree = std::min(2, family.largest_emitted);
  while (recipes_for(family, degree).empty()) ++degree;
  return degree;
}

std::string compile_messages(const Language& language, const FinishedKernel& finished, Scalar scalar) {
  const test::TemporaryFolder folder;
  const Compiler compiler = compiler_of(language.name);
  const std::string file = folder.path() / ("emitted" + compiler.suffix);
  test::write_file(file, compiler.before + language.print_kernel(finished, scalar) + compiler.after);
  const auto result = run_command(compiler.command + quoted(file));
  return result.exit_code == 0 ? "" : result.out + result.err;
}

class EmittedFile : public testing::TestWithParam<std::size_t> {};

TEST_P(EmittedFile, OfEachLanguageAndScalarCompilesAlone) {
  const Family& family = families()[GetParam()];
  const FinishedKernel finished = preferred_kernel(family, usual_degree(family), Prefer::kSpeed);
  for (const Language& language : languages()) {
    EXPECT_EQ(compile_messages(language, finished, Scalar::kFloat), "") << language.name;
    if (language.name == "glsl-es") continue;  // has no double
    EXPECT_EQ(compile_messages(language, finished, Scalar::kDouble), "") << language.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Families, EmittedFile, testing::Range<std::size_t>(0, families().size()),
                         [](const auto& index) { return families()[index.param].name; });

// Inputs of the family rounded to T, as few as keep the program small.
template <class T>
std::vector<std::vector<T>> some_inputs(const Family& family, int degree) {
  std::vector<std::vector<T>> inputs;
  for (const std::vector<double>& wanted : family.domain.test_inputs(degree)) {
    if (inputs.size() == 20) break;
    inputs.emplace_back(wanted.begin(), wanted.end());
  }
  return inputs;
}

// A C program that prints every output of the kernel at the inputs, as hexadecimal floats.
template <class T>
std::string c_program(const Kernel& kernel, const std::string& call, const std::vector<std::vector<T>>& inputs) {
  const std::string type = std::is_same_v<T, float> ? "float" : "double";
  std::ostringstream text;
  text << std::hexfloat << "#include <stdio.h>\n#include \"kernel.h\"\nint main(void) {\n  static const " << type
       << " inputs[][" << inputs.front().size() << "] = {\n";
  for (const auto& input : inputs) {
    text << "      {";
    for (const T v : input) text << "(" << type << ")" << static_cast<double>(v) << ", ";
    text << "},\n";
  }
  text << "  };\n  for (int i = 0; i < " << inputs.size() << "; ++i) {\n    " << type << " out["
       << kernel.outputs.size() << "];\n    " << (kernel.returns_scalar() ? "out[0] = " : "") << call << "(";
  int first = 0;
  for (const Parameter& parameter : kernel.parameters) {
    text << (first > 0 ? ", " : "") << (parameter.shape.empty() ? "" : "&") << "inputs[i][" << first << "]";
    first += parameter.size();
  }
  if (!kernel.returns_scalar()) {
    int offset = 0;
    for (const Parameter& result : kernel.results) {
      text << ", out + " << offset;
      offset += result.size();
    }
  }
  text << ");\n    for (int k = 0; k < " << kernel.outputs.size()
       << "; ++k) printf(\"%a\\n\", (double)out[k]);\n  }\n  return 0;\n}\n";
  return text.str();
}

bool updates_in_place(const Kernel& kernel) {
  return std::any_of(kernel.results.begin(), kernel.results.end(), [&](const Parameter& result) {
    return std::any_of(kernel.parameters.begin(), kernel.parameters.end(),
                       [&](const Parameter& parameter) { return parameter.name == result.name; });
  });
}

template <class T>
void expect_same_bits_in_c(const Family& family, Scalar scalar) {
  const int degree = usual_degree(family);
  const FinishedKernel finished = preferred_kernel(family, degree, Prefer::kSpeed);
  if (updates_in_place(finished.kernel)) return;
  const auto inputs = some_inputs<T>(family, degree);
  const test::TemporaryFolder folder;
  test::write_file(folder.path() / "kernel.h", print::c99_kernel(finished, scalar));
  const std::string call = finished.kernel.name + (scalar == Scalar::kDouble ? "_double" : "");
  test::write_file(folder.path() / "main.c", c_program<T>(finished.kernel, call, inputs));
  const std::string binary = quoted(folder.path() / "main");
  const auto compiled = run_command(std::string("gcc -std=c99 -O1 -ffp-contract=off -D_GNU_SOURCE") + kStrict + "-o " +
                                    binary + " " + quoted(folder.path() / "main.c") + " -lm");
  ASSERT_EQ(compiled.exit_code, 0) << compiled.err;
  std::istringstream printed(run_command(binary).out);
  Evaluator<T> evaluator(finished.kernel);
  for (const auto& input : inputs) {
    for (const T value : evaluator(input)) {
      std::string number;
      ASSERT_TRUE(printed >> number);
      EXPECT_EQ(static_cast<T>(std::strtod(number.c_str(), nullptr)), value) << family.name;
    }
  }
}

class CompiledC : public testing::TestWithParam<std::size_t> {};

TEST_P(CompiledC, ComputesTheKernelBitForBit) {
  const Family& family = families()[GetParam()];
  expect_same_bits_in_c<float>(family, Scalar::kFloat);
  expect_same_bits_in_c<double>(family, Scalar::kDouble);
}

INSTANTIATE_TEST_SUITE_P(Families, CompiledC, testing::Range<std::size_t>(0, families().size()),
                         [](const auto& index) { return families()[index.param].name; });

}  // namespace
}  // namespace sh::codegen
