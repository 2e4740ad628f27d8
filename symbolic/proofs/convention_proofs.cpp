#include "symbolic/convention/convention.hpp"
#include "symbolic/number/polynomial.hpp"
#include "symbolic/proofs/identities.hpp"
#include "symbolic/proofs/points.hpp"
#include "symbolic/rotation/rotation_recursion.hpp"
#include "symbolic/typeset/typeset.hpp"

namespace sh::symbolic {
namespace {

using RadicalMatrix = Matrix<RadicalSum>;
using HalfAngle = CosSin<cln::cl_RA>;

RadicalMatrix identity(int size) { return RadicalMatrix::identity(size, RadicalSum(cln::cl_RA(1))); }

std::vector<Polynomial> homogeneous_band(int degree) {
  std::vector<Polynomial> band;
  for (int m = -degree; m <= degree; ++m) band.push_back(basis_function(degree, m).homogeneous);
  return band;
}

// exp(i n angle), for whole n.
RadicalSum turn(const HalfAngle& half, int n) {
  const cln::cl_N one = cln::complex(half.cosine, n < 0 ? cln::cl_RA(-half.sine) : half.sine);
  RadicalSum result;
  result.add_term({1, 0}, cln::expt(one, cln::cl_I(2 * std::abs(n))));
  return result;
}

// Y_complex(R s) = conj(D) Y_complex(s), D_(m',m) = exp(-i m' alpha) d_(m',m)(beta) exp(-i m gamma).
RadicalMatrix complex_rotation(int degree, const HalfAngle& alpha, const HalfAngle& beta, const HalfAngle& gamma) {
  RadicalMatrix d(2 * degree + 1, 2 * degree + 1);
  const std::array<cln::cl_RA, 2> point{beta.cosine, beta.sine};
  for (int row = -degree; row <= degree; ++row) {
    for (int column = -degree; column <= degree; ++column) {
      const WignerEntry entry = wigner_d(degree, row, column);
      const RadicalSum value(entry.factor * Surd(entry.polynomial.evaluate(point)));
      d(degree + row, degree + column) = (turn(alpha, -row) * value * turn(gamma, -column)).conjugate();
    }
  }
  return d;
}

}  // namespace

int prove_unitary(const RadicalMatrix& w, bool condon_shortley) {
  const RadicalMatrix one = identity(w.rows());
  if (!(w * adjoint(w) == one) || !(adjoint(w) * w == one)) throw Refuted("W W* is not 1");
  const int degree = (w.rows() - 1) / 2;
  const Convention complex{.condon_shortley = condon_shortley, .complex = true};
  for (int m = -degree; m <= degree; ++m) {
    const BasisFunction& real = basis_function(degree, m);
    PolynomialSum difference;
    difference.add(-RadicalSum(real.factor), real.homogeneous);
    for (int n = -degree; n <= degree; ++n) {
      const ConventionFunction f = convention_function(complex, degree, n);
      const RadicalSum weight = w(degree + m, degree + n) * RadicalSum(f.factor);
      difference.add(weight, f.re);
      difference.add(weight * RadicalSum::imaginary_unit(), f.im);
    }
    if (!difference.terms({"x", "y", "z"}).empty())
      throw Refuted(real.name() + ": W Y_complex is not the real function");
  }
  return 1;
}

int prove_axes(const AxesBand& band, int degree) {
  const std::vector<Polynomial> functions = homogeneous_band(degree);
  const std::array<SignedPermutation, 3> generators{SignedPermutation("y,z,x"), SignedPermutation("y,x,z"),
                                                    SignedPermutation("-x,y,z")};
  for (const SignedPermutation& axes : all_signed_permutations()) {
    const Matrix<cln::cl_RA> t = band(axes, degree);
    const auto moved = coordinates(axes);
    for (int m = 0; m <= 2 * degree; ++m) {
      Polynomial difference = substitute(functions[m], moved);
      for (int n = 0; n <= 2 * degree; ++n) difference -= t(m, n) * functions[n];
      if (!difference.is_zero()) throw Refuted("axes " + axes.to_string() + " l=" + std::to_string(degree));
    }
    for (const SignedPermutation& generator : generators) {
      if (!(band(generator * axes, degree) == band(generator, degree) * t)) {
        throw Refuted("axes " + generator.to_string() + " after " + axes.to_string() + " do not compose");
      }
    }
  }
  return 48;
}

int prove_basis_change(const Convention& convention, int degree, const RadicalMatrix& change,
                       const RadicalMatrix& inverse) {
  const std::vector<Polynomial> functions = homogeneous_band(degree);
  const auto moved = coordinates(convention.axes);
  for (int m = -degree; m <= degree; ++m) {
    const ConventionFunction f = convention_function(convention, degree, m);
    PolynomialSum difference;
    difference.add(RadicalSum(f.factor), substitute(f.re, moved));
    difference.add(RadicalSum(f.factor) * RadicalSum::imaginary_unit(), substitute(f.im, moved));
    for (int n = -degree; n <= degree; ++n) {
      const RadicalSum factor = change(degree + m, degree + n) * RadicalSum(orthonormal_factor(degree, n));
      difference.add(-factor, functions[degree + n]);
    }
    if (!difference.terms({}).empty()) throw Refuted("l=" + std::to_string(degree) + " m=" + std::to_string(m));
  }
  if (!(change * inverse == identity(change.rows())))
    throw Refuted("l=" + std::to_string(degree) + ": A A^-1 is not 1");
  return 1;
}

int prove_there_and_back(const ConventionMap& there, const ConventionMap& back) {
  if (!is_identity(compose(back, there))) throw Refuted("back after there is not the identity");
  if (!is_identity(compose(there, back))) throw Refuted("there after back is not the identity");
  return 1;
}

int prove_through(const ConventionMap& a_to_b, const ConventionMap& b_to_c, const ConventionMap& a_to_c) {
  const ConventionMap through = compose(b_to_c, a_to_b);
  if (through.forward != a_to_c.forward || through.backward != a_to_c.backward) {
    throw Refuted("the direct map differs from the one through a third convention");
  }
  return 1;
}

int prove_complex_rotation(const std::vector<RadicalMatrix>& w) {
  const HalfAngle alpha{cln::cl_RA(3) / 5, cln::cl_RA(4) / 5};
  const HalfAngle beta{cln::cl_RA(12) / 13, cln::cl_RA(5) / 13};
  const HalfAngle gamma{cln::cl_RA(15) / 17, cln::cl_RA(-8) / 17};
  const Quaternion<cln::cl_RA> q =
      quaternion_from_euler<cln::cl_RA>("zyz", EulerFrame::kIntrinsic, {alpha, beta, gamma});
  const auto bands = rotation_bands<cln::cl_RA>(static_cast<int>(w.size()) - 1, matrix_from_quaternion(q), 1);
  for (int degree = 0; degree < static_cast<int>(w.size()); ++degree) {
    const Matrix<Surd> real = surd_entries(degree, bands[degree]);
    const RadicalMatrix sandwich = w[degree] * complex_rotation(degree, alpha, beta, gamma) * adjoint(w[degree]);
    for (int i = 0; i < real.rows(); ++i) {
      for (int j = 0; j < real.columns(); ++j) {
        if (!(sandwich(i, j) == RadicalSum(real(i, j)))) {
          throw Refuted("band " + std::to_string(degree) + ": W D W* differs");
        }
      }
    }
  }
  return static_cast<int>(w.size());
}

}  // namespace sh::symbolic
