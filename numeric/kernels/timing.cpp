// See timing.hpp.
#include "numeric/kernels/timing.hpp"

#include <vector>

#include "numeric/kernels/flat_call.hpp"

namespace sh::numeric {

Operations count_operations(const BoundKernel& kernel, const Signature& signature) {
  const std::vector<Wide> in(signature.input_count(), Wide(0.5));
  std::vector<Wide> out(signature.output_count());
  const auto before = Wide::counts();
  FlatCall<Wide>(kernel, signature)(in.data(), out.data());
  return Wide::counts() - before;
}

template <class T>
double nanoseconds_per_call(const BoundKernel& kernel, const Samples<T>& samples) {
  constexpr std::size_t kInputs = 16;
  constexpr auto kBudget = std::chrono::milliseconds(2);
  auto calls = calls_again(kernel, samples, kInputs);
  return least_nanoseconds(calls, kBudget);
}

template double nanoseconds_per_call<float>(const BoundKernel&, const Samples<float>&);
template double nanoseconds_per_call<double>(const BoundKernel&, const Samples<double>&);

}  // namespace sh::numeric
