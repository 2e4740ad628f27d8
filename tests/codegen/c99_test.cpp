// C99: gcc and clang compile the emitted kernels of every family, and the results equal the kernel's own bit for bit.
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <sstream>

#include "codegen/ir/evaluate.hpp"
#include "codegen/measure/measure.hpp"
#include "codegen/print/files.hpp"
#include "tests/codegen/support.hpp"

namespace sh::codegen {
namespace {

using print::Scalar;
using test::quoted;
using test::run_command;

constexpr const char* kFlags =
    " -std=c99 -O0 -ffp-contract=off -Wall -Wextra -Wpedantic -Wconversion -Wdouble-promotion -Werror -I . ";
constexpr std::size_t kInputs = 5;  // few, to keep the programs small

// Some of the test inputs of the kernel's family, rounded to T.
template <class T>
std::vector<std::vector<T>> some_inputs(const FinishedKernel& finished) {
  const std::vector<std::vector<double>> all = finished.domain.test_inputs(finished.kernel.degree);
  std::vector<std::vector<T>> inputs;
  for (std::size_t i = 0; i < kInputs; ++i) {
    const std::vector<double>& wanted = all[i * all.size() / kInputs];
    inputs.emplace_back(wanted.begin(), wanted.end());
  }
  return inputs;
}

template <class T>
std::string braced(const std::vector<T>& values) {
  std::ostringstream text;
  text << std::hexfloat << '{';
  for (const T value : values) text << static_cast<double>(value) << (std::is_same_v<T, float> ? "F, " : ", ");
  return text.str() + "}";
}

// A C function `name` that calls the kernel at the inputs and prints every output as a hexadecimal float.
template <class T>
std::string c_unit(const FinishedKernel& finished, const std::string& name, const std::vector<std::vector<T>>& inputs) {
  const std::string type = std::is_same_v<T, float> ? "float" : "double";
  const numeric::Signature signature = printed_signature(finished.kernel);
  std::ostringstream declarations;
  std::ostringstream arguments;
  std::ostringstream prints;
  if (signature.returns_value) prints << "    printf(\"%a\\n\", (double)returned);\n";
  int first = 0;
  for (const numeric::Parameter& p : signature.parameters) {
    const std::string variable = "arg" + std::to_string(&p - signature.parameters.data());
    declarations << "    " << type << ' ' << variable << '[' << p.values() << "];\n";
    for (int i = 0; p.is_read() && i < p.values(); ++i)
      declarations << "    " << variable << '[' << i << "] = in[item][" << first++ << "];\n";
    arguments << (arguments.str().empty() ? "" : ", ") << variable << (p.count == 0 ? "[0]" : "");
    if (p.is_written()) {
      prints << "    for (int i = 0; i < " << p.values() << R"(; ++i) printf("%a\n", (double))" << variable
             << "[i]);\n";
    }
  }
  std::string unit = "#include <stdio.h>\n#include \"" + name + ".h\"\nvoid run_" + name + "(void);\nvoid run_" + name +
                     "(void) {\n  static const " + type + " in[" + std::to_string(inputs.size()) + "][" +
                     std::to_string(signature.input_count()) + "] = {";
  for (const auto& input : inputs) unit += braced(input) + ",\n";
  unit += "};\n  for (int item = 0; item < " + std::to_string(inputs.size()) + "; ++item) {\n" + declarations.str() +
          "    " + (signature.returns_value ? "const " + type + " returned = " : "") + name + "(" + arguments.str() +
          ");\n";
  return unit + prints.str() + "  }\n}\n";
}

// The program under construction: its files and its expected output.
class Program {
 public:
  void add(const FinishedKernel& finished) {
    add<float>(finished, Scalar::kFloat, finished.kernel.name);
    add<double>(finished, Scalar::kDouble, finished.kernel.name + "_double");
  }

  // Compiles and runs the program, and compares every line with the expected output.
  void expect_same_bits(const std::string& compiler) {
    test::write_file(folder_.path() / "main.c", declarations_ + "int main(void) {\n" + calls_ + "  return 0;\n}\n");
    const auto built = run_command("cd " + quoted(folder_.path()) + " && " + compiler + kFlags + "*.c -o main -lm");
    ASSERT_EQ(built.exit_code, 0) << built.err;
    std::istringstream printed(run_command(quoted(folder_.path() / "main")).out);
    std::string number;
    for (const Expected& expected : expected_) {
      ASSERT_TRUE(printed >> number) << expected.kernel;
      const double value = std::strtod(number.c_str(), nullptr);
      ASSERT_EQ(std::bit_cast<std::uint64_t>(value), std::bit_cast<std::uint64_t>(expected.value))
          << expected.kernel << " output " << expected.output << ": " << value << " instead of " << expected.value;
    }
    EXPECT_FALSE(printed >> number);
  }

 private:
  struct Expected {
    std::string kernel;
    std::size_t output;
    double value;
  };

  template <class T>
  void add(const FinishedKernel& finished, Scalar scalar, const std::string& name) {
    const auto inputs = some_inputs<T>(finished);
    test::write_file(folder_.path() / (name + ".h"), print::c99_kernel(finished, scalar));
    test::write_file(folder_.path() / (name + ".c"), c_unit(finished, name, inputs));
    declarations_ += "void run_" + name + "(void);\n";
    calls_ += "  run_" + name + "();\n";
    Evaluator<T> evaluator(finished.kernel);
    for (const auto& input : inputs) {
      const std::vector<T> outputs = evaluator(input);
      std::vector<T> in_place(outputs.size());
      for (std::size_t i = 0; i < outputs.size(); ++i) {
        in_place[finished.kernel.element(i)] = outputs[i];
      }
      for (std::size_t i = 0; i < outputs.size(); ++i) expected_.push_back({name, i, static_cast<double>(in_place[i])});
    }
  }

  test::TemporaryFolder folder_;
  std::string declarations_;
  std::string calls_;
  std::vector<Expected> expected_;
};

class CompiledC : public testing::TestWithParam<std::string> {};

TEST_P(CompiledC, GivesTheKernelsOwnBitsForEveryFamily) {
  Program program;
  for (const FinishedKernel& finished : test::emitted_kernels()) program.add(finished);
  program.expect_same_bits(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Compilers, CompiledC, testing::Values("gcc", "clang"),
                         [](const auto& compiler) { return compiler.param; });

}  // namespace
}  // namespace sh::codegen
