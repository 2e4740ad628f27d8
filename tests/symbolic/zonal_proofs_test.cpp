// A spoiled coefficient refutes every proof about zonal functions.
#include <gtest/gtest.h>

#include "symbolic/zonal/window.hpp"
#include "tests/symbolic/spoiled.hpp"

namespace sh::symbolic {
namespace {

using test::Change;
using test::expect_refuted;
using test::millionth;
using test::nudge;
using Terms = std::vector<ZonalTerm>;
using Surds = std::vector<Surd>;

// Scales one coefficient of the first polynomial (or the factor where there is none); a zero becomes a millionth.
void nudge_term(ZonalTerm& term) {
  if (term.numerator.empty()) return nudge(term.factor);
  Polynomial& first = term.numerator.front();
  if (first.is_zero()) {
    first = Polynomial(millionth());
  } else {
    nudge(first);
  }
}

// One change for each degree whose term is not zero.
std::vector<Change<Terms>> nudged_terms(const Terms& terms) {
  std::vector<Change<Terms>> changes;
  for (std::size_t l = 0; l < terms.size(); ++l) {
    if (!terms[l].factor.is_zero()) changes.emplace_back([l](Terms& spoiled) { nudge_term(spoiled[l]); });
  }
  return changes;
}

// One change for each factor.
std::vector<Change<Surds>> nudged_factors(int count) {
  std::vector<Change<Surds>> changes;
  for (int l = 0; l < count; ++l) {
    changes.emplace_back([l](Surds& factors) {
      if (factors[l].is_zero()) {
        factors[l] = Surd(millionth());
      } else {
        nudge(factors[l]);
      }
    });
  }
  return changes;
}

TEST(ZonalProofs, CatchASpoiledDefinition) {
  for (const ZonalFamily& family : zonal_families()) {
    SCOPED_TRACE(family.name);
    const Terms terms = zonal_coefficients(family, 6);
    std::vector<Change<Terms>> changes = nudged_terms(terms);
    changes.emplace_back([](Terms& spoiled) { spoiled[1].factor = -spoiled[1].factor; });
    changes.emplace_back([](Terms& spoiled) { std::swap(spoiled[0], spoiled[1]); });
    expect_refuted(
        terms, [&](const Terms& claimed) { prove_zonal_family(family, claimed); }, changes);
  }
}

TEST(ZonalProofs, CatchAShiftedExponentOfACosinePower) {
  const ZonalFamily& family = zonal_family("cosine-power");
  expect_refuted(zonal_coefficients(family, 4), [&](const Terms& claimed) { prove_zonal_family(family, claimed); },
                 {[](Terms& terms) { terms[4].denominator.back() += Polynomial(2); }});
}

TEST(ZonalProofs, CatchAComplementThatLeavesAGap) {
  const Terms cap = zonal_coefficients(zonal_family("cap"), 6);
  const Terms complement = zonal_coefficients(zonal_family("cap-complement"), 6);
  std::vector<Change<Terms>> changes = nudged_terms(complement);
  changes.emplace_back([&](Terms& spoiled) { spoiled = cap; });
  expect_refuted(
      complement, [&](const Terms& claimed) { prove_cap_complement(cap, claimed); }, changes);
}

TEST(ZonalProofs, CatchASpoiledIrradianceFactor) {
  Surds factors;
  for (int l = 0; l <= 8; ++l) factors.push_back(irradiance_factor(l));
  std::vector<Change<Surds>> changes = nudged_factors(9);
  changes.emplace_back([](Surds& spoiled) { std::swap(spoiled[2], spoiled[4]); });
  expect_refuted(
      factors, [&](const Surds& claimed) { prove_irradiance_factors(claimed, factors); }, changes);
}

TEST(ZonalProofs, CatchAFoldedFactorThatIsNotTheConvolution) {
  using FoldedFactor = std::function<Surd(Folded folded, int degree)>;
  Surds irradiance;
  Surds convolution;
  for (int l = 0; l <= 4; ++l) {
    irradiance.push_back(irradiance_factor(l));
    convolution.push_back(convolution_factor(l));
  }
  const Terms clamped = zonal_coefficients(zonal_family("clamped-cosine"), 4);
  expect_refuted(
      FoldedFactor(folded_factor),
      [&](const FoldedFactor& folded) { prove_irradiance_convolution(irradiance, convolution, clamped, folded); },
      {[](FoldedFactor& folded) {
         folded = [](Folded, int degree) { return irradiance_factor(degree); };  // without 1 / pi
       },
       [](FoldedFactor& folded) { folded = [](Folded, int) { return Surd(1); }; }});
  expect_refuted(
      irradiance,
      [&](const Surds& claimed) { prove_irradiance_convolution(claimed, convolution, clamped, folded_factor); },
      nudged_factors(5));
}

TEST(WindowProofs, CatchAnAngleAnExponentAndAPenalty) {
  using Polynomials = std::vector<Polynomial>;
  Polynomials hann;
  Polynomials sine;
  std::vector<int> exponents;
  std::vector<cln::cl_RA> penalties;
  for (int l = 0; l <= 4; ++l) {
    hann.push_back(window_hann(l));
    sine.push_back(window_lanczos_sine(l));
    exponents.push_back(window_gaussian_exponent(l));
    penalties.push_back(window_laplacian_penalty(l));
  }
  expect_refuted(hann, [&](const Polynomials& claimed) { prove_window_angles(claimed, sine); },
                 {[](Polynomials& p) { nudge(p[3]); }, [](Polynomials& p) { std::swap(p[1], p[2]); }});
  expect_refuted(sine, [&](const Polynomials& claimed) { prove_window_angles(hann, claimed); },
                 {[](Polynomials& p) { nudge(p[1]); }, [](Polynomials& p) { test::negate(p[4]); }});
  expect_refuted(exponents, prove_window_gaussian,
                 {[](std::vector<int>& e) { ++e[0]; }, [](std::vector<int>& e) { e[4] = 20; }});  // l (l+1)
  const Basis basis = derive_basis(4);
  expect_refuted(penalties, [&](const std::vector<cln::cl_RA>& claimed) { prove_window_laplacian(claimed, basis); },
                 {[](std::vector<cln::cl_RA>& p) { nudge(p[2]); }, [](std::vector<cln::cl_RA>& p) { p[3] = 81; }});
}

TEST(ZonalProofs, CatchASpoiledConvolutionFactor) {
  Surds factors;
  for (int l = 0; l <= 5; ++l) factors.push_back(convolution_factor(l));
  std::vector<Change<Surds>> changes = nudged_factors(6);
  changes.emplace_back([](Surds& spoiled) {  // sqrt((2l+1) / 4 pi), a factor upside down
    for (Surd& factor : spoiled) factor = factor.inverse();
  });
  expect_refuted(factors, prove_convolution, changes);
}

TEST(ZonalProofs, CatchASpoiledTurnedFunction) {
  using Entries = std::vector<TurnedZonal>;
  std::vector<Change<Entries>> changes{[](Entries& e) { std::swap(e[1].polynomial, e[3].polynomial); },  // x for y
                                       [](Entries& e) { e[3].factor = -e[3].factor; },  // with a Condon-Shortley phase
                                       [](Entries& e) { e.pop_back(); }};
  for (int i = 0; i < 25; ++i) {
    changes.emplace_back([i](Entries& e) { nudge(e[i].factor); });
    changes.emplace_back([i](Entries& e) { nudge(e[i].polynomial); });
  }
  expect_refuted(turned_zonal(4), prove_turned_zonal, changes);
}

}  // namespace
}  // namespace sh::symbolic
