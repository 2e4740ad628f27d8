// Decisions by measurements on a probe: bounces, bands and directions.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "numeric/sampling/power_law.hpp"
#include "prt/plan/bounds.hpp"
#include "prt/plan/draft.hpp"
#include "prt/rays/directions.hpp"

namespace sh::prt {

namespace {

constexpr double kLoosestTolerance = 0.1;

// Albedo times blocked part times the largest relative radiance after any number of bounces, for all rotations of the
// light: a bound on the light that comes back to a vertex.
double light_that_returns(const Draft& draft) {
  std::vector<double> returned;
  for (std::size_t k = 0; k < draft.rows.blocked.size(); ++k) {
    const float own = draft.scene.mesh.albedo[draft.probe[k]].maxCoeff();
    returned.push_back(static_cast<double>(own) * draft.rows.blocked[k]);
  }
  const double largest = draft.light->largest_product_of_bands(0, unshadowed_band_norm);
  return kProbeMargin * rms(returned) * draft.relative(largest, draft.gain);
}

// The error of a tolerance of 1: every number is off by the largest possible number.
double error_of_tolerance(const Draft& draft) {
  const double largest = transfer_band_bound(kInterreflected, true, draft.bake.degree);
  return draft.error_of(std::vector<double>(draft.light->coefficients().bands_squared(), largest));
}

void loosen_tolerance(Draft& draft, double returned) {
  constexpr double kPart = 0.1;
  double& tolerance = draft.bake.bounces.tolerance;
  const double before = tolerance;
  const double unit = error_of_tolerance(draft);
  const double wanted = std::min(kLoosestTolerance, unit > 0.0 ? draft.share(kPart) / unit : kLoosestTolerance);
  if (draft.shines() || wanted <= before) {
    draft.decide("bounces", fmt::format("to {:.2g} as requested", before),
                 draft.shines() ? "surfaces emit light" : "the budget leaves no room");
    return;
  }
  tolerance = wanted;
  draft.decide("bounces", fmt::format("to {:.2g} instead of {:.2g}", tolerance, before),
               fmt::format("up to {:.2g} of the light comes back; about {:.0f} % of the applications are left",
                           returned, 100.0 * std::log(tolerance) / std::log(before)),
               tolerance * unit, "bound");
}

// The error of omitting the lights' bands above `degree`, up to the requested degree.
double bound_above(const Draft& draft, int degree) {
  return draft.relative(draft.light->largest_product_of_bands(degree + 1, [&](int l) { return draft.band_bound(l); }));
}

double measured_above(const Draft& draft, int degree) {
  const std::size_t length = draft.light->coefficients().bands_squared();
  const std::size_t low = coefficient_count(degree);
  std::vector<float> parts = draft.rows.transfer;
  for (std::size_t row = 0; row < parts.size(); row += length) {
    std::fill_n(parts.begin() + row, low, 0.0F);
  }
  return kProbeMargin * draft.gain * draft.error_on_probe(parts);
}

// error = factor N^-rate, the error of a probe with N directions against many.
struct Convergence {
  double factor = 0.0;
  double rate = 0.5;
  [[nodiscard]] double error(double directions) const { return factor * std::pow(directions, -rate); }
  [[nodiscard]] double directions(double error) const {
    return factor > 0.0 ? std::pow(factor / error, 1.0 / rate) : 0.0;
  }
};

constexpr std::array<int, 3> kTried = {256, 512, 1024};
constexpr int kReference = 8192;
constexpr int kFewest = 64;
constexpr int kUnit = 64;

Convergence measure(const Draft& draft) {
  const std::size_t length = draft.light->coefficients().bands_squared();
  const ProbeRows reference = draft.trace_probe(kReference);
  std::vector<std::pair<double, double>> errors;
  for (const int tried : kTried) {
    std::vector<float> parts = draft.trace_probe(tried).transfer;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      parts[i] = i % length < draft.count() ? parts[i] - reference.transfer[i] : 0.0F;
    }
    errors.emplace_back(tried, std::max(draft.error_on_probe(parts), 1e-12));
  }
  const numeric::PowerLaw law = numeric::fit_power_law(errors, -1.2, -0.4).value();  // the possible range for samplers
  Convergence convergence{law.factor, -law.exponent};
  // With bounces the view of other surfaces is sampled, too, and both errors are reflected again.
  const bool bounces = draft.bake.kind->has_bounces();
  convergence.factor *= kProbeMargin * (bounces ? 2.0 * draft.gain : 1.0);
  return convergence;
}

}  // namespace

void decide_bounces(Draft& draft) {
  constexpr double kPart = 0.25;
  const double returned = light_that_returns(draft);
  if (draft.shines() || draft.has_mirrors() || returned > draft.share(kPart)) {
    loosen_tolerance(draft, returned);
    return;
  }
  draft.bake.kind = draft.bake.kind->without_bounces;
  draft.decide("bounces", "none: shadowed instead of interreflected",
               "albedo times the blocked part bounds the light that comes back", returned, "measured");
}

void decide_bands(Draft& draft) {
  constexpr double kPart = 0.4;
  const int asked = draft.bake.degree;
  for (int degree = 0; degree < asked; ++degree) {
    const double bound = bound_above(draft, degree);
    const double measured = measured_above(draft, degree);
    const double error = std::min(bound, measured);
    if (error <= draft.share(kPart)) {
      draft.bake.degree = degree;
      draft.decide("bands", fmt::format("degree {} instead of {}", degree, asked),
                   fmt::format("|T_l| |L_l| over bands {} to {}, lights turned: {} (any visibility: {:.2g})",
                               degree + 1, asked, name_of(draft.options.turns), bound),
                   error, bound <= measured ? "bound" : "measured");
      return;
    }
  }
  draft.decide(
      "bands", fmt::format("degree {} as requested", asked),
      fmt::format("without band {} the error would be {:.2g}", asked,
                  asked > 0 ? std::min(bound_above(draft, asked - 1), measured_above(draft, asked - 1)) : 1.0));
}

double floor_of_directions(const Draft& draft) {
  const double floor = measure(draft).error(static_cast<double>(draft.bake.directions));
  if (floor > draft.left) {
    const double needed = std::ceil(measure(draft).directions(draft.left));
    throw std::invalid_argument(
        fmt::format("error {:.3g}: cannot be met: {} directions alone give {:.3g} (measured); expected {:.2g} or more, "
                    "or {} directions",
                    draft.options.error, draft.bake.directions, floor, 1.1 * floor + draft.plan.record.error,
                    needed <= static_cast<double>(kMaxDirections) ? fmt::format("{:.0f}", needed) : "no number of"));
  }
  return floor;
}

void decide_directions(Draft& draft) {
  const int asked = draft.bake.directions;
  const Convergence convergence = measure(draft);
  const double wanted = convergence.directions(draft.left);
  const double rounded = std::ceil(wanted / kUnit) * kUnit;
  draft.bake.directions = std::min(asked, std::max(kFewest, static_cast<int>(std::min(rounded, 1e6))));
  const double error = convergence.error(static_cast<double>(draft.bake.directions));
  const bool bounces = draft.bake.kind->has_bounces();
  draft.decide("directions",
               draft.bake.directions < asked ? fmt::format("{} instead of {}", draft.bake.directions, asked)
                                             : fmt::format("{} as requested", asked),
               fmt::format("the error falls as N^-{:.2f} on {} vertices, against {} directions", convergence.rate,
                           draft.probe.size(), kReference),
               error, bounces ? "heuristic" : "measured");
}

}  // namespace sh::prt
