// Tables of values as users would send them, made from numeric's own conventions, in memory.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <complex>
#include <functional>
#include <string>
#include <vector>

#include "numeric/identify/identify.hpp"
#include "numeric/oracle/basis.hpp"
#include "numeric/sampling/directions.hpp"
#include "tests/message_of.hpp"

namespace sh::numeric::identify {

// As many random directions as functions, and half as many more.
inline std::vector<std::array<double, 3>> test_directions(int degree) {
  std::vector<std::array<double, 3>> directions;
  for (const auto& d : random_directions(coefficient_count(degree) * 3 / 2 + 4, 7))
    directions.push_back({d.x, d.y, d.z});
  return directions;
}

inline const Preset& preset_named(const std::string& name) {
  return *std::find_if(presets().begin(), presets().end(), [&](const Preset& p) { return p.name == name; });
}

using Values = std::vector<std::complex<double>>;
// The values of a direction, changed in place.
using Change = std::function<void(Values&)>;

inline void leave(Values& /*values*/) {}

inline void round_to_float(Values& values) {
  for (auto& v : values)
    v = {static_cast<double>(static_cast<float>(v.real())), static_cast<double>(static_cast<float>(v.imag()))};
}

inline Samples make_samples(const Convention& convention, int degree, const Change& change = leave) {
  Samples samples;
  samples.degree = degree;
  samples.is_array = convention.order == IndexOrder::kCosineSineArray;
  samples.file = "table.csv";
  samples.directions = test_directions(degree);
  for (const auto& direction : samples.directions) {
    samples.lines.push_back(static_cast<int>(samples.lines.size()) + 2);
    auto values = convention_values(convention, degree, direction);
    change(values);
    samples.columns.resize(values.size());
    for (std::size_t j = 0; j < values.size(); ++j) samples.columns[j].push_back(values[j]);
  }
  return samples;
}

inline Identification identify_values(const Convention& convention, int degree, const Change& change = leave) {
  return identify({make_samples(convention, degree, change)});
}

inline bool holds(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// The coefficients reported as wrong with respect to a preset: of the nearest reading, or of a doubt.
inline std::vector<Coefficient> wrong_for(const Identification& result, const std::string& preset) {
  std::vector<Coefficient> wrong;
  for (const auto& doubt : result.doubts) {
    if (holds(doubt.reading.presets.own, preset)) return doubt.wrong;
  }
  for (const auto& c : result.coefficients) {
    if (c.wrong) wrong.push_back(c);
  }
  return wrong;
}

/// Expects a refusal in one line that begins with `start` and contains `part`.
template <class Call>
void expect_refusal(const Call& call, const std::string& start, const std::string& part) {
  const std::string message = test::message_of(call);
  EXPECT_TRUE(message.starts_with(start)) << message;
  EXPECT_NE(message.find(part), std::string::npos) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

}  // namespace sh::numeric::identify
