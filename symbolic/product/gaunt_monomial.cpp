// The Gaunt tensor by exact integration: G_ijk = K_i K_j K_k 4 pi mean(S_i S_j S_k), K the factors, S the homogeneous
// polynomials of the basis. The product S_i S_j is multiplied out once a pair; for each k a table holds the mean of S_k
// times every monomial that such a product can hold, so an entry is a dot product of two sorted lists.
#include <vector>

#include "symbolic/basis/basis.hpp"
#include "symbolic/number/sphere_integral.hpp"
#include "symbolic/product/gaunt.hpp"

namespace sh::symbolic {
namespace {

using Means = Polynomial::Terms;  // monomial -> mean of S_k times it

// Every monomial of degree 0 .. largest with a mean that is not zero.
Means means_with(const Polynomial& solid, int largest) {
  Means means;
  for (int a = 0; a <= largest; ++a) {
    for (int b = 0; a + b <= largest; ++b) {
      for (int c = 0; a + b + c <= largest; ++c) {
        Polynomial monomial;
        monomial.add_term({a, b, c}, 1);
        const cln::cl_RA mean = sphere_mean(monomial * solid);
        if (!cln::zerop(mean)) means.emplace_hint(means.end(), Monomial{a, b, c}, mean);
      }
    }
  }
  return means;
}

cln::cl_RA dot(const Polynomial::Terms& product, const Means& means) {
  cln::cl_RA sum = 0;
  auto mean = means.begin();
  for (const auto& [monomial, coefficient] : product) {
    while (mean != means.end() && mean->first < monomial) ++mean;
    if (mean == means.end()) break;
    if (mean->first == monomial) sum = sum + coefficient * mean->second;
  }
  return sum;
}

}  // namespace

GauntTensor gaunt_by_monomials(int degree) {
  require_gaunt_degree(degree);
  std::vector<BasisFunction> basis;
  std::vector<Means> means;
  for (int l = 0; l <= degree; ++l) {
    for (int m = -l; m <= l; ++m) {
      basis.push_back(basis_function(l, m));
      means.push_back(means_with(basis.back().homogeneous, 2 * degree));
    }
  }
  const Surd sphere_area = Surd(4) * Surd::square_root(1, 2);
  GauntTensor tensor;
  for (std::size_t i = 0; i < basis.size(); ++i) {
    for (std::size_t j = i; j < basis.size(); ++j) {
      const Polynomial product = basis[i].homogeneous * basis[j].homogeneous;
      for (std::size_t k = j; k < basis.size(); ++k) {
        const cln::cl_RA mean = dot(product.terms(), means[k]);
        if (cln::zerop(mean)) continue;
        const Surd factor = sphere_area * basis[i].factor * basis[j].factor * basis[k].factor;
        tensor.emplace_hint(tensor.end(), IndexTriple{static_cast<int>(i), static_cast<int>(j), static_cast<int>(k)},
                            factor * Surd(mean));
      }
    }
  }
  return tensor;
}

}  // namespace sh::symbolic
