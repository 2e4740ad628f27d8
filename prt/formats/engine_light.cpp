#include "prt/formats/engine_light.hpp"

#include <fmt/format.h>

#include "numeric/identify/coefficient_map.hpp"

namespace sh::prt::formats {
namespace {

namespace identify = numeric::identify;

identify::CoefficientMap map_of(const EngineConvention& engine, int degree) {
  const identify::Preset& preset = identify::find_preset(std::string(engine.functions));
  identify::Convention convention = preset.convention;
  convention.axes = engine.world();
  const bool own = engine.hold == identify::Folded::kNothing;
  return identify::CoefficientMap(convention, degree, own ? preset.coefficients_hold : engine.hold);
}

}  // namespace

int degree_of(const Triples& triples) {
  int degree = kMaxDegree;
  while (degree >= 0 && coefficient_count(degree) != triples.size()) --degree;
  return degree;
}

const identify::Axes& EngineConvention::world() const { return identify::find_preset(std::string(axes)).world; }

Triples EngineConvention::to(const LightCoefficients& light) const {
  const std::vector<double> all = map_of(*this, light.degree).to(light.values);
  Triples triples(light.bands_squared());
  for (std::size_t i = 0; i < triples.size(); ++i) {
    for (std::size_t channel = 0; channel < 3; ++channel) {
      triples[i][channel] = unit * all[channel * triples.size() + i] + 0.0;  // no -0
    }
  }
  return triples;
}

LightCoefficients EngineConvention::from(const Triples& triples) const {
  LightCoefficients light = LightCoefficients::zero(degree_of(triples));
  for (std::size_t i = 0; i < triples.size(); ++i) {
    for (std::size_t channel = 0; channel < 3; ++channel) light.at(channel, i) = triples[i][channel] / unit;
  }
  light.values = map_of(*this, light.degree).from(light.values);
  return light;
}

std::string joined(const std::array<double, 3>& triple, std::string_view between) {
  return fmt::format("{}{}{}{}{}", triple[0], between, triple[1], between, triple[2]);
}

std::array<std::vector<double>, 3> channels_of(const Triples& triples) {
  std::array<std::vector<double>, 3> channels;
  for (const auto& triple : triples) {
    for (std::size_t channel = 0; channel < 3; ++channel) channels[channel].push_back(triple[channel]);
  }
  return channels;
}

Triples triples_of(const std::array<std::vector<double>, 3>& channels) {
  Triples triples(channels[0].size());
  for (std::size_t i = 0; i < triples.size(); ++i) triples[i] = {channels[0][i], channels[1][i], channels[2][i]};
  return triples;
}

}  // namespace sh::prt::formats
