// See candidates.hpp.
#include "numeric/identify/candidates.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "numeric/identify/identify.hpp"
#include "numeric/oracle/basis.hpp"
#include "numeric/sampling/error_stats.hpp"

namespace sh::numeric::identify {
namespace {

using Complex = std::complex<double>;

// A column as a multiple of one function of size 1: v = scale * g + rest.
struct Fit {
  Complex scale;
  double rest = 0;     // largest, in units of the band's maximum
  double largest = 0;  // largest |v|
};

// The orthonormal functions at the directions, for one choice of axes.
class Functions {
 public:
  Functions(const Samples& samples, const Axes& axes) : rows_(samples.directions.size()) {
    values_.assign(coefficient_count(samples.degree), std::vector<double>(rows_));
    std::vector<double> all(values_.size());
    for (std::size_t row = 0; row < rows_; ++row) {
      const auto d = axes.apply(samples.directions[row]);
      basis(samples.degree, d[0], d[1], d[2], all.data());
      for (std::size_t i = 0; i < all.size(); ++i) values_[i][row] = all[i];
    }
  }

  [[nodiscard]] Fit fit(const std::vector<Complex>& column, const Function& f, bool complex) const {
    const auto& cosine = of(f.degree, complex ? std::abs(f.order) : f.order);
    const bool has_sine = complex && f.order != 0;
    const auto& sine = of(f.degree, has_sine ? -std::abs(f.order) : f.order);
    const double size = has_sine ? std::numbers::sqrt2 / 2 : 1;
    const double sign = f.order < 0 ? -size : size;
    const auto g = [&](std::size_t row) { return Complex(size * cosine[row], has_sine ? sign * sine[row] : 0); };
    Complex product = 0;
    double square = 0;
    for (std::size_t row = 0; row < rows_; ++row) {
      product += std::conj(g(row)) * column[row];
      square += std::norm(g(row));
    }
    Fit result{product / square, 0, 0};
    for (std::size_t row = 0; row < rows_; ++row) {
      result.rest = std::max(result.rest, std::norm(column[row] - result.scale * g(row)));
    }
    result.rest = std::sqrt(result.rest) / band_maximum(f.degree);
    return result;
  }

 private:
  [[nodiscard]] const std::vector<double>& of(int l, int m) const { return values_[coefficient_index(l, m)]; }

  std::size_t rows_;
  std::vector<std::vector<double>> values_;  // [function][row]
};

std::vector<IndexOrder> orders_of(const Samples& samples) {
  if (samples.is_array) return {IndexOrder::kCosineSineArray};
  return {IndexOrder::kAcn, IndexOrder::kZeroFirst, IndexOrder::kCosineSineBands};
}

// Sizes, phases and folded factors that a kind of functions may have.
std::vector<Convention> scalings(bool complex) {
  using enum Normalisation;
  std::vector<Convention> all;
  for (const auto normalisation : {kOrthonormal, kFourPi, kSchmidt, kSn3d, kUnnormalised, kPrimitive}) {
    if (complex && (normalisation == kUnnormalised || normalisation == kPrimitive)) continue;
    for (const auto folded : {Folded::kNothing, Folded::kCosineOverPi, Folded::kCosine}) {
      for (const bool phase : {false, true}) {
        Convention convention;
        convention.normalisation = normalisation;
        convention.folded = folded;
        convention.condon_shortley = phase;
        convention.complex = complex;
        all.push_back(convention);
      }
    }
  }
  return all;
}

int rank_of(const Convention& convention) {
  if (!own_presets(convention).empty()) return 0;
  if (!world_presets(convention).empty()) return 1;
  if (convention.axes == Axes{}) return 2;
  return convention.axes.determinant() > 0 ? 3 : 4;
}

// Rounds so that noise does not decide between equals.
double coarse(double penalty) { return std::round(penalty * 1e3); }

class Search {
 public:
  explicit Search(const Samples& samples) : samples_(samples) {
    for (const auto& column : samples.columns) {
      double square = 0;
      for (const Complex& v : column) {
        square = std::max(square, std::norm(v));
        complex_ = complex_ || v.imag() != 0;
      }
      largest_.push_back(std::sqrt(square));
    }
    zero_ = *std::max_element(largest_.begin(), largest_.end()) * 1e-6;
    real_ = !complex_;
    complex_ = complex_ || samples.degree == 0;  // the one function of degree 0 is real in any case
  }

  [[nodiscard]] std::vector<Candidate> run() const {
    std::vector<Candidate> all;
    for (const Axes& axes : all_axes()) {
      const Functions functions(samples_, axes);
      for (const IndexOrder order : orders_of(samples_)) {
        if (real_) add(functions, axes, order, false, all);
        if (complex_) add(functions, axes, order, true, all);
      }
    }
    std::stable_sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) {
      return std::tuple(a.wrong, coarse(a.penalty), a.rank) < std::tuple(b.wrong, coarse(b.penalty), b.rank);
    });
    return all;
  }

 private:
  void add(const Functions& functions, const Axes& axes, IndexOrder order, bool complex,
           std::vector<Candidate>& all) const {
    const auto places = functions_in_order(order, samples_.degree);
    std::vector<Fit> fits(places.size());
    for (std::size_t j = 0; j < places.size(); ++j) {
      if (!places[j].is_hole()) fits[j] = functions.fit(samples_.columns[j], places[j], complex);
      fits[j].largest = largest_[j];
    }
    for (Convention convention : scalings(complex)) {
      convention.axes = axes;
      convention.order = order;
      all.push_back(judge(convention, places, fits));
    }
  }

  [[nodiscard]] Candidate judge(const Convention& convention, const std::vector<Function>& places,
                                const std::vector<Fit>& fits) const {
    Candidate candidate{convention, 0, 0, rank_of(convention)};
    for (std::size_t j = 0; j < places.size(); ++j) {
      const double size = places[j].is_hole() ? 0 : size_of(convention, places[j]);
      const Fit& fit = fits[j];
      const double deviation = std::abs(fit.scale - size) + fit.rest;
      if (size == 0 ? fit.largest <= zero_ : deviation <= kRounded * std::abs(size)) continue;
      ++candidate.wrong;
      candidate.penalty += penalty_of(fit, size);
    }
    return candidate;
  }

  static double penalty_of(const Fit& fit, double size) {
    constexpr double kMost = 10;
    const double scale = std::abs(fit.scale);
    if (size == 0 || scale == 0) return kMost;
    return std::min(kMost, std::abs(std::log(scale / std::abs(size)))) + (fit.rest > kRounded * scale ? 1 : 0);
  }

  static double size_of(const Convention& convention, const Function& f) {
    return static_cast<double>(relative_size(convention, f.degree, f.order));
  }

  const Samples& samples_;
  std::vector<double> largest_;  // [column]
  double zero_ = 0;              // what counts as zero
  bool real_ = true;             // kinds of functions that the values may be
  bool complex_ = false;
};

bool same_but_axes(Convention convention, const Preset& preset) {
  convention.axes = preset.convention.axes;
  return convention == preset.convention;
}

}  // namespace

std::vector<std::string> own_presets(const Convention& convention) {
  std::vector<std::string> names;
  for (const Preset& preset : presets()) {
    if (convention == preset.convention) names.push_back(preset.name);
  }
  return names;
}

std::vector<std::string> world_presets(const Convention& convention) {
  std::vector<std::string> names;
  for (const Preset& preset : presets()) {
    const bool differs = preset.world != preset.convention.axes;
    if (differs && convention.axes == preset.world && same_but_axes(convention, preset)) names.push_back(preset.name);
  }
  return names;
}

std::vector<Candidate> ranked_candidates(const Samples& samples) { return Search(samples).run(); }

}  // namespace sh::numeric::identify
