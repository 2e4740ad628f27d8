// Each proof holds for what is derived and falls for a spoiled copy of it.
#include "symbolic/proofs/zonal_proofs.hpp"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

#include "symbolic/zonal/convolution.hpp"

namespace sh::symbolic {
namespace {

const cln::cl_RA kOneInAMillion = cln::cl_RA(1000001) / 1000000;

// Scales one coefficient of the first polynomial (or the factor where there is none); a zero becomes a millionth.
ZonalTerm nudged(ZonalTerm term) {
  if (term.numerator.empty()) {
    term.factor = Surd(kOneInAMillion) * term.factor;
  } else {
    Polynomial& first = term.numerator.front();
    const Monomial monomial = first.is_zero() ? Monomial() : first.terms().begin()->first;
    first.add_term(monomial, (first.is_zero() ? 1 : first.coefficient(monomial)) * (kOneInAMillion - 1));
  }
  return term;
}

TEST(ZonalProofs, EveryEntryOfTheCatalogueHolds) {
  std::set<std::string> names;
  for (const Proof& proof : zonal_proofs()) {
    const ProofResult result = proof.run(proof.default_degree);
    EXPECT_TRUE(result.proved) << proof.name << ": " << result.detail;
    EXPECT_TRUE(names.insert(proof.name).second) << proof.name;
  }
}

TEST(ZonalProofs, DefinitionsOffByOnePartInAMillionAreRefuted) {
  for (const ZonalFamily& family : zonal_families()) {
    for (std::size_t l = 0; l <= 6; ++l) {
      std::vector<ZonalTerm> spoiled = zonal_coefficients(family, 6);
      if (spoiled[l].factor.is_zero()) continue;
      spoiled[l] = nudged(spoiled[l]);
      EXPECT_FALSE(prove_zonal_family(family, spoiled).proved) << family.name << " " << l;
    }
  }
}

TEST(ZonalProofs, DefinitionsOfTheWrongSignOrDegreeAreRefuted) {
  for (const ZonalFamily& family : zonal_families()) {
    std::vector<ZonalTerm> wrong_sign = zonal_coefficients(family, 2);
    wrong_sign[1].factor = -wrong_sign[1].factor;
    EXPECT_FALSE(prove_zonal_family(family, wrong_sign).proved) << family.name;
    std::vector<ZonalTerm> swapped = zonal_coefficients(family, 2);
    std::swap(swapped[0], swapped[1]);
    EXPECT_FALSE(prove_zonal_family(family, swapped).proved) << family.name;
  }
}

TEST(ZonalProofs, CosinePowersOfAShiftedExponentAreRefuted) {
  const ZonalFamily& family = zonal_family("cosine-power");
  std::vector<ZonalTerm> shifted = zonal_coefficients(family, 4);
  shifted[4].denominator.back() += Polynomial(2);
  EXPECT_FALSE(prove_zonal_family(family, shifted).proved);
}

TEST(ZonalProofs, AComplementThatLeavesAGapIsRefuted) {
  const std::vector<ZonalTerm> cap = zonal_coefficients(zonal_family("cap"), 6);
  const std::vector<ZonalTerm> complement = zonal_coefficients(zonal_family("cap-complement"), 6);
  EXPECT_TRUE(prove_cap_complement(cap, complement).proved);
  for (std::size_t l = 0; l <= 6; ++l) {
    std::vector<ZonalTerm> spoiled = complement;
    spoiled[l] = nudged(spoiled[l]);
    EXPECT_FALSE(prove_cap_complement(cap, spoiled).proved) << l;
  }
  EXPECT_FALSE(prove_cap_complement(cap, cap).proved);
}

TEST(ZonalProofs, IrradianceFactorsThatAreWrongAreRefuted) {
  std::vector<Surd> factors;
  for (int l = 0; l <= 8; ++l) factors.push_back(irradiance_factor(l));
  for (std::size_t l = 0; l <= 8; ++l) {
    std::vector<Surd> spoiled = factors;
    spoiled[l] = spoiled[l].is_zero() ? Surd(cln::cl_RA(1) / 1000000) : Surd(kOneInAMillion) * spoiled[l];
    EXPECT_FALSE(prove_irradiance_factors(spoiled).proved) << l;
  }
  std::swap(factors[2], factors[4]);
  EXPECT_FALSE(prove_irradiance_factors(factors).proved);
}

TEST(ZonalProofs, ConvolutionFactorsThatAreWrongAreRefuted) {
  std::vector<Surd> factors;
  for (int l = 0; l <= 5; ++l) factors.push_back(convolution_factor(l));
  for (std::size_t l = 0; l <= 5; ++l) {
    std::vector<Surd> spoiled = factors;
    spoiled[l] = Surd(kOneInAMillion) * spoiled[l];
    EXPECT_FALSE(prove_convolution(spoiled).proved) << l;
  }
  std::vector<Surd> inverted = factors;  // sqrt((2l+1) / 4 pi), a factor upside down
  for (Surd& factor : inverted) factor = factor.inverse();
  EXPECT_FALSE(prove_convolution(inverted).proved);
}

TEST(ZonalProofs, TurnedZonalFunctionsThatAreWrongAreRefuted) {
  const std::vector<TurnedZonal> entries = turned_zonal(4);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    std::vector<TurnedZonal> spoiled = entries;
    spoiled[i].factor = Surd(kOneInAMillion) * spoiled[i].factor;
    EXPECT_FALSE(prove_turned_zonal(spoiled).proved) << i;
    spoiled = entries;
    const auto [monomial, coefficient] = *entries[i].polynomial.terms().rbegin();
    spoiled[i].polynomial.add_term(monomial, coefficient / 1000000);
    EXPECT_FALSE(prove_turned_zonal(spoiled).proved) << i;
  }
  std::vector<TurnedZonal> swapped = entries;  // x for y
  std::swap(swapped[1].polynomial, swapped[3].polynomial);
  EXPECT_FALSE(prove_turned_zonal(swapped).proved);
  std::vector<TurnedZonal> wrong_phase = entries;  // with a Condon-Shortley phase
  wrong_phase[3].factor = -wrong_phase[3].factor;
  EXPECT_FALSE(prove_turned_zonal(wrong_phase).proved);
  std::vector<TurnedZonal> incomplete = entries;
  incomplete.pop_back();
  EXPECT_FALSE(prove_turned_zonal(incomplete).proved);
}

}  // namespace
}  // namespace sh::symbolic
