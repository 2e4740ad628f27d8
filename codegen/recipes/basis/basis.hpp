// The recipes of the basis: values, gradients, values at any vector, evaluation and projection.
#pragma once

#include "codegen/ir/ir.hpp"
#include "codegen/recipes/basis/parity_columns.hpp"

namespace sh::codegen::recipes {

/// The citation of basis_recurrence.
inline constexpr const char* kRecurrenceSource =
    "P.-P. Sloan, \"Efficient Spherical Harmonic Evaluation\", JCGT 2(2), 2013; constants derived exactly";

/// Appends the nodes of every Y_lm on the unit sphere, in order. If `weight` is a node, it multiplies all values (it
/// enters at the start of the columns). Throws std::invalid_argument for a degree that symbolic::require_basis_index
/// refuses.
std::vector<NodeId> append_recurrence(Builder& build, const Direction& d, int degree, NodeId weight = -1);

/// Appends the nodes of every solid harmonic r^l Y_lm, in order.
std::vector<NodeId> append_solid_recurrence(Builder& build, const Direction& d, int degree);

/// basis_l<degree>: inputs x, y, z with |d| = 1; out ((degree+1)^2). Throws the exceptions of append_recurrence.
Kernel basis_recurrence(int degree);

/// The citation of basis_centred.
inline constexpr const char* kCentredSource =
    "polynomials in 2z^2-1 for m <= 2, the recurrence in l for m > 2, doubling in m; derived exactly";

/// Appends the nodes of every Y_lm, in order. Throws the exceptions of symbolic::require_basis_index.
std::vector<NodeId> append_centred(SignedBuilder& build, const Direction& d, int degree);

/// basis_l<degree> with small rounding error.
Kernel basis_centred(int degree);

/// The largest degree of recipes by Chebyshev polynomials: their sums in powers of T_2 lose digits above it.
inline constexpr int kLastChebyshev = 10;

/// Appends the nodes of every Y_lm on the unit sphere, in order. If `weight` is a node, it multiplies all values.
/// Throws the exceptions of symbolic::require_basis_index.
std::vector<NodeId> append_chebyshev(SignedBuilder& build, const Direction& d, int degree, NodeId weight = -1);

/// basis_l<degree>, degree 0 to kLastChebyshev, with few operations and small rounding error.
Kernel basis_chebyshev(int degree);

/// Appends the nodes of every Y_lm on the unit sphere, in order. If `weight` is a node, it multiplies all values.
/// Throws the exceptions of symbolic::require_basis_index.
std::vector<NodeId> append_parity(SignedBuilder& build, const Direction& d, int degree, const ParityChoices& choices,
                                  NodeId weight = -1);

/// Appends the nodes of every solid harmonic r^l Y_lm, in order. One of the nodes is d S_(m+1,m) / dz.
std::vector<NodeId> append_solid(SignedBuilder& build, const Direction& d, int degree);

/// basis_l<degree> with accurate_choices.
Kernel basis_parity(int degree);
/// basis_l<degree> with the fewest operations.
Kernel basis_parity_least(int degree);

/// basis_gradient_l<degree>: any x, y, z; out, dx, dy, dz ((degree+1)^2 each). Parity columns give the values.
Kernel basis_gradient_ladder(int degree);
/// The same, but the recurrence in l gives the values.
Kernel basis_gradient_recurrence(int degree);

/// basis_normalised_l<degree>: x, y, z; out ((degree+1)^2). They compute d / |d| (eight operations, one square root and
/// one division) and then the basis by one of its recipes.
Kernel basis_normalised_chebyshev(int degree);
Kernel basis_normalised_parity(int degree);

/// evaluate_l<degree>: c ((degree+1)^2), x, y, z with |d| = 1; returns the value.
Kernel evaluate_columns(int degree);
Kernel evaluate_sum(int degree);

/// evaluate_rgb_l<degree>: c (3, (degree+1)^2) channel by channel, x, y, z; rgb (3).
Kernel evaluate_rgb_chebyshev(int degree);
Kernel evaluate_rgb_columns(int degree);
Kernel evaluate_rgb_sum(int degree);

/// The position of the coefficient of x^i y^j (in the part p) or of z x^i y^j (in the part q, with_z). p comes first,
/// then q; each part is ordered by falling i, then by falling j.
int polynomial_index(int degree, int i, int j, bool with_z);

/// The exact coefficient of every monomial in every Y_lm. Rows: polynomial_index; columns: l(l+1)+m.
std::vector<std::vector<symbolic::Surd>> polynomial_matrix(int degree);
/// The norm of each row of the matrix: the largest value of this coefficient for |c| = 1.
const std::vector<double>& polynomial_norms(int degree);

/// evaluate_prepare_l<degree>: c ((degree+1)^2); polynomial ((degree+1)^2). Converts each order to powers of x^2+y^2,
/// then to monomials.
Kernel evaluate_prepare(int degree);
/// evaluate_prepared_l<degree>: polynomial ((degree+1)^2), x, y, z with |d| = 1; returns the value.
Kernel evaluate_prepared(int degree);

/// project_l<degree>: x, y, z with |d| = 1, weight; sum ((degree+1)^2) in place.
Kernel project_chebyshev(int degree);
Kernel project_parity(int degree);
Kernel project_recurrence(int degree);

/// project_moments_l<degree>: x, y, z, weight; moments ((degree+1)^2) in place.
Kernel project_moments(int degree);
/// project_finish_l<degree>: moments ((degree+1)^2); c ((degree+1)^2).
Kernel project_finish(int degree);

}  // namespace sh::codegen::recipes
