// Time of the generated basis per degree against the textbook evaluation, both in the same run.
// Control: Green 2003, section "Spherical Harmonics": every value from its own associated Legendre recurrence,
// factorials and an angle; it is what a first implementation looks like.
// Prints one line a degree: ns a call (minimum of the repetitions) and the ratio.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "generated/cpp/basis.hpp"

namespace {

constexpr int kDegrees = 11;
constexpr int kDirections = 1024;  // fits the first-level cache

// Directions uniform on the sphere, (kDirections, 3).
const std::vector<std::array<float, 3>>& directions() {
  static const auto set = [] {
    std::mt19937 random(1);
    std::normal_distribution<float> normal;
    std::vector<std::array<float, 3>> result(kDirections);
    for (auto& d : result) {
      d = {normal(random), normal(random), normal(random)};
      const float length = std::hypot(d[0], d[1], d[2]);
      for (float& component : d) component /= length;
    }
    return result;
  }();
  return set;
}

double factorial(int n) { return n < 2 ? 1.0 : n * factorial(n - 1); }

// Associated Legendre function without the Condon-Shortley phase, l >= m >= 0, |z| <= 1. Green 2003, recurrences 1-3.
double legendre(int l, int m, double z) {
  double diagonal = 1;
  const double sine = std::sqrt((1 - z) * (1 + z));
  for (int i = 1; i <= m; ++i) diagonal *= (2 * i - 1) * sine;
  if (l == m) return diagonal;
  double previous = diagonal;
  double current = z * (2 * m + 1) * diagonal;
  for (int i = m + 2; i <= l; ++i) {
    const double next = ((2 * i - 1) * z * current - (i + m - 1) * previous) / (i - m);
    previous = current;
    current = next;
  }
  return current;
}

double textbook_value(int l, int m, double z, double phi) {
  const int order = std::abs(m);
  const double scale = std::sqrt((2 * l + 1) / (4 * std::numbers::pi) * factorial(l - order) / factorial(l + order));
  const double value = scale * legendre(l, order, z);
  if (m == 0) return value;
  return std::numbers::sqrt2 * value * (m > 0 ? std::cos(order * phi) : std::sin(order * phi));
}

template <int Degree>
void textbook(float x, float y, float z, float* out) {
  const double phi = std::atan2(static_cast<double>(y), static_cast<double>(x));
  for (int l = 0; l <= Degree; ++l) {
    for (int m = -l; m <= l; ++m) {
      out[l * (l + 1) + m] = static_cast<float>(textbook_value(l, m, static_cast<double>(z), phi));
    }
  }
}

template <int Degree, void (*Evaluate)(float, float, float, float*)>
void run(benchmark::State& state) {
  std::array<float, std::size_t{Degree + 1} * std::size_t{Degree + 1}> out{};
  const auto& set = directions();
  std::size_t i = 0;
  for (auto _ : state) {
    const auto& d = set[i++ % kDirections];
    Evaluate(d[0], d[1], d[2], out.data());
    benchmark::DoNotOptimize(out);
  }
}

template <int Degree>
void generated(float x, float y, float z, float* out) {
  sh::basis<Degree>(x, y, z, out);
}

template <int Degree>
void register_degree() {
  const std::string degree = std::to_string(Degree);
  benchmark::RegisterBenchmark(("generated/" + degree).c_str(), run<Degree, generated<Degree>>);
  benchmark::RegisterBenchmark(("textbook/" + degree).c_str(), run<Degree, textbook<Degree>>);
}

// Keeps the minimum over the repetitions, so that a busy machine distorts the ratio little.
class MinimumReporter : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& one : runs) {
      if (one.run_type != Run::RT_Iteration) continue;
      const auto entry = minimum_.try_emplace(one.run_name.function_name, std::numeric_limits<double>::max()).first;
      entry->second = std::min(entry->second, one.GetAdjustedCPUTime());
    }
  }
  void Finalize() override {
    std::printf("%6s %14s %14s %8s\n", "degree", "generated ns", "textbook ns", "ratio");
    for (int degree = 0; degree < kDegrees; ++degree) {
      const double ours = minimum_["generated/" + std::to_string(degree)];
      const double control = minimum_["textbook/" + std::to_string(degree)];
      std::printf("%6d %14.2f %14.1f %8.4f\n", degree, ours, control, ours / control);
    }
  }

 private:
  std::map<std::string, double> minimum_;
};

template <std::size_t... Degree>
void register_all(std::index_sequence<Degree...>) {
  (register_degree<static_cast<int>(Degree)>(), ...);
}

}  // namespace

int main() {
  std::string name = "basis_bench";
  std::string repetitions = "--benchmark_repetitions=5";
  std::string seconds = "--benchmark_min_time=0.02";
  std::array<char*, 3> arguments = {name.data(), repetitions.data(), seconds.data()};
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  register_all(std::make_index_sequence<kDegrees>());
  MinimumReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
}
