// Parts that the answers of `shcheck identify` and `shcheck rotation-matrix` share.
#pragma once

#include <complex>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "numeric/identify/convention.hpp"
#include "numeric/output/formatted.hpp"

namespace sh::numeric::identify {

using Json = nlohmann::ordered_json;

inline std::string join(const std::vector<std::string>& words, const char* between = ", ") {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

inline std::string number(const std::complex<double>& value, int digits) {
  const std::string real = output::formatted("%.*g", digits, value.real());
  return value.imag() == 0 ? real : real + output::formatted("%+.*gi", digits, value.imag());
}

inline Json complex_json(const std::complex<double>& value) {
  if (value.imag() == 0) return value.real();
  return {{"re", value.real()}, {"im", value.imag()}};
}

/// The readings after the first, in the words of text(reading): those that are presets, the rest counted or listed.
/// `why`: behind the number of readings.
template <class Reading, class Text>
std::string other_readings(const std::vector<Reading>& readings, bool all, const char* why, const Text& text) {
  constexpr std::size_t kFew = 4;
  std::string list;
  int hidden = 0;
  for (std::size_t i = 1; i < readings.size(); ++i) {
    if (all || readings.size() <= kFew || !readings[i].presets.empty()) {
      list += "  or: " + text(readings[i]) + "\n";
    } else {
      ++hidden;
    }
  }
  if (hidden > 0)
    list += output::formatted("  or: %d further readings that are no preset (--all lists them)\n", hidden);
  if (list.empty()) return "";
  return output::formatted("%zu readings are the same on these data%s:\n", readings.size(), why) + list;
}

}  // namespace sh::numeric::identify
