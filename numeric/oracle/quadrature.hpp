// Exact integration of polynomials: Gauss-Legendre on [-1, 1] and a product rule on the sphere, in any Real.
//
// Input: a number of nodes, or the degree to be integrated exactly. Output: nodes and weights, correct to the last
// digit or two of Real. Compiled for the six types of real.hpp.
#pragma once

#include <vector>

namespace sh::numeric {

/// sum weights[i] f(nodes[i]) = integral of f over [-1, 1] for every polynomial f of degree <= 2n-1. Nodes rise and are
/// symmetric about 0 to the last bit.
template <class Real>
struct GaussLegendreRule {
  std::vector<Real> nodes;    // (n)
  std::vector<Real> weights;  // (n), sum 2
};

/// The rule with n >= 1 nodes; throws std::invalid_argument otherwise. Cost O(n^2).
template <class Real>
GaussLegendreRule<Real> gauss_legendre(int n);

template <class Real>
struct SphereNode {
  Real x, y, z, weight;
};

/// Nodes on the unit sphere whose weights sum to 4 pi: sum weight f(x, y, z) = integral of f over the sphere for every
/// polynomial f of degree <= `degree`. Gauss-Legendre in z times degree + 1 equidistant azimuths; no node is a pole.
/// To integrate products of two bands l use degree 2 l. Throws std::invalid_argument for degree < 0.
template <class Real>
std::vector<SphereNode<Real>> sphere_rule(int degree);

}  // namespace sh::numeric
