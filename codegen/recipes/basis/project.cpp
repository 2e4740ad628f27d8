// Recipes: sum += weight * Y(d) without storing the basis, directly or by moments.
//
//   chebyshev   the basis by Chebyshev polynomials; the weight enters like that of parity
//   parity      the basis by parity; the sectoral functions include the weight where the values are linear in them
//   recurrence  the basis by the recurrence in l; the weight enters at the start of the columns
//
// Moments are the (degree+1)^2 sums of weight * Re or Im (x+iy)^m z^n for m + n <= degree, at the place of Y_(m+n,+-m).
// They need plain products only. At the end one linear map converts them to coefficients.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "codegen/measure/directions.hpp"
#include "codegen/recipes/basis/basis.hpp"
#include "codegen/recipes/basis/chebyshev_columns.hpp"
#include "symbolic/basis/basis.hpp"

namespace sh::codegen::recipes {
namespace {

using symbolic::Surd;

constexpr int kWeightInput = 3;
constexpr int kFirstSumInput = 4;

void describe(Kernel& kernel, const Parameter& sum) {
  kernel.domain = "|d| = 1 for d = (x, y, z); z is the polar axis; any weight";
  kernel.parameters = with_direction({}, {parameter(Role::kWeight, "weight"), sum});
  kernel.results = {sum};
  label_coefficients(kernel, sum.degree);
}

// Output i = input sum i + node i.
void accumulate(Kernel& kernel, Builder& build, const std::vector<NodeId>& values) {
  std::vector<NodeId> sums;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const NodeId sum = build.input(kFirstSumInput + static_cast<int>(i), "");
    sums.push_back(build.add(sum, values[i]));
  }
  set_outputs(kernel, sums);
}

template <class Append>
Kernel accumulated_basis(int degree, const std::string& source, const Append& append) {
  Kernel kernel;
  describe(kernel, array(Role::kCoefficients, "sum", degree));
  kernel.title = "Adds one weighted sample to a projection on bands 0 to " + std::to_string(degree);
  kernel.result = "sum += weight Y_lm(d) at index l(l+1)+m, orthonormal on the unit sphere, no Condon-Shortley phase";
  kernel.citation = source;
  SignedBuilder build(kernel);
  const Direction d = direction_inputs(build);
  const NodeId weight = build.input(kWeightInput, "weight");
  accumulate(kernel, build, append(build, d, weight));
  return kernel;
}

// The largest growth of the errors of the moments: the largest sum of the |coefficients| of a Y_lm, divided by the
// maximum of its band.
double amplification(int degree) {
  double largest = 0;
  for (int l = 0; l <= degree; ++l) {
    for (int m = 0; m <= l; ++m) {
      const AxialForm form = whole_axial_form(l, m);
      double sum = 0;
      for (const cln::cl_RA& power : form.powers) {
        sum += std::abs(cln::double_approx((form.scale * Surd(power)).evaluate(20)));
      }
      largest = std::max(largest, sum / std::sqrt((2 * l + 1) / (4 * std::numbers::pi)));
    }
  }
  return largest;
}

}  // namespace

Kernel project_chebyshev(int degree) {
  Kernel kernel =
      accumulated_basis(degree, kChebyshevSource, [degree](SignedBuilder& build, const Direction& d, NodeId weight) {
        return append_chebyshev(build, d, degree, weight);
      });
  kernel.factored = true;
  return kernel;
}

Kernel project_parity(int degree) {
  Kernel kernel =
      accumulated_basis(degree, kParitySource, [degree](SignedBuilder& build, const Direction& d, NodeId weight) {
        return append_parity(build, d, degree, accurate_choices(degree), weight);
      });
  kernel.factored = true;
  return kernel;
}

Kernel project_recurrence(int degree) {
  return accumulated_basis(degree, kRecurrenceSource, [degree](Builder& build, const Direction& d, NodeId weight) {
    return append_recurrence(build, d, degree, weight);
  });
}

Kernel project_moments(int degree) {
  symbolic::require_basis_index(degree, 0);
  Kernel kernel;
  describe(kernel, array(Role::kMoments, "moments", degree));
  kernel.title = "Adds one weighted sample to the moments of a projection on bands 0 to " + std::to_string(degree);
  kernel.result =
      "moments += weight z^n Re (x+iy)^m at index l(l+1)+m, Im (x+iy)^m at l(l+1)-m, l = m+n; project_finish_l" +
      std::to_string(degree) + " makes coefficients of their sums";
  kernel.citation = "products by falling order; the map to coefficients is linear";
  kernel.factored = true;
  Builder build(kernel);
  const Direction d = direction_inputs(build);
  std::vector<NodeId> values(coefficient_count(degree));
  values[0] = build.input(kWeightInput, "weight");
  for (int m = 1; m <= degree; ++m) {
    const auto last = coefficient_index(m - 1, m - 1);
    const auto last_sine = coefficient_index(m - 1, 1 - m);
    const NodeId xc = build.mul(d.x, values[last]);
    const NodeId yc = build.mul(d.y, values[last]);
    if (m == 1) {
      values[coefficient_index(1, 1)] = xc;
      values[coefficient_index(1, -1)] = yc;
      continue;
    }
    const NodeId ys = build.mul(d.y, values[last_sine]);
    const NodeId xs = build.mul(d.x, values[last_sine]);
    values[coefficient_index(m, m)] = build.sub(xc, ys, "c" + std::to_string(m));
    values[coefficient_index(m, -m)] = build.add(xs, yc, "s" + std::to_string(m));
  }
  for (int m = -degree; m <= degree; ++m) {
    for (int l = std::abs(m) + 1; l <= degree; ++l) {
      values[coefficient_index(l, m)] = build.mul(values[coefficient_index(l - 1, m)], d.z);
    }
  }
  accumulate(kernel, build, values);
  for (Output& output : kernel.outputs) output.label.insert(0, "as ");
  return kernel;
}

Kernel project_finish(int degree) {
  symbolic::require_basis_index(degree, 0);
  Kernel kernel;
  kernel.title = "Coefficients of bands 0 to " + std::to_string(degree) + " from the sums of project_moments_l" +
                 std::to_string(degree);
  kernel.domain = "any moments";
  kernel.result = fmt::format(
      "coefficients of Y_lm at index l(l+1)+m, orthonormal, no Condon-Shortley phase; errors of the moments grow up to "
      "{:.2g} times in units of sqrt((2l+1)/(4 pi))",
      amplification(degree));
  kernel.citation = "the polynomials of Y_lm in z, exact";
  kernel.factored = true;
  kernel.parameters = {array(Role::kMoments, "moments", degree)};
  kernel.results = {array(Role::kCoefficients, "c", degree)};
  label_coefficients(kernel, degree);
  Builder build(kernel);
  std::vector<NodeId> values(coefficient_count(degree));
  for (int l = 0; l <= degree; ++l) {
    for (int m = -l; m <= l; ++m) {
      const int order = std::abs(m);
      const AxialForm form = whole_axial_form(l, order);
      NodeId sum = -1;
      for (std::size_t k = 0; k < form.powers.size(); ++k) {
        // z^n is at the place of degree order + n.
        const int place = order + 2 * static_cast<int>(k) + (form.odd ? 1 : 0);
        const NodeId moment = build.input(coefficient_index(place, m), "");
        sum = plus_scaled(build, sum, form.scale * Surd(form.powers[k]), moment, indexed("k", l, order));
      }
      values[coefficient_index(l, m)] = sum;
    }
  }
  set_outputs(kernel, values);
  return kernel;
}

}  // namespace sh::codegen::recipes
