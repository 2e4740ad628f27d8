// Wigner 3j symbols of integer degrees, exactly, and in floating point for all values of one degree at once.
//
//     ( a  b  c )
//     ( A  B  C )    degrees {a, b, c}, orders {A, B, C}
//
// Zero unless A + B + C = 0 and |a - b| <= c <= a + b (and for A = B = C = 0 unless a + b + c is even). All throw
// std::invalid_argument, one line, for a degree outside 0 .. kMaxWignerDegree and an |order| above its degree.
#pragma once

#include <array>
#include <vector>

#include "numeric/oracle/surd.hpp"

namespace sh::numeric {

constexpr int kMaxWignerDegree = 10000;

/// Three degrees or three orders.
using Triple = std::array<int, 3>;

/// By Racah's formula, its sum as one of products of three binomials, which are integers, the rest as powers of primes
/// [Racah42], [JohanssonForssen16]. Measured: 7 microseconds at degree 100, 0.1 ms at 1000, 7 ms at 10,000.
Surd wigner_3j_exact(const Triple& degrees, const Triple& orders);

/// values[i] is the symbol with c = first_degree + i, C = -A - B; c runs from max(|a - b|, |C|) to a + b.
template <class Real>
struct Wigner3jRow {
  int first_degree = 0;
  std::vector<Real> values;
};

/// By the three-term recurrence in c from both ends, matched where it oscillates, normalized by
/// sum (2c+1) value^2 = 1 [SchultenGordon75], [LuscombeLuban98]. Growing values are scaled, so that nothing overflows;
/// the tails are right relative to themselves, down to where Real underflows. Measured in double against exact values,
/// to degree 1000: 43 epsilon of the row's largest value, in the tails 230 epsilon of the value. Compiled for the six
/// types of real.hpp.
template <class Real>
Wigner3jRow<Real> wigner_3j_row(int a, int b, int order_a, int order_b);

/// One symbol, from its row.
template <class Real>
Real wigner_3j(const Triple& degrees, const Triple& orders);

/// Throws for the arguments that the functions above refuse; `function` begins the line.
void require_wigner(const char* function, const Triple& degrees, const Triple& orders);

/// The orders add up to 0 and the degrees form a triangle.
bool wigner_3j_may_differ_from_zero(const Triple& degrees, const Triple& orders);

/// Racah's sum, sum over k of (-1)^k C(a+b-c, k) C(a-b+c, a-A-k) C(-a+b+c, b+B-k): the symbol is this times
/// (-1)^(a-b-C) sqrt of (a+A)! (a-A)! (b+B)! (b-B)! (c+C)! (c-C)! / ((a+b-c)! (a-b+c)! (-a+b+c)! (a+b+c+1)!).
/// Precondition: the symbol may differ from zero.
Integer racah_sum(const Triple& degrees, const Triple& orders);

}  // namespace sh::numeric
