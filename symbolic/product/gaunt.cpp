#include "symbolic/product/gaunt.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace sh::symbolic {

IndexTriple sorted(IndexTriple triple) {
  std::array<int, 3> indices{triple.i, triple.j, triple.k};
  std::sort(indices.begin(), indices.end());
  return {indices[0], indices[1], indices[2]};
}

bool gaunt_may_differ_from_zero(int i, int j, int k) {
  const DegreeOrder a = degree_order(i);
  const DegreeOrder b = degree_order(j);
  const DegreeOrder c = degree_order(k);
  const bool even = (a.degree + b.degree + c.degree) % 2 == 0;
  const bool triangle = std::abs(a.degree - b.degree) <= c.degree && c.degree <= a.degree + b.degree;
  const int negative = (a.order < 0 ? 1 : 0) + (b.order < 0 ? 1 : 0) + (c.order < 0 ? 1 : 0);
  std::array<int, 3> sizes{std::abs(a.order), std::abs(b.order), std::abs(c.order)};
  std::sort(sizes.begin(), sizes.end());
  return even && triangle && negative % 2 == 0 && sizes[0] + sizes[1] == sizes[2];
}

void require_gaunt_degree(int degree) {
  if (degree < 0 || degree > kMaxGauntDegree) {
    throw std::invalid_argument("Gaunt tensor: degree " + std::to_string(degree) + "; it should be 0 to " +
                                std::to_string(kMaxGauntDegree) +
                                " (products of polynomials of higher degree are slow to integrate)");
  }
}

}  // namespace sh::symbolic
