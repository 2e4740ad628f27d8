// See timing.hpp.
#include "numeric/timing.hpp"

#include <algorithm>
#include <chrono>
#include <limits>
#include <vector>

#include "numeric/flat_call.hpp"

namespace sh::numeric {

Operations count_operations(const BoundKernel& kernel, const Signature& signature) {
  const std::vector<Wide> in(static_cast<std::size_t>(signature.input_count()), Wide(0.5));
  std::vector<Wide> out(static_cast<std::size_t>(signature.output_count()));
  const auto before = Wide::counts();
  FlatCall<Wide>(kernel, signature)(in.data(), out.data());
  return Wide::counts() - before;
}

template <class T>
double nanoseconds_per_call(const BoundKernel& kernel, const Samples<T>& samples) {
  using Clock = std::chrono::steady_clock;
  constexpr std::size_t kInputs = 16;
  constexpr int kRepeats = 16;
  constexpr auto kBudget = std::chrono::milliseconds(2);
  constexpr int kPasses = 3;  // at least
  std::vector<FlatCall<T>> calls;
  std::vector<T> out(static_cast<std::size_t>(samples.signature.output_count()));
  // The last inputs are the random ones.
  for (std::size_t i = samples.count() - std::min(kInputs, samples.count()); i < samples.count(); ++i) {
    calls.emplace_back(kernel, samples.signature)(samples.input(i), out.data());
  }
  double least = std::numeric_limits<double>::infinity();
  const auto end = Clock::now() + kBudget;
  for (int pass = 0; pass < kPasses || Clock::now() < end; ++pass) {
    const auto start = Clock::now();
    for (int repeat = 0; repeat < kRepeats; ++repeat) {
      for (auto& call : calls) call.call_again();
    }
    const std::chrono::duration<double, std::nano> elapsed = Clock::now() - start;
    least = std::min(least, elapsed.count() / static_cast<double>(calls.size() * kRepeats));
  }
  return least;
}

template double nanoseconds_per_call<float>(const BoundKernel&, const Samples<float>&);
template double nanoseconds_per_call<double>(const BoundKernel&, const Samples<double>&);

}  // namespace sh::numeric
