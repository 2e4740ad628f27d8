#include "tests/bench/harness.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <stdexcept>

namespace sh::bench {
namespace {

using Clock = std::chrono::steady_clock;
constexpr double kPass = 2e-4;      // seconds that a pass of one task lasts at least
constexpr double kQuiet = 0.03;     // a spread that no further passes are needed for
constexpr double kPatience = 0.25;  // seconds of passes after which a spread is taken as it is

double since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

double seconds(const std::function<void()>& task, int repetitions) {
  const auto start = Clock::now();
  for (int i = 0; i < repetitions; ++i) task();
  return since(start);
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

// The processor, the compiler of the benchmark, and the day.
std::string machine() {
  std::string processor = "unknown processor";
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with("model name")) continue;
    processor = line.substr(line.find(':') + 2);
    break;
  }
#ifdef __AVX512F__
  processor += ", AVX-512";
#elif defined(__AVX2__)
  processor += ", AVX2";
#endif
#ifdef __clang__
  const std::string compiler = "clang++ " + std::to_string(__clang_major__);
#else
  const std::string compiler = "g++ " + std::to_string(__GNUC__);
#endif
  std::array<char, 16> day{};
  const std::time_t now = std::time(nullptr);
  std::strftime(day.data(), day.size(), "%Y-%m-%d", std::gmtime(&now));
  return processor + ", " + compiler + ", " + day.data();
}

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
  std::vector<double> least;
  const auto start = Clock::now();
  do {
    for (int pass = 0; pass < passes; ++pass) {
      for (std::size_t i = 0; i < tasks.size(); ++i) {
        all[i].push_back(seconds(tasks[i], repetitions[i]) / repetitions[i]);
      }
    }
    least.clear();
    spread_of_last = 0;
    for (const std::vector<double>& passes_of_task : all) {
      least.push_back(*std::min_element(passes_of_task.begin(), passes_of_task.end()));
      spread_of_last = std::max(spread_of_last, median_of(passes_of_task) / least.back() - 1);
    }
  } while (spread_of_last > kQuiet && since(start) < kPatience);
  return least;
}

double last_spread() { return spread_of_last; }

void Table::say(const std::string& line) const {
  std::FILE* const out = markdown_ ? stderr : stdout;
  std::fprintf(out, "%s\n", line.c_str());
  std::fflush(out);
}

void Table::section(const std::string& title, const std::string& note) {
  say("\n" + title);
  if (!note.empty()) say("  (" + note + ")");
  lines_.push_back({"*" + title + "*", "", "", ""});
}

void Table::verdict(const std::string& what, const std::string& figures, double value, double target, double spread,
                    const std::string& unit) {
  const bool pass = value <= target;
  const bool is_noise = !pass && value <= target * (1 + spread);
  const std::string word = pass ? "pass" : is_noise ? "noise" : "MISS";
  std::array<char, 256> line{};
  std::snprintf(line.data(), line.size(), "  %-44s %-46s %8s  <= %-8s %s", what.c_str(), figures.c_str(),
                number(value).c_str(), number(target).c_str(), word.c_str());
  say(line.data());
  const std::string limit = number(target) + (unit.empty() ? "" : " " + unit) +
                            (pass       ? ""
                             : is_noise ? ": missed, but by less than the noise"
                                        : ": missed");
  if (unit.empty()) {
    lines_.push_back({what, figures, number(value), limit});
  } else {
    lines_.push_back({what, number(value) + " " + unit, "", limit});
  }
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
  verdict(what, unit, value, target, 0, unit.empty() ? "error" : unit);
}

void Table::remark(const std::string& text) { say("  " + text); }

void Table::cell(const std::string& row, const std::string& column, const std::string& text) {
  const auto add = [](std::vector<std::string>& names, const std::string& name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  };
  add(rows_, row);
  add(columns_, column);
  cells_[{row, column}] = text;
}

void Table::cell(const std::string& row, int degree, double ns) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), ns < 9.95 ? "%.2g" : "%.0f", ns);
  cell(row, std::to_string(degree), text.data());
}

bool Table::summary() const {
  constexpr double kNoisy = 0.1;
  say("\n" + std::to_string(passed_) + " targets met, " + std::to_string(noise_) + " missed by less than the noise, " +
      std::to_string(missed_.size()) + " missed");
  for (const std::string& line : missed_) say("  missed: " + line);
  if (!spreads_.empty()) {
    const double spread = median_of(spreads_);
    say("the median pass took " + std::to_string(std::lround(100 * spread)) + " % longer than the least one" +
        (spread > kNoisy ? ": this machine is too noisy now to judge" : ""));
  }
  if (markdown_) print_markdown();
  return missed_.empty();
}

void Table::print_markdown() const {
  std::vector<std::vector<std::string>> table = lines_;
  if (cells_.empty()) {
    table.insert(table.begin(), {machine(), "measured", "ratio", "at most"});
  } else {
    table.assign(1, {machine()});
    table.front().insert(table.front().end(), columns_.begin(), columns_.end());
    for (const std::string& row : rows_) {
      std::vector<std::string>& line = table.emplace_back(1, row);
      for (const std::string& column : columns_) {
        const auto found = cells_.find({row, column});
        line.push_back(found == cells_.end() ? "" : found->second);
      }
    }
  }
  for (std::size_t i = 0; i < table.size(); ++i) {
    std::string line = "|";
    for (const std::string& text : table[i]) line += text.empty() ? " |" : " " + text + " |";
    std::printf("%s\n", line.c_str());
    if (i > 0) continue;
    line = "|";
    for (std::size_t k = 0; k < table[i].size(); ++k) line += "---|";
    std::printf("%s\n", line.c_str());
  }
}

int run_sections(int argc, char** argv, const Sections& sections) {
  std::vector<std::string> wanted(argv + 1, argv + argc);
  const auto markdown = std::find(wanted.begin(), wanted.end(), "--markdown");
  const bool is_table = markdown != wanted.end();
  if (is_table) wanted.erase(markdown);
  try {
    for (const std::string& name : wanted) {
      if (std::any_of(sections.begin(), sections.end(), [&](const auto& section) { return section.first == name; }))
        continue;
      std::string known;
      for (const auto& section : sections) known += " " + section.first;
      throw std::invalid_argument(name + ": expected --markdown or sections:" + known);
    }
    Table table(is_table);
    for (const auto& [name, run] : sections) {
      if (wanted.empty() || std::find(wanted.begin(), wanted.end(), name) != wanted.end()) run(table);
    }
    return table.summary() ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", argv[0], error.what());
    return 2;
  }
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
