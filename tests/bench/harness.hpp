// Timing and the table of targets.
//
// Times drift between machines and runs, so a figure is always a ratio of two times taken by turns in one run: the
// least of many short passes of each. A line passes when its ratio is at most its target.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace sh::bench {

/// Seconds of one call of each task, by turns, the least of the passes. A pass repeats short tasks.
std::vector<double> least_times(const std::vector<std::function<void()>>& tasks, int passes = 25);

/// The table that is printed while it is measured.
class Table {
 public:
  void section(const std::string& title, const std::string& note = {});
  /// A ratio of two times (or sizes): ours, the control's or the limit's, in `unit`; passes when ours / other <=
  /// target.
  void ratio(const std::string& what, const std::string& unit, double ours, double other, const std::string& other_name,
             double target);
  /// A figure that has to be at most its target.
  void figure(const std::string& what, const std::string& unit, double value, double target);
  /// A figure without a target.
  void remark(const std::string& text);
  /// Prints how many lines passed; true when all did.
  bool summary() const;

 private:
  void verdict(const std::string& what, const std::string& figures, double value, double target);
  int passed_ = 0;
  std::vector<std::string> missed_;
};

/// "1.2e-07"
std::string scientific(double value);

struct Free {
  void operator()(void* memory) const { std::free(memory); }
};
template <class T>
using Buffer = std::unique_ptr<T[], Free>;

/// `count` values, aligned to 64 bytes, set to `value`.
template <class T>
Buffer<T> make_buffer(std::size_t count, T value = T{}) {
  const std::size_t bytes = (count * sizeof(T) + 127) / 64 * 64;
  Buffer<T> buffer(static_cast<T*>(std::aligned_alloc(64, bytes)));
  for (std::size_t i = 0; i < count; ++i) buffer[i] = value;
  return buffer;
}

/// Keeps a value computed, and memory written, without using it.
template <class T>
inline void keep(const T& value) {
  asm volatile("" : : "g"(&value) : "memory");
}

/// n unit directions, plain: x y z of one after the other.
std::vector<float> random_directions(std::size_t n);
/// Coefficients of unit length each, plain.
std::vector<float> random_vectors(std::size_t n, std::size_t size);
/// n rotation matrices, plain, 9 values each.
std::vector<float> random_rotations(std::size_t n);
/// Plain records in blocks of 16, see generated/batch/batch.hpp; lanes past n are 0.
Buffer<float> to_blocks(const std::vector<float>& plain, std::size_t size);

/// Operations of a kernel that is written, from generated/MANIFEST. Throws std::runtime_error when there is none.
struct Counts {
  int mul = 0;
  int add = 0;  ///< with subtractions and negations
};
Counts manifest_counts(const std::string& kernel);

// The sections, in the order in which they are printed.
void operations(Table& table);
void basis(Table& table);
void rotation(Table& table);
void high_rotation(Table& table);
void product(Table& table);
void evaluate(Table& table);
void project(Table& table);
void legendre(Table& table);
void build(Table& table);
void gaunt(Table& table);

}  // namespace sh::bench
