// Kernels in other conventions, compared with the exact functions of each convention, and their cost.
#include "codegen/convention/in_convention.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "codegen/choose/catalogue.hpp"
#include "codegen/families/family.hpp"
#include "codegen/ir/evaluate.hpp"
#include "codegen/measure/directions.hpp"
#include "numeric/oracle/index.hpp"
#include "symbolic/basis/basis.hpp"
#include "symbolic/convention/convention.hpp"
#include "tests/codegen/support.hpp"

namespace sh::codegen {
namespace {

using symbolic::Preset;
using symbolic::Surd;

constexpr int kDigits = 60;

FinishedKernel emitted(const std::string& family, int degree, const ConventionOptions& options) {
  const Family& f = find_family(family);
  return in_convention(preferred_kernel(f, degree, Prefer::kSpeed), f.reference(degree, kReferencePoints), options);
}

int largest_degree(const Preset& preset) { return std::min(4, symbolic::largest_degree(preset.convention)); }

cln::cl_F as_float(const cln::cl_RA& value) { return cln::cl_float(value, cln::float_format(kDigits)); }

void expect_close(const cln::cl_F& a, const cln::cl_F& b, const std::string& what) {
  EXPECT_LT(cln::double_approx(cln::abs(a - b)), 1e-50) << what;
}

using Numbers = std::vector<cln::cl_F>;

template <class Exact>
Numbers numbers(const Exact& exact) {
  Numbers result;
  for (const cln::cl_RA& value : exact) result.push_back(as_float(value));
  return result;
}

Numbers values_of(const FinishedKernel& kernel, const Numbers& inputs) {
  return Evaluator<cln::cl_F>(kernel.kernel, kDigits)(inputs);
}

// Our coefficients in the convention's storage.
Numbers stored(const symbolic::Convention& convention, int degree, const Numbers& c) {
  Numbers result(storage_size(convention.order, degree));
  for (int l = 0; l <= degree; ++l) {
    for (int m = -l; m <= l; ++m) {
      const Surd scale = convention_factor(convention, l, m) / convention_factor(symbolic::Convention{}, l, m);
      result[storage_position(convention.order, degree, l, m)] =
          c[numeric::coefficient_index(l, m)] * (folded_factor(convention.folded, l) / scale).evaluate(kDigits);
    }
  }
  return result;
}

Numbers joined(Numbers left, const Numbers& right) {
  left.insert(left.end(), right.begin(), right.end());
  return left;
}

void expect_all_close(const Numbers& values, const Numbers& expected, const std::string& what) {
  ASSERT_EQ(values.size(), expected.size()) << what;
  for (std::size_t i = 0; i < values.size(); ++i) expect_close(values[i], expected[i], what);
}

TEST(InConvention, BasisEqualsTheFunctionsOfEveryRealPreset) {
  for (const Preset& preset : symbolic::presets()) {
    if (preset.convention.complex) continue;
    const int degree = largest_degree(preset);
    const FinishedKernel finished = emitted("basis", degree, {preset.name, ""});
    const symbolic::SignedPermutation& axes = preset.convention.axes;
    for (const auto& d : rational_directions(3)) {
      const Numbers values = values_of(finished, numbers(d));
      std::vector<cln::cl_RA> own;
      for (int row = 0; row < 3; ++row) own.push_back(axes.sign(row) * d[axes.axis(row)]);
      for (int l = 0; l <= degree; ++l) {
        for (int m = -l; m <= l; ++m) {
          const auto exact = convention_function(preset.convention, l, m);
          const int place = storage_position(preset.convention.order, degree, l, m);
          expect_close(values[place], (Surd(exact.re.evaluate(own)) * exact.factor).evaluate(kDigits), preset.name);
        }
      }
    }
  }
}

TEST(InConvention, CostsNothingAtRunTime) {
  // Constants absorb signs and scales. If one product serves several outputs of a turned zonal function, up to two
  // changes of sign or scale remain.
  for (const Preset& preset : symbolic::presets()) {
    if (preset.convention.complex) continue;
    for (const char* family : {"basis", "zonal"}) {
      const int degree = largest_degree(preset);
      const FinishedKernel ours = test::fastest(family, degree);
      const FinishedKernel theirs = emitted(family, degree, {preset.name, ""});
      const int left_over = family == std::string("basis") ? 0 : 2;
      EXPECT_LE(theirs.cost.operations(), ours.cost.operations() + left_over) << family << " " << preset.name;
    }
  }
}

TEST(InConvention, AxesOnlyRenameTheArguments) {
  const FinishedKernel finished = emitted("basis", 4, {"", "x,z,-y"});
  const FinishedKernel ours = test::fastest("basis", 4);
  EXPECT_LE(finished.cost.operations(), ours.cost.operations());
  for (const auto& d : rational_directions(3)) {
    const Numbers renamed = numbers(std::vector<cln::cl_RA>{d[0], d[2], -d[1]});
    expect_all_close(values_of(finished, numbers(d)), values_of(ours, renamed), "axes");
  }
}

TEST(InConvention, CoefficientsScaleTheOtherWay) {
  // A zonal function that is turned to d and summed with the convention's functions is the same in every convention.
  const int degree = 3;
  for (const std::string name : {"ambix", "gaussian-splatting", "shtools"}) {
    const symbolic::Convention convention = symbolic::find_preset(name).convention;
    Numbers theirs;
    Numbers ours;
    for (int l = 0; l <= degree; ++l) {
      const Surd scale = convention_factor(convention, l, 0) / convention_factor(symbolic::Convention{}, l, 0);
      ours.push_back(as_float(cln::cl_RA(l + 2) / 7));
      theirs.push_back(ours.back() / scale.evaluate(kDigits));
    }
    const auto directions = rational_directions(2);
    const auto sum = [&](const FinishedKernel& turned, const FinishedKernel& basis, const Numbers& zonal) {
      const Numbers c = values_of(turned, joined(zonal, numbers(directions[0])));
      const Numbers y = values_of(basis, numbers(directions[1]));
      cln::cl_F total = as_float(0);
      for (std::size_t i = 0; i < c.size(); ++i) total = total + c[i] * y[i];
      return total;
    };
    expect_close(sum(emitted("zonal", degree, {name, ""}), emitted("basis", degree, {name, ""}), theirs),
                 sum(test::fastest("zonal", degree), test::fastest("basis", degree), ours), name);
  }
}

TEST(InConvention, ScalesFactorsAndResultOfAProductByTheirOwnDegrees) {
  // theirs(s a, t b) = u (a b), each in its own storage; DirectXMath scales by a sign, N3D by a factor as well.
  const Family family = rectangular_product_family(2, 1, 3);
  const FinishedKernel ours = preferred_kernel(family, 3, Prefer::kSpeed);
  Numbers a;
  Numbers b;
  for (int i = 0; i < 9; ++i) a.push_back(as_float(cln::cl_RA(i + 2) / 7));
  for (int i = 0; i < 4; ++i) b.push_back(as_float(cln::cl_RA(3 - 2 * i) / 5));
  for (const char* name : {"directxmath", "ambix"}) {
    const symbolic::Convention convention = symbolic::find_preset(name).convention;
    const FinishedKernel theirs = in_convention(ours, family.reference(3, kReferencePoints), {name, ""});
    expect_all_close(values_of(theirs, joined(stored(convention, 2, a), stored(convention, 1, b))),
                     stored(convention, 3, values_of(ours, joined(a, b))), name);
  }
}

TEST(InConvention, IrradianceIsTheSameFromEveryStorage) {
  const auto normal = rational_directions(1)[0];
  // E(n) and its lightmap form are physical: signs, scales and folded cosines of the coefficients do not reach them.
  for (const char* name : {"directxmath", "unity", "threejs"}) {
    const symbolic::Convention convention = symbolic::find_preset(name).convention;
    for (const auto& [family, degree] : {std::pair("irradiance_evaluate", 2), std::pair("lightmap", 1)}) {
      Numbers c;
      for (int i = 0; i < numeric::coefficient_count(degree); ++i) c.push_back(as_float(cln::cl_RA(2 * i - 5) / 7));
      const Numbers n = degree == 1 ? Numbers{} : numbers(normal);
      expect_all_close(values_of(emitted(family, degree, {name, ""}), joined(stored(convention, degree, c), n)),
                       values_of(test::fastest(family, degree), joined(c, n)), std::string(name) + " " + family);
    }
  }
}

TEST(InConvention, RefusesWhatItCannotMean) {
  EXPECT_THROW(emitted("basis", 2, {"scipy", ""}), std::invalid_argument);  // complex
  EXPECT_THROW(emitted("basis", 3, {"unity", ""}), std::invalid_argument);  // folded: to degree 2
  EXPECT_THROW(emitted("basis", 2, {"nothing", ""}), std::invalid_argument);
  EXPECT_THROW(emitted("basis", 2, {"", "x,x,z"}), std::invalid_argument);
  EXPECT_THROW(emitted("irradiance", 2, {"unity", ""}), std::invalid_argument);               // convolved already
  EXPECT_THROW(emitted("evaluate_prepared", 2, {"directxmath", ""}), std::invalid_argument);  // no effect
  EXPECT_THROW(emitted("product", 2, {"directxmath", "y,z,x"}), std::invalid_argument);
  for (const char* family : {"product", "square", "triple"})  // of irradiance, not of radiance
    EXPECT_THROW(emitted(family, 2, {"unity", ""}), std::invalid_argument) << family;
}

class Gauge : public test::SmallKernel {};

TEST_F(Gauge, MultipliesOnceWhereNoConstantIsFree) {
  const NodeId product = build.mul(kX, kY);
  output(product);
  output(build.add(product, build.mul(kY, kZ)));
  const Kernel scaled = with_gauges(kernel, {Surd(1), Surd(1), Surd(1)}, {Surd(3), Surd::square_root(2)});
  const std::vector<double> point{0.3125, -1.75, 2.5};
  const auto before = Evaluator<double>(kernel)(point);
  const auto after = Evaluator<double>(scaled)(point);
  EXPECT_DOUBLE_EQ(after[0], 3 * before[0]);
  EXPECT_DOUBLE_EQ(after[1], std::sqrt(2.0) * before[1]);
  EXPECT_EQ(cost(scaled).operations(), cost(kernel).operations() + 2);
}

}  // namespace
}  // namespace sh::codegen
