#include "codegen/print/batch_driver.hpp"

#include <algorithm>

namespace sh::codegen::print {
namespace {

const std::vector<DriverSpec>& specs() {
  static const std::vector<DriverSpec> kSpecs{
      {"basis", "Values of the real spherical harmonics", "", "", "", ""},
      {"basis_gradient", "Values and Cartesian gradient of the solid harmonics: values, d/dx, d/dy, d/dz", "", "", "",
       ""},
      {"evaluate", "Functions given by coefficients, at directions", "evaluate_prepare", "evaluate_prepared", "", "",
       true},
      {"evaluate_rgb", "Colours given by coefficients, channel by channel, at directions", "", "", "", "", true},
      {"project", "Adds weight * Y of every direction to the sum", "", "", "project_moments", "project_finish"},
      {"rotate", "Coefficients of rotated functions, by rotation matrices", "", "", "", ""},
      {"product", "Products of two functions, projected on the same bands", "", "", "", "", false, 6}};
  return kSpecs;
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
    record.arguments.push_back(p.shape.empty() ? from + "[" + std::to_string(record.size) + "]" : from);
    record.size += p.size();
  }
  s.out_size = total_size(kernel.results);
  s.returns = kernel.returns_scalar();
  s.out = s.sums ? kernel.results.front().name : "out";
  return s;
}

std::string call_of(const Kernel& kernel) {
  const RecordSignature s = signature_of(kernel);
  std::string call = "sh::" + kernel.family + "<Degree>(";
  for (const Record& record : s.inputs) {
    for (const std::string& a : record.arguments) call += (call.back() == '(' ? "" : ", ") + a;
  }
  if (s.returns) return "out[0] = " + call + ");";
  for (std::size_t i = 0; i < kernel.results.size(); ++i) {
    call += i == 0 ? ", out" : ", out + " + (i == 1 ? std::string() : std::to_string(i) + " * ") + "kCount";
  }
  const std::string count =
      kernel.results.size() > 1 ? "constexpr int kCount = (Degree + 1) * (Degree + 1);\n    " : "";
  return count + call + ");";
}

std::vector<Driver> drivers_of(const WrittenFamilies& families) {
  const auto find = [&](const std::string& name) {
    const auto found = families.find(name);
    return found == families.end() ? nullptr : &found->second;
  };
  std::vector<Driver> drivers;
  for (const DriverSpec& spec : specs()) {
    if (const auto* kernels = find(spec.name)) {
      const auto served = std::count_if(kernels->begin(), kernels->end(), [&](const FinishedKernel& finished) {
        return finished.kernel.degree <= spec.largest;
      });
      const std::span<const FinishedKernel> used = std::span(*kernels).first(static_cast<std::size_t>(served));
      const int further = used.size() < kernels->size() ? kernels->back().kernel.degree : 0;
      drivers.push_back(
          {spec, used, further, find(spec.prepare), find(spec.prepared), find(spec.parts), find(spec.finish)});
    }
  }
  return drivers;
}

}  // namespace sh::codegen::print
