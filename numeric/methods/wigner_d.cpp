// Rotation by Wigner's d in three-term recurrences over the degree: stable at every tilt, no matrix is stored.
//
// r (3x3 row-major), c -> out (bands^2) = D(r) c, README.md's conventions; out may be c. R = Rz(alpha) Ry(beta)
// Rz(gamma) as in turns.hpp. For each pair of orders p >= |q| the values d^l_pq(beta) rise from
//   d^p_pq = (-1)^(p-q) sqrt((2p)! / ((p+q)! (p-q)!)) cos^(p+q)(beta/2) sin^(p-q)(beta/2)
// by [BlancoFlorezBermejo97] eq. 64 (the recurrence of Jacobi polynomials, upward: the direction in which d grows or
// oscillates; [Varshalovich88] 4.8.2). Starts carry an exponent of their own: none underflows in float, or at beta
// near 0 or pi. cos(beta) -+ 1 is taken from the half angle, so entries near the diagonal keep their digits there.
// Cost: degree^3 / 3 values of d at a root and 10 operations each, memory for one row of starts. Error: turns.hpp and
// methods.hpp have the measured figures.
#include "numeric/methods/methods.hpp"
#include "numeric/methods/turns.hpp"
#include "numeric/oracle/instances.hpp"
#include "numeric/oracle/legendre.hpp"

namespace sh::numeric::methods {
namespace {

// d^p_pq, q = -p .. p at place p + q, for rising p, starting at p = 0.
template <class Real>
class Starts {
 public:
  explicit Starts(const Turn<Real>& half)
      : cosine2_(scaled<Real>(half.cosine * half.cosine)),
        sine2_(scaled<Real>(half.sine * half.sine)),
        mixed_(multiply(scaled<Real>(-half.sine), scaled(half.cosine))) {}

  [[nodiscard]] const Scaled<Real>& operator()(int q) const { return row_[p_ + q]; }

  void next() {
    using std::sqrt;
    std::vector<Scaled<Real>> row{multiply(sine2_, row_.front())};
    ++p_;
    const long p = p_;
    for (long q = 1 - p; q < p; ++q) {
      const Real ratio = static_cast<Real>(2 * p * (2 * p - 1)) / static_cast<Real>((p + q) * (p - q));
      row.push_back(multiply(multiply(scaled<Real>(sqrt(ratio)), mixed_), row_[p - 1 + q]));
    }
    row.push_back(multiply(cosine2_, row_.back()));
    row_ = std::move(row);
  }

 private:
  Scaled<Real> cosine2_, sine2_, mixed_;
  int p_ = 0;
  std::vector<Scaled<Real>> row_{{1, 0}};
};

// d^l_pq for rising l, starting at l = p >= |q|.
template <class Real>
class Rise {
 public:
  Rise(int p, int q, const Scaled<Real>& start, const Turn<Real>& half)
      : p_(p), q_(q), l_(p), exponent_(start.exponent), current_(start.mantissa) {
    const bool flat = half.sine < half.cosine;
    square_ = 2 * (flat ? half.sine * half.sine : half.cosine * half.cosine);  // cos(beta) = +-(1 - square)
    sign_ = flat ? 1 : -1;
  }

  [[nodiscard]] Real value() const { return exponent_ == 0 ? current_ : times_power_of_two(current_, exponent_); }

  void next() {
    using std::sqrt;
    const long k = l_ * (l_ + 1);
    const long l2 = (l_ + 1) * (l_ + 1);
    // sign (cos(beta) - pq / k), k > 0 unless p = q = 0.
    const Real slope =
        (k == 0 ? Real(1) : Real(static_cast<Real>(k - sign_ * p_ * q_) / static_cast<Real>(k))) - square_;
    const Real root = sqrt(static_cast<Real>((l2 - p_ * p_) * (l2 - q_ * q_)));
    Real sum = static_cast<Real>(sign_ * (2 * l_ + 1)) * slope * current_;
    if (l_ > p_) sum -= root_ / static_cast<Real>(l_) * before_;
    before_ = current_;
    current_ = static_cast<Real>(l_ + 1) * sum / root;
    root_ = root;
    ++l_;
    rescale(current_, before_, exponent_);
  }

 private:
  long p_, q_, l_;
  long sign_ = 1;
  long exponent_;
  Real square_;
  Real current_;
  Real before_ = 0;
  Real root_ = 0;  // of the step before
};

}  // namespace

template <class Real>
void rotate_wigner_d(int degree, const Real* r, const Real* c, Real* out) {
  rotate_by_turns(degree, r, c, out, [degree](const auto& half_beta, const Real* in, Real* tilted) {
    const Turn<Real> half{static_cast<Real>(half_beta.cosine), static_cast<Real>(half_beta.sine)};
    std::fill_n(tilted, coefficient_count(degree), Real(0));
    Starts<Real> starts(half);
    for (int p = 0; p <= degree; ++p) {
      for (int q = 0; q <= p; ++q) {
        Rise<Real> same(p, q, starts(q), half);
        Rise<Real> opposite(p, -q, starts(-q), half);
        for (int l = p; l <= degree; ++l) {
          const int middle = coefficient_index(l, 0);
          add_tilt(p, q, same.value(), opposite.value(), in + middle, tilted + middle);
          same.next();
          opposite.next();
        }
      }
      starts.next();
    }
  });
}

#define SHFORGE_INSTANCE(Real) template void rotate_wigner_d<Real>(int, const Real*, const Real*, Real*);

SHFORGE_FOR_EACH_METHOD_REAL(SHFORGE_INSTANCE)

}  // namespace sh::numeric::methods
