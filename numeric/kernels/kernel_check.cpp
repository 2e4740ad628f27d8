// See kernel_check.hpp.
#include "numeric/kernels/kernel_check.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <stdexcept>
#include <utility>

#include "numeric/glsl/glsl_runner.hpp"
#include "numeric/kernels/family_record.hpp"
#include "numeric/kernels/flat_call.hpp"
#include "numeric/kernels/timing.hpp"
#include "numeric/oracle/basis.hpp"
#include "numeric/output/formatted.hpp"
#include "numeric/output/read_file.hpp"

namespace sh::numeric {
namespace {

constexpr const char* kCpp = "c++";

// The exact values of one family and degree, shared by its variants.
struct Truth {
  Samples<float> in_float;
  Samples<double> in_double;
};

Truth make_truth(const FamilyCheck& check, int degree) {
  return {make_samples<float>(check, degree), make_samples<double>(check, degree)};
}

template <class T>
KernelResult measure(const BoundKernel& kernel, const std::string& unit, const std::string& language,
                     const std::vector<T>& values, const std::vector<Wide>& own, const Samples<T>& samples) {
  // In GLSL a value below the smallest normal number may be lost as a whole.
  const auto smallest_normal = static_cast<double>(std::numeric_limits<T>::min());
  const double smallest_size =
      language == kCpp ? smallest_normal : smallest_normal / static_cast<double>(std::numeric_limits<T>::epsilon());
  KernelResult result{.kernel = kernel.name(),
                      .family = kernel.family,
                      .language = language,
                      .scalar = sizeof(T) == sizeof(float) ? "float" : "double",
                      .degree = kernel.degree,
                      .unit = unit,
                      .inputs = samples.count(),
                      .operations = count_operations(kernel, samples.signature),
                      .rounding = errors_of(samples, values, own, smallest_size),
                      .total = errors_of(samples, values, samples.exact, smallest_size)};
  result.worst_rounding = worst_case(result.rounding.scaled().worst(), kernel.degree, samples);
  result.worst_total = worst_case(result.total.scaled().worst(), kernel.degree, samples);
  return result;
}

template <class T>
std::vector<T> run_cpp(const BoundKernel& kernel, const Samples<T>& samples) {
  const auto outputs = static_cast<std::size_t>(samples.signature.output_count());
  std::vector<T> values(samples.count() * outputs);
  FlatCall<T> call(kernel, samples.signature);
  for (std::size_t i = 0; i < samples.count(); ++i) call(samples.input(i), values.data() + i * outputs);
  return values;
}

template <class T>
bool same_bits(T a, T b) {
  using Bits = std::conditional_t<sizeof(T) == sizeof(float), std::uint32_t, std::uint64_t>;
  return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
}

// How many outputs change when an array of the inputs is the array of the outputs.
template <class T>
std::size_t count_different_in_place(const BoundKernel& kernel, const Samples<T>& samples,
                                     const std::vector<T>& values) {
  constexpr std::size_t kTried = 16;
  const auto outputs = static_cast<std::size_t>(samples.signature.output_count());
  std::size_t different = 0;
  FlatCall<T> call(kernel, samples.signature);
  std::vector<T> out(outputs);
  for (const auto& pair : in_place_pairs(samples.signature)) {
    const std::size_t step = std::max<std::size_t>(1, samples.count() / kTried);
    for (std::size_t i = 0; i < samples.count(); i += step) {
      call.in_place(pair, samples.input(i), out.data());
      for (std::size_t k = 0; k < outputs; ++k) different += same_bits(out[k], values[i * outputs + k]) ? 0 : 1;
    }
  }
  return different;
}

template <class T>
KernelResult check_cpp(const BoundKernel& kernel, const std::string& unit, const std::vector<T>& values,
                       const std::vector<Wide>& own, const Samples<T>& samples) {
  auto result = measure(kernel, unit, kCpp, values, own, samples);
  result.different_in_place = count_different_in_place(kernel, samples, values);
  result.nanoseconds = nanoseconds_per_call(kernel, samples);
  return result;
}

// The contexts of the two GLSL languages, and the folder that the kernels come from.
class GlslCheck {
 public:
  explicit GlslCheck(const std::filesystem::path& generated)
      : folder_(generated / "glsl"), core_(GlslLanguage::kCore450), es_(GlslLanguage::kEs300) {}

  std::vector<KernelResult> check(const BoundKernel& kernel, const std::string& unit, const std::vector<float>& cpp,
                                  const std::vector<Wide>& own, const Samples<float>& samples) {
    const auto file = folder_ / (kernel.name() + ".glsl");
    const std::string source = output::read_file(file.string());
    std::vector<KernelResult> results;
    for (const auto& [language, runner] : {std::pair{GlslLanguage::kCore450, &core_}, {GlslLanguage::kEs300, &es_}}) {
      const auto run = [&, runner = runner](Grouping grouping) {
        return runner->run(file.string(), source, {kernel.name(), samples.signature}, samples.inputs, grouping);
      };
      const auto values = run(Grouping::kFree);
      results.push_back(measure(kernel, unit, to_string(language), values, own, samples));
      auto bits = compare_bits(kernel.degree, cpp, values, samples);
      if (const std::size_t differ_when_free = bits.different; differ_when_free > 0) {
        bits = compare_bits(kernel.degree, cpp, run(Grouping::kInvariant), samples);
        bits.regrouped = differ_when_free;
      }
      results.back().bits = bits;
    }
    return results;
  }

  [[nodiscard]] std::string renderer() const { return core_.renderer(); }

 private:
  std::filesystem::path folder_;
  GlslRunner core_;
  GlslRunner es_;
};

void append_results(std::vector<KernelResult>& all, const BoundKernel& kernel, const std::string& unit,
                    const Truth& truth, GlslCheck* glsl) {
  const auto float_values = run_cpp(kernel, truth.in_float);
  const auto float_own = own_formula(kernel, truth.in_float);
  const auto double_own = own_formula(kernel, truth.in_double);
  all.push_back(check_cpp(kernel, unit, float_values, float_own, truth.in_float));
  all.push_back(check_cpp(kernel, unit, run_cpp(kernel, truth.in_double), double_own, truth.in_double));
  if (glsl == nullptr) return;
  for (auto& result : glsl->check(kernel, unit, float_values, float_own, truth.in_float))
    all.push_back(std::move(result));
}

// The kernels of one check by degree, so that variants share their exact values.
std::map<int, std::vector<BoundKernel>> kernels_of(const FamilyCheck& check) {
  std::map<int, std::vector<BoundKernel>> result;
  for (auto& kernel : bound_kernels()) {
    if (without_variant(kernel.family) == check.family) result[kernel.degree].push_back(std::move(kernel));
  }
  return result;
}

void require_family(const std::string& family) {
  std::string names;
  for (const auto& check : all_checks()) {
    if (family.empty() || check.family == family) return;
    names += (names.empty() ? "" : ", ") + check.family;
  }
  throw std::invalid_argument("--family: expected one of " + names + ", got '" + family + "'");
}

}  // namespace

BitComparison compare_bits(int degree, const std::vector<float>& cpp, const std::vector<float>& glsl,
                           const Samples<float>& samples) {
  BitComparison bits;
  const auto outputs = static_cast<std::size_t>(samples.signature.output_count());
  bits.compared = cpp.size();
  for (std::size_t i = 0; i < cpp.size(); ++i) {
    if (same_bits(cpp[i], glsl[i])) continue;
    // An intermediate value may have been flushed and multiplied since, by constants and by large inputs.
    constexpr double kFlushed = 256 * static_cast<double>(std::numeric_limits<float>::min());
    if (std::abs(static_cast<double>(glsl[i]) - static_cast<double>(cpp[i])) <
        kFlushed * std::max(1.0, samples.sizes[i])) {
      ++bits.flushed;
    } else if (bits.different++ == 0) {
      bits.first_difference =
          output_label(samples.signature, degree, i % outputs) + " at " + samples.names[i / outputs] +
          output::formatted(": %.9g, c++ %.9g", static_cast<double>(glsl[i]), static_cast<double>(cpp[i]));
    }
  }
  return bits;
}

std::vector<std::string> unchecked_kernels(const std::vector<BoundKernel>& kernels) {
  std::vector<std::string> names;
  for (const auto& kernel : kernels) {
    if (find_check(kernel.family) == nullptr) names.push_back(kernel.name());
  }
  return names;
}

std::vector<KernelResult> check_kernels(const CheckOptions& options,
                                        const std::function<void(const std::string&)>& progress) {
  require_family(options.family);
  GlslCheck glsl(options.generated);
  progress("GLSL: " + glsl.renderer());
  std::vector<KernelResult> results;
  for (const auto& check : all_checks()) {
    if (!options.family.empty() && options.family != check.family) continue;
    progress("checking " + check.family);
    for (const auto& [degree, kernels] : kernels_of(check)) {
      const Truth truth = make_truth(check, degree);
      for (const auto& kernel : kernels) append_results(results, kernel, check.unit, truth, &glsl);
    }
  }
  std::stable_sort(results.begin(), results.end(),
                   [](const KernelResult& a, const KernelResult& b) { return a.family < b.family; });
  return results;
}

std::vector<KernelResult> check_kernel(const BoundKernel& kernel, const std::filesystem::path& generated) {
  const FamilyCheck& check = check_of(kernel.family);
  const auto glsl = generated.empty() ? nullptr : std::make_unique<GlslCheck>(generated);
  std::vector<KernelResult> results;
  append_results(results, kernel, check.unit, make_truth(check, kernel.degree), glsl.get());
  return results;
}

template <class T>
KernelResult kernel_errors(const BoundKernel& kernel, const FamilyCheck& check) {
  const auto samples = make_samples<T>(check, kernel.degree);
  return measure(kernel, check.unit, kCpp, run_cpp(kernel, samples), own_formula(kernel, samples), samples);
}

template KernelResult kernel_errors<float>(const BoundKernel&, const FamilyCheck&);
template KernelResult kernel_errors<double>(const BoundKernel&, const FamilyCheck&);

}  // namespace sh::numeric
