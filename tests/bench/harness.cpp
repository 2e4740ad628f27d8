#include "tests/bench/harness.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>

namespace sh::bench {
namespace {

using Clock = std::chrono::steady_clock;
constexpr double kPass = 2e-4;  // seconds that a pass of one task lasts at least

double seconds(const std::function<void()>& task, int repetitions) {
  const auto start = Clock::now();
  for (int i = 0; i < repetitions; ++i) task();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

int repetitions_for(const std::function<void()>& task) {
  task();
  int repetitions = 1;
  while (seconds(task, repetitions) < kPass) repetitions *= 2;
  return repetitions;
}

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double spread_of_last = 0;

std::string number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), value < 10 ? "%.3g" : "%.1f", value);
  return text.data();
}

}  // namespace

std::string scientific(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1e", value);
  return text.data();
}

std::vector<double> least_times(const std::vector<std::function<void()>>& tasks, int passes) {
  std::vector<int> repetitions;
  repetitions.reserve(tasks.size());
  for (const auto& task : tasks) repetitions.push_back(repetitions_for(task));
  std::vector<std::vector<double>> all(tasks.size());
  for (int pass = 0; pass < passes; ++pass) {
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      all[i].push_back(seconds(tasks[i], repetitions[i]) / repetitions[i]);
    }
  }
  std::vector<double> least;
  spread_of_last = 0;
  for (const std::vector<double>& passes_of_task : all) {
    least.push_back(*std::min_element(passes_of_task.begin(), passes_of_task.end()));
    spread_of_last = std::max(spread_of_last, median_of(passes_of_task) / least.back() - 1);
  }
  return least;
}

double last_spread() { return spread_of_last; }

void Table::section(const std::string& title, const std::string& note) {
  std::printf("\n%s\n", title.c_str());
  if (!note.empty()) std::printf("  (%s)\n", note.c_str());
}

void Table::verdict(const std::string& what, const std::string& figures, double value, double target, double spread) {
  const bool pass = value <= target;
  const bool is_noise = !pass && value <= target * (1 + spread);
  std::printf("  %-44s %-46s %8s  <= %-8s %s\n", what.c_str(), figures.c_str(), number(value).c_str(),
              number(target).c_str(),
              pass       ? "pass"
              : is_noise ? "noise"
                         : "MISS");
  std::fflush(stdout);
  if (pass) {
    ++passed_;
  } else if (is_noise) {
    ++noise_;
  } else {
    missed_.push_back(what + ": " + number(value) + " > " + number(target));
  }
}

void Table::ratio(const std::string& what, const std::string& unit, double ours, double other,
                  const std::string& other_name, double target) {
  spreads_.push_back(last_spread());
  verdict(what, number(ours) + " " + unit + ", " + other_name + " " + number(other), ours / other, target,
          spreads_.back());
}

void Table::figure(const std::string& what, const std::string& unit, double value, double target) {
  verdict(what, unit, value, target, 0);
}

void Table::remark(const std::string& text) {
  std::printf("  %s\n", text.c_str());
  std::fflush(stdout);
}

bool Table::summary() const {
  constexpr double kNoisy = 0.1;
  std::printf("\n%d targets met, %d missed by less than the noise, %zu missed\n", passed_, noise_, missed_.size());
  for (const std::string& line : missed_) std::printf("  missed: %s\n", line.c_str());
  if (!spreads_.empty()) {
    const double spread = median_of(spreads_);
    std::printf("the median pass took %.0f %% longer than the least one%s\n", 100 * spread,
                spread > kNoisy ? ": this machine is too noisy now to judge" : "");
  }
  return missed_.empty();
}

std::vector<float> random_vectors(std::size_t n, std::size_t size) {
  std::mt19937 random(1);
  std::normal_distribution<float> normal;
  std::vector<float> values(n * size);
  for (std::size_t i = 0; i < n; ++i) {
    float square = 0;
    for (std::size_t k = 0; k < size; ++k) {
      values[i * size + k] = normal(random);
      square += values[i * size + k] * values[i * size + k];
    }
    for (std::size_t k = 0; k < size; ++k) values[i * size + k] /= std::sqrt(square);
  }
  return values;
}

std::vector<float> random_directions(std::size_t n) { return random_vectors(n, 3); }

std::vector<float> random_rotations(std::size_t n) {
  const std::vector<float> quaternions = random_vectors(n, 4);
  std::vector<float> matrices;
  for (std::size_t i = 0; i < n; ++i) {
    const float w = quaternions[4 * i];
    const float x = quaternions[4 * i + 1];
    const float y = quaternions[4 * i + 2];
    const float z = quaternions[4 * i + 3];
    const std::array<float, 9> r{1 - 2 * (y * y + z * z), 2 * (x * y - w * z),     2 * (x * z + w * y),
                                 2 * (x * y + w * z),     1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
                                 2 * (x * z - w * y),     2 * (y * z + w * x),     1 - 2 * (x * x + y * y)};
    matrices.insert(matrices.end(), r.begin(), r.end());
  }
  return matrices;
}

Buffer<float> to_blocks(const std::vector<float>& plain, std::size_t size) {
  constexpr std::size_t kBlock = 16;
  const std::size_t n = plain.size() / size;
  Buffer<float> blocks = make_buffer<float>((n + kBlock - 1) / kBlock * kBlock * size);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < size; ++k) {
      blocks[i / kBlock * kBlock * size + k * kBlock + i % kBlock] = plain[i * size + k];
    }
  }
  return blocks;
}

}  // namespace sh::bench
