// The meaning of the basis, evaluation and projection.
#include "tests/codegen/meaning_check.hpp"

namespace sh::codegen::test {
namespace {

void check_basis(Check& check) {
  const Vector3 d = check.direction();
  const std::vector<double> out = check.call("basis", Check::with({}, d)).at("out");
  for (int l = 0; l <= check.degree; ++l) {
    for (int m = -l; m <= l; ++m)
      check.expect(out.at(check.world.definition.place(check.degree, l, m)), check.y(l, m, d));
  }
  check.expect_holes(out, check.degree);
}

void check_normalized(Check& check) {
  const Vector3 d = check.direction();
  const std::vector<double> out = check.call("basis_normalised", Check::with({}, scaled(d, 3))).at("out");
  for (int l = 0; l <= check.degree; ++l) {
    for (int m = -l; m <= l; ++m)
      check.expect(out.at(check.world.definition.place(check.degree, l, m)), check.y(l, m, d));
  }
  check.expect_holes(out, check.degree);
}

// The derivative by differences is exact for polynomials of degree 4.
void check_gradient(Check& check) {
  const Vector3 v = scaled(check.direction(), 1.5);
  const Arrays arrays = check.call("basis_gradient", Check::with({}, v));
  const auto solid = [&](int l, int m, int axis, double step) {
    Vector3 at = v;
    if (axis >= 0) at.at(static_cast<std::size_t>(axis)) += step;
    const double r = std::sqrt(dot(at, at));
    return std::pow(r, l) * check.y(l, m, unit(at));
  };
  constexpr double kStep = 0.25;
  for (int l = 0; l <= check.degree; ++l) {
    for (int m = -l; m <= l; ++m) {
      const auto place = static_cast<std::size_t>(check.world.definition.place(check.degree, l, m));
      check.expect(arrays.at("out").at(place), solid(l, m, -1, 0));
      for (int axis = 0; axis < 3; ++axis) {
        const auto step = [&](double h) { return solid(l, m, axis, h) - solid(l, m, axis, -h); };
        check.expect(arrays.at(std::string("d") + "xyz"[axis]).at(place),
                     (8 * step(kStep) - step(2 * kStep)) / (12 * kStep));
      }
    }
  }
  for (const char* array : {"out", "dx", "dy", "dz"}) check.expect_holes(arrays.at(array), check.degree);
}

// --- evaluation and projection

void check_evaluate(Check& check) {
  const auto c = check.coefficients();
  const Vector3 d = check.direction();
  check.expect(check.call("evaluate", Check::with({{"c", c}}, d)).at("value")[0], check.value(c, d));
}

void check_evaluate_rgb(Check& check) {
  const auto c = check.coefficients(3);
  const Vector3 d = check.direction();
  const Arrays arrays = check.call("evaluate_rgb", Check::with({{"c", c}}, d));
  for (int channel = 0; channel < 3; ++channel)
    check.expect(arrays.at("rgb").at(static_cast<std::size_t>(channel)), check.value(c, d, channel));
}

// x^i y^j by falling i and j, then z x^i y^j, in the coordinates of the functions with polar axis z.
void check_prepare(Check& check) {
  const auto c = check.coefficients();
  const auto polynomial = check.call("evaluate_prepare", {{"c", c}}).at("polynomial");
  const Vector3 d = check.direction();
  const std::string polar = check.world.definition.own_axes ? "z,x,y" : "x,y,z";
  const auto [x, y, z] = named_coordinates(polar, named_coordinates(check.world.axes, d));
  double total = 0;
  std::size_t at = 0;
  for (const int with_z : {0, 1}) {
    const int most = check.degree - with_z;
    for (int i = most; i >= 0; --i) {
      for (int j = most - i; j >= 0; --j)
        total += polynomial.at(at++) * std::pow(x, i) * std::pow(y, j) * (with_z == 1 ? z : 1);
    }
  }
  check.expect(total, check.value(c, d));
}

void check_prepared(Check& check) {
  const auto c = check.coefficients();
  const Vector3 d = check.direction();
  const auto polynomial = check.call("evaluate_prepare", {{"c", c}}).at("polynomial");
  check.expect(check.call("evaluate_prepared", Check::with({{"polynomial", polynomial}}, d)).at("value")[0],
               check.value(c, d));
}

void check_project(Check& check) {
  const auto before = check.coefficients();
  const Vector3 d = check.direction();
  const double weight = check.any();
  const Arrays arrays = check.call("project", Check::with({{"weight", {weight}}, {"sum", before}}, d));
  check.expect_function(arrays.at("sum"),
                        [&](const Vector3& s) { return check.value(before, s) + weight * check.sample(dot(d, s)); });
}

void check_moments(Check& check) {
  const std::vector<double> none(static_cast<std::size_t>((check.degree + 1) * (check.degree + 1)), 0);
  const Vector3 d = check.direction();
  const double weight = check.any();
  const auto moments =
      check.call("project_moments", Check::with({{"weight", {weight}}, {"moments", none}}, d)).at("moments");
  check.expect_function(check.call("project_finish", {{"moments", moments}}).at("c"),
                        [&](const Vector3& s) { return weight * check.sample(dot(d, s)); });
}

}  // namespace

std::vector<Meaning> basis_meanings() {
  return {{"basis", check_basis},
          {"basis_gradient", check_gradient},
          {"basis_normalised", check_normalized},
          {"evaluate", check_evaluate},
          {"evaluate_rgb", check_evaluate_rgb},
          {"evaluate_prepare", check_prepare},
          {"evaluate_prepared", check_prepared},
          {"project", check_project},
          {"project_moments", check_moments},
          {"project_finish", check_moments}};
}

}  // namespace sh::codegen::test
