// Arrays of records with guard zones, and the drivers of sh::batch with their kernels.
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "generated/batch/batch.hpp"
#include "tests/generated/kernel_support.hpp"

namespace sh::test {

using batch::InstructionSet;
using batch::Layout;
using batch::Records;

inline constexpr std::size_t kMostInputs = 3;

/// Runs f on every available instruction set, on AVX-512 as on processors of both kinds, then goes back to the one before.
template <class F>
void on_every_set(const F& f) {
  const InstructionSet before = batch::instruction_set();
  bool& loads_delay_stores = batch::detail::loads_delay_stores;
  for (const InstructionSet set : {InstructionSet::kBaseline, InstructionSet::kAvx2, InstructionSet::kAvx512}) {
    if (!batch::available(set)) continue;
    batch::use_instruction_set(set);
    f();
    if (set != InstructionSet::kAvx512) continue;
    loads_delay_stores = !loads_delay_stores;
    f();
    loads_delay_stores = !loads_delay_stores;
  }
  batch::use_instruction_set(before);
}

/// Calls f.operator()<Degree>() for a degree known at run time, 0 to Largest.
template <int Largest, class F>
void with_degree(int degree, const F& f) {
  [&]<int... kDegree>(std::integer_sequence<int, kDegree...>) {
    ((degree == kDegree ? f.template operator()<kDegree>() : void()), ...);
  }
  (std::make_integer_sequence<int, Largest + 1>());
}

/// How an array of records lies in memory; `offset` values past an address that is a multiple of 64.
struct Place {
  Layout layout = Layout::kPlain;
  std::size_t offset = 0;
};

/// Values that end where memory ends: to read or write past them is a fault.
template <class T>
class FencedArray {
 public:
  explicit FencedArray(std::size_t size) : size_(size) {
    const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    const std::size_t bytes = (size * sizeof(T) + page - 1) / page * page;
    mapped_ = bytes + page;
    memory_ = mmap(nullptr, mapped_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    char* const fence = static_cast<char*>(memory_) + bytes;
    if (memory_ == MAP_FAILED || mprotect(fence, page, PROT_NONE) != 0) throw std::runtime_error("no memory");
    values_ = reinterpret_cast<T*>(fence) - size;
  }
  FencedArray(const FencedArray&) = delete;
  FencedArray& operator=(const FencedArray&) = delete;
  ~FencedArray() { munmap(memory_, mapped_); }

  [[nodiscard]] T* data() const { return values_; }
  [[nodiscard]] T* begin() const { return values_; }
  [[nodiscard]] T* end() const { return values_ + size_; }

 private:
  std::size_t size_, mapped_;
  void* memory_;
  T* values_;
};

/// n records of `size` values between guard zones. All other values are not a number, so a driver that reads one of
/// them spoils its results.
template <class T>
class Array {
 public:
  Array(Place place, std::size_t n, std::size_t size)
      : layout_(place.layout), n_(place.layout == Layout::kShared ? 1 : n), size_(size) {
    const std::size_t values = layout_ == Layout::kBlocked ? batch::blocked_size<T>(n_, size) : n_ * size;
    memory_.assign(values + 3 * kGuard, std::numeric_limits<T>::quiet_NaN());
    void* start = memory_.data() + kGuard;
    std::size_t space = (values + 2 * kGuard) * sizeof(T);
    first_ = static_cast<T*>(std::align(64, values * sizeof(T), start, space)) + place.offset;
  }
  Array(Place place, const std::vector<std::vector<T>>& records, std::size_t size)
      : Array(place, records.size(), size) {
    for (std::size_t i = 0; i < n_; ++i) {
      for (std::size_t k = 0; k < size_; ++k) at(i, k) = records[i][k];
    }
  }

  T& at(std::size_t i, std::size_t k) { return first_[index(i, k)]; }
  [[nodiscard]] Records<T> records() const { return {first_, layout_}; }

  [[nodiscard]] std::vector<std::vector<T>> read() {
    std::vector<std::vector<T>> result(n_, std::vector<T>(size_));
    for (std::size_t i = 0; i < n_; ++i) {
      for (std::size_t k = 0; k < size_; ++k) result[i][k] = at(i, k);
    }
    return result;
  }

  /// True if all values that belong to no record are unchanged.
  [[nodiscard]] bool guarded() {
    std::vector<T> rest = memory_;
    for (std::size_t i = 0; i < n_; ++i) {
      for (std::size_t k = 0; k < size_; ++k) rest[&at(i, k) - memory_.data()] = T(0);
    }
    std::size_t numbers = 0;
    for (const T value : rest) numbers += value == T(0) ? 1 : 0;
    return numbers == n_ * size_;
  }

 private:
  static constexpr std::size_t kGuard = 64;
  [[nodiscard]] std::size_t index(std::size_t i, std::size_t k) const {
    constexpr std::size_t kBlock = batch::kBlock<T>;
    if (layout_ != Layout::kBlocked) return i * size_ + k;
    return i / kBlock * kBlock * size_ + k * kBlock + i % kBlock;
  }

  Layout layout_;
  std::size_t n_;
  std::size_t size_;
  std::vector<T> memory_;
  T* first_ = nullptr;
};

/// n rotation matrices, row by row: a turn about x, then one about z. Every fifth is one about z, which kernels tell apart.
template <class T>
std::vector<T> random_rotations(std::size_t n, std::mt19937& random) {
  std::uniform_real_distribution<double> angle(0, 6.28);
  std::vector<T> r;
  for (std::size_t i = 0; i < n; ++i) {
    const double a = angle(random);
    const double b = i % 5 == 3 ? 0 : angle(random);
    const double m[9] = {std::cos(a),
                         -std::sin(a) * std::cos(b),
                         std::sin(a) * std::sin(b),
                         std::sin(a),
                         std::cos(a) * std::cos(b),
                         -std::cos(a) * std::sin(b),
                         0,
                         std::sin(b),
                         std::cos(b)};
    for (const double value : m) r.push_back(static_cast<T>(value));
  }
  return r;
}

/// A driver at one degree, beside the kernel that it runs.
template <class T>
struct Subject {
  std::string name;
  int degree = 0;
  std::vector<int> in = {};  ///< sizes of the input records
  int out = 0;               ///< size of an output record
  /// A valid record of input j.
  std::function<std::vector<T>(std::size_t j, std::mt19937& random)> record;
  std::function<void(std::size_t n, const std::array<Records<const T>, kMostInputs>& in, Records<T> out)> run;
  std::function<void(const std::array<const T*, kMostInputs>& in, T* out)> kernel;
  double tolerance = 0;         ///< largest difference between the two, machine epsilons
  double tolerance_shared = 0;  ///< the same where an input is shared and something is computed from it once
};

/// Every driver at some degrees.
template <class T>
std::vector<Subject<T>> subjects();

extern template std::vector<Subject<float>> subjects<float>();
extern template std::vector<Subject<double>> subjects<double>();

}  // namespace sh::test
