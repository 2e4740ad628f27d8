// Recipe: all real spherical harmonics up to a degree by the normalized recurrence in l, one column for each order m.
//
// With c_m + i s_m = (x + iy)^m and Y_lm = p_l_m c_m (m >= 0), p_l_m s_-m (m < 0):
//     p_m_m = k_m_m,   p_l_m = a_l_m z p_(l-1)_m - b_l_m p_(l-2)_m,
//     c_(m+1) = x c_m - y s_m,   s_(m+1) = x s_m + y c_m.
// The structure comes from [Sloan13]; this file derives the constants exactly. The recipe writes the plain recurrence,
// and the passes find its short forms for small l - m. Off the unit sphere, x^2+y^2+z^2 multiplies b_l_m.
#include "codegen/recipes/basis/basis.hpp"

#include <tuple>
#include <utility>

#include "symbolic/basis/basis.hpp"

namespace sh::codegen::recipes {
namespace {

// p_l_m for l = m .. degree from p_m_m, at element l - m. r2: x^2+y^2+z^2 off the unit sphere, otherwise -1.
std::vector<NodeId> axial_column(Builder& build, NodeId z, NodeId r2, NodeId start, int degree, int m) {
  std::vector<NodeId> p{start};
  for (int l = m + 1; l <= degree; ++l) {
    const NodeId raised = build.mul(build.mul(build.constant(upper_factor(l, m), indexed("a", l, m)), z), p.back());
    if (l == m + 1) {
      p.push_back(raised);
    } else {
      NodeId b = build.constant(lower_factor(l, m), indexed("b", l, m));
      if (r2 >= 0) b = build.mul(b, r2);
      p.push_back(build.sub(raised, build.mul(b, p[l - m - 2])));
    }
    build.name(p.back(), indexed("p", l, m));
  }
  return p;
}

// (c_(m+1), s_(m+1)) from (c_m, s_m); (c_1, s_1) = (x, y), or a multiple of it.
std::pair<NodeId, NodeId> next_azimuthal(Builder& build, const Direction& d, NodeId c, NodeId s, int m) {
  // Each statement has only one call, because the order of nodes must not depend on the compiler.
  const std::string suffix = std::to_string(m + 1);
  const NodeId xc = build.mul(d.x, c);
  const NodeId ys = build.mul(d.y, s);
  const NodeId next_c = build.sub(xc, ys, "c" + suffix);
  const NodeId xs = build.mul(d.x, s);
  const NodeId yc = build.mul(d.y, c);
  const NodeId next_s = build.add(xs, yc, "s" + suffix);
  return {next_c, next_s};
}

std::vector<NodeId> append(Builder& build, const Direction& d, int degree, NodeId r2, NodeId weight) {
  symbolic::require_basis_index(degree, 0);
  std::vector<NodeId> values(basis_count(degree));
  NodeId start = build.constant(sectoral_factor(0), indexed("k", 0, 0));
  if (weight >= 0) start = build.mul(start, weight);
  const std::vector<NodeId> zonal = axial_column(build, d.z, r2, start, degree, 0);
  for (int l = 0; l <= degree; ++l) values[basis_index(l, 0)] = zonal[l];
  NodeId c = weight < 0 ? d.x : build.mul(weight, d.x);
  NodeId s = weight < 0 ? d.y : build.mul(weight, d.y);
  for (int m = 1; m <= degree; ++m) {
    if (m > 1) std::tie(c, s) = next_azimuthal(build, d, c, s, m - 1);
    const NodeId k = build.constant(sectoral_factor(m), indexed("k", m, m));
    const std::vector<NodeId> p = axial_column(build, d.z, r2, k, degree, m);
    for (int l = m; l <= degree; ++l) {
      const NodeId axial = p[l - m];
      values[basis_index(l, -m)] = build.mul(axial, s, indexed("y", l, m) + "s");
      values[basis_index(l, m)] = build.mul(axial, c, indexed("y", l, m) + "c");
    }
  }
  return values;
}

}  // namespace

std::vector<NodeId> append_recurrence(Builder& build, const Direction& d, int degree, NodeId weight) {
  return append(build, d, degree, -1, weight);
}

std::vector<NodeId> append_solid_recurrence(Builder& build, const Direction& d, int degree) {
  const NodeId x2 = build.mul(d.x, d.x, "x2");
  const NodeId y2 = build.mul(d.y, d.y, "y2");
  const NodeId z2 = build.mul(d.z, d.z, "z2");
  const NodeId r2 = build.add(build.add(x2, y2), z2, "r2");
  return append(build, d, degree, r2, -1);
}

Kernel basis_recurrence(int degree) {
  Kernel kernel;
  describe_basis(kernel, degree);
  kernel.citation = kRecurrenceSource;
  Builder build(kernel);
  const Direction d = direction_inputs(build);
  set_basis_outputs(kernel, append_recurrence(build, d, degree));
  return kernel;
}

}  // namespace sh::codegen::recipes
