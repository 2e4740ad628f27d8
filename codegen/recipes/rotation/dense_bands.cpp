#include <stdexcept>
#include <utility>

#include "codegen/recipes/rotation/band_matrices.hpp"
#include "symbolic/basis/basis.hpp"
#include "symbolic/rotation/rotation.hpp"

namespace sh::codegen::recipes {
namespace {

using symbolic::Matrix;
using symbolic::Polynomial;
using symbolic::Surd;

Complex multiply(SignedBuilder& build, const Complex& a, const Complex& b) {
  const Value rr = build.times(a.re, b.re);
  const Value ii = build.times(a.im, b.im);
  const Value ri = build.times(a.re, b.im);
  const Value ir = build.times(a.im, b.re);
  const Value re = build.sum({rr, -ii});
  return {re, build.sum({ri, ir})};
}

// Element (i, m), i >= m, not both 0: first^(i-m) second^m.
class Powers {
 public:
  Powers(SignedBuilder& build, const Complex& first, const Complex& second, int most) : powers_(most + 1) {
    for (int i = 1; i <= most; ++i) {
      powers_[i].push_back(i == 1 ? first : multiply(build, powers_[i - 1][0], first));
      for (int m = 1; m <= i; ++m) {
        powers_[i].push_back(i == 1 ? second : multiply(build, powers_[i - 1][m - 1], second));
      }
    }
  }
  [[nodiscard]] const Complex& operator()(int i, int m) const { return powers_[i][m]; }

 private:
  std::vector<std::vector<Complex>> powers_;
};

using Coefficients = std::vector<cln::cl_RA>;  // of powers from 0 on

Coefficients times_linear(const Coefficients& a, const cln::cl_RA& constant, const cln::cl_RA& linear) {
  Coefficients result(a.size() + 1, 0);
  for (std::size_t k = 0; k < a.size(); ++k) {
    result[k] = result[k] + constant * a[k];
    result[k + 1] = result[k + 1] + linear * a[k];
  }
  return result;
}

// Divides a form in c, s = cos, sin of b/2 by its factor (2 s c)^across c^along s^opposite; the result is in x = cos b.
Coefficients in_cosine(const Polynomial& form, int across, int along, int opposite) {
  Coefficients result;
  for (const auto& [monomial, coefficient] : form.terms()) {
    const int up = monomial.exponent(0) - across - along;
    const int down = monomial.exponent(1) - across - opposite;
    if (up < 0 || down < 0 || up % 2 != 0 || down % 2 != 0) throw std::logic_error("rotation: unexpected term");
    Coefficients product{coefficient / cln::expt(cln::cl_RA(2), up / 2 + down / 2 + across)};
    for (int i = 0; i < up / 2; ++i) product = times_linear(product, 1, 1);
    for (int i = 0; i < down / 2; ++i) product = times_linear(product, 1, -1);
    result.resize(product.size(), 0);
    for (std::size_t k = 0; k < product.size(); ++k) result[k] = result[k] + product[k];
  }
  return result;
}

// For the entries k_m / k_n T_mn of rows +-m and columns +-n, m >= n: the part with e^(i(ma+ng)) (plus) or e^(i(ma-ng))
// (minus), divided by the powers of P, A and B.
struct Axial {
  Coefficients plus;
  Coefficients minus;
};

Axial axial_part(const Matrix<Polynomial>& about_y, int m, int n) {
  const int l = (about_y.rows() - 1) / 2;
  const Polynomial& cosines = about_y(l + m, l + n);
  if (n == 0) return {in_cosine(cosines, m, 0, 0), {}};
  const Polynomial& sines = about_y(l - m, l - n);
  // A and B are doubled, so their powers are 2^n times as large.
  const cln::cl_RA scale = cln::cl_RA(1) / cln::expt(cln::cl_RA(2), n + 1);
  return {in_cosine(scale * (cosines + sines), m - n, 2 * n, 0), in_cosine(scale * (cosines - sines), m - n, 0, 2 * n)};
}

// The values of polynomials of degree 0, 1, 2, ... with p_d = (a x + b) p_(d-1) - c p_(d-2), as Jacobi's have.
class ThreeTerms {
 public:
  ThreeTerms(SignedBuilder& build, NodeId x) : build_(build), x_(x) {}

  // polynomial: the next one, times ratio.
  Value next(Coefficients polynomial, const Surd& ratio) {
    const std::size_t d = polynomial.size() - 1;
    if (d == 0) {
      values_ = {constant(ratio * Surd(polynomial[0]))};
    } else if (d == 1) {
      values_.push_back(linear(ratio * Surd(polynomial[1]), ratio * Surd(polynomial[0])));
    } else {
      step(polynomial, ratio);
    }
    before_ = std::move(last_);
    last_ = std::move(polynomial);
    before_ratio_ = last_ratio_;
    last_ratio_ = ratio;
    return values_.back();
  }

 private:
  void step(const Coefficients& polynomial, const Surd& ratio) {
    const std::size_t d = polynomial.size() - 1;
    const cln::cl_RA a = polynomial[d] / last_[d - 1];
    const cln::cl_RA b = (polynomial[d - 1] - a * last_[d - 2]) / last_[d - 1];
    const cln::cl_RA below = d == 2 ? cln::cl_RA(0) : last_[d - 3];
    const cln::cl_RA c = (a * below + b * last_[d - 2] - polynomial[d - 2]) / before_[d - 2];
    const Surd by_last = ratio / last_ratio_;
    const Value factor = linear(by_last * Surd(a), by_last * Surd(b));
    const Value raised = build_.times(factor, values_[d - 1]);
    const Value lowered = build_.times(ratio / before_ratio_ * Surd(c), values_[d - 2]);
    values_.push_back(build_.sum({raised, -lowered}));
  }

  // a x + b
  Value linear(const Surd& a, const Surd& b) {
    const Value ax = build_.times(a, {x_});
    return b.is_zero() ? ax : build_.sum({ax, constant(b)});
  }

  Value constant(const Surd& value) {
    const bool negative = value.is_negative();
    return {build_.constant(negative ? -value : value), negative};
  }

  SignedBuilder& build_;
  NodeId x_;
  std::vector<Value> values_;
  Coefficients last_;
  Coefficients before_;
  Surd last_ratio_;
  Surd before_ratio_;
};

Complex times(SignedBuilder& build, Value factor, const Complex& value) {
  const Value re = build.times(factor, value.re);
  return {re, build.times(factor, value.im)};
}

// The powers in the entries.
struct PowerTables {
  Powers p_a;  // P^(i-m) A^m
  Powers p_b;
  Powers q_a;  // (-Q)^(i-m) A^m
  Powers q_b;  // (-conj(Q))^(i-m) B^m
};

// Fills the matrices of bands 2 and up.
class BandWriter {
 public:
  BandWriter(SignedBuilder& build, PowerTables powers, std::vector<Matrix<Polynomial>> about_y, NodeId x,
             BandMatrices& bands)
      : build_(build), powers_(std::move(powers)), about_y_(std::move(about_y)), x_(x), bands_(bands) {}

  // Rows +-m, columns +-n and rows +-n, columns +-m, m >= n > 0, of all bands.
  void set_pair(int m, int n) {
    ThreeTerms plus(build_, x_);
    ThreeTerms minus(build_, x_);
    for (int l = m; l < size(); ++l) {
      const Axial axial = axial_part(about_y_[l], m, n);
      const Surd ratio = symbolic::factor_ratio(l, m, n);
      const Value p_plus = plus.next(axial.plus, ratio);
      const Value p_minus = minus.next(axial.minus, ratio);
      if (l < 2) continue;
      const Complex z = times(build_, p_plus, powers_.p_a(m, n));
      set(l, m, n, z, times(build_, p_minus, powers_.p_b(m, n)));
      if (m == n) continue;
      const Complex transposed = times(build_, p_plus, powers_.q_a(m, n));  // d_nm = (-1)^(m-n) d_mn
      set(l, n, m, transposed, times(build_, p_minus, powers_.q_b(m, n)));
    }
  }

  // Rows +-m of column 0 and columns +-m of row 0, of all bands.
  void set_zero(int m) {
    ThreeTerms axial(build_, x_);
    for (int l = m; l < size(); ++l) {
      const Value value = axial.next(axial_part(about_y_[l], m, 0).plus, symbolic::factor_ratio(l, m, 0));
      if (l < 2) continue;
      Matrix<Value>& d = bands_[l];
      if (m == 0) {
        d(l, l) = value;
        continue;
      }
      const Complex column = times(build_, value, powers_.p_a(m, 0));
      const Complex row = times(build_, value, powers_.q_a(m, 0));
      d(l + m, l) = column.re;
      d(l - m, l) = column.im;
      d(l, l + m) = row.re;
      d(l, l - m) = -row.im;
    }
  }

 private:
  [[nodiscard]] int size() const { return static_cast<int>(bands_.size()); }

  void set(int l, int m, int n, const Complex& z, const Complex& w) {
    Matrix<Value>& d = bands_[l];
    d(l + m, l + n) = build_.sum({z.re, w.re});
    d(l + m, l - n) = build_.sum({w.im, -z.im});
    d(l - m, l + n) = build_.sum({z.im, w.im});
    d(l - m, l - n) = build_.sum({z.re, -w.re});
  }

  SignedBuilder& build_;
  PowerTables powers_;
  std::vector<Matrix<Polynomial>> about_y_;
  NodeId x_;
  BandMatrices& bands_;
};

}  // namespace

Matrix<Value> band_one(const std::array<NodeId, 9>& r) {
  constexpr int kAxes[] = {1, 2, 0};
  Matrix<Value> band(3, 3);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) band(i, j) = {r[3 * kAxes[i] + kAxes[j]]};
  }
  return band;
}

void append_dense_bands(SignedBuilder& build, BandMatrices& bands, const RotationNumbers& numbers, int degree) {
  const Powers p_a(build, numbers.p, numbers.a, degree);
  const Powers p_b(build, numbers.p, numbers.b, degree);
  const Powers q_a(build, {-numbers.q.re, -numbers.q.im}, numbers.a, degree);
  const Powers q_b(build, {-numbers.q.re, numbers.q.im}, numbers.b, degree);
  std::vector<Matrix<Polynomial>> about_y;
  for (int l = 0; l <= degree; ++l) {
    about_y.push_back(symbolic::rotation_about_y(l));
    if (l >= 2) bands.emplace_back(2 * l + 1, 2 * l + 1);
  }
  BandWriter writer(build, {p_a, p_b, q_a, q_b}, std::move(about_y), numbers.cosine, bands);
  for (int m = 0; m <= degree; ++m) {
    writer.set_zero(m);
    for (int n = 1; n <= m; ++n) writer.set_pair(m, n);
  }
}

BandMatrices dense_bands(SignedBuilder& build, const std::array<NodeId, 9>& r, int degree) {
  BandMatrices bands{Matrix<Value>(1, 1, {{build.constant(Surd(1))}})};
  if (degree >= 1) bands.push_back(band_one(r));
  if (degree < 2) return bands;
  const auto entry = [&r](int row, int column) { return Value{r[3 * row + column]}; };
  const Value a_re = build.sum({entry(0, 0), entry(1, 1)}, "a_re");
  const Value a_im = build.sum({entry(1, 0), -entry(0, 1)}, "a_im");
  const Value b_re = build.sum({entry(1, 1), -entry(0, 0)}, "b_re");
  const Value b_im = -build.sum({entry(0, 1), entry(1, 0)}, "b_im");
  append_dense_bands(build, bands,
                     {r[8], {a_re, a_im}, {b_re, b_im}, {entry(0, 2), entry(1, 2)}, {-entry(2, 0), entry(2, 1)}},
                     degree);
  return bands;
}

}  // namespace sh::codegen::recipes
