#include "codegen/recipes/basis.hpp"

#include <cln/integer.h>

#include <tuple>
#include <utility>

#include "symbolic/basis.hpp"

namespace sh::codegen::recipes {
namespace {

using symbolic::Surd;

std::string indexed(const char* letter, int l, int m) {
  return std::string(letter) + "_" + std::to_string(l) + "_" + std::to_string(m);
}

// Y_mm / Re (x+iy)^m = (2m-1)!! sqrt((2 - delta_m0) (2m+1) / (4 pi (2m)!))
Surd sectoral_factor(int m) {
  const cln::cl_I odd = m == 0 ? cln::cl_I(1) : cln::doublefactorial(static_cast<unsigned>(2 * m - 1));
  const cln::cl_RA square =
      cln::cl_RA((m == 0 ? 1 : 2) * (2 * m + 1)) / (4 * cln::factorial(static_cast<unsigned>(2 * m)));
  return Surd(odd) * Surd::square_root(square, -1);
}

// a_l_m = sqrt((4l^2 - 1) / (l^2 - m^2))
Surd upper_factor(int l, int m) { return Surd::square_root(cln::cl_RA(4 * l * l - 1) / (l * l - m * m)); }

// b_l_m = sqrt((2l+1) ((l-1)^2 - m^2) / ((2l-3) (l^2 - m^2))) = a_l_m / a_(l-1)_m
Surd lower_factor(int l, int m) { return upper_factor(l, m) / upper_factor(l - 1, m); }

struct Direction {
  NodeId x, y, z;
};

// p_l_m for l = m .. degree; element l - m.
std::vector<NodeId> axial_column(Builder& build, NodeId z, int degree, int m) {
  std::vector<NodeId> p{build.constant(sectoral_factor(m), indexed("k", m, m))};
  for (int l = m + 1; l <= degree; ++l) {
    const NodeId raised = build.mul(build.mul(build.constant(upper_factor(l, m), indexed("a", l, m)), z), p.back());
    if (l == m + 1) {
      p.push_back(raised);
    } else {
      const NodeId b = build.constant(lower_factor(l, m), indexed("b", l, m));
      p.push_back(build.sub(raised, build.mul(b, p[static_cast<std::size_t>(l - m - 2)])));
    }
    build.name(p.back(), indexed("p", l, m));
  }
  return p;
}

// (c_(m+1), s_(m+1)) from (c_m, s_m); (c_1, s_1) = (x, y).
std::pair<NodeId, NodeId> next_azimuthal(Builder& build, const Direction& d, NodeId c, NodeId s, int m) {
  // One call a statement: the order of nodes must not depend on the compiler.
  const std::string suffix = std::to_string(m + 1);
  const NodeId xc = build.mul(d.x, c);
  const NodeId ys = build.mul(d.y, s);
  const NodeId next_c = build.sub(xc, ys, "c" + suffix);
  const NodeId xs = build.mul(d.x, s);
  const NodeId yc = build.mul(d.y, c);
  const NodeId next_s = build.add(xs, yc, "s" + suffix);
  return {next_c, next_s};
}

void describe(Kernel& kernel, int degree) {
  kernel.citation =
      "P.-P. Sloan, \"Efficient Spherical Harmonic Evaluation\", JCGT 2(2), 2013; constants derived exactly";
  kernel.title = degree == 0
                     ? "The real spherical harmonic of degree 0"
                     : "Real spherical harmonics of degree 0 to " + std::to_string(degree) + " in one direction";
  kernel.domain = "|d| = 1 for d = (x, y, z); z is the polar axis";
  kernel.result = "Y_lm(d) at index l(l+1)+m, orthonormal on the unit sphere, no Condon-Shortley phase";
  kernel.parameters = {{"x", {}}, {"y", {}}, {"z", {}}};
  kernel.results = {{"out", {(degree + 1) * (degree + 1)}}};
}

void set_output(Kernel& kernel, int l, int m, NodeId node) {
  const int index = l * (l + 1) + m;
  Output& output = kernel.outputs[static_cast<std::size_t>(index)];
  output.node = node;
  output.label = "l=" + std::to_string(l) + " m=" + std::to_string(m);
}

}  // namespace

Kernel basis_recurrence(int degree) {
  symbolic::require_basis_index(degree, 0);
  Kernel kernel;
  describe(kernel, degree);
  kernel.outputs.resize(static_cast<std::size_t>(kernel.results[0].size()));
  Builder build(kernel);
  const Direction d{build.input(0, "x"), build.input(1, "y"), build.input(2, "z")};

  const std::vector<NodeId> zonal = axial_column(build, d.z, degree, 0);
  for (int l = 0; l <= degree; ++l) set_output(kernel, l, 0, zonal[static_cast<std::size_t>(l)]);
  NodeId c = d.x;
  NodeId s = d.y;
  for (int m = 1; m <= degree; ++m) {
    if (m > 1) std::tie(c, s) = next_azimuthal(build, d, c, s, m - 1);
    const std::vector<NodeId> p = axial_column(build, d.z, degree, m);
    for (int l = m; l <= degree; ++l) {
      const NodeId axial = p[static_cast<std::size_t>(l - m)];
      set_output(kernel, l, -m, build.mul(axial, s, indexed("y", l, m) + "s"));
      set_output(kernel, l, m, build.mul(axial, c, indexed("y", l, m) + "c"));
    }
  }
  return kernel;
}

}  // namespace sh::codegen::recipes
