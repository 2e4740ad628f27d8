// Recipe: all real spherical harmonics up to a degree by the normalised recurrence in l, one column per order m.
//
// With c_m + i s_m = (x + iy)^m and Y_lm = p_l_m c_m (m >= 0), p_l_m s_-m (m < 0):
//     p_m_m = k_m_m,   p_l_m = a_l_m z p_(l-1)_m - b_l_m p_(l-2)_m,
//     c_(m+1) = x c_m - y s_m,   s_(m+1) = x s_m + y c_m.
// [Sloan13] has the structure; the constants are derived here, exactly. What is written is the plain recurrence; the
// passes find its short forms for small l - m. Off the unit sphere b_l_m is multiplied by x^2+y^2+z^2.
#pragma once

#include "codegen/recipes/basis/sphere.hpp"

namespace sh::codegen::recipes {

inline constexpr const char* kRecurrenceSource =
    "P.-P. Sloan, \"Efficient Spherical Harmonic Evaluation\", JCGT 2(2), 2013; constants derived exactly";

/// Appends the nodes of every Y_lm on the unit sphere, in order, times `weight` where one is given (it enters where the
/// columns start). Throws std::invalid_argument for a degree that symbolic::require_basis_index refuses.
std::vector<NodeId> append_recurrence(Builder& build, const Direction& d, int degree, NodeId weight = -1);

/// Appends the nodes of every solid harmonic r^l Y_lm, in order.
std::vector<NodeId> append_solid_recurrence(Builder& build, const Direction& d, int degree);

/// basis_l<degree>: inputs x, y, z with |d| = 1; out ((degree+1)^2). Throws as append_recurrence does.
Kernel basis_recurrence(int degree);

}  // namespace sh::codegen::recipes
