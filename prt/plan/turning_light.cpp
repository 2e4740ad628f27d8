#include "prt/plan/turning_light.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sh::prt {

namespace {

constexpr std::size_t kChannels = 3;
constexpr double kRounding = 1e-12;  // of the largest coefficient: exact zeros come out up to this size

using Group = std::vector<std::uint32_t>;

std::vector<Group> groups_of(int degree, LightTurns turns) {
  std::vector<Group> groups;
  for (int l = 0; l <= degree; ++l) {
    const auto at = [l](int m) { return static_cast<std::uint32_t>(l * (l + 1) + m); };
    Group band;
    for (int m = -l; m <= l; ++m) {
      band.push_back(at(m));
      if (turns == LightTurns::kNone) {
        groups.push_back({at(m)});
      } else if (turns == LightTurns::kAboutZ && m >= 0) {
        groups.push_back(m == 0 ? Group{at(0)} : Group{at(-m), at(m)});
      }
    }
    if (turns == LightTurns::kAny) groups.push_back(band);
  }
  return groups;
}

template <class Value>
double norm(const Group& group, const Value& value) {
  double squares = 0.0;
  for (const std::uint32_t i : group) squares += value(i) * value(i);
  return std::sqrt(squares);
}

}  // namespace

TurningLight::TurningLight(LightCoefficients light, LightTurns turns)
    : light_(std::move(light)), turns_(turns), groups_(groups_of(light_.degree, turns)) {}

double TurningLight::largest_product(std::size_t channel, const std::vector<double>& t) const {
  if (turns_ == LightTurns::kNone) {
    double sum = 0.0;
    for (std::size_t i = 0; i < t.size(); ++i) sum += t[i] * light_.at(channel, i);
    return std::abs(sum);
  }
  return largest_product_of_errors(channel, t);
}

double TurningLight::largest_product_of_errors(std::size_t channel, const std::vector<double>& e) const {
  double sum = 0.0;
  for (const Group& group : groups_) {
    sum += norm(group, [&](std::uint32_t i) { return e[i]; }) *
           norm(group, [&](std::uint32_t i) { return light_.at(channel, i); });
  }
  return sum;
}

std::vector<std::uint32_t> TurningLight::needed() const {
  double largest = 0.0;
  for (const double value : light_.values) largest = std::max(largest, std::abs(value));
  std::vector<std::uint32_t> indices;
  for (const Group& group : groups_) {
    for (std::size_t channel = 0; channel < kChannels; ++channel) {
      if (norm(group, [&](std::uint32_t i) { return light_.at(channel, i); }) > kRounding * largest) {
        indices.insert(indices.end(), group.begin(), group.end());
        break;
      }
    }
  }
  std::sort(indices.begin(), indices.end());
  return indices;
}

double TurningLight::band_norm(std::size_t channel, int l) const {
  double squares = 0.0;
  for (int i = l * l; i < (l + 1) * (l + 1); ++i) {
    squares += std::pow(light_.at(channel, i), 2);
  }
  return std::sqrt(squares);
}

}  // namespace sh::prt
