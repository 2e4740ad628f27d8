// A light as an engine holds it: coefficients in the engine's own functions, axes and unit.
#pragma once
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "numeric/identify/convention.hpp"
#include "prt/light/light_coefficients.hpp"

namespace sh::prt::formats {

/// Red, green, blue of each coefficient.
using Triples = std::vector<std::array<double, 3>>;

/// Triples of a degree, (degree+1)^2; -1 for another count.
int degree_of(const Triples& triples);

/// The functions of one preset (numeric/identify/convention.hpp) in the world axes of another, most often the same.
/// Coefficients are those of the radiance times the factor that they `hold`, times `unit`.
struct EngineConvention {
  std::string_view functions;
  std::string_view axes = functions;
  numeric::identify::Folded hold = numeric::identify::Folded::kNothing;  // kNothing: as the preset says
  double unit = 1.0;

  [[nodiscard]] const numeric::identify::Axes& world() const;
  /// Throws std::invalid_argument for a degree that the functions do not have.
  [[nodiscard]] Triples to(const LightCoefficients& light) const;
  [[nodiscard]] LightCoefficients from(const Triples& triples) const;
};

/// A light on its way into a file. Formats with pictures draw them from `radiance`, in the same axes.
struct EngineLight {
  Triples coefficients;
  const EngineConvention* convention;
  const LightCoefficients* radiance;  // in the project's convention, in any degree
};

/// Numbers as text, the shortest that reads back the same, separated by `between`.
std::string joined(const std::array<double, 3>& triple, std::string_view between = ", ");

/// The channels of triples: red, green, blue of one coefficient each become three rows of coefficients.
std::array<std::vector<double>, 3> channels_of(const Triples& triples);
Triples triples_of(const std::array<std::vector<double>, 3>& channels);

}  // namespace sh::prt::formats
