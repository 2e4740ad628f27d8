// A spoiled entry refutes every proof about Gaunt coefficients and products.
#include <gtest/gtest.h>

#include "tests/symbolic/spoiled.hpp"

namespace sh::symbolic {
namespace {

using test::Change;
using test::expect_refuted;
using test::millionth;
using test::negate;
using test::nudge;
using Forms = std::vector<BilinearForm>;

TEST(GauntProofs, CatchOneSpoiledEntryOfTheTensor) {
  const GauntTensor tensor = gaunt_tensor(3);
  std::vector<Change<GauntTensor>> changes{[](GauntTensor& t) { t[{1, 2, 3}] = Surd(1); }};
  for (const auto& [triple, value] : tensor) {
    changes.emplace_back([triple = triple](GauntTensor& t) { nudge(t[triple]); });
    changes.emplace_back([triple = triple](GauntTensor& t) { negate(t[triple]); });
    changes.emplace_back([triple = triple](GauntTensor& t) { t.erase(triple); });
  }
  expect_refuted(
      tensor, [](const GauntTensor& claimed) { prove_gaunt_tensor(claimed, 3); }, changes);
}

TEST(GauntProofs, CatchOneOrderOfAnEntryThatDiffers) {
  expect_refuted(
      product_form({2, 2, 2}), prove_gaunt_symmetry,
      {[](Forms& forms) { nudge(forms[4].terms[1].factor); }, [](Forms& forms) { negate(forms[4].terms[1].factor); },
       [](Forms& forms) { forms[5].terms.erase(forms[5].terms.begin()); }});
}

TEST(GauntProofs, CatchAnEntryAtAForbiddenPlace) {
  std::vector<Change<GauntTensor>> changes{[](GauntTensor& stored_zero) { stored_zero[{0, 0, 0}] = Surd(); }};
  for (const IndexTriple& forbidden : {IndexTriple{0, 0, 2},  // parity of the degrees
                                       {1, 1, 12},            // odd sum
                                       {2, 2, 12},            // no triangle, odd sum
                                       {0, 0, 6},             // no triangle
                                       {1, 3, 6},             // one negative order
                                       {3, 3, 7},             // orders do not add up
                                       {8, 6, 6}}) {          // not sorted
    changes.emplace_back([forbidden](GauntTensor& tensor) { tensor[forbidden] = Surd(millionth()); });
  }
  expect_refuted(
      gaunt_tensor(3), [](const GauntTensor& tensor) { prove_gaunt_selection_rules(tensor); }, changes);
}

// The sign of a symbol cancels in Gaunt's tensor: there the symbols come in pairs of the same degrees.
TEST(GauntProofs, CatchTheSignOfWignerSymbols) {
  const auto negated = [](bool (*where)(int l1, int l2, int l3, int m3)) {
    return [where](Wigner3j& symbol) {
      symbol = [where](int l1, int l2, int l3, int m1, int m2, int m3) {
        const Surd value = wigner_3j(l1, l2, l3, m1, m2, m3);
        return where(l1, l2, l3, m3) ? -value : value;
      };
    };
  };
  expect_refuted(Wigner3j(wigner_3j), [](const Wigner3j& symbol) { prove_wigner_3j(symbol, 2); },
                 {negated([](int, int, int, int) { return true; }),
                  negated([](int l1, int l2, int l3, int) { return l1 == 1 && l2 == 1 && l3 == 1; }),
                  negated([](int, int, int, int m3) { return m3 % 2 != 0; }),
                  negated([](int l1, int l2, int, int m3) { return (l1 - l2 - m3) % 2 != 0; })});
}

// One change for each form: its first term.
std::vector<Change<Forms>> nudged_terms(const Forms& forms) {
  std::vector<Change<Forms>> changes;
  for (std::size_t output = 0; output < forms.size(); ++output) {
    if (forms[output].terms.empty()) continue;
    changes.emplace_back([output](Forms& spoiled) { nudge(spoiled[output].terms.front().factor); });
  }
  return changes;
}

TEST(GauntProofs, CatchOneSpoiledTermOfAProduct) {
  const Forms forms = product_form({2, 2, 4});
  std::vector<Change<Forms>> changes = nudged_terms(forms);
  for (std::size_t output = 0; output < forms.size(); ++output) {
    changes.emplace_back([output](Forms& spoiled) { nudge(spoiled[output].terms.back().factor); });
    changes.emplace_back([output](Forms& spoiled) { negate(spoiled[output].terms.front().factor); });
  }
  changes.emplace_back([](Forms& spoiled) { std::swap(spoiled[5].output, spoiled[7].output); });
  // A projection on the bands of the factors is not equal to the product.
  changes.emplace_back([](Forms& spoiled) { spoiled = product_form({2, 2, 2}); });
  expect_refuted(
      forms, [](const Forms& claimed) { prove_product_identity(claimed, 2); }, changes);
}

TEST(GauntProofs, CatchOneSpoiledTermOfASquare) {
  const Forms forms = square_form(2, 4);
  std::vector<Change<Forms>> changes = nudged_terms(forms);
  changes.emplace_back([](Forms& spoiled) { spoiled = product_form({2, 2, 4}); });  // mixed terms not doubled
  expect_refuted(
      forms, [](const Forms& claimed) { prove_square_identity(claimed, 2); }, changes);
}

TEST(GauntProofs, CatchOneSpoiledTermOfAZonalProduct) {
  const Forms forms = zonal_product_form({2, 2, 4});
  std::vector<Change<Forms>> changes = nudged_terms(forms);
  changes.emplace_back([](Forms& spoiled) {  // band 1 of the zonal factor for band 2
    for (BilinearTerm& term : spoiled[6].terms) term.j = term.j == 2 ? 1 : term.j;
  });
  expect_refuted(
      forms, [](const Forms& claimed) { prove_zonal_product_identity(claimed, 2); }, changes);
}

TEST(GauntProofs, CatchOneSpoiledEntryOfATransferMatrix) {
  using Entries = Matrix<RadicalSum>;
  const ProductShape shape{2, 1, 1};
  std::vector<Surd> known;
  for (int k = 1; k <= 4; ++k) known.emplace_back(cln::cl_RA(1) / k);
  std::vector<Change<Entries>> changes{[](Entries& matrix) { matrix = matrix.transposed(); }};
  for (int entry = 0; entry < 4 * 9; ++entry) {
    changes.emplace_back([entry](Entries& matrix) { matrix(entry / 9, entry % 9) += RadicalSum(millionth()); });
  }
  expect_refuted(
      transfer_matrix(known, shape), [&](const Entries& matrix) { prove_transfer_matrix(matrix, known, shape); },
      changes);
}

}  // namespace
}  // namespace sh::symbolic
