// Tables of triple products and of products as bilinear forms.
//
// In another convention the entries are those of convention_map.hpp. Both tensors hold in the convention's own
// coordinates, so its axes do not enter.
#include <map>

#include "symbolic/convention/convention_map.hpp"
#include "symbolic/product/gaunt.hpp"
#include "symbolic/typeset/typeset_families.hpp"

namespace sh::symbolic {
namespace {

void fill_gaunt(FormulaTable& table, int degree, const Convention& convention) {
  const TripleTensor entries = map_triple_integral(map_to(convention, degree), all_orders(gaunt_tensor(degree)));
  for (const auto& [triple, value] : entries) {
    if (triple != sorted(triple)) continue;
    table.rows.push_back({"G" + tex_indices(triple.i, triple.j, triple.k), formula_terms(value, "")});
  }
}

// A term of a product: the place of its row, the symbol of the row, the coefficients that multiply it. Empty
// coefficients: no term.
struct ProductTerm {
  std::pair<int, int> place;
  std::string symbol;
  std::string coefficients;
  int factor = 1;
};

// The rows of (f g)_k = sum P_ijk f_i g_j; term(k, i, j) describes the term of P_ijk.
template <class Term>
auto fill_product(Term term) {
  return [term](FormulaTable& table, int degree, const Convention& convention) {
    const TripleTensor entries = map_product_form(map_to(convention, degree), all_orders(gaunt_tensor(degree)));
    std::map<IndexTriple, RadicalSum> by_result;
    for (const auto& [t, value] : entries) by_result[{t.k, t.i, t.j}] = value;
    std::map<std::pair<int, int>, Formula> rows;
    for (const auto& [t, value] : by_result) {
      const ProductTerm own = term(t.i, t.j, t.k);
      if (own.coefficients.empty()) continue;
      Formula& row = rows[own.place];
      row.symbol = own.symbol;
      const auto terms = formula_terms(RadicalSum(cln::cl_RA(own.factor)) * value, own.coefficients);
      row.terms.insert(row.terms.end(), terms.begin(), terms.end());
    }
    for (auto& [place, row] : rows) table.rows.push_back(std::move(row));
  };
}

ProductTerm product_term(int k, int i, int j) {
  return {{k, 0}, indexed("c", k), indexed("a", i) + " " + indexed("b", j)};
}

// P_ijk and P_jik are equal and multiply the same a_i a_j.
ProductTerm square_term(int k, int i, int j) {
  if (j < i) return {};
  if (i == j) return {{k, 0}, indexed("c", k), indexed("a", i) + "^{2}"};
  return {{k, 0}, indexed("c", k), indexed("a", i) + " " + indexed("a", j), 2};
}

ProductTerm zonal_term(int k, int i, int j) {
  const auto [l, m] = degree_order(j);
  if (m != 0) return {};
  return {{k, 0}, indexed("c", k), indexed("a", i) + " " + indexed("h", l)};
}

ProductTerm transfer_term(int k, int i, int j) { return {{k, i}, "M" + tex_indices(k, i), indexed("b", j)}; }

}  // namespace

std::vector<TypesetFamily> product_tables() {
  constexpr int kLargest = 9;
  const std::string limit = "the tensor has over 40,000 ordered entries there";
  const std::string indices = "Indices are l(l+1)+m.";
  return {{"gaunt",
           "Gaunt coefficients of real harmonics",
           kLargest,
           limit,
           {indices,
            "G_ijk is the integral of Y_i Y_j Y_k over the sphere (no conjugate). The tensor is symmetric; entries "
            "with i <= j <= k that are not listed are zero."},
           fill_gaunt},
          {"product",
           "Products",
           kLargest,
           limit,
           {indices, "c is the product of a and b, projected on their bands."},
           fill_product(product_term)},
          {"square",
           "Squares",
           kLargest,
           limit,
           {indices, "c is the square of a, projected on its bands."},
           fill_product(square_term)},
          {"zonal-product",
           "Products with a zonal function",
           kLargest,
           limit,
           {indices,
            "c is the product of a and a zonal function about z with coefficients h_l, projected on the bands of a."},
           fill_product(zonal_term)},
          {"transfer",
           "Transfer matrix of a known function",
           kLargest,
           limit,
           {indices,
            "M_ki is the entry in row k and column i of the matrix that multiplies by a known function b: c = M a. "
            "Entries that are not listed are zero."},
           fill_product(transfer_term)}};
}

}  // namespace sh::symbolic
