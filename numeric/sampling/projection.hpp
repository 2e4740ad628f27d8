// From values on the sphere to coefficients: by quadrature where the nodes are ours, by least squares where the samples
// lie wherever somebody measured them.
//
// Conventions: README.md. Double only; the basis is the oracle's, so degree and accuracy have no limit but rounding.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "numeric/oracle/quadrature.hpp"

namespace sh::numeric {

/// out (bands^2) = sum over the nodes of weight f(x, y, z) Y_i(x, y, z): the coefficients of f up to `degree`, with the
/// error of the rule. Exact up to rounding when f has degree k and the rule integrates degree k + `degree`. Throws
/// std::invalid_argument for degree < 0, and when f is not finite at a node (which one is said).
std::vector<double> project(int degree, std::span<const SphereNode<double>> nodes,
                            const std::function<double(double, double, double)>& f);

/// A measurement: |d| within 1e-3 of 1 (it is scaled to 1), value finite, weight >= 0 (0: left out).
struct SphereSample {
  double x, y, z;
  double value;
  double weight = 1;
};

struct LeastSquaresFit {
  std::vector<double> coefficients;  // (bands^2)
  double condition;                  // of the weighted matrix of basis values: digits lost are log10 of it
  double residual_rms;               // sqrt(sum w r^2 / sum w) of r = value - fit
  double residual_max;               // largest |r| of a sample of weight > 0
  std::size_t worst_sample;          // where
};

/// The coefficients up to `degree` that minimize sum w r^2: orthogonal triangularisation of the matrix with the values
/// as its last column, block by block [GolubVanLoan13] 5.3, so memory does not grow with the samples; rank and
/// condition number from the singular values of the triangle. Throws std::invalid_argument in one line for degree < 0,
/// samples that break the above (which one), fewer samples than coefficients, and directions that do not determine all
/// coefficients (their rank, singular values below epsilon x samples x the largest count as 0): all on one circle, in
/// too few places. Time O(samples bands^4).
LeastSquaresFit fit_samples(int degree, std::span<const SphereSample> samples);

}  // namespace sh::numeric
