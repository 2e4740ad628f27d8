// The cost of a kernel: operations, counted exactly, and run time on the machine at hand.
#pragma once

#include <algorithm>
#include <chrono>
#include <limits>
#include <vector>

#include "numeric/kernels/bind.hpp"
#include "numeric/kernels/flat_call.hpp"
#include "numeric/kernels/samples.hpp"

namespace sh::numeric {

/// Operations of one call, counted by running it on Wide.
inline Operations count_operations(const BoundKernel& kernel, const Signature& signature) {
  const std::vector<Wide> in(signature.input_count(), Wide(0.5));
  std::vector<Wide> out(signature.output_count());
  const auto before = Wide::counts();
  FlatCall<Wide>(kernel, signature)(in.data(), out.data());
  return Wide::counts() - before;
}

/// Nanoseconds of one of the calls (each callable without arguments, at least one): the least mean over all of them of
/// the passes that the budget allows, at least three. A pass lasts some microseconds.
template <class Call>
double least_nanoseconds(std::vector<Call>& calls, std::chrono::nanoseconds budget) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::nanoseconds kPass = std::chrono::microseconds(5);
  constexpr int kPasses = 3;
  const auto pass = [&](long repeats) {
    const auto start = Clock::now();
    for (long repeat = 0; repeat < repeats; ++repeat) {
      for (auto& call : calls) call();
    }
    return std::chrono::duration<double, std::nano>(Clock::now() - start).count();
  };
  const long repeats = 1 + static_cast<long>(static_cast<double>(kPass.count()) / std::max(1.0, pass(1)));
  double least = std::numeric_limits<double>::infinity();
  const auto end = Clock::now() + budget;
  for (int i = 0; i < kPasses || Clock::now() < end; ++i) least = std::min(least, pass(repeats));
  return least / static_cast<double>(repeats) / static_cast<double>(calls.size());
}

/// A kernel's call on inputs loaded before, for least_nanoseconds.
template <class T>
struct CallAgain {
  FlatCall<T> call;
  void operator()() { call.call_again(); }
};

/// The kernel on some of the inputs: `count` of the last ones, which are the random ones.
template <class T>
std::vector<CallAgain<T>> calls_again(const BoundKernel& kernel, const Samples<T>& samples, std::size_t count) {
  std::vector<CallAgain<T>> calls;
  std::vector<T> out(samples.signature.output_count());
  for (std::size_t i = samples.count() - std::min(count, samples.count()); i < samples.count(); ++i) {
    calls.push_back({FlatCall<T>(kernel, samples.signature)});
    calls.back().call(samples.input(i), out.data());
  }
  return calls;
}

/// Nanoseconds a call: the least mean over some inputs of several passes. Informative: it depends on the machine and
/// its load.
template <class T>
double nanoseconds_per_call(const BoundKernel& kernel, const Samples<T>& samples) {
  auto calls = calls_again(kernel, samples, 16);
  return least_nanoseconds(calls, std::chrono::milliseconds(2));
}

}  // namespace sh::numeric
