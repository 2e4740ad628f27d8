// See kernel_check.hpp.
#include "numeric/kernel_check.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "numeric/basis.hpp"
#include "numeric/cpp_kernels.hpp"
#include "numeric/glsl_runner.hpp"
#include "numeric/oracle_table.hpp"

namespace sh::numeric {
namespace {

using Progress = std::function<void(const std::string&)>;

constexpr int kRandomDirections = 4096;

// The kernel at every input of the table: (n, bands^2).
template <class T>
std::vector<T> run_cpp(int degree, const OracleTable<T>& table) {
  const auto count = static_cast<std::size_t>(coefficient_count(degree));
  std::vector<T> values(table.inputs.size() * count);
  T* out = values.data();
  for (const auto& [x, y, z] : table.inputs) {
    basis_kernel<T>(degree)(x, y, z, out);
    out += count;
  }
  return values;
}

template <class T>
KernelResult measure(int degree, const std::string& language, const std::vector<T>& values,
                     const OracleTable<T>& table) {
  const ErrorStats none(static_cast<double>(std::numeric_limits<T>::epsilon()));
  KernelResult result{basis_kernel_name(degree),
                      language,
                      sizeof(T) == sizeof(float) ? "float" : "double",
                      degree,
                      {},
                      none,
                      none,
                      {},
                      {}};
  result.operations = count_operations(degree);
  const auto count = static_cast<std::size_t>(coefficient_count(degree));
  const auto stride = static_cast<std::size_t>(coefficient_count(table.degree));
  for (std::size_t k = 0; k < table.inputs.size(); ++k) {
    const auto& [x, y, z] = table.inputs[k];
    const Direction input = {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
    for (int l = 0; l <= degree; ++l) {
      for (int m = -l; m <= l; ++m) {
        const auto i = static_cast<std::size_t>(coefficient_index(l, m));
        const auto value = static_cast<double>(values[k * count + i]);
        result.rounding.add(l, m, input, table.own_polynomial[k * stride + i].error_of(value));
        result.total.add(l, m, input, table.true_function[k * stride + i].error_of(value));
      }
    }
  }
  return result;
}

template <class T>
KernelResult check_cpp(int degree, const OracleTable<T>& table) {
  auto result = measure(degree, "c++", run_cpp(degree, table), table);
  result.nanoseconds = nanoseconds_per_call<T>(degree);
  return result;
}

std::string describe(std::size_t item, std::size_t index, float cpp, float glsl, const OracleTable<float>& table) {
  std::ostringstream text;
  const auto& [x, y, z] = table.inputs[item];
  text.precision(9);
  text << "value " << index << " at (" << x << ", " << y << ", " << z << "): " << glsl << ", c++ " << cpp;
  return text.str();
}

BitComparison compare_bits(int degree, const std::vector<float>& cpp, const std::vector<float>& glsl,
                           const OracleTable<float>& table) {
  BitComparison bits;
  const auto count = static_cast<std::size_t>(coefficient_count(degree));
  bits.compared = cpp.size();
  for (std::size_t i = 0; i < cpp.size(); ++i) {
    if (std::bit_cast<std::uint32_t>(cpp[i]) == std::bit_cast<std::uint32_t>(glsl[i])) continue;
    if (glsl[i] == 0 && std::abs(cpp[i]) < std::numeric_limits<float>::min()) {
      ++bits.flushed;
    } else if (bits.different++ == 0) {
      bits.first_difference = describe(i / count, i % count, cpp[i], glsl[i], table);
    }
  }
  return bits;
}

std::string read_text(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string text((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  if (!stream) throw std::runtime_error(file.string() + ": cannot be read; --generated names the folder generated/");
  return text;
}

KernelResult check_glsl(int degree, GlslRunner& runner, GlslLanguage language, const std::filesystem::path& generated,
                        const OracleTable<float>& table) {
  const auto file = generated / "glsl" / (basis_kernel_name(degree) + ".glsl");
  const GlslFunction function{basis_kernel_name(degree), {{}, {}, {}, {coefficient_count(degree), true}}};
  std::vector<float> inputs;
  for (const auto& input : table.inputs) inputs.insert(inputs.end(), input.begin(), input.end());
  const auto values = runner.run(file.string(), read_text(file), function, inputs);
  auto result = measure(degree, to_string(language), values, table);
  result.bits = compare_bits(degree, run_cpp(degree, table), values, table);
  return result;
}

}  // namespace

std::size_t checked_direction_count() { return standard_directions(kRandomDirections).size(); }

std::vector<KernelResult> check_kernels(const std::filesystem::path& generated, const Progress& progress) {
  const auto directions = standard_directions(kRandomDirections);
  progress("oracle: " + std::to_string(directions.size()) + " directions at 100 digits, as float and as double");
  const auto in_float = make_oracle_table<float>(kMaxKernelDegree, directions);
  const auto in_double = make_oracle_table<double>(kMaxKernelDegree, directions);
  GlslRunner core(GlslLanguage::kCore450);
  GlslRunner es(GlslLanguage::kEs300);
  progress("GLSL: " + core.renderer());
  std::vector<KernelResult> results;
  for (int degree = 0; degree <= kMaxKernelDegree; ++degree) {
    progress("checking " + basis_kernel_name(degree));
    results.push_back(check_cpp(degree, in_float));
    results.push_back(check_cpp(degree, in_double));
    results.push_back(check_glsl(degree, core, GlslLanguage::kCore450, generated, in_float));
    results.push_back(check_glsl(degree, es, GlslLanguage::kEs300, generated, in_float));
  }
  return results;
}

}  // namespace sh::numeric
