// Recipe: all real spherical harmonics up to a degree by the normalized recurrence in l, one column for each order m.
//
// With c_m + i s_m = (x + iy)^m and Y_lm = p_l_m c_m (m >= 0), p_l_m s_-m (m < 0):
//     p_m_m = k_m_m,   p_l_m = a_l_m z p_(l-1)_m - b_l_m p_(l-2)_m,
//     c_(m+1) = x c_m - y s_m,   s_(m+1) = x s_m + y c_m.
// The structure comes from [Sloan13]; this file derives the constants exactly. The recipe writes the plain recurrence,
// and the passes find its short forms for small l - m. Off the unit sphere, x^2+y^2+z^2 multiplies b_l_m.
#include "codegen/recipes/basis/basis.hpp"

#include "codegen/recipes/basis/chebyshev_columns.hpp"
#include "symbolic/basis/basis.hpp"

namespace sh::codegen::recipes {
namespace {

constexpr Recurrence kRecurrence{upper_factor, lower_factor};

// r2: x^2+y^2+z^2 off the unit sphere, otherwise -1.
std::vector<NodeId> append(Builder& build, const Direction& d, int degree, NodeId r2, NodeId weight) {
  symbolic::require_basis_index(degree, 0);
  std::vector<NodeId> values(coefficient_count(degree));
  NodeId start = build.constant(sectoral_factor(0), indexed("k", 0, 0));
  if (weight >= 0) start = build.mul(start, weight);
  const std::vector<NodeId> zonal = append_column(build, kRecurrence, d.z, start, degree, 0, r2);
  for (int l = 0; l <= degree; ++l) values[coefficient_index(l, 0)] = zonal[l];
  Pair power{d.x, d.y};
  if (weight >= 0) {
    power.cosine = build.mul(weight, d.x);
    power.sine = build.mul(weight, d.y);
  }
  for (int m = 1; m <= degree; ++m) {
    if (m > 1) power = next_power(build, d.x, d.y, power, m);
    const NodeId k = build.constant(sectoral_factor(m), indexed("k", m, m));
    const std::vector<NodeId> p = append_column(build, kRecurrence, d.z, k, degree, m, r2);
    for (int l = m; l <= degree; ++l) {
      values[coefficient_index(l, -m)] = build.mul(p[l - m], power.sine, indexed("y", l, m) + "s");
      values[coefficient_index(l, m)] = build.mul(p[l - m], power.cosine, indexed("y", l, m) + "c");
    }
  }
  return values;
}

// Computes d / |d| and then the basis; append(build, direction) makes its nodes.
template <class Append>
Kernel normalized(int degree, const std::string& source, const Append& append) {
  Kernel kernel;
  describe_basis(kernel, degree);
  kernel.title = "Real spherical harmonics of degree 0 to " + std::to_string(degree) + " in the direction of a vector";
  kernel.domain = "d = (x, y, z) finite, not zero, |d|^2 neither over- nor underflows; z is the polar axis";
  kernel.result = "Y_lm(d/|d|) at index l(l+1)+m, orthonormal on the unit sphere, no Condon-Shortley phase";
  kernel.parameters = with_direction({}, {}, Role::kVector);
  kernel.citation = source;
  kernel.factored = true;
  SignedBuilder build(kernel);
  const Direction d = direction_inputs(build);
  const NodeId square = append_squares(build, d).r2;
  const NodeId one = build.constant(symbolic::Surd(1), "one");
  const NodeId inverse = build.div(one, build.sqrt(square), "inverse");
  const NodeId x = build.mul(d.x, inverse, "nx");
  const NodeId y = build.mul(d.y, inverse, "ny");
  const NodeId z = build.mul(d.z, inverse, "nz");
  set_outputs(kernel, append(build, Direction{x, y, z}));
  return kernel;
}

}  // namespace

std::vector<NodeId> append_recurrence(Builder& build, const Direction& d, int degree, NodeId weight) {
  return append(build, d, degree, -1, weight);
}

std::vector<NodeId> append_solid_recurrence(Builder& build, const Direction& d, int degree) {
  return append(build, d, degree, append_squares(build, d).r2, -1);
}

Kernel basis_recurrence(int degree) {
  Kernel kernel;
  describe_basis(kernel, degree);
  kernel.citation = kRecurrenceSource;
  Builder build(kernel);
  const Direction d = direction_inputs(build);
  set_outputs(kernel, append_recurrence(build, d, degree));
  return kernel;
}

Kernel basis_normalised_chebyshev(int degree) {
  return normalized(degree, kChebyshevSource,
                    [degree](SignedBuilder& build, const Direction& d) { return append_chebyshev(build, d, degree); });
}

Kernel basis_normalised_parity(int degree) {
  return normalized(degree, kParitySource, [degree](SignedBuilder& build, const Direction& d) {
    return append_parity(build, d, degree, accurate_choices(degree));
  });
}

}  // namespace sh::codegen::recipes
