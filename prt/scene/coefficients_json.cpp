#include "prt/scene/coefficients_json.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

namespace sh::prt {
namespace {

// What the numbers mean. A file may leave an entry out, but must not contradict it.
constexpr std::pair<std::string_view, std::string_view> kMeanings[] = {
    {"convention",
     "real spherical harmonics, orthonormal on the unit sphere, no Condon-Shortley phase; "
     "index i = l(l+1)+m; band 1 is (y, z, x)"},
    {"axes", "z up, right-handed; pictures face +x, +y to the left (but mirror balls: to the right), +z up"},
    {"unit", "W m^-2 sr^-1 times sqrt(sr): integral of radiance times Y_i over the sphere"},
    {"color_space", "linear Rec. 709"},
    {"layout", "coefficients[channel][i], channels red, green, blue"}};

// The degree of so many coefficients a channel, or -1.
int degree_of(std::size_t count) {
  int degree = kMaxDegree;
  while (degree >= 0 && coefficient_count(degree) != count) --degree;
  return degree;
}

}  // namespace

nlohmann::ordered_json coefficients_json(const LightCoefficients& light) {
  nlohmann::ordered_json json = {{"type", "coefficients"}, {"degree", light.degree}};
  for (const auto& [key, meaning] : kMeanings) json[std::string(key)] = meaning;
  for (int channel = 0; channel < 3; ++channel) {
    const double* first = &light.at(channel, 0);
    json["coefficients"].push_back(std::vector<double>(first, first + light.bands_squared()));
  }
  return json;
}

std::vector<std::string_view> coefficients_keys() {
  std::vector<std::string_view> keys = {"degree",          "coefficients", "file", "format",  "width",       "height",
                                        "negative_pixels", "mapping",      "suns", "windows", "sampled_from"};
  for (const auto& [key, meaning] : kMeanings) keys.push_back(key);
  return keys;
}

LightCoefficients read_coefficients(const JsonReader& reader) {
  for (const auto& [key, meaning] : kMeanings) {
    const auto given = reader.find(key);
    if (given && given->text() != meaning) given->expected(fmt::format("\"{}\"", meaning));
  }
  const JsonReader numbers = reader.at("coefficients");
  const std::vector<JsonReader> channels = numbers.items();
  if (channels.size() != 3) numbers.expected("three arrays: red, green, blue");
  const int degree = degree_of(channels[0].items().size());
  if (degree < 0) channels[0].expected(fmt::format("(degree+1)^2 numbers, of degree 0 to {}", kMaxDegree));
  if (const auto given = reader.find("degree"); given && given->integer(0, kMaxDegree) != degree) {
    given->expected(fmt::format("{}, the degree of the coefficients", degree));
  }
  LightCoefficients light = LightCoefficients::zero(degree);
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const std::vector<JsonReader> items = channels[channel].items();
    if (items.size() != light.bands_squared()) {
      channels[channel].expected(fmt::format("{} numbers, as many as the other channels", light.bands_squared()));
    }
    for (std::size_t i = 0; i < items.size(); ++i) light.at(channel, i) = items[i].real();
  }
  return light;
}

}  // namespace sh::prt
