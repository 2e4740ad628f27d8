// Tables of triple products and of products as bilinear forms.
//
// In another convention the entries are those of symbolic/convention/convention_map.hpp. Both tensors hold in the convention's own
// coordinates, so its axes do not enter.
#include <map>

#include "symbolic/convention/convention_map.hpp"
#include "symbolic/product/gaunt.hpp"
#include "symbolic/product/product_form.hpp"
#include "symbolic/typeset/typeset.hpp"
#include "symbolic/typeset/typeset_families.hpp"

namespace sh::symbolic {
namespace {

constexpr int kMaxTypesetProductDegree = 9;

std::string index_note() { return "Indices are l(l+1)+m."; }

FormulaTable gaunt_table(int degree, const Convention& convention) {
  FormulaTable table{{},
                     {index_note(),
                      "G_ijk is the integral of Y_i Y_j Y_k over the sphere (no conjugate). The tensor is symmetric; "
                      "entries with i <= j <= k that are not listed are zero."},
                     {}};
  const TripleTensor entries = map_triple_integral(map_to(convention, degree), all_orders(gaunt_tensor(degree)));
  for (const auto& [triple, value] : entries) {
    if (triple != sorted(triple)) continue;
    table.rows.push_back({"G" + tex_indices(triple.i, triple.j, triple.k), formula_terms(value, "")});
  }
  return table;
}

// P_ijk of (f g)_k = sum P_ijk f_i g_j, sorted by (k, i, j).
std::map<IndexTriple, RadicalSum> product_entries(int degree, const Convention& convention) {
  std::map<IndexTriple, RadicalSum> result;
  const TripleTensor entries = map_product_form(map_to(convention, degree), all_orders(gaunt_tensor(degree)));
  for (const auto& [triple, value] : entries) result[{triple.k, triple.i, triple.j}] = value;
  return result;
}

void append(std::vector<FormulaTerm>& terms, const std::vector<FormulaTerm>& more) {
  terms.insert(terms.end(), more.begin(), more.end());
}

// One row c_k for each result; `symbols` names a term by (i, j) or drops it with an empty string.
template <class Symbols>
FormulaTable bilinear_table(int degree, const Convention& convention, const std::string& note, Symbols symbols) {
  FormulaTable table{{}, {index_note(), note}, {}};
  std::map<int, std::vector<FormulaTerm>> rows;
  for (const auto& [triple, value] : product_entries(degree, convention)) {
    const std::string text = symbols(triple.j, triple.k);
    if (!text.empty()) append(rows[triple.i], formula_terms(value, text));
  }
  for (auto& [k, terms] : rows) table.rows.push_back({indexed("c", k), std::move(terms)});
  return table;
}

FormulaTable product_table(int degree, const Convention& convention) {
  return bilinear_table(degree, convention, "c is the product of a and b, projected on their bands.",
                        [](int i, int j) { return indexed("a", i) + " " + indexed("b", j); });
}

// Entries (i, j) and (j, i) together multiply a_i a_j.
FormulaTable square_table(int degree, const Convention& convention) {
  FormulaTable table{{}, {index_note(), "c is the square of a, projected on its bands."}, {}};
  std::map<int, std::map<std::pair<int, int>, RadicalSum>> rows;
  for (const auto& [triple, value] : product_entries(degree, convention)) {
    rows[triple.i][std::minmax(triple.j, triple.k)] += value;
  }
  for (const auto& [k, pairs] : rows) {
    Formula row{indexed("c", k), {}};
    for (const auto& [pair, value] : pairs) {
      const std::string first = pair.first == pair.second ? "a_{" + std::to_string(pair.first) + "}^{2}"
                                                          : indexed("a", pair.first) + " " + indexed("a", pair.second);
      append(row.terms, formula_terms(value, first));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

FormulaTable zonal_product_table(int degree, const Convention& convention) {
  return bilinear_table(degree, convention,
                        "c is the product of a and a zonal function about z with coefficients h_l, projected on the "
                        "bands of a.",
                        [](int i, int j) {
                          const DegreeOrder y = degree_order(j);
                          return y.order == 0 ? indexed("a", i) + " " + indexed("h", y.degree) : std::string();
                        });
}

FormulaTable transfer_table(int degree, const Convention& convention) {
  FormulaTable table{
      {},
      {index_note(),
       "M_ki is the entry in row k and column i of the matrix that multiplies by a known function b: c = "
       "M a. Entries that are not listed are zero."},
      {}};
  std::map<std::pair<int, int>, std::vector<FormulaTerm>> rows;
  for (const auto& [triple, value] : product_entries(degree, convention)) {
    append(rows[{triple.i, triple.j}], formula_terms(value, indexed("b", triple.k)));
  }
  for (auto& [place, terms] : rows) {
    table.rows.push_back({"M" + tex_indices(place.first, place.second), std::move(terms)});
  }
  return table;
}

}  // namespace

std::vector<TypesetFamily> product_tables() {
  const std::string limit = "the tensor has over 40,000 ordered entries there";
  return {{"gaunt", "Gaunt coefficients of real harmonics", kMaxTypesetProductDegree, limit, gaunt_table},
          {"product", "Products", kMaxTypesetProductDegree, limit, product_table},
          {"square", "Squares", kMaxTypesetProductDegree, limit, square_table},
          {"zonal-product", "Products with a zonal function", kMaxTypesetProductDegree, limit, zonal_product_table},
          {"transfer", "Transfer matrix of a known function", kMaxTypesetProductDegree, limit, transfer_table}};
}

}  // namespace sh::symbolic
