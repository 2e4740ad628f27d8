// The numbers of sphere_function.hpp that a user gives.
#include <fmt/core.h>

#include <charconv>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include "numeric/output/read_file.hpp"
#include "numeric/plot/sphere_function.hpp"

namespace sh::numeric::plot {
namespace {

constexpr std::size_t kShown = 40;  // of a wrong word
constexpr std::size_t kLargestFile = 4'000'000;
constexpr const char* kSeparators = ", \t\r\n\v\f";

// The number that a word spells; `place` begins the message.
double parse_number(const std::string& place, const std::string& word) {
  const char* end = word.data() + word.size();
  double value = 0;
  const auto [stop, error] = std::from_chars(word.data() + (word[0] == '+' ? 1 : 0), end, value);
  if (error == std::errc::result_out_of_range) {
    throw std::invalid_argument(
        fmt::format("{}: expected a number in the range of a double, got '{}'", place, word.substr(0, kShown)));
  }
  if (error != std::errc() || stop != end || !std::isfinite(value)) {
    throw std::invalid_argument(
        fmt::format("{}: expected a number such as -0.5 or 1e-3, got '{}'", place, word.substr(0, kShown)));
  }
  return value;
}

void append_numbers(const std::string& place, const std::string& text, std::vector<double>& numbers) {
  for (auto begin = text.find_first_not_of(kSeparators); begin != std::string::npos;) {
    const auto end = text.find_first_of(kSeparators, begin);
    numbers.push_back(parse_number(place, text.substr(begin, end - begin)));
    begin = text.find_first_not_of(kSeparators, end);
  }
}

}  // namespace

std::vector<double> parse_numbers(const std::string& name, const std::string& text) {
  std::vector<double> numbers;
  append_numbers(name, text, numbers);
  if (numbers.empty())
    throw std::invalid_argument(fmt::format("{}: expected numbers, got '{}'", name, text.substr(0, kShown)));
  return numbers;
}

std::vector<double> read_numbers(const std::string& file) {
  std::istringstream lines(output::read_file(file, kLargestFile));
  std::vector<double> numbers;
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    append_numbers(fmt::format("{}:{}", file, ++number), line.substr(0, line.find('#')), numbers);
  }
  if (numbers.empty()) throw std::invalid_argument(fmt::format("{}: expected numbers, got none", file));
  return numbers;
}

std::vector<double> numbers_from(const std::string& name, const std::string& text) {
  const std::string first = text.substr(0, text.find_first_of(kSeparators));
  double value = 0;
  const char* begin = first.data() + (first.starts_with('+') ? 1 : 0);
  const bool number = std::from_chars(begin, first.data() + first.size(), value).ec != std::errc::invalid_argument;
  return number || first.empty() ? parse_numbers(name, text) : read_numbers(text);
}

}  // namespace sh::numeric::plot
