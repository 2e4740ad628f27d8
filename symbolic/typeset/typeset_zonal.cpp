// Tables of zonal functions: their coefficients, convolution, irradiance, and turning to a direction.
//
// In another convention z_l is multiplied by entry (0, 0) of the band matrix of convention_map.hpp; the axis is the
// convention's own polar axis.
#include "symbolic/convention/convention_map.hpp"
#include "symbolic/typeset/typeset_families.hpp"
#include "symbolic/zonal/convolution.hpp"
#include "symbolic/zonal/zonal.hpp"

namespace sh::symbolic {
namespace {

// The factor of a zonal coefficient of ours.
Surd zonal_scale(const ConventionMap& map, int l) { return map.forward[l](l, l).surd(); }

// "c0" -> "c_{0}"
std::string tex_parameter(const std::string& name) {
  return name.size() == 1 ? name : name.substr(0, 1) + "_{" + name.substr(1) + "}";
}

std::vector<NamedPolynomial> named(const std::vector<Polynomial>& factors, const std::vector<std::string>& names) {
  std::vector<NamedPolynomial> result;
  for (const Polynomial& factor : factors) result.push_back({factor, names});
  return result;
}

TypesetFamily zonal_table(const ZonalFamily& family) {
  TypesetFamily table{family.name,
                      "Zonal function " + family.name,
                      kMaxConventionDegree,
                      "conventions are exact to degree 20",
                      {"f(t) = " + family.function + ", t the cosine of the angle to the polar axis."},
                      {}};
  if (!family.domain.empty()) table.notes.push_back("Domain: " + family.domain + ".");
  table.notes.emplace_back("z_l is the coefficient of the function (l, 0); all others are zero.");
  table.fill = [&family](FormulaTable& rows_of, int degree, const Convention& convention) {
    std::vector<std::string> names;
    for (const std::string& parameter : family.parameters) names.push_back(tex_parameter(parameter));
    const ConventionMap map = map_to(convention, degree);
    for (int l = 0; l <= degree; ++l) {
      const ZonalTerm term = family.closed_form(l);
      const Surd factor = zonal_scale(map, l) * term.factor;
      rows_of.rows.push_back(
          {indexed("z", l), {{factor, false, named(term.numerator, names), named(term.denominator, names)}}});
    }
  };
  return table;
}

void fill_irradiance(FormulaTable& table, int degree, const Convention& convention) {
  if (convention.folded == Folded::kCosineOverPi) {
    table.notes.emplace_back("The coefficients of this convention hold A_l / pi already.");
  }
  for (int l = 0; l <= degree; ++l) table.rows.push_back({indexed("A", l), {{irradiance_factor(l)}}});
}

void fill_convolution(FormulaTable& table, int degree, const Convention& convention) {
  const ConventionMap map = map_to(convention, degree);
  for (int l = 0; l <= degree; ++l) {
    table.rows.push_back({indexed("C", l), {{convolution_factor(l) / zonal_scale(map, l)}}});
  }
}

void fill_turned(FormulaTable& table, int degree, const Convention& convention) {
  const ConventionMap map = map_to(convention, degree);
  const std::vector<TurnedZonal> entries = turned_zonal(degree);
  for (int l = 0; l <= degree; ++l) {
    const RadicalSum own_scale(zonal_scale(map, l).inverse());
    for (int m = -l; m <= l; ++m) {
      PolynomialSum sum;
      for (int n = -l; n <= l; ++n) {
        const TurnedZonal& entry = entries[coefficient_index(l, n)];
        sum.add(map.forward[l](l + m, l + n) * own_scale * RadicalSum(entry.factor), entry.polynomial);
      }
      Formula row{"c" + tex_indices(l, m), sum.terms({"x", "y", "z"})};
      for (FormulaTerm& term : row.terms) term.symbols = indexed("h", l);
      table.rows.push_back(std::move(row));
    }
  }
}

}  // namespace

std::vector<TypesetFamily> zonal_tables() {
  const std::string limit = "conventions are exact to degree 20";
  std::vector<TypesetFamily> families{
      {"irradiance",
       "Irradiance factors",
       1000,
       "longer tables are of no use",
       {"Irradiance has the coefficients A_l L_lm of radiance L, in every convention."},
       fill_irradiance},
      {"convolution",
       "Convolution factors",
       kMaxConventionDegree,
       limit,
       {"The convolution of f with the zonal function of coefficients h_l has the coefficients C_l h_l f_lm."},
       fill_convolution},
      {"turned-zonal",
       "A zonal function turned to a direction",
       kMaxConventionDegree,
       limit,
       {"Coefficient (l, m) of the zonal function with coefficients h_l when its axis is turned to the unit direction "
        "(x, y, z)."},
       fill_turned}};
  for (const ZonalFamily& family : zonal_families()) families.push_back(zonal_table(family));
  return families;
}

}  // namespace sh::symbolic
