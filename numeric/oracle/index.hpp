// The places of coefficients: degree l and order m at l(l+1)+m. The one definition for the whole project.
#pragma once

namespace sh::numeric {

/// The number of coefficients up to and including `degree`: bands^2.
constexpr int coefficient_count(int degree) { return (degree + 1) * (degree + 1); }

/// The place of degree l, order m among the coefficients: l(l+1)+m.
constexpr int coefficient_index(int degree, int order) { return degree * (degree + 1) + order; }

}  // namespace sh::numeric
