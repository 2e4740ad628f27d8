// See identify.hpp.
#include "numeric/identify/identify.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <tuple>

#include "numeric/oracle/basis.hpp"
#include "numeric/sampling/error_stats.hpp"

namespace sh::numeric::identify {
namespace {

using Complex = std::complex<double>;

// The unit of a column's deviations: the function's size or, where the function should be zero, the table's largest
// value.
double unit_of(const Samples& samples, const Convention& convention, const Function& f) {
  const double size = f.is_hole() ? 0 : std::abs(static_cast<double>(relative_size(convention, f.degree, f.order)));
  if (size > 0) return size * band_maximum(f.degree);
  double largest = 1e-300;
  for (const auto& column : samples.columns) {
    for (const Complex& v : column) largest = std::max(largest, std::abs(v));
  }
  return largest;
}

Coefficient measure(const Samples& samples, const Columns& expected, std::size_t j, const Function& f, double unit) {
  Coefficient c;
  c.index = static_cast<int>(j);
  c.function = f;
  const auto& column = samples.columns[j];
  Complex product = 0;
  double square = 0;
  for (std::size_t row = 0; row < column.size(); ++row) {
    product += std::conj(expected[j][row]) * column[row];
    square += std::norm(expected[j][row]);
  }
  if (square > 0) c.ratio = product / square;
  for (std::size_t row = 0; row < column.size(); ++row) {
    const double deviation = std::abs(column[row] - expected[j][row]) / unit;
    c.shape = std::max(c.shape, std::abs(column[row] - c.ratio * expected[j][row]) / unit);
    if (row > 0 && deviation <= c.deviation) continue;
    c.deviation = deviation;
    c.worst_row = row;
    c.found = column[row];
    c.expected = expected[j][row];
  }
  return c;
}

// The deviation that half of the coefficients do not exceed.
double median_deviation(const std::vector<Coefficient>& coefficients) {
  std::vector<double> all;
  for (const auto& c : coefficients) {
    if (!c.function.is_hole()) all.push_back(c.deviation);
  }
  const auto middle = all.begin() + static_cast<std::ptrdiff_t>((all.size() - 1) / 2);
  std::nth_element(all.begin(), middle, all.end());
  return *middle;
}

std::vector<Coefficient> compare(const Samples& samples, const Convention& convention, double noise) {
  constexpr double kStandsOut = 100;
  const auto expected = expected_columns(samples, convention);
  const auto functions = functions_in_order(convention.order, samples.degree);
  std::vector<Coefficient> all;
  std::vector<double> units;
  for (std::size_t j = 0; j < functions.size(); ++j) {
    units.push_back(unit_of(samples, convention, functions[j]));
    all.push_back(measure(samples, expected, j, functions[j], units.back()));
  }
  const double outlier = std::max(kOutlier, kStandsOut * median_deviation(all));
  for (Coefficient& c : all) {
    const bool is_zero = c.ratio == Complex(0) && c.expected == Complex(0);
    if (!is_zero) c.reason = rounding_of(convention, c);
    const double allowed = kNoiseAllowance * noise / units[static_cast<std::size_t>(c.index)];
    const double deviation = c.deviation - allowed;
    c.wrong = deviation > (is_zero ? 1e-6 : kRounded) || (deviation > outlier && c.reason.empty());
    if (c.wrong) c.reason = reason_of(samples, convention, expected, c, noise);
  }
  return all;
}

bool is_wrong(const Coefficient& c) { return c.wrong; }

std::vector<int> wrong_ones(const std::vector<Coefficient>& coefficients) {
  std::vector<int> wrong;
  for (const auto& c : coefficients) {
    if (c.wrong) wrong.push_back(c.index);
  }
  return wrong;
}

// The presets nearest to data of degree 0 or 1 that none of them fits.
std::vector<Doubt> doubts_of(const Samples& samples, const std::vector<Candidate>& candidates, double noise) {
  const auto is_preset = [](const Candidate& c) { return c.rank == 0; };
  const auto nearest = std::find_if(candidates.begin(), candidates.end(), is_preset);
  const int functions = coefficient_count(samples.degree);
  std::vector<Doubt> doubts;
  for (auto c = nearest; c != candidates.end() && c->wrong == nearest->wrong; ++c) {
    if (!is_preset(*c) || c->wrong > 2 || c->wrong >= functions) continue;
    Doubt doubt{c->reading, compare(samples, c->reading.convention, noise)};
    std::erase_if(doubt.wrong, std::not_fn(is_wrong));
    const bool swapped = doubt.wrong.front().reason.starts_with("swapped");
    if (doubt.wrong.size() == 1 || swapped) doubts.push_back(std::move(doubt));
  }
  return doubts;
}

// The answer for a table as it is.
Identification directly(const Samples& samples, double noise) {
  const auto candidates = ranked_candidates(samples, noise);
  const Candidate& best = candidates.front();
  Identification result{samples, {}, compare(samples, best.reading.convention, noise), {}};
  result.noise = noise;
  const auto wrong = wrong_ones(result.coefficients);
  for (const Candidate& c : candidates) {
    if (c.wrong != best.wrong) break;
    const bool equal = best.wrong == 0 || wrong_ones(compare(samples, c.reading.convention, noise)) == wrong;
    if (std::abs(c.penalty - best.penalty) < 1e-3 && equal) result.readings.push_back(c.reading);
  }
  if (samples.degree <= 1 && best.wrong == 0 && best.rank > 1) result.doubts = doubts_of(samples, candidates, noise);
  return result;
}

bool explains_half(const Identification& result) {
  const auto is_function = [](const Coefficient& c) { return !c.function.is_hole(); };
  const auto functions = std::count_if(result.coefficients.begin(), result.coefficients.end(), is_function);
  return 2 * static_cast<std::ptrdiff_t>(wrong_ones(result.coefficients).size()) < functions;
}

// A mirrored complex convention is more likely a preset's conjugate.
bool may_be_conjugated(const Identification& result) {
  const Reading& reading = result.readings.front();
  return reading.convention.complex && reading.convention.axes.determinant() < 0 && reading.presets.empty();
}

// The table with a mistake undone, if it fits a convention then.
std::optional<Identification> without_mistake(const Samples& samples, bool preset) {
  for (const Undone& undone : undone_mistakes(samples)) {
    Identification result = directly(undone.samples, consistency_of(undone.samples).noise);
    if (!result.fits() || (preset && result.readings.front().presets.empty())) continue;
    result.mistake = undone.mistake;
    return result;
  }
  return std::nullopt;
}

Identification identify_one(const Samples& samples) {
  const Consistency consistency = consistency_of(samples);
  Identification result = directly(samples, consistency.bad_rows.empty() ? consistency.noise : 0);
  if (result.fits() && !may_be_conjugated(result)) return result;
  if (!explains_half(result) && !consistency.bad_rows.empty()) {
    Identification rest = directly(without_rows(samples, consistency.bad_rows), consistency.noise);
    for (const std::size_t row : consistency.bad_rows) rest.bad_lines.push_back(samples.lines[row]);
    std::sort(rest.bad_lines.begin(), rest.bad_lines.end());
    if (rest.fits()) return rest;
  }
  // Two wrong coefficients may be swapped.
  const bool fits = result.fits();
  if (fits || wrong_ones(result.coefficients).size() > 2) {
    if (auto undone = without_mistake(samples, fits)) return *undone;
  }
  return result;
}

}  // namespace

bool Identification::fits() const { return std::none_of(coefficients.begin(), coefficients.end(), is_wrong); }

const Coefficient* Identification::first_wrong() const {
  if (!doubts.empty()) return &doubts.front().wrong.front();
  const auto first = std::find_if(coefficients.begin(), coefficients.end(), is_wrong);
  return first == coefficients.end() ? nullptr : &*first;
}

double Identification::digits() const {
  double worst = 1e-17;
  for (const auto& c : coefficients) {
    if (!c.wrong) worst = std::max(worst, c.deviation);
  }
  return -std::log10(worst);
}

Identification identify(const std::vector<Samples>& ways) {
  std::vector<Identification> results;
  for (const Samples& way : ways) results.push_back(identify_one(way));
  const auto rank = [](const Identification& result) {
    return std::tuple(wrong_ones(result.coefficients).size(), result.bad_lines.size(), !result.mistake.empty());
  };
  return *std::min_element(results.begin(), results.end(),
                           [&](const Identification& a, const Identification& b) { return rank(a) < rank(b); });
}

}  // namespace sh::numeric::identify
