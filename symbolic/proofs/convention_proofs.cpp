#include "symbolic/proofs/convention_proofs.hpp"

#include <array>

#include "symbolic/basis/basis.hpp"
#include "symbolic/convention/convention.hpp"
#include "symbolic/convention/presets.hpp"
#include "symbolic/number/polynomial_calculus.hpp"
#include "symbolic/rotation/rotation.hpp"
#include "symbolic/rotation/rotation_input.hpp"
#include "symbolic/rotation/rotation_recursion.hpp"

namespace sh::symbolic {
namespace {

using RadicalMatrix = Matrix<RadicalSum>;
using RadicalPolynomial = std::map<Monomial, RadicalSum>;

RadicalMatrix identity(int size) { return RadicalMatrix::identity(size, RadicalSum(cln::cl_RA(1))); }

std::array<Polynomial, 3> coordinates(const SignedPermutation& axes) {
  std::array<Polynomial, 3> result;
  for (int row = 0; row < 3; ++row) {
    result[row] = cln::cl_RA(axes.sign(row)) * Polynomial::variable(axes.axis(row));
  }
  return result;
}

void add(RadicalPolynomial& sum, const RadicalSum& factor, const Polynomial& p) {
  for (const auto& [monomial, coefficient] : p.terms()) sum[monomial] += factor * RadicalSum(coefficient);
}

bool vanishes(const RadicalPolynomial& p) {
  return std::all_of(p.begin(), p.end(), [](const auto& term) { return term.second.is_zero(); });
}

std::vector<Polynomial> homogeneous_band(int degree) {
  std::vector<Polynomial> band;
  for (int m = -degree; m <= degree; ++m) band.push_back(basis_function(degree, m).homogeneous);
  return band;
}

// exp(i n angle) from the half angle's exact cosine and sine, for whole n.
RadicalSum turn(const cln::cl_RA& half_cosine, const cln::cl_RA& half_sine, int n) {
  const cln::cl_N half = cln::complex(half_cosine, n < 0 ? cln::cl_RA(-half_sine) : half_sine);
  RadicalSum result;
  result.add_term({1, 0}, cln::expt(half, cln::cl_I(2 * std::abs(n))));
  return result;
}

struct HalfAngle {
  cln::cl_RA cosine;
  cln::cl_RA sine;
};

// Y_complex(R s) = conj(D) Y_complex(s), D_(m',m) = exp(-i m' alpha) d_(m',m)(beta) exp(-i m gamma).
RadicalMatrix complex_rotation(int degree, const HalfAngle& alpha, const HalfAngle& beta, const HalfAngle& gamma) {
  const int size = 2 * degree + 1;
  RadicalMatrix d(size, size);
  const std::array<cln::cl_RA, 2> point{beta.cosine, beta.sine};
  for (int row = -degree; row <= degree; ++row) {
    for (int column = -degree; column <= degree; ++column) {
      const WignerEntry entry = wigner_d(degree, row, column);
      const RadicalSum value(entry.factor * Surd(entry.polynomial.evaluate(point)));
      const RadicalSum phased = turn(alpha.cosine, alpha.sine, -row) * value * turn(gamma.cosine, gamma.sine, -column);
      d(degree + row, degree + column) = phased.conjugate();
    }
  }
  return d;
}

// Runs `prove` for every band up to `degree` and the samples that reach it.
template <class Prove>
ProofResult for_samples(int degree, Prove prove) {
  std::size_t count = 0;
  for (int top : {std::min(degree, 2), degree}) {
    for (const Convention& convention : sample_conventions(top)) {
      ProofResult result = prove(convention, top);
      if (!result.proved) return result;
      ++count;
    }
  }
  return proved(std::to_string(count) + " conventions");
}

ProofResult prove_all_basis_changes(int degree) {
  return for_samples(degree, [](const Convention& convention, int top) {
    for (int l = 0; l <= top; ++l) {
      ProofResult result =
          prove_basis_change(convention, l, basis_change(convention, l), basis_change_inverse(convention, l));
      if (!result.proved) return result;
    }
    return proved("");
  });
}

ProofResult prove_all_round_trips(int degree) {
  const Convention ours;
  return for_samples(degree, [&](const Convention& convention, int top) {
    return prove_there_and_back(convention_map(ours, convention, top), convention_map(convention, ours, top));
  });
}

// Each sample by way of the next one.
ProofResult prove_all_compositions(int degree) {
  const std::vector<Convention> samples = sample_conventions(degree);
  const Convention ours;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Convention& middle = samples[i];
    const Convention& end = samples[(i + 1) % samples.size()];
    ProofResult result = prove_through(convention_map(ours, middle, degree), convention_map(middle, end, degree),
                                       convention_map(ours, end, degree));
    if (!result.proved) return result;
  }
  return proved(std::to_string(samples.size()) + " triples");
}

}  // namespace

ProofResult prove_unitary(const RadicalMatrix& w) {
  const RadicalMatrix one = identity(w.rows());
  if (!(w * adjoint(w) == one) || !(adjoint(w) * w == one)) return refuted("W W* is not 1");
  return proved(std::to_string(w.rows()) + " rows");
}

ProofResult prove_axes(const AxesBand& band, int degree) {
  const std::vector<Polynomial> functions = homogeneous_band(degree);
  const std::array<SignedPermutation, 3> generators{SignedPermutation("y,z,x"), SignedPermutation("y,x,z"),
                                                    SignedPermutation("-x,y,z")};
  for (const SignedPermutation& axes : all_signed_permutations()) {
    const Matrix<cln::cl_RA> t = band(axes, degree);
    const auto moved = coordinates(axes);
    for (int m = 0; m <= 2 * degree; ++m) {
      Polynomial difference = substitute(functions[m], moved);
      for (int n = 0; n <= 2 * degree; ++n) difference -= t(m, n) * functions[n];
      if (!difference.is_zero()) return refuted("axes " + axes.to_string() + " l=" + std::to_string(degree));
    }
    for (const SignedPermutation& generator : generators) {
      if (!(band(generator * axes, degree) == band(generator, degree) * t)) {
        return refuted("axes " + generator.to_string() + " after " + axes.to_string() + " do not compose");
      }
    }
  }
  return proved("48 signed permutations");
}

ProofResult prove_basis_change(const Convention& convention, int degree, const RadicalMatrix& change,
                               const RadicalMatrix& inverse) {
  const std::vector<Polynomial> functions = homogeneous_band(degree);
  const auto moved = coordinates(convention.axes);
  for (int m = -degree; m <= degree; ++m) {
    const ConventionFunction f = convention_function(convention, degree, m);
    RadicalPolynomial difference;
    add(difference, RadicalSum(f.factor), substitute(f.re, moved));
    add(difference, RadicalSum(f.factor) * RadicalSum::imaginary_unit(), substitute(f.im, moved));
    for (int n = -degree; n <= degree; ++n) {
      add(difference, -(change(degree + m, degree + n) * RadicalSum(orthonormal_factor(degree, n))),
          functions[degree + n]);
    }
    if (!vanishes(difference)) return refuted("l=" + std::to_string(degree) + " m=" + std::to_string(m));
  }
  if (!(change * inverse == identity(change.rows())))
    return refuted("l=" + std::to_string(degree) + ": A A^-1 is not 1");
  return proved(std::to_string(change.rows()) + " functions");
}

ProofResult prove_there_and_back(const ConventionMap& there, const ConventionMap& back) {
  if (!is_identity(compose(back, there))) return refuted("back after there is not the identity");
  if (!is_identity(compose(there, back))) return refuted("there after back is not the identity");
  return proved(std::to_string(there.degree + 1) + " bands");
}

ProofResult prove_through(const ConventionMap& a_to_b, const ConventionMap& b_to_c, const ConventionMap& a_to_c) {
  const ConventionMap through = compose(b_to_c, a_to_b);
  if (through.forward != a_to_c.forward || through.backward != a_to_c.backward) {
    return refuted("the direct map differs from the one through a third convention");
  }
  return proved(std::to_string(a_to_c.degree + 1) + " bands");
}

ProofResult prove_complex_rotation(const std::vector<RadicalMatrix>& w) {
  const HalfAngle alpha{cln::cl_RA(3) / 5, cln::cl_RA(4) / 5};
  const HalfAngle beta{cln::cl_RA(12) / 13, cln::cl_RA(5) / 13};
  const HalfAngle gamma{cln::cl_RA(15) / 17, cln::cl_RA(-8) / 17};
  const Quaternion<cln::cl_RA> q = quaternion_from_euler<cln::cl_RA>(
      "zyz", EulerFrame::kIntrinsic,
      {{{alpha.cosine, alpha.sine}, {beta.cosine, beta.sine}, {gamma.cosine, gamma.sine}}});
  const auto bands = rotation_bands<cln::cl_RA>(static_cast<int>(w.size()) - 1, matrix_from_quaternion(q), 1);
  for (std::size_t l = 0; l < w.size(); ++l) {
    const int degree = static_cast<int>(l);
    const Matrix<Surd> real = surd_entries(degree, bands[l]);
    const RadicalMatrix sandwich = w[l] * complex_rotation(degree, alpha, beta, gamma) * adjoint(w[l]);
    for (int i = 0; i < real.rows(); ++i) {
      for (int j = 0; j < real.columns(); ++j) {
        if (!(sandwich(i, j) == RadicalSum(real(i, j))))
          return refuted("band " + std::to_string(l) + ": W D W* differs");
      }
    }
  }
  return proved(std::to_string(w.size()) + " bands at a rational rotation");
}

std::vector<Convention> sample_conventions(int degree) {
  std::vector<Convention> samples;
  for (const Preset& preset : presets()) {
    if (preset.convention.folded != Folded::kNothing && degree > 2) continue;
    samples.push_back(preset.convention);
    samples.push_back(preset.in_world());
  }
  for (const Normalisation normalisation :
       {Normalisation::kOrthonormal, Normalisation::kFourPi, Normalisation::kSchmidt, Normalisation::kSn3d,
        Normalisation::kUnnormalised, Normalisation::kPrimitive}) {
    Convention c;
    c.normalisation = normalisation;
    c.condon_shortley = normalisation != Normalisation::kSchmidt;
    c.complex = normalisation == Normalisation::kFourPi || normalisation == Normalisation::kSchmidt;
    c.order = c.complex ? IndexOrder::kZeroFirst : IndexOrder::kCosineSineBands;
    c.axes = SignedPermutation(c.complex ? "-z,x,y" : "y,-z,x");
    samples.push_back(c);
  }
  return samples;
}

std::vector<Proof> convention_proofs() {
  const std::string limit = "exact band matrices are kept to degree 20";
  const std::string slow = "exact products of band matrices for every convention take minutes beyond";
  return {
      {"complex-unitary", "Y_real = W Y_complex with W W* = 1, with and without the Condon-Shortley phase",
       "exact products", 10, kMaxConventionDegree, limit,
       [](int degree) {
         for (int l = 0; l <= degree; ++l) {
           for (const bool phase : {false, true}) {
             ProofResult result = prove_unitary(real_from_complex(l, phase));
             if (!result.proved) return result;
           }
         }
         return proved(std::to_string(degree + 1) + " bands");
       }},
      {"complex-rotation", "real rotation matrix = W D W*, D from Wigner's d", "exact, at a rational rotation", 10,
       kMaxConventionDegree, limit,
       [](int degree) {
         std::vector<RadicalMatrix> w;
         for (int l = 0; l <= degree; ++l) w.push_back(real_from_complex(l, true));
         return prove_complex_rotation(w);
       }},
      {"axes", "Y_l(P s) = D_l(P) Y_l(s) for the 48 signed permutations P, D(PQ) = D(P) D(Q)",
       "substitution, exact products", 10, 10, "48 matrices with all products take minutes beyond",
       [](int degree) {
         for (int l = 0; l <= degree; ++l) {
           ProofResult result = prove_axes(axes_band, l);
           if (!result.proved) return result;
         }
         return proved("48 signed permutations, " + std::to_string(degree + 1) + " bands");
       }},
      {"convention-functions", "A_l Y_l = the convention's functions written out, A_l A_l^-1 = 1",
       "polynomial identities, every preset and a spread of others", 10, 10, slow, prove_all_basis_changes},
      {"convention-round-trip", "ours -> convention -> ours is the identity", "exact products, every preset and others",
       10, 10, slow, prove_all_round_trips},
      {"convention-composition", "ours -> a -> b equals ours -> b", "exact products, every preset and others", 10, 10,
       slow, prove_all_compositions},
  };
}

}  // namespace sh::symbolic
