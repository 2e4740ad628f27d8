#include "codegen/measure/size.hpp"

#include "numeric/kernels/size_formula.hpp"

namespace sh::codegen {
namespace {

numeric::Parameter described(const Parameter& array, numeric::Access access) {
  return {.name = array.name,
          .count = array.shape.empty() ? 0 : array.size(),
          .access = access,
          .role = role_name(array.role),
          .degree = array.degree,
          .channels = array.channels()};
}

}  // namespace

numeric::Signature signature_of(const Kernel& kernel) {
  using numeric::Access;
  numeric::Signature signature;
  signature.returns_value = kernel.returns_scalar();
  for (const Parameter& parameter : kernel.parameters) {
    const bool updated = position_of(kernel.results, parameter.name) >= 0;
    signature.parameters.push_back(described(parameter, updated ? Access::kInOut : Access::kIn));
  }
  if (signature.returns_value) return signature;
  for (const Parameter& result : kernel.results) {
    if (position_of(kernel.parameters, result.name) < 0)
      signature.parameters.push_back(described(result, Access::kOut));
  }
  return signature;
}

Size size_of(const Kernel& kernel, const Domain& domain) {
  if (domain.size) return domain.size;
  std::function<double(std::size_t)> gain;
  if (domain.gain) gain = [of = domain.gain, degree = kernel.degree](std::size_t i) { return of(degree, i); };
  return [formula = numeric::SizeFormula(domain.sizes, signature_of(kernel), kernel.degree, gain)](
             std::span<const double> inputs, std::size_t element) { return formula(inputs.data(), element); };
}

}  // namespace sh::codegen
