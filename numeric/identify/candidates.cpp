// Every convention, ranked by the number of columns that it does not explain; see identify.hpp.
#include <Eigen/Core>
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
  Functions(const Samples& samples, const Axes& axes)
      : values_(coefficient_count(samples.degree), samples.directions.size()) {
    for (Eigen::Index row = 0; row < values_.cols(); ++row) {
      const auto d = axes.apply(samples.directions[row]);
      basis(samples.degree, d[0], d[1], d[2], values_.col(row).data());
    }
  }

  [[nodiscard]] Fit fit(const std::vector<Complex>& values, const Function& f, bool complex) const {
    const Eigen::Map<const Eigen::RowVectorXcd> column(values.data(), values_.cols());
    const int m = complex ? std::abs(f.order) : f.order;
    Eigen::RowVectorXcd g = values_.row(coefficient_index(f.degree, m)).cast<Complex>();
    if (complex && m != 0) {
      const Complex i(0, f.order < 0 ? -1 : 1);
      g = (g + i * values_.row(coefficient_index(f.degree, -m))) / std::numbers::sqrt2;
    }
    const Complex scale = g.dot(column) / g.squaredNorm();
    return {scale, (column - scale * g).cwiseAbs().maxCoeff() / band_maximum(f.degree), 0};
  }

 private:
  Eigen::MatrixXd values_;  // (functions, directions)
};

}  // namespace

std::vector<IndexOrder> orders_of(const Samples& samples) {
  if (samples.is_array) return {IndexOrder::kCosineSineArray};
  std::vector<IndexOrder> orders{IndexOrder::kAcn, IndexOrder::kZeroFirst, IndexOrder::kCosineSineBands};
  if (samples.degree <= largest_degree({.normalization = Normalization::kFuMa})) orders.push_back(IndexOrder::kFuMa);
  return orders;
}

namespace {

bool normalization_is_real(Normalization normalization) {
  return normalization == Normalization::kUnnormalized || normalization == Normalization::kPrimitive ||
         normalization == Normalization::kFuMa;
}

// Sizes, phases and folded factors that a kind of functions may have.
std::vector<Convention> scalings(bool complex) {
  using enum Normalization;
  std::vector<Convention> all;
  for (const auto normalization : {kOrthonormal, kFourPi, kSchmidt, kSn3d, kUnnormalized, kPrimitive, kFuMa}) {
    if (complex && normalization_is_real(normalization)) continue;
    for (const auto folded : {Folded::kNothing, Folded::kCosineOverPi, Folded::kCosine}) {
      for (const bool phase : {false, true}) {
        all.push_back({.normalization = normalization, .condon_shortley = phase, .complex = complex, .folded = folded});
      }
    }
  }
  return all;
}

PresetNames names_of(const Convention& convention) {
  const auto same = [&](Convention preset) {
    preset.axes = convention.axes;
    return convention == preset;
  };
  return preset_names(convention.axes, same, std::equal_to<>());
}

int rank_of(const Reading& reading) {
  if (!reading.presets.own.empty()) return 0;
  if (!reading.presets.world.empty()) return 1;
  if (reading.convention.axes == Axes{}) return 2;
  return reading.convention.axes.determinant() > 0 ? 3 : 4;
}

// Rounds so that noise does not decide between equals.
double coarse(double penalty) { return std::round(penalty * 1e3); }

class Search {
 public:
  Search(const Samples& samples, double noise) : samples_(samples), noise_(noise) {
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
      // The format defines weights and order together.
      if ((convention.normalization == Normalization::kFuMa) != (order == IndexOrder::kFuMa)) continue;
      convention.axes = axes;
      convention.order = order;
      all.push_back(judge(convention, places, fits));
    }
  }

  [[nodiscard]] Candidate judge(const Convention& convention, const std::vector<Function>& places,
                                const std::vector<Fit>& fits) const {
    Candidate candidate{{convention, names_of(convention)}};
    candidate.rank = rank_of(candidate.reading);
    for (std::size_t j = 0; j < places.size(); ++j) {
      const Function& f = places[j];
      const auto size = f.is_hole() ? 0 : static_cast<double>(relative_size(convention, f.degree, f.order));
      const double noise = kNoiseAllowance * noise_;
      const double deviation = std::abs(fits[j].scale - size) + fits[j].rest;
      const bool is_right = size == 0 ? fits[j].largest <= std::max(zero_, noise)
                                      : deviation <= kRounded * std::abs(size) + noise / band_maximum(f.degree);
      if (is_right) continue;
      ++candidate.wrong;
      candidate.penalty += penalty_of(fits[j], size);
    }
    return candidate;
  }

  static double penalty_of(const Fit& fit, double size) {
    constexpr double kMost = 10;
    const double scale = std::abs(fit.scale);
    if (size == 0 || scale == 0) return kMost;
    return std::min(kMost, std::abs(std::log(scale / std::abs(size)))) + (fit.rest > kRounded * scale ? 1 : 0);
  }

  const Samples& samples_;
  double noise_;                 // standard deviation of the values
  std::vector<double> largest_;  // [column]
  double zero_ = 0;              // values up to this count as zero
  bool real_ = true;             // kinds of functions that the values may be
  bool complex_ = false;
};

}  // namespace

std::vector<Candidate> ranked_candidates(const Samples& samples, double noise) { return Search(samples, noise).run(); }

}  // namespace sh::numeric::identify
