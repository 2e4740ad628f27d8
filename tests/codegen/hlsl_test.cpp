// HLSL: the errors of emitted kernels stay below the limits of their families.
//
// glslang compiles a pixel shader that calls the kernel to SPIR-V, and spirv-cross translates it to GLSL. The function
// in this GLSL text runs on the software rasterizer. The translation may regroup operations, so the test compares
// errors and not bits.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <stdexcept>

#include "codegen/measure/measure.hpp"
#include "numeric/glsl/glsl_runner.hpp"
#include "numeric/kernels/bind.hpp"
#include "numeric/kernels/kernel_limits.hpp"
#include "numeric/kernels/samples.hpp"
#include "numeric/sampling/error_stats.hpp"
#include "tests/codegen/support.hpp"

namespace sh::codegen {
namespace {

using numeric::GlslLanguage;
using test::quoted;
using test::run_command;

// A pixel shader that calls the function once, so that the compiler drops no part of it.
std::string pixel_shader(const Kernel& kernel) {
  std::string body;
  std::string arguments;
  std::string value;
  for (const numeric::Parameter& p : printed_signature(kernel).parameters) {
    const std::string name = "p_" + p.name;
    body += "float " + name + (p.count == 0 ? "" : "[" + std::to_string(p.count) + "]") + "; ";
    arguments += (arguments.empty() ? "" : ", ") + name;
    value = name + "[0]";
  }
  const std::string call = kernel.name + "(" + arguments + ")";
  return "float4 main() : SV_Target { " + body +
         (kernel.returns_scalar() ? "return " + call : call + "; return " + value) + "; }\n";
}

// The translation of the HLSL text to a GLSL function, without the surrounding text.
std::string translated(const Kernel& kernel, const std::string& hlsl, GlslLanguage language) {
  const test::TemporaryFolder folder;
  test::write_file(folder.path() / "kernel.hlsl", hlsl + pixel_shader(kernel));
  const std::string version = language == GlslLanguage::kCore450 ? "450" : "300 --es";
  const auto result = run_command("cd " + quoted(folder.path()) +
                                  " && glslangValidator -D -V -Od -S frag -e main kernel.hlsl -o kernel.spv >log"
                                  " && spirv-cross --version " +
                                  version + " kernel.spv || { cat log; false; }");
  if (result.exit_code != 0) throw std::runtime_error(result.out + result.err);
  const std::string before = "_entryPointOutput;\n";  // declared last before the functions
  const std::size_t first = result.out.find(before) + before.size();
  const std::size_t end = result.out.rfind("\n}\n", result.out.find("_main()")) + 3;
  return "precision highp float;\n" + result.out.substr(first, end - first);
}

const numeric::BoundKernel& bound_kernel(const std::string& name) {
  static const std::vector<numeric::BoundKernel> kAll = numeric::bound_kernels();
  const auto found = std::find_if(kAll.begin(), kAll.end(), [&](const auto& kernel) { return kernel.name() == name; });
  if (found == kAll.end()) throw std::invalid_argument(name + ": not in generated/cpp");
  return *found;
}

// The expected outputs of a kernel at every input of its family's check.
struct Truth {
  explicit Truth(const Kernel& kernel) {
    const numeric::FamilyCheck* const check = numeric::find_check(kernel.family);
    if (check == nullptr) throw std::invalid_argument(kernel.family + ": no check describes the family");
    samples = numeric::make_samples<float>(*check, kernel.degree);
    own = numeric::own_formula(bound_kernel(kernel.name), samples);
  }
  numeric::Samples<float> samples;
  std::vector<numeric::Wide> own;  // the kernel's formula without rounding
};

void expect_within_limits(const Kernel& kernel, const std::vector<float>& values, const Truth& truth) {
  const auto& samples = truth.samples;
  ASSERT_EQ(values.size(), samples.exact.size()) << kernel.name;
  constexpr double kEpsilon = std::numeric_limits<float>::epsilon();
  constexpr double kSmallestSize = double{std::numeric_limits<float>::min()} / kEpsilon;  // below it, GLSL may flush
  numeric::ErrorStats rounding(kEpsilon);
  numeric::ErrorStats total(kEpsilon);
  const std::size_t outputs = values.size() / samples.count();
  for (std::size_t i = 0; i < values.size(); ++i) {
    const numeric::Place place{i / outputs, i % outputs};
    const numeric::Wide value(static_cast<double>(values[i]));
    const double size = samples.sizes[i] == 0 ? 0 : std::max(samples.sizes[i], kSmallestSize);
    rounding.add(place, (value - truth.own[i]).high(), size);
    total.add(place, (value - samples.exact[i]).high(), size);
  }
  const auto limits = numeric::limits_for(kernel.family, kernel.degree, "float");
  ASSERT_TRUE(limits) << kernel.name;
  EXPECT_LE(rounding.scaled().max(), limits->rounding)
      << kernel.name << " at " << samples.names[rounding.scaled().worst().input];
  EXPECT_LE(total.scaled().max(), limits->total)
      << kernel.name << " at " << samples.names[total.scaled().worst().input];
}

class HlslKernel : public testing::TestWithParam<std::string> {};

TEST_P(HlslKernel, KeepsTheLimitsOfItsFamilyWhenTranslatedAndRun) {
  const Family& family = find_family(GetParam());
  const std::vector<int> degrees = test::some_degrees(family);
  for (const int degree : std::set<int>{degrees.front(), degrees[degrees.size() / 2]}) {
    const FinishedKernel finished = preferred_kernel(family, degree, Prefer::kSpeed);
    const Kernel& kernel = finished.kernel;
    const std::string hlsl = find_language("hlsl").print_kernel(finished, print::Scalar::kFloat);
    const Truth truth(kernel);
    for (const GlslLanguage language : {GlslLanguage::kCore450, GlslLanguage::kEs300}) {
      numeric::GlslRunner runner(language);
      expect_within_limits(kernel,
                           runner.run(kernel.name + ".hlsl", translated(kernel, hlsl, language),
                                      {kernel.name, printed_signature(kernel)}, truth.samples.inputs),
                           truth);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Families, HlslKernel, testing::ValuesIn([] {
                           std::vector<std::string> names;
                           for (const Family& family : families()) names.push_back(family.name);
                           return names;
                         }()),
                         [](const auto& family) { return family.param; });

}  // namespace
}  // namespace sh::codegen
