#include "codegen/print/batch_driver.hpp"

#include <algorithm>

#include "numeric/oracle/index.hpp"

namespace sh::codegen::print {
namespace {

std::string size_text(const Parameter& array, int kernel_degree) {
  if (array.role == Role::kSamples) {
    const std::string one = "8 degree^2 + 4";
    const bool channels = array.shape.size() == 2;
    return (channels ? std::to_string(array.shape.front()) + " (" + one + ")" : one) + ", at degree 0 one a channel";
  }
  if (array.role == Role::kZonalCoefficients) return "degree + 1";
  return holds_coefficients(array.role) && array.degree == 2 * kernel_degree ? "(2 degree + 1)^2" : "";
}

}  // namespace

RecordSignature signature_of(const Kernel& kernel) {
  RecordSignature s;
  for (const Parameter& p : kernel.parameters) {
    if (position_of(kernel.results, p.name) >= 0) {
      s.sums = true;
      continue;
    }
    const bool component = is_coordinate(p.role);
    if (!component || p.axis == 0) s.inputs.push_back({component ? "directions" : p.name, {}, 0});
    const std::string from = "in[" + std::to_string(s.inputs.size() - 1) + "]";
    Record& record = s.inputs.back();
    record.shared = is_shared(p.role);
    record.arguments.push_back(p.shape.empty() ? from + "[" + std::to_string(record.size) + "]"
                               : record.shared ? "blocks." + from
                                               : from);
    record.size += p.size();
    record.size_text = size_text(p, kernel.degree);
  }
  s.out_size = total_size(kernel.results);
  s.returns = kernel.returns_scalar();
  s.out = s.sums ? kernel.results.front().name : "out";
  return s;
}

bool are_coefficients(int size, const Kernel& kernel, int channels) {
  const int bands = kernel.degree + 1;
  return size == channels * bands * bands;
}

std::string call_of(const Kernel& kernel) {
  return call_of(kernel, kernel.family + "<Degree>", "(Degree + 1) * (Degree + 1)");
}

std::string call_of(const Kernel& kernel, const std::string& function, const std::string& count) {
  const RecordSignature s = signature_of(kernel);
  std::string call = "sh::" + function + "(";
  for (const Record& record : s.inputs) {
    for (const std::string& a : record.arguments) call += (call.back() == '(' ? "" : ", ") + a;
  }
  if (s.returns) return "out[0] = " + call + ");";
  for (std::size_t i = 0; i < kernel.results.size(); ++i) {
    call += i == 0 ? ", out" : ", out + " + (i == 1 ? std::string() : std::to_string(i) + " * ") + "kCount";
  }
  return (kernel.results.size() > 1 ? "constexpr int kCount = " + count + ";\n    " : "") + call + ");";
}

int last_without_sums(const Driver& driver) {
  int degree = -1;
  for (const FinishedKernel& finished : driver.kernels) {
    const Cost of_kernel = cost(finished.kernel);
    if (of_kernel.add + of_kernel.fma > 0) break;
    degree = finished.kernel.degree;
  }
  return degree;
}

std::string size_in_degree(int size, const Kernel& kernel) {
  const int count = numeric::coefficient_count(kernel.degree);
  if (size % count != 0) return std::to_string(size);
  return (size == count ? "" : std::to_string(size / count) + " * ") + "((Degree + 1) * (Degree + 1))";
}

std::vector<Driver> drivers_of(const std::vector<WrittenFamily>& families) {
  const auto find = [&](const std::string& name) -> const std::vector<FinishedKernel>* {
    const auto found =
        std::find_if(families.begin(), families.end(), [&](const WrittenFamily& f) { return f.name == name; });
    return found == families.end() ? nullptr : &found->kernels;
  };
  std::vector<Driver> drivers;
  for (const auto& [name, spec, kernels] : families) {
    if (!spec) continue;
    const int largest = spec->largest;
    const auto served = std::count_if(kernels.begin(), kernels.end(), [largest](const FinishedKernel& finished) {
      return finished.kernel.degree <= largest;
    });
    const std::span<const FinishedKernel> used = std::span(kernels).first(served);
    const int further = used.size() < kernels.size() ? kernels.back().kernel.degree : 0;
    drivers.push_back({.name = name,
                       .spec = *spec,
                       .kernels = used,
                       .further = further,
                       .prepare = find(spec->prepare),
                       .prepared = find(spec->prepared),
                       .parts = find(spec->parts),
                       .finish = find(spec->finish)});
  }
  return drivers;
}

}  // namespace sh::codegen::print
