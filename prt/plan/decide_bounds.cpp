// Decisions by bounds: the need for bounces, and the type of the stored numbers.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "prt/plan/bounds.hpp"
#include "prt/plan/draft.hpp"
#include "prt/transfer/storage.hpp"

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

// The largest error that an element makes in each column of the rows, (bands^2 of the requested degree).
std::vector<double> storage_errors(const Draft& draft, Element element) {
  std::vector<double> errors(draft.light->coefficients().bands_squared(), 0.0);
  const Storage& storage = draft.plan.storage;
  for (std::size_t i = 0; i < draft.count(); ++i) {
    if (storage.kept.empty() || std::binary_search(storage.kept.begin(), storage.kept.end(), i)) {
      errors[i] = encoding_error(element, static_cast<double>(draft.plan.largest[i]));
    }
  }
  return errors;
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

void decide_storage(Draft& draft) {
  constexpr double kSampling = 1.01;  // sums over directions may exceed the exact bound
  constexpr double kPart = 0.5;
  draft.plan.largest.resize(draft.count());
  for (int l = 0; l <= draft.bake.degree; ++l) {
    std::fill(draft.plan.largest.begin() + l * l, draft.plan.largest.begin() + (l + 1) * (l + 1),
              static_cast<float>(kSampling * draft.band_bound(l)));
  }
  for (const Element element : {Element::kByte, Element::kHalf}) {
    const double error = draft.error_of(storage_errors(draft, element));
    if (error <= draft.share(kPart)) {
      draft.plan.storage.element = element;
      const bool byte = element == Element::kByte;
      draft.decide("storage", byte ? "8 bits with a scale a coefficient" : "half",
                   byte ? "half a scale for each number, bounded by what transfer can be, times the lights"
                        : "2^-11 of each number, bounded by what transfer can be, times the lights",
                   error, "bound");
      return;
    }
  }
  draft.decide("storage", "single", "the budget leaves no room for half");
}

}  // namespace sh::prt
