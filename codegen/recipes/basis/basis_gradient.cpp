// Recipes: the solid harmonics S_lm = r^l Y_lm up to a degree and their Cartesian gradients.
//
// Ladder: with q = (2l+1)/(2l-1), C and S for orders m and -m, and functions of degree l-1 on the right side
// [Hobson31]:
//     d/dz S_lm = sqrt(q (l^2-m^2)) S_(l-1)m
//     d/dx C_m = d C_(m-1) - u C_(m+1),  d/dy S_m =  d C_(m-1) + u C_(m+1),
//     d/dx S_m = d S_(m-1) - u S_(m+1),  d/dy C_m = -d S_(m-1) - u S_(m+1),
//     d = 1/2 sqrt(q (l+m)(l+m-1)) (times sqrt 2 for m = 1), u = 1/2 sqrt(q (l-m)(l-m-1)),
//     d/dx, d/dy of S_l0 = -sqrt(q l(l-1)/2) (C_1, S_1).
// Four products give six derivatives.
#include "codegen/recipes/basis/basis.hpp"

namespace sh::codegen::recipes {
namespace {

using symbolic::Surd;

class Ladder {
 public:
  Ladder(SignedBuilder& build, const std::vector<NodeId>& values, int degree) : build_(build), values_(values) {
    const NodeId zero = build.constant(Surd(), "zero");
    for (auto* part : {&x, &y, &z}) part->assign(values.size(), zero);
    for (int l = 1; l <= degree; ++l) {
      zonal(l);
      for (int m = 1; m <= l; ++m) pair(l, m);
    }
  }

  std::vector<NodeId> x, y, z;

 private:
  // sqrt(square * (2l+1)/(2l-1))
  static Surd factor(int l, const cln::cl_RA& square) { return Surd::square_root(square * (2 * l + 1) / (2 * l - 1)); }

  // k times the value of degree l and order m; zero if there is no such value. The constant keeps its sign.
  Value times(const Surd& k, const std::string& name, int l, int m) {
    if (k.is_zero() || std::abs(m) > l) return {};
    return {build_.mul(build_.constant(k, name), values_[coefficient_index(l, m)])};
  }

  void set(std::vector<NodeId>& derivatives, int l, int m, Value value) {
    if (!value.is_zero()) derivatives[coefficient_index(l, m)] = build_.node(value);
  }

  void zonal(int l) {
    set(z, l, 0, times(factor(l, l * l), indexed("z", l, 0), l - 1, 0));
    const Surd down = -factor(l, cln::cl_RA(l * (l - 1)) / 2);
    set(x, l, 0, times(down, indexed("u", l, 0), l - 1, 1));
    set(y, l, 0, times(down, indexed("u", l, 0), l - 1, -1));
  }

  void pair(int l, int m) {
    const Surd along = factor(l, l * l - m * m);
    set(z, l, m, times(along, indexed("z", l, m), l - 1, m));
    set(z, l, -m, times(along, indexed("z", l, m), l - 1, -m));
    const Surd d = factor(l, cln::cl_RA((l + m) * (l + m - 1)) / (m == 1 ? 2 : 4));
    const Surd u = factor(l, cln::cl_RA((l - m) * (l - m - 1)) / 4);
    const Value dc = times(d, indexed("d", l, m), l - 1, m - 1);
    const Value uc = times(u, indexed("u", l, m), l - 1, m + 1);
    // For m = 1 there is no S_0, and the last two derivatives are equal.
    const Value ds = m == 1 ? Value{} : times(d, indexed("d", l, m), l - 1, 1 - m);
    const Value minus_us = times(-u, indexed("v", l, m), l - 1, -1 - m);
    set(x, l, m, build_.minus(dc, uc));
    set(y, l, -m, build_.plus(dc, uc));
    set(x, l, -m, build_.plus(ds, minus_us));
    set(y, l, m, build_.minus(minus_us, ds));
  }

  SignedBuilder& build_;
  const std::vector<NodeId>& values_;
};

void describe(Kernel& kernel, int degree) {
  kernel.title = "Real solid harmonics r^l Y_lm of degree 0 to " + std::to_string(degree) + " with their gradients";
  kernel.domain = "any d = (x, y, z); z is the polar axis";
  kernel.result =
      "r^l Y_lm(d/r) and its derivatives by x, y, z at index l(l+1)+m; r = |d|, Y_lm orthonormal on the unit sphere, "
      "no Condon-Shortley phase";
  kernel.parameters = with_direction({}, {}, Role::kVector);
  kernel.results = {array(Role::kBasisValues, "out", degree)};
  for (int axis = 0; axis < 3; ++axis) {
    kernel.results.push_back(array(Role::kBasisGradient, std::string("d") + "xyz"[axis], degree));
    kernel.results.back().axis = axis;
  }
  kernel.factored = true;
}

template <class AppendValues>
Kernel with_ladder(int degree, const std::string& source, const AppendValues& append_values) {
  Kernel kernel;
  describe(kernel, degree);
  kernel.citation = source + "; gradients by the ladder to the band below (Hobson, 1931)";
  SignedBuilder build(kernel);
  const Direction d = direction_inputs(build);
  const std::vector<NodeId> values = append_values(build, d);
  const Ladder ladder(build, values, degree);
  for (const auto& [prefix, nodes] : {std::pair("", &values), std::pair("d/dx ", &ladder.x),
                                      std::pair("d/dy ", &ladder.y), std::pair("d/dz ", &ladder.z)}) {
    const std::size_t first = kernel.outputs.size();
    label_coefficients(kernel, degree);
    for (std::size_t i = 0; i < nodes->size(); ++i) {
      Output& output = kernel.outputs[first + i];
      output.node = (*nodes)[i];
      output.label.insert(0, prefix);
    }
  }
  return kernel;
}

}  // namespace

Kernel basis_gradient_ladder(int degree) {
  return with_ladder(degree, "parity columns",
                     [degree](SignedBuilder& build, const Direction& d) { return append_solid(build, d, degree); });
}

Kernel basis_gradient_recurrence(int degree) {
  return with_ladder(
      degree, "recurrence in l as in Sloan, JCGT 2(2), 2013",
      [degree](Builder& build, const Direction& d) { return append_solid_recurrence(build, d, degree); });
}

}  // namespace sh::codegen::recipes
