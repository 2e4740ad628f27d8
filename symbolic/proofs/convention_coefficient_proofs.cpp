// Proofs of the coefficients of a convention: the same function of direction, and its index orders.
#include <cstdlib>

#include "symbolic/convention/convention.hpp"
#include "symbolic/number/polynomial.hpp"
#include "symbolic/proofs/identities.hpp"
#include "symbolic/proofs/points.hpp"
#include "symbolic/typeset/typeset.hpp"

namespace sh::symbolic {
namespace {

// Y'_m = re + i im in our coordinates.
struct Written {
  RadicalSum factor;
  Polynomial re;
  Polynomial im;
};

std::vector<Written> written_band(const Convention& convention, int degree) {
  std::vector<Written> band;
  const bool turns = !(convention.axes == SignedPermutation());
  const auto moved = coordinates(convention.axes);
  const auto in_ours = [&](const Polynomial& p) { return turns ? substitute(p, moved) : p; };
  for (int m = -degree; m <= degree; ++m) {
    const ConventionFunction f = convention_function(convention, degree, m);
    band.push_back({RadicalSum(f.factor), in_ours(f.re), in_ours(f.im)});
  }
  return band;
}

// A_l / pi by its integral, 1 where nothing is folded in.
cln::cl_RA convolution_with(Folded folded, int degree) {
  if (folded == Folded::kNothing) return 1;
  const Polynomial integrand = Polynomial::variable(0) * legendre_polynomial(degree, 0);
  return 2 * definite_integral(integrand, 0, Polynomial(), Polynomial(1)).coefficient({});
}

constexpr DegreeOrder kHole{-1, 0};

// The functions in the order of the array.
std::vector<DegreeOrder> listed(IndexOrder order, int degree) {
  std::vector<DegreeOrder> list;
  if (order == IndexOrder::kCosineSineArray) {
    for (const int sign : {1, -1}) {
      for (int l = 0; l <= degree; ++l) {
        for (int a = 0; a <= degree; ++a)
          list.push_back(a > l || (a == 0 && sign < 0) ? kHole : DegreeOrder{l, sign * a});
      }
    }
    return list;
  }
  for (int l = 0; l <= degree; ++l) {
    if (order == IndexOrder::kAcn) {
      for (int m = -l; m <= l; ++m) list.push_back({l, m});
      continue;
    }
    if (order == IndexOrder::kFuMa && l == 1) {
      list.insert(list.end(), {{1, 1}, {1, -1}, {1, 0}});
      continue;
    }
    const bool pairs = order == IndexOrder::kZeroFirst || order == IndexOrder::kFuMa;
    list.push_back({l, 0});
    for (int a = 1; a <= l; ++a) {
      list.push_back({l, a});
      if (pairs) list.push_back({l, -a});
    }
    for (int a = 1; a <= l && !pairs; ++a) list.push_back({l, -a});
  }
  return list;
}

}  // namespace

int prove_same_function(const Convention& convention, const ConventionMap& ours_to_convention) {
  if (ours_to_convention.to_order != convention.order) throw Refuted("the map leads to another index order");
  for (int l = 0; l <= ours_to_convention.degree; ++l) {
    const std::vector<Written> band = written_band(convention, l);
    const Matrix<RadicalSum>& c = ours_to_convention.forward.at(l);
    const cln::cl_RA convolution = convolution_with(convention.folded, l);
    for (int n = -l; n <= l; ++n) {
      PolynomialSum difference;
      for (int a = -l; a <= l; ++a) {
        const RadicalSum& weight = c(l + a, l + n);
        if (weight.is_zero()) continue;
        const Written& y = band[l + a];
        difference.add(weight * y.factor, y.re);
        difference.add(weight * y.factor * RadicalSum::imaginary_unit(), y.im);
      }
      const BasisFunction& ours = basis_function(l, n);
      difference.add(-RadicalSum(Surd(convolution) * ours.factor), ours.homogeneous);
      if (!difference.terms({"x", "y", "z"}).empty()) throw Refuted(ours.name() + ": sum c' Y' differs from sum c Y");
    }
  }
  return 1;
}

int prove_index_orders(int degree, const Storage& storage) {
  for (const IndexOrder order : index_orders()) {
    for (int largest = 0; largest <= degree; ++largest) {
      const std::vector<DegreeOrder> list = listed(order, largest);
      if (storage.size(order, largest) != static_cast<int>(list.size())) {
        throw Refuted("the size of an array to degree " + std::to_string(largest));
      }
      for (std::size_t i = 0; i < list.size(); ++i) {
        const auto [l, m] = list[i];
        if (l < 0) continue;
        if (storage.position(order, largest, l, m) == static_cast<int>(i)) continue;
        throw Refuted("l=" + std::to_string(l) + " m=" + std::to_string(m) + " stands at another place");
      }
    }
  }
  return static_cast<int>(index_orders().size()) * (degree + 1);
}

}  // namespace sh::symbolic
