// Timing, the limits of the machine, inputs, and the table of targets.
//
// Times drift between machines and runs. So a figure is a ratio of two times of one run, which take turns in many short
// passes; the least time of each counts. A line passes when its ratio is at most its target. A line that misses it by less
// than the spread of its passes is noise.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <functional>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "numeric/oracle/index.hpp"
#include "prt/large_pages.hpp"

namespace sh::bench {

using numeric::coefficient_count;

/// Seconds of one call of each task, by turns, the least of the passes. A pass repeats short tasks. More passes follow for a
/// quarter of a second while their times spread.
std::vector<double> least_times(const std::vector<std::function<void()>>& tasks, int passes = 25);

/// Of the last least_times: how much longer the median pass of a task was than its least one, as a part of that; the most of
/// its tasks.
double last_spread();

/// The table that is printed while it is measured; with `markdown` on standard error, and as a table of a README on standard
/// output in the end: of its cells if it has any, else of its lines.
class Table {
 public:
  explicit Table(bool markdown = false) : markdown_(markdown) {}
  void section(const std::string& title, const std::string& note = {});
  /// A ratio of two times (or sizes): ours, the control's or the limit's, in `unit`; passes when ours / other <=
  /// target.
  void ratio(const std::string& what, const std::string& unit, double ours, double other, const std::string& other_name,
             double target);
  /// A figure that has to be at most its target.
  void figure(const std::string& what, const std::string& unit, double value, double target);
  /// A figure without a target.
  void remark(const std::string& text);
  /// A cell of the README's table; rows and columns stand in the order of their first cells.
  void cell(const std::string& row, const std::string& column, const std::string& text);
  void cell(const std::string& row, int degree, double ns);
  /// Prints how many lines passed, and how noisy the machine was; true when none missed its target by more than the
  /// spread of its passes.
  bool summary() const;

 private:
  // spread: what a value may exceed its target by, as a part of it, and be noise; unit: of value and target in Markdown
  void verdict(const std::string& what, const std::string& figures, double value, double target, double spread,
               const std::string& unit = {});
  void say(const std::string& line) const;
  void print_markdown() const;

  bool markdown_;
  int passed_ = 0;
  int noise_ = 0;
  std::vector<double> spreads_;
  std::vector<std::string> missed_;
  std::vector<std::vector<std::string>> lines_;  // of the README's table
  std::vector<std::string> rows_;
  std::vector<std::string> columns_;
  std::map<std::pair<std::string, std::string>, std::string> cells_;
};

/// A benchmark of named sections, all or those that the arguments name; `--markdown` prints a README's table. Returns the exit
/// code: 1 if a target is missed by more than the noise, 2 for an error, such as an unknown section.
using Sections = std::vector<std::pair<std::string, void (*)(Table&)>>;
int run_sections(int argc, char** argv, const Sections& sections);

/// "1.2e-07"
std::string scientific(double value);

struct Free {
  void operator()(void* memory) const { std::free(memory); }
};
template <class T>
using Buffer = std::unique_ptr<T[], Free>;

/// `count` values, aligned to 64 bytes, set to `value`; on large pages like those that files are read into.
template <class T>
Buffer<T> make_buffer(std::size_t count, T value = T{}) {
  const std::size_t bytes = (count * sizeof(T) + 127) / 64 * 64;
  Buffer<T> buffer(static_cast<T*>(std::aligned_alloc(64, bytes)));
  prt::ask_for_large_pages(buffer.get(), bytes);
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

/// Calls f.operator()<Degree>() for First..Last.
template <int First, int Last, class F>
void for_degrees(const F& f) {
  [&]<int... kOffset>(std::integer_sequence<int, kOffset...>) { (f.template operator()<First + kOffset>(), ...); }
  (std::make_integer_sequence<int, Last - First + 1>());
}

// The limits of the machine, for the batched kernels. They are measured in the same run.

/// A task that fills `count` values, 64 bytes a store.
std::function<void()> fill_task(float* values, std::size_t count);

/// A task that reads `count` values once.
std::function<void()> read_task(const float* values, std::size_t count);

/// A task that reads `inputs` values once and writes `outputs` values once, by turns as they go along; the stores may
/// go past the caches. Both arrays aligned to 64 bytes.
std::function<void()> stream_task(const float* in, std::size_t inputs, float* out, std::size_t outputs,
                                  bool past_caches);

/// Operations of fma_task: each a multiply-add of 16 floats.
inline constexpr int kFmaOperations = 16 * 256;
/// A task of independent multiply-adds of 16 floats: chains enough to hide their latency.
std::function<void()> fma_task();

/// Sixteen floats in the registers of the machine, as a scalar type of the kernels.
class Sixteen {
 public:
  using value_type = float;
  using Vector = float __attribute__((vector_size(64)));

  Sixteen() = default;
  explicit Sixteen(float value) : v_(Vector{} + value) {}
  explicit Sixteen(Vector v) : v_(v) {}

  [[nodiscard]] const Vector& vector() const { return v_; }

  friend Sixteen operator+(Sixteen a, Sixteen b) { return Sixteen(a.v_ + b.v_); }
  friend Sixteen operator-(Sixteen a, Sixteen b) { return Sixteen(a.v_ - b.v_); }
  friend Sixteen operator*(Sixteen a, Sixteen b) { return Sixteen(a.v_ * b.v_); }
  friend Sixteen operator-(Sixteen a) { return Sixteen(-a.v_); }

 private:
  Vector v_{};
};

/// Operations of a kernel that is written, from generated/MANIFEST. Throws std::runtime_error when there is none.
struct Counts {
  int mul = 0;
  int add = 0;  ///< with subtractions and negations
};
Counts manifest_counts(const std::string& kernel);

// The sections, in the order in which they are printed.
void operations(Table& table);
void basis(Table& table);
void plain(Table& table);
void rotation(Table& table);
void high_rotation(Table& table);
void product(Table& table);
void transfer(Table& table);
void evaluate(Table& table);
void project(Table& table);
void irradiance(Table& table);
void legendre(Table& table);
void build(Table& table);
void gaunt(Table& table);

}  // namespace sh::bench
