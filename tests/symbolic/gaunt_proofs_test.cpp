// Each proof holds for what is derived and falls for a spoiled copy of it.
#include "symbolic/proofs/gaunt_proofs.hpp"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

namespace sh::symbolic {
namespace {

const Surd kOneInAMillion(cln::cl_RA(1000001) / 1000000);

std::vector<BilinearForm> with_term(std::vector<BilinearForm> forms, std::size_t output, std::size_t term,
                                    const Surd& scale) {
  forms[output].terms[term].factor = scale * forms[output].terms[term].factor;
  return forms;
}

TEST(GauntProofs, EveryEntryOfTheCatalogueHolds) {
  std::set<std::string> names;
  for (const Proof& proof : gaunt_proofs()) {
    const ProofResult result = proof.run(4);
    EXPECT_TRUE(result.proved) << proof.name << ": " << result.detail;
    EXPECT_TRUE(names.insert(proof.name).second) << proof.name;
  }
}

TEST(GauntProofs, OneSpoiledEntryRefutesTheTensor) {
  const GauntTensor tensor = gaunt_tensor(3);
  for (const auto& [triple, value] : tensor) {
    GauntTensor nudged = tensor;
    nudged[triple] = kOneInAMillion * value;
    EXPECT_FALSE(prove_gaunt_tensor(nudged, 3).proved);
    GauntTensor negated = tensor;
    negated[triple] = -value;
    EXPECT_FALSE(prove_gaunt_tensor(negated, 3).proved);
    GauntTensor missing = tensor;
    missing.erase(triple);
    EXPECT_FALSE(prove_gaunt_tensor(missing, 3).proved);
  }
  GauntTensor extra = tensor;
  extra[{1, 2, 3}] = Surd(1);
  EXPECT_FALSE(prove_gaunt_tensor(extra, 3).proved);
}

TEST(GauntProofs, OneOrderOfAnEntryThatDiffersRefutesSymmetry) {
  const std::vector<BilinearForm> forms = product_form({2, 2, 2});
  EXPECT_TRUE(prove_gaunt_symmetry(forms).proved);
  EXPECT_FALSE(prove_gaunt_symmetry(with_term(forms, 4, 1, kOneInAMillion)).proved);
  EXPECT_FALSE(prove_gaunt_symmetry(with_term(forms, 4, 1, Surd(-1))).proved);
  std::vector<BilinearForm> missing = forms;
  missing[5].terms.erase(missing[5].terms.begin());
  EXPECT_FALSE(prove_gaunt_symmetry(missing).proved);
}

TEST(GauntProofs, AnEntryAtAForbiddenPlaceRefutesTheSelectionRules) {
  const GauntTensor tensor = gaunt_tensor(3);
  EXPECT_TRUE(prove_gaunt_selection_rules(tensor).proved);
  const std::vector<IndexTriple> forbidden{{0, 0, 2},   // parity of the degrees
                                           {1, 1, 12},  // odd sum
                                           {2, 2, 12},  // no triangle, odd sum
                                           {0, 0, 6},   // no triangle
                                           {1, 3, 6},   // one negative order
                                           {3, 3, 7},   // orders do not add up
                                           {8, 6, 6}};  // not sorted
  for (const IndexTriple& triple : forbidden) {
    GauntTensor spoiled = tensor;
    spoiled[triple] = Surd(cln::cl_RA(1) / 1000000);
    EXPECT_FALSE(prove_gaunt_selection_rules(spoiled).proved) << triple.i << " " << triple.j << " " << triple.k;
  }
  GauntTensor stored_zero = tensor;
  stored_zero[{0, 0, 0}] = Surd();
  EXPECT_FALSE(prove_gaunt_selection_rules(stored_zero).proved);
}

TEST(GauntProofs, OneSpoiledTermRefutesTheProductIdentity) {
  const std::vector<BilinearForm> forms = product_form({2, 2, 4});
  EXPECT_TRUE(prove_product_identity(forms, 2).proved);
  for (std::size_t output = 0; output < forms.size(); ++output) {
    const std::size_t last = forms[output].terms.size() - 1;
    EXPECT_FALSE(prove_product_identity(with_term(forms, output, last, kOneInAMillion), 2).proved) << output;
    EXPECT_FALSE(prove_product_identity(with_term(forms, output, 0, Surd(-1)), 2).proved) << output;
  }
  std::vector<BilinearForm> shifted = forms;
  std::swap(shifted[5].output, shifted[7].output);
  EXPECT_FALSE(prove_product_identity(shifted, 2).proved);
  // Projected on as many bands as the factors have, a product is no longer equal to it.
  EXPECT_FALSE(prove_product_identity(product_form({2, 2, 2}), 2).proved);
}

TEST(GauntProofs, OneSpoiledTermRefutesTheSquareIdentity) {
  const std::vector<BilinearForm> forms = square_form(2, 4);
  for (std::size_t output = 0; output < forms.size(); ++output) {
    EXPECT_FALSE(prove_square_identity(with_term(forms, output, 0, kOneInAMillion), 2).proved) << output;
  }
  EXPECT_FALSE(prove_square_identity(product_form({2, 2, 4}), 2).proved);  // mixed terms not doubled
}

TEST(GauntProofs, OneSpoiledTermRefutesTheZonalProductIdentity) {
  const std::vector<BilinearForm> forms = zonal_product_form({2, 2, 4});
  for (std::size_t output = 0; output < forms.size(); ++output) {
    if (forms[output].terms.empty()) continue;
    EXPECT_FALSE(prove_zonal_product_identity(with_term(forms, output, 0, kOneInAMillion), 2).proved) << output;
  }
  std::vector<BilinearForm> shifted = forms;  // band 1 of the zonal factor for band 2
  for (BilinearTerm& term : shifted[6].terms) term.j = term.j == 2 ? 1 : term.j;
  EXPECT_FALSE(prove_zonal_product_identity(shifted, 2).proved);
}

TEST(GauntProofs, OneSpoiledEntryRefutesTheTransferMatrix) {
  const ProductShape shape{2, 1, 1};
  std::vector<Surd> known;
  known.reserve(4);
  for (int k = 0; k < 4; ++k) known.emplace_back(cln::cl_RA(1) / (k + 1));
  std::vector<std::vector<RadicalSum>> matrix = transfer_matrix(known, shape);
  EXPECT_TRUE(prove_transfer_matrix(matrix, known, shape).proved);
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t column = 0; column < 9; ++column) {
      std::vector<std::vector<RadicalSum>> spoiled = matrix;
      spoiled[row][column] += RadicalSum(cln::cl_RA(1) / 1000000);
      EXPECT_FALSE(prove_transfer_matrix(spoiled, known, shape).proved) << row << " " << column;
    }
  }
  matrix.pop_back();
  EXPECT_FALSE(prove_transfer_matrix(matrix, known, shape).proved);
}

}  // namespace
}  // namespace sh::symbolic
