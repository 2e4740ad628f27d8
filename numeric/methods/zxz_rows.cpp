// See zxz_rows.hpp.
#include "numeric/methods/zxz_rows.hpp"

#include <algorithm>
#include <array>
#include <type_traits>

#include "numeric/methods/row_sums.hpp"
#include "numeric/methods/turns.hpp"
#include "numeric/oracle/instances.hpp"
#include "numeric/oracle/require.hpp"

namespace sh::numeric::methods {

#if defined(SH_ROWS_X86)
namespace avx2 {
void add_rows(const RowSums<double>& sums);
}
namespace avx512 {
void add_rows(const RowSums<double>& sums);
}
#endif

namespace {

using AddRows = void (*)(const RowSums<double>&);

// The copy of the loop for the widest instruction set of this machine.
AddRows widest() {
#if defined(SH_ROWS_X86)
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl")) {
    return avx512::add_rows;
  }
  if (__builtin_cpu_supports("avx2")) return avx2::add_rows;
#endif
  return baseline::add_rows;
}

// D(S) of one band after the other, from degree 0 up. Rows and columns are counted from l down: place k is order l - k.
template <class Real>
class Swap {
 public:
  explicit Swap(int degree) {
    using std::sqrt;
    const int size = degree + 1;
    for (int n = 0; n < 2 * size; ++n) {
      roots_.push_back(sqrt(static_cast<Real>(n)));
      inverse_roots_.push_back(n == 0 ? Real(0) : Real(1 / roots_.back()));
    }
    const long unscaled = kLargestRowsDegree<Real> / 2;
    half_shift_ = degree > unscaled ? (degree - static_cast<int>(unscaled) + 1) / 2 : 0;
    down_ = times_power_of_two(Real(1), -half_shift_);
    top_.resize(size);
    for (auto* values : {&gauge_, &slope_, &weight_[0], &weight_[1]}) values->resize(size + kRowsAtOnce);
    for (Columns& columns : columns_) {
      for (auto* values : {&columns.order, &columns.top, &columns.row, &columns.above, &columns.cosine, &columns.sine})
        values->resize(size / 2 + 1);
    }
    gauge_[0] = 1;
    next_top(0);
    fill_columns();
  }

  // To the next band.
  void next() {
    ++l_;
    next_top(l_);
    next_gauge();
    fill_columns();
  }

  // band = D(S) band, (2l+1) at order 0.
  void apply(Real* band) {
    for (int k = 0; k <= l_; ++k) {
      weight_[0][k] = gauge_[k] * band[l_ - k] * down_;
      weight_[1][k] = gauge_[k] * band[k - l_] * down_;
    }
    weight_[1][l_] = 0;                               // there is no order -0
    if (l_ > 0) weight_[0][l_] *= inverse_roots_[2];  // normalization of order 0
    const int rows = (l_ / kRowsAtOnce + 1) * kRowsAtOnce;
    for (int k = l_ + 1; k < rows; ++k) weight_[0][k] = weight_[1][k] = 0;
    for (int odd = 0; odd < 2; ++odd) add_columns(odd, rows, band);
  }

 private:
  // Columns whose order has the parity of l, or the other; `cosine`, `sine` are sums for orders b and -b.
  struct Columns {
    std::vector<Real> order, top, row, above, cosine, sine;
  };

  [[nodiscard]] int first_order(int odd) const { return (l_ + odd) % 2; }
  [[nodiscard]] int count(int odd) const { return (l_ - first_order(odd)) / 2 + (l_ < first_order(odd) ? 0 : 1); }

  // |K_lb|, up to the shift: sqrt(2 (2l)! / ((l+b)! (l-b)!)) / 2^l, times sqrt 2 for b > 0, l > 0.
  void next_top(int l) {
    if (l > 1) {
      const Real factor = roots_[2 * l] * roots_[2 * l - 1] / 2;
      for (int b = 0; b < l; ++b) top_[b] *= factor * inverse_roots_[l + b] * inverse_roots_[l - b];
    } else {
      top_[0] = times_power_of_two(Real(1), 2 * half_shift_);
    }
    if (l > 0) top_[l] = times_power_of_two(Real(1), 1 - l + 2 * half_shift_);
  }

  // g of place k, with g_0 = g_1 = d_l^(-1/2), and slope +-2 g_k / (d g_(k+1)), + for rows of the parity of l.
  void next_gauge() {
    using std::sqrt;
    gauge_[0] = gauge_[1] = 1 / sqrt(roots_[2 * l_]);
    for (int k = 1; k < l_; ++k) {
      gauge_[k + 1] =
          gauge_[k - 1] * (roots_[k] * inverse_roots_[k + 1]) * (roots_[2 * l_ - k + 1] * inverse_roots_[2 * l_ - k]);
    }
    for (int k = 0; k < l_; ++k) {
      const Real size = 2 * gauge_[k] * inverse_roots_[2 * l_ - k] * inverse_roots_[k + 1] / gauge_[k + 1];
      slope_[k] = k % 2 == 0 ? size : Real(-size);
    }
    for (int k = l_; k < l_ + kRowsAtOnce; ++k) slope_[k] = 0;
  }

  // Order and first row; the sign of K_lb is + + - - from b = l down.
  void fill_columns() {
    const Real inverse = 1 / gauge_[0];
    for (int odd = 0; odd < 2; ++odd) {
      Columns& columns = columns_[odd];
      int b = first_order(odd);
      for (int i = 0; i < count(odd); ++i, b += 2) {
        columns.order[i] = static_cast<Real>(b);
        columns.top[i] = (l_ - b) % 4 < 2 ? top_[b] * inverse : -top_[b] * inverse;
      }
    }
  }

  void add_columns(int odd, int rows, Real* band) {
    Columns& columns = columns_[odd];
    const int n = count(odd);
    std::copy_n(columns.top.begin(), n, columns.row.begin());
    for (auto* values : {&columns.above, &columns.cosine, &columns.sine}) std::fill_n(values->begin(), n, Real(0));
    add_rows(RowSums<Real>{n, rows, columns.order.data(), slope_.data(), weight_[odd].data(), columns.row.data(),
                           columns.above.data(), columns.cosine.data(), columns.sine.data()});
    int b = first_order(odd);
    for (int i = 0; i < n; ++i, b += 2) {
      if (b > 0) band[-b] = columns.sine[i] * down_;
      band[b] = columns.cosine[i] * down_;
    }
  }

  int l_ = 0;
  int half_shift_ = 0;  // K is kept times 2^(2 half_shift)
  Real down_;
  std::vector<Real> roots_, inverse_roots_;  // of 0, 1, 2 ..
  std::vector<Real> top_, gauge_, slope_;
  std::array<std::vector<Real>, 2> weight_;
  std::array<Columns, 2> columns_;
};

template <class Real>
void rotate_rows(int degree, const Real* r, const Real* c, Real* out) {
  const auto turns = three_turns(r);
  auto back = turns.half_beta + turns.half_beta;
  back.sine = -back.sine;
  const auto first = multiples<Real>(turns.gamma, degree);
  const auto middle = multiples<Real>(back, degree);
  const auto last = multiples<Real>(turns.alpha, degree);
  std::vector<Real> room(2 * degree + 1);
  Real* band = room.data() + degree;
  Swap<Real> swap(degree);
  for (int l = 0; l <= degree; ++l) {
    if (l > 0) swap.next();
    turn_band(l, first, c + coefficient_index(l, 0), band);
    swap.apply(band);
    turn_band(l, middle, band, band);
    swap.apply(band);
    turn_band(l, last, band, out + coefficient_index(l, 0));
  }
}

}  // namespace

template <>
void add_rows(const RowSums<double>& sums) {
  static const AddRows kChosen = widest();
  kChosen(sums);
}

template <class Real>
void rotate_zxz_rows(int degree, const Real* r, const Real* c, Real* out) {
  require_range("rotate_zxz_rows: degree", degree, 0, kLargestRowsDegree<Real>);
  if constexpr (std::is_same_v<Real, float>) {
    std::vector<double> wide(c, c + coefficient_count(degree));
    const auto matrix = nearest_rotation<double>(r);
    rotate_rows(degree, matrix.data(), wide.data(), wide.data());
    std::transform(wide.begin(), wide.end(), out, [](double v) { return static_cast<float>(v); });
  } else {
    rotate_rows(degree, r, c, out);
  }
}

#define SHFORGE_INSTANCE(Real) template void rotate_zxz_rows<Real>(int, const Real*, const Real*, Real*);

SHFORGE_FOR_EACH_METHOD_REAL(SHFORGE_INSTANCE)

}  // namespace sh::numeric::methods
