// See cpp_kernels.hpp. The kernels meet the scalar types here and nowhere else in shcheck.
#include "numeric/cpp_kernels.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <limits>
#include <utility>
#include <vector>

#include "generated/cpp/basis.hpp"
#include "numeric/basis.hpp"
#include "numeric/directions.hpp"

namespace sh::numeric {
namespace {

template <class T, int... Degree>
constexpr std::array<BasisKernel<T>, sizeof...(Degree)> kernel_table(
    std::integer_sequence<int, Degree...> /*degrees*/) {
  return {[](T x, T y, T z, T* out) { sh::basis<Degree>(x, y, z, out); }...};
}

}  // namespace

std::string basis_kernel_name(int degree) { return "basis_l" + std::to_string(degree); }

template <class T>
BasisKernel<T> basis_kernel(int degree) {
  static constexpr auto kTable = kernel_table<T>(std::make_integer_sequence<int, kMaxKernelDegree + 1>());
  return kTable.at(static_cast<std::size_t>(degree));
}

Operations count_operations(int degree) {
  std::vector<Counted> out(static_cast<std::size_t>(coefficient_count(degree)));
  const auto before = Counted::counts();
  basis_kernel<Counted>(degree)(Counted(0.6F), Counted(0.48F), Counted(0.64F), out.data());
  return Counted::counts() - before;
}

template <class T>
double nanoseconds_per_call(int degree) {
  constexpr int kCalls = 1024;
  constexpr int kPasses = 25;
  std::vector<std::array<T, 3>> inputs;
  for (const auto& d : random_directions(kCalls, 1)) {
    inputs.push_back({static_cast<T>(d.x), static_cast<T>(d.y), static_cast<T>(d.z)});
  }
  const auto stride = static_cast<std::size_t>(coefficient_count(degree));
  std::vector<T> out(stride);
  const auto kernel = basis_kernel<T>(degree);
  double least = std::numeric_limits<double>::infinity();
  volatile T kept = 0;
  for (int pass = 0; pass < kPasses; ++pass) {
    const auto start = std::chrono::steady_clock::now();
    for (const auto& [x, y, z] : inputs) kernel(x, y, z, out.data());
    const std::chrono::duration<double, std::nano> elapsed = std::chrono::steady_clock::now() - start;
    kept = out[stride - 1];
    least = std::min(least, elapsed.count() / kCalls);
  }
  static_cast<void>(kept);
  return least;
}

template BasisKernel<float> basis_kernel<float>(int);
template BasisKernel<double> basis_kernel<double>(int);
template double nanoseconds_per_call<float>(int);
template double nanoseconds_per_call<double>(int);

}  // namespace sh::numeric
