#include "symbolic/errata/blanco_recurrence.hpp"

#include <cstdlib>

#include "symbolic/errata/exact_rotation.hpp"
#include "symbolic/errata/exact_tools.hpp"

namespace sh::symbolic::errata {
namespace {

using Rational = cln::cl_RA;
using Band = Matrix<RadicalSum>;

Rational d_11(const Rational& cos_b) { return (1 + cos_b) / 2; }
Rational d_1_minus_1(const Rational& cos_b) { return (1 - cos_b) / 2; }

// Eqs. 67 (row l) and 68 (row l-1) from m = row to m = 1 - row.
std::optional<std::vector<RadicalSum>> row_down(int l, int row, const Rational& cos_b, const RadicalSum& corner) {
  std::vector<RadicalSum> values(to_size(2 * row + 1));
  values.back() = corner;
  for (int m = row; m > -row; --m) {
    const Rational below = row == l ? Rational(1) : l * cos_b - m;
    if (zerop(d_11(cos_b)) || zerop(below)) return std::nullopt;
    const Rational quotient = row == l ? Rational(1) : (l * cos_b - m + 1) / below;
    const RadicalSum tangent = root(d_1_minus_1(cos_b) / d_11(cos_b));
    values[to_size(row + m - 1)] =
        scaled(-quotient, root(ratio(l + m, l - m + 1)) * tangent * values[to_size(row + m)]);
  }
  return values;
}

RadicalSum inner_entry(int l, int m1, int m, const Rational& cos_b, const Band& below, const Band& below2) {
  const RadicalSum outer = scaled(Rational(l * (2 * l - 1)), root(Rational(1) / ((l * l - m * m) * (l * l - m1 * m1))));
  const int k = (l - 1) * (l - 1);
  const RadicalSum inner = scaled(ratio(1, (l - 1) * (2 * l - 1)), root((k - m * m) * (k - m1 * m1)));
  return outer * (scaled(cos_b - ratio(m * m1, l * (l - 1)), entry_or_zero(below, m1, m)) -
                  inner * entry_or_zero(below2, m1, m));
}

// A band that fills up: entries as they become known, the rest by the symmetries 38.
class Filling {
 public:
  explicit Filling(int l) : l_(l), band_(2 * l + 1, 2 * l + 1), known_(2 * l + 1, 2 * l + 1) {}
  void set(int m1, int m, const RadicalSum& value) {
    band_(l_ + m1, l_ + m) = value;
    known_(l_ + m1, l_ + m) = 1;
  }
  /// d_{m'm} = (-1)^(m'-m) d_{mm'} = d_{-m,-m'} = (-1)^(m'-m) d_{-m',-m}, from whichever is known.
  [[nodiscard]] Band completed() const {
    Band result = band_;
    for (int m1 = -l_; m1 <= l_; ++m1) {
      for (int m = -l_; m <= l_; ++m) {
        if (!known(m1, m)) result(l_ + m1, l_ + m) = mirrored(m1, m);
      }
    }
    return result;
  }

 private:
  [[nodiscard]] bool known(int m1, int m) const { return known_(l_ + m1, l_ + m) != 0; }
  [[nodiscard]] RadicalSum mirrored(int m1, int m) const {
    const Rational sign = parity(m1 - m);
    if (known(m, m1)) return scaled(sign, band_(l_ + m, l_ + m1));
    if (known(-m, -m1)) return band_(l_ - m, l_ - m1);
    return scaled(sign, band_(l_ - m1, l_ - m));
  }
  int l_;
  Band band_;
  Matrix<int> known_;
};

Band start_band(const CosSin<Rational>& b) {  // eqs. 49-52
  Filling band(1);
  band.set(0, 0, RadicalSum(b.cosine));
  band.set(1, -1, RadicalSum(d_1_minus_1(b.cosine)));
  band.set(1, 0, scaled(-b.sine, root(ratio(1, 2))));
  band.set(1, 1, RadicalSum(d_11(b.cosine)));
  return band.completed();
}

std::optional<Band> next_band(int l, const Rational& cos_b, const Band& below, const Band& below2) {
  const RadicalSum corner = entry_or_zero(below, l - 1, l - 1);
  const auto top = blanco_top_row(l, cos_b, scaled(d_11(cos_b), corner));                // eq. 65
  const auto second = blanco_second_row(l, cos_b, scaled(l * cos_b - (l - 1), corner));  // eq. 66
  if (!top || !second) return std::nullopt;
  Filling band(l);
  for (int m1 = 2 - l; m1 <= l - 2; ++m1) {
    for (int m = 2 - l; m <= l - 2; ++m) band.set(m1, m, inner_entry(l, m1, m, cos_b, below, below2));
  }
  for (int m = -l; m <= l; ++m) band.set(l, m, (*top)[to_size(l + m)]);
  for (int m = 1 - l; m < l; ++m) band.set(l - 1, m, (*second)[to_size(l - 1 + m)]);
  return band.completed();
}

}  // namespace

std::optional<std::vector<RadicalSum>> blanco_top_row(int l, const Rational& cos_b, const RadicalSum& corner) {
  return row_down(l, l, cos_b, corner);
}

std::optional<std::vector<RadicalSum>> blanco_second_row(int l, const Rational& cos_b, const RadicalSum& corner) {
  return row_down(l, l - 1, cos_b, corner);
}

std::optional<std::vector<Band>> blanco_bands(int degree, const CosSin<Rational>& b) {
  std::vector<Band> bands{Band::identity(1, RadicalSum(Rational(1))), start_band(b)};
  for (int l = 2; l <= degree; ++l) {
    const std::optional<Band> next = next_band(l, b.cosine, bands[to_size(l - 1)], bands[to_size(l - 2)]);
    if (!next) return std::nullopt;
    bands.push_back(*next);
  }
  return bands;
}

}  // namespace sh::symbolic::errata
