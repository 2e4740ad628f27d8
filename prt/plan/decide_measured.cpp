// Decisions by measurements on a probe: bounces, bands and directions.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "prt/plan/bounds.hpp"
#include "prt/plan/draft.hpp"
#include "prt/rays/directions.hpp"

namespace sh::prt {

namespace {

constexpr double kLoosestTolerance = 0.1;
constexpr int kFewest = 64;
constexpr int kUnit = 64;

using Radiances = Measurement::Radiances;

// The stated error between two sets of numbers of the probe.
double difference(const Draft& draft, const Radiances& a, const Radiances& b, double factor = 1.0) {
  Radiances e(a.size());
  for (std::size_t i = 0; i < e.size(); ++i) e[i] = factor * (a[i] - b[i]);
  return draft.measurement->error(e);
}

Radiances radiances_of(const Draft& draft, const std::vector<float>& rows, const RowShape& shape) {
  return draft.measurement->radiances(rows, shape);
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
  const bool proves = draft.bake.kind->has_form_factors();
  const double unit = error_of_tolerance(draft);
  const double wanted = std::min(kLoosestTolerance, draft.share(kPart) / unit);
  if (!proves || draft.shines() || wanted <= before) {
    draft.decide("bounces", fmt::format("to {:.2g} as requested", before),
                 !proves          ? fmt::format("without bounces the error would be {:.2g}", returned)
                 : draft.shines() ? "surfaces emit light"
                                  : "the budget leaves no room");
    return;
  }
  tolerance = wanted;
  draft.decide("bounces", fmt::format("to {:.2g} instead of {:.2g}", tolerance, before),
               fmt::format("without bounces the error would be {:.2g}; about {:.0f} % of the applications are left",
                           returned, 100.0 * std::log(tolerance) / std::log(before)),
               tolerance * unit, "bound");
  draft.loosened = tolerance * unit;
}

// The error of omitting the lights' bands above `degree`, up to the requested degree. None is proved where light meets
// lobes, whose bands it omits, too.
double bound_above(const Draft& draft, int degree) {
  if (draft.bake.kind->is_glossy()) return std::numeric_limits<double>::infinity();
  return draft.relative(draft.light->largest_product_of_bands(degree + 1, [&](int l) { return draft.band_bound(l); }));
}

// The rows along many directions if bakes have this degree: light bounces between lobes at that degree, too.
std::vector<float> many_at(const Draft& draft, int degree) {
  if (draft.bake.kind->indirect == nullptr) return draft.many;
  BakeOptions options = draft.measurement->reference_options(draft.bake);
  options.degree = degree;
  return draft.measurement->rows(options);
}

double measured_above(const Draft& draft, int degree) {
  const RowShape low(*draft.bake.kind, draft.scene.mesh, degree);
  return difference(draft, radiances_of(draft, draft.measurement->kept(many_at(draft, degree), low), low),
                    radiances_of(draft, draft.many, draft.traced_shape()));
}

// The error of this many directions alone, with the current kind, measured and as stated.
double measured_error_of_directions(const Draft& draft, int directions) {
  const double spread = draft.bake.kind->has_bounces() ? draft.measurement->spread() : 1.0;
  const RowShape shape = draft.traced_shape();
  return difference(draft, radiances_of(draft, draft.measurement->rows(draft.along(directions)), shape),
                    radiances_of(draft, draft.many, shape), spread);
}

double error_of_directions(const Draft& draft, int directions) {
  const double measured = measured_error_of_directions(draft, directions);
  return measured + draft.error_of_reference(directions, measured);
}

[[noreturn]] void refuse(const Draft& draft, double least) {
  constexpr double kRate = 0.75;  // at which most samplers converge
  const double needed = std::ceil(draft.asked.directions * std::pow(1.1 * least / draft.options.error, 1.0 / kRate));
  throw std::invalid_argument(fmt::format(
      "error {:.3g}: cannot be met: {} directions alone give {:.3g} (measured); expected {:.3g} or more, or {} "
      "directions",
      draft.options.error, draft.asked.directions, least, 1.1 * least,
      needed <= static_cast<double>(kMaxDirections) ? fmt::format("about {:.0f}", needed) : "no number of"));
}

}  // namespace

int fewest_directions(const std::function<double(int directions)>& error_along, int asked, double limit) {
  int few = 0;
  double more = 0.0;  // the error of `few`
  int many = std::min(kFewest, asked);
  double less = error_along(many);
  while (less > limit && many < asked) {
    few = many;
    more = less;
    many = std::min(2 * many, asked);
    less = error_along(many);
  }
  if (few == 0 || less > limit) return many;
  const double place = std::log(more / limit) / std::log(more / less);
  for (const double at : {place, 0.5 * (1.0 + place)}) {
    const double between = few * std::pow(static_cast<double>(many) / few, at);
    const int rounded = static_cast<int>(std::ceil(between / kUnit)) * kUnit;
    if (rounded >= many) break;
    if (error_along(rounded) <= limit) return rounded;
  }
  return many;
}

void decide_bounces(Draft& draft) {
  constexpr double kPart = 0.25;
  BakeOptions without = draft.measurement->reference_options(draft.asked);
  without.kind = draft.bake.kind->without_bounces;
  std::vector<float> rows = draft.measurement->rows(without);
  const double returned = difference(draft, radiances_of(draft, rows, without.kind->shape(draft.asked.degree)),
                                     radiances_of(draft, draft.many, draft.traced_shape()));
  if (draft.shines() || draft.has_mirrors() || returned > draft.share(kPart)) {
    loosen_tolerance(draft, returned);
    return;
  }
  draft.bake.kind = without.kind;
  draft.many = std::move(rows);
  draft.decide("bounces", fmt::format("none: {} instead of {}", without.kind->word, draft.asked.kind->word),
               "this little light comes back", returned, "measured");
}

// Walks from few rows and all columns to all rows and few columns, along the border of what the budget allows.
void decide_matrices(Draft& draft) {
  constexpr double kPart = 0.3;
  const RowShape rows = draft.row_shape();
  if (!rows.matrices) return draft.decide("matrices", "none", "without bounces there are none");
  const int degree = draft.bake.degree;
  const auto size = [&](const KeptBands& kept) { return rows.with(kept).matrices->count(); };
  KeptBands next = draft.bake.keep;
  std::tie(next.result, next.light) = std::pair(0, degree);
  KeptBands best = draft.bake.keep;
  double error = 0.0;
  double least = 0.0;  // error of those that the budget does not allow
  while (next.result <= degree && next.light >= 0) {
    const bool is_whole = next.result == degree && next.light == degree;
    const double measured = is_whole ? 0.0 : measured_error_of(draft, rows.with(next));
    if (measured > draft.share(kPart)) {
      least = least > 0.0 ? std::min(least, measured) : measured;
      ++next.result;
      continue;
    }
    if (std::pair(size(next), measured) < std::pair(size(best), error))
      std::tie(best, error) = std::pair(next, measured);
    --next.light;
  }
  if (best == draft.bake.keep) {
    return draft.decide("matrices", fmt::format("{0} x {0} as the degree needs", rows.matrices->rows()),
                        degree > 0 ? fmt::format("with fewer the error would be {:.2g} or more", least)
                                   : std::string("they have one number a channel"));
  }
  draft.bake.keep = best;
  const TransferShape some = *rows.with(best).matrices;
  draft.decide("matrices",
               fmt::format("{} x {} instead of {} x {}", some.rows(), some.columns(), rows.matrices->rows(),
                           rows.matrices->columns()),
               fmt::format("degree {} of what returns, {} of the light: what the other bands add", some.result_degree,
                           some.degree),
               error, "measured");
}

void decide_visibility(Draft& draft) {
  constexpr double kPart = 0.2;
  const RowShape rows = draft.row_shape();
  const int whole = rows.numbers.function_degree();
  KeptBands kept = draft.bake.keep;
  double error = 0.0;
  for (kept.visibility = 0; kept.visibility < whole; ++kept.visibility) {
    error = measured_error_of(draft, rows.with(kept));
    if (error > draft.share(kPart)) continue;
    draft.bake.keep = kept;
    return draft.decide(
        "visibility", fmt::format("{} of {} numbers", coefficient_count(kept.visibility), rows.numbers.count()),
        fmt::format("degree {}: what its bands {} to {} add", kept.visibility, kept.visibility + 1, whole), error,
        "measured");
  }
  draft.decide("visibility", fmt::format("all {} numbers", rows.numbers.count()),
               whole > 0 ? fmt::format("without band {} the error would be {:.2g}", whole, error)
                         : std::string("there is one band"));
}

void decide_bands(Draft& draft) {
  constexpr double kPart = 0.4;
  const int asked = draft.bake.degree;
  for (int degree = 0; degree < asked; ++degree) {
    const double bound = bound_above(draft, degree);
    const double measured = measured_above(draft, degree);
    const double error = std::min(bound, measured);
    if (error <= draft.share(kPart)) {
      draft.many = many_at(draft, degree);
      draft.bake.degree = degree;
      draft.decide(
          "bands", fmt::format("degree {} instead of {}", degree, asked),
          fmt::format("what bands {} to {} add, lights turned: {}{}", degree + 1, asked, name_of(draft.options.turns),
                      std::isinf(bound) ? "" : fmt::format(" (at most, for any visibility: {:.2g})", bound)),
          error, bound <= measured ? "bound" : "measured");
      return;
    }
  }
  draft.decide(
      "bands", fmt::format("degree {} as requested", asked),
      fmt::format("without band {} the error would be {:.2g}", asked,
                  asked > 0 ? std::min(bound_above(draft, asked - 1), measured_above(draft, asked - 1)) : 1.0));
}

double measured_error_of(const Draft& draft, const RowShape& stored) {
  const RowShape plain = draft.row_shape();
  const Measurement& measurement = *draft.measurement;
  return difference(draft, radiances_of(draft, measurement.kept(draft.many, stored), stored),
                    radiances_of(draft, measurement.kept(draft.many, plain), plain));
}

double measured_error_of(const Draft& draft, Element element) {
  RowShape stored = draft.row_shape();
  stored.numbers.storage.element = element;
  return measured_error_of(draft, stored);
}

double floor_of_directions(Draft& draft) {
  const int asked = draft.bake.directions;
  const double measured = measured_error_of_directions(draft, asked);
  draft.unconverged = draft.error_of_reference(asked, measured);
  const double floor = measured + draft.unconverged;
  if (floor > draft.left) refuse(draft, floor);
  return floor;
}

// Fewer directions for bounces make errors that more directions for shadows balance. What both cost together decides.
void decide_hits(Draft& draft) {
  // Of a direction's hits in all bounces, over the rays of a direction. Lobes meet a matrix at each corner of a hit.
  const double bounce_cost = draft.bake.kind->stores_matrices() ? 100.0 : 6.0;
  const int asked = draft.bake.directions;
  const auto as_asked = [&](const char* why) {
    draft.bounce_part = 1;
    draft.decide("hits",
                 draft.bake.fewer_for_bounces() > 0
                     ? fmt::format("of {} directions as requested", draft.bake.bounces.directions)
                     : std::string("of all directions"),
                 why);
  };
  if (!draft.bake.kind->has_bounces()) {
    return draft.decide("hits", "none", "without bounces there are none");
  }
  if (draft.shines()) return as_asked("the measurement does not see the light of surfaces");
  const double hits = bounce_cost * draft.blocked();
  int best = 1;
  double least = 0.0;
  for (const int part : {1, 4, 8}) {
    draft.bounce_part = part;
    const int directions = draft.allows("directions") ? draft.fewest_directions_within_limit() : asked;
    const int fewer = draft.along(directions).fewer_for_bounces();
    if (part > 1 && (fewer == 0 || draft.error_along(directions) > draft.options.error)) continue;
    const double cost = directions + hits * (fewer > 0 ? fewer : directions);
    if (part == 1 || cost < least) std::tie(best, least) = std::pair(part, cost);
  }
  if (best == 1) return as_asked("fewer would need more directions for shadows, and save less");
  draft.bounce_part = 1;
  const double without = draft.error_along(asked);
  draft.bounce_part = best;
  draft.bake.bounces.directions = draft.bounces_along(asked);
  draft.decide("hits", fmt::format("of one direction in {}", best),
               "light that bounces is smooth; the error of all decisions together stays within the limit",
               std::max(0.0, draft.error_along(asked) - without), "measured");
}

void decide_directions(Draft& draft) {
  const int asked = draft.bake.directions;
  draft.bake.directions = draft.fewest_directions_within_limit();
  if (draft.bounce_part > 1) draft.bake.bounces.directions = draft.bounces_along(draft.bake.directions);
  const bool fewer = draft.bake.directions < asked;
  draft.decide(
      "directions",
      fewer ? fmt::format("{} instead of {}", draft.bake.directions, asked) : fmt::format("{} as requested", asked),
      fmt::format("the error of all decisions together stays within the limit, against {} directions",
                  draft.measurement->reference_options(draft.asked).directions),
      error_of_directions(draft, draft.bake.directions), "measured");
}

void state_error(Draft& draft) {
  const std::vector<Decision>& all = draft.plan.record.decisions;
  const bool measured =
      std::any_of(all.begin(), all.end(), [](const Decision& decision) { return decision.basis == "measured"; });
  if (!measured) return;
  const double error = draft.error_along(draft.bake.directions);
  if (error > draft.options.error) refuse(draft, error);
  draft.plan.record.error = error;
  const Measurement& measurement = *draft.measurement;
  draft.plan.known_by = fmt::format("measured, {} % confidence: {} of {} vertices, {} turn{} of the lights",
                                    Probe::kConfidence, measurement.probe().vertices.size(), draft.starts.size(),
                                    measurement.turns(), measurement.turns() == 1 ? "" : "s");
}

}  // namespace sh::prt
