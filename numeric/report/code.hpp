// Codes of methods: from a bound kernel, from two in a row, from a function on flat values, from a batch.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <vector>

#include "numeric/kernels/timing.hpp"
#include "numeric/report/method.hpp"

namespace sh::numeric {

// How many inputs a timed pass goes through: few where one call takes long.
inline std::size_t timed_inputs(int degree) { return degree > 10 ? 2 : 16; }

// One kernel.
template <class T>
Code<T> code_of(const BoundKernel& kernel) {
  return {[kernel](const Samples<T>& samples, T* out) {
            FlatCall<T> call(kernel, samples.signature);
            const auto outputs = static_cast<std::size_t>(samples.signature.output_count());
            for (std::size_t i = 0; i < samples.count(); ++i) call(samples.input(i), out + i * outputs);
          },
          [kernel](const Samples<T>& samples, std::chrono::nanoseconds budget) {
            auto calls = calls_again(kernel, samples, timed_inputs(kernel.degree));
            return least_nanoseconds(calls, budget);
          }};
}

// function(in, out), flat.
template <class T>
using FlatFunction = std::function<void(const T*, T*)>;

template <class T>
std::function<void(const Samples<T>&, T*)> runner_of(FlatFunction<T> function) {
  return [function](const Samples<T>& samples, T* out) {
    const auto outputs = static_cast<std::size_t>(samples.signature.output_count());
    for (std::size_t i = 0; i < samples.count(); ++i) function(samples.input(i), out + i * outputs);
  };
}

template <class T>
Code<T> code_of(FlatFunction<T> function, int degree) {
  return {runner_of(function), [function, degree](const Samples<T>& samples, std::chrono::nanoseconds budget) {
            std::vector<T> out(samples.signature.output_count());
            std::vector<std::function<void()>> calls;
            const std::size_t count = std::min(timed_inputs(degree), samples.count());
            for (std::size_t i = samples.count() - count; i < samples.count(); ++i) {
              calls.emplace_back([&, i] { function(samples.input(i), out.data()); });
            }
            return least_nanoseconds(calls, budget);
          }};
}

// `first` makes something of the first inputs, `second` takes that and the rest: rotate_build and rotate_apply. The
// time is that of both, or (prepared) of the second alone.
struct Pair {
  BoundKernel first;
  Signature first_signature;
  BoundKernel second;
  Signature second_signature;
};

template <class T>
Code<T> code_of(const Pair& pair, Mode mode) {
  const auto taken = static_cast<std::size_t>(pair.first_signature.input_count());
  const auto made = static_cast<std::size_t>(pair.first_signature.output_count());
  // The inputs of the second.
  const auto between = [pair, taken, made](const Samples<T>& samples, std::size_t i) {
    std::vector<T> in(pair.second_signature.input_count());
    FlatCall<T>(pair.first, pair.first_signature)(samples.input(i), in.data());
    std::copy(samples.input(i) + taken, samples.input(i) + samples.signature.input_count(),
              in.begin() + static_cast<std::ptrdiff_t>(made));
    return in;
  };
  return {[pair, between](const Samples<T>& samples, T* out) {
            FlatCall<T> second(pair.second, pair.second_signature);
            const auto outputs = static_cast<std::size_t>(samples.signature.output_count());
            for (std::size_t i = 0; i < samples.count(); ++i) second(between(samples, i).data(), out + i * outputs);
          },
          [pair, between, mode](const Samples<T>& samples, std::chrono::nanoseconds budget) {
            struct Both {
              FlatCall<T> first, second;
              bool with_first;
              void operator()() {
                if (with_first) first.call_again();
                second.call_again();
              }
            };
            std::vector<Both> calls;
            std::vector<T> unused(std::max(pair.first_signature.output_count(), pair.second_signature.output_count()));
            const std::size_t count = std::min(timed_inputs(pair.first.degree), samples.count());
            for (std::size_t i = samples.count() - count; i < samples.count(); ++i) {
              calls.push_back(
                  {{pair.first, pair.first_signature}, {pair.second, pair.second_signature}, mode == Mode::kOne});
              calls.back().first(samples.input(i), unused.data());
              calls.back().second(between(samples, i).data(), unused.data());
            }
            return least_nanoseconds(calls, budget);
          }};
}

}  // namespace sh::numeric
