// Recipes: zonal coefficients of a cap of unit value about +z from u = 1 - cos(half-angle).
//
//     z_0 = sqrt(pi) u,   z_l = sqrt((2l+1) pi) s P_l'(c) / (l (l+1)),   c = 1 - u,   s = 1 - c^2 = u (2 - u)
//
// u and 2 - u stay factors, so tiny caps and caps that leave out a tiny cap keep their digits. Reference: the integral
// of (2l+1) P_l = P'_(l+1) - P'_(l-1) over the cap, [AbramowitzStegun64] 8.5.3, 8.5.4.
#include "codegen/recipes/basis/sphere.hpp"
#include "codegen/recipes/zonal/zonal.hpp"

namespace sh::codegen::recipes {
namespace {

using symbolic::Surd;

// sqrt((2l+1) pi)
Surd norm(int l) { return Surd::square_root(cln::cl_RA(2 * l + 1), 1); }

Kernel described(int degree) {
  Kernel kernel;
  kernel.title = degree == 0
                     ? "The mean of a spherical cap, as its zonal coefficient of degree 0"
                     : "Zonal coefficients of degree 0 to " + std::to_string(degree) + " of a spherical cap about +z";
  kernel.citation =
      "M. Abramowitz, I. A. Stegun, Handbook of Mathematical Functions, 1964, 8.5.3, 8.5.4; constants derived exactly";
  kernel.domain =
      "0 <= one_minus_cos <= 2, that is 1 - cos(half-angle): 1 a hemisphere, 2 the sphere; any tiny cap. For a small "
      "half-angle h take 2 sin(h/2)^2";
  kernel.result = "z_l of sum z_l Y_l0 for the function 1 in the cap and 0 outside; orthonormal Y_l0";
  kernel.parameters = {parameter(Role::kCapSize, "one_minus_cos")};
  kernel.results = {array(Role::kZonalCoefficients, "zonal", degree)};
  for (int l = 0; l <= degree; ++l) kernel.outputs.push_back({-1, numbered("l=", l)});
  return kernel;
}

// Polynomials of higher degree use s - 1/2, because in powers of s their coefficients are much larger than their
// values.
constexpr int kCentredFrom = 5;

// The parts of every coefficient. `weight u` and `weight s` include the weight.
struct Cap {
  NodeId u;           // 1 - cos
  NodeId c;           // cos
  NodeId s;           // sin^2
  NodeId weighted_u;  // weight u
  NodeId weighted_s;  // weight s
};

Cap cap_of(Builder& build, NodeId u, NodeId weight) {
  Cap cap{u, -1, -1, u, -1};
  const NodeId one = build.constant(Surd(1), "one");
  const NodeId two = build.constant(Surd(2), "two");
  const NodeId complement = build.sub(two, u);
  cap.c = build.sub(one, u, "c");
  cap.s = build.mul(u, complement, "s");
  if (weight >= 0) cap.weighted_u = build.mul(weight, u, "lit_u");
  cap.weighted_s = weight < 0 ? cap.s : build.mul(cap.weighted_u, complement, "lit_s");
  return cap;
}

// The coefficients of P_l'(c) / (l (l+1)), without its factor c for even l, in powers of s - center, lowest first.
std::vector<cln::cl_RA> in_sine_square(int l, const cln::cl_RA& center) {
  // c^2 = (1 - center) - (s - center)
  std::vector<cln::cl_RA> powers = composed(whole_axial_form(l, 1).powers, 1 - center, -1);
  for (cln::cl_RA& power : powers) power = power / (l * (l + 1));
  return powers;
}

// The polynomial in v by Horner's rule. If it begins with a positive constant, every step adds positive constants or
// subtracts from them; otherwise it uses the coefficients unchanged.
NodeId horner(Builder& build, const std::vector<cln::cl_RA>& coefficients, const Surd& scale, NodeId v, int l) {
  const auto constant = [&](std::size_t k, const cln::cl_RA& value) {
    return build.constant(scale * Surd(value), numbered("a", l) + "_" + std::to_string(k));
  };
  std::size_t k = coefficients.size() - 1;
  bool negated = cln::plusp(coefficients[0]) && cln::minusp(coefficients[k]);
  NodeId value = constant(k, negated ? -coefficients[k] : coefficients[k]);
  while (k-- > 0) {
    const NodeId product = build.mul(value, v);
    const NodeId a = constant(k, cln::abs(coefficients[k]));
    const bool minus = cln::minusp(coefficients[k]);
    const bool from_constant = negated != minus && cln::plusp(coefficients[0]);
    if (from_constant) {
      value = build.sub(a, product);
      negated = minus;
    } else {
      value = negated == minus ? build.add(product, a) : build.sub(product, a);
    }
  }
  return value;
}

}  // namespace

std::vector<NodeId> append_cap(Builder& build, NodeId one_minus_cos, NodeId weight, int degree) {
  const Cap cap = cap_of(build, one_minus_cos, weight);
  const NodeId first = build.constant(norm(0), "k0");
  std::vector<NodeId> z{build.mul(first, cap.weighted_u, "z0")};
  const NodeId even = build.mul(cap.c, cap.weighted_s, weight < 0 ? "cs" : "lit_cs");
  NodeId middle = -1;
  for (int l = 1; l <= degree; ++l) {
    const bool centred = l >= kCentredFrom;
    if (centred && middle < 0) middle = build.sub(cap.s, build.constant(Surd(cln::cl_RA(1) / 2), "k_half"), "v");
    const std::vector<cln::cl_RA> coefficients = in_sine_square(l, centred ? cln::cl_RA(1) / 2 : cln::cl_RA(0));
    const NodeId polynomial = horner(build, coefficients, norm(l), centred ? middle : cap.s, l);
    z.push_back(build.mul(polynomial, l % 2 == 0 ? even : cap.weighted_s, numbered("z", l)));
  }
  return z;
}

Kernel cap_horner(int degree) {
  Kernel kernel = described(degree);
  Builder build(kernel);
  set_outputs(kernel, append_cap(build, build.input(0, "u"), -1, degree));
  return kernel;
}

Kernel cap_recurrence(int degree) {
  Kernel kernel = described(degree);
  Builder build(kernel);
  const Cap cap = cap_of(build, build.input(0, "u"), -1);
  std::vector<NodeId> z{build.mul(build.constant(norm(0), "k0"), cap.u, "z0")};
  if (degree > 0) z.push_back(build.mul(build.constant(norm(1) * Surd(cln::cl_RA(1) / 2), "k1"), cap.s, "z1"));
  // l P'_(l+1) = (2l+1) c P'_l - (l+1) P'_(l-1)
  for (int l = 1; l < degree; ++l) {
    const Surd a = Surd(cln::cl_RA(2 * l + 1) / (l + 2)) * norm(l + 1) / norm(l);
    const NodeId raised = build.mul(build.mul(build.constant(a, numbered("a", l + 1)), cap.c), z.back());
    if (l == 1) {
      z.push_back(raised);
    } else {
      const Surd b = Surd(cln::cl_RA(l - 1) / (l + 2)) * norm(l + 1) / norm(l - 1);
      const NodeId lowered = build.mul(build.constant(b, numbered("b", l + 1)), z[l - 1]);
      z.push_back(build.sub(raised, lowered));
    }
    build.name(z.back(), numbered("z", l + 1));
  }
  set_outputs(kernel, z);
  return kernel;
}

}  // namespace sh::codegen::recipes
