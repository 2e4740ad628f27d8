// The meaning of zonal functions, lights, irradiance and windows.
#include "tests/codegen/meaning_check.hpp"

namespace sh::codegen::test {
namespace {

// --- zonal functions and lights

void check_zonal(Check& check) {
  const auto zonal = check.zonal_coefficients();
  const Vector3 d = check.direction();
  check.expect_function(check.call("zonal", Check::with({{"zonal", zonal}}, d)).at("out"),
                        [&](const Vector3& s) { return check.zonal(zonal, dot(d, s)); });
}

void check_cap(Check& check) {
  constexpr double kSize = 0.375;
  const auto zonal = check.call("cap", {{"one_minus_cos", {kSize}}}).at("zonal");
  for (const double t : {-0.9, -0.2, 0.1, 0.5, 0.99}) check.expect(check.zonal(zonal, t), check.cap(kSize, t));
}

void check_add_cap(Check& check) {
  constexpr double kSize = 0.375;
  const auto before = check.coefficients();
  const Vector3 d = check.direction();
  const double color = check.any();
  const Arrays arrays =
      check.call("add_cap", Check::with({{"one_minus_cos", {kSize}}, {"colour", {color}}, {"sum", before}}, d));
  check.expect_function(arrays.at("sum"),
                        [&](const Vector3& s) { return check.value(before, s) + color * check.cap(kSize, dot(d, s)); });
}

void check_add_cap_rgb(Check& check) {
  constexpr double kSize = 0.375;
  const auto before = check.coefficients(3);
  const Vector3 d = check.direction();
  const Vector3 color{check.any(), check.any(), check.any()};
  const Arrays arrays = check.call(
      "add_cap_rgb",
      Check::with(
          {{"one_minus_cos", {kSize}}, {"r", {color[0]}}, {"g", {color[1]}}, {"b", {color[2]}}, {"sum", before}}, d));
  for (int channel = 0; channel < 3; ++channel) {
    check.expect_function(
        arrays.at("sum"),
        [&](const Vector3& s) {
          return check.value(before, s, channel) +
                 color.at(static_cast<std::size_t>(channel)) * check.cap(kSize, dot(d, s));
        },
        check.degree, channel);
  }
}

// --- irradiance

void check_irradiance(Check& check) {
  const auto c = check.coefficients();
  check.expect_function(check.call("irradiance", {{"c", c}}).at("c"),
                        [&](const Vector3& n) { return check.irradiance(c, n); });
}

void check_irradiance_evaluate(Check& check) {
  const auto c = check.coefficients();
  const Vector3 n = check.direction();
  check.expect(check.call("irradiance_evaluate", Check::with({{"c", c}}, n)).at("irradiance")[0],
               check.irradiance(c, n));
}

void check_irradiance_matrix(Check& check) {
  const auto c = check.coefficients();
  const auto matrix = check.call("irradiance_matrix", {{"c", c}}).at("m");
  for (int i = 0; i < 9; ++i) {
    const Vector3 n = check.direction();
    const double v[] = {n[0], n[1], n[2], 1};
    double form = 0;
    for (std::size_t row = 0; row < 4; ++row) {
      for (std::size_t column = 0; column < 4; ++column) form += v[row] * matrix.at(4 * row + column) * v[column];
    }
    check.expect(form, check.irradiance(c, n));
  }
}

// Radiance of band l of a channel, at d.
double radiance_of_band(const Check& check, const std::vector<double>& c, int l, const Vector3& d, int channel) {
  return check.sum(
      c, d, [&](int of) { return of == l ? 1 / check.held(l) : 0; }, check.degree, channel);
}

// The gradient of the radiance of band 1.
Vector3 gradient_of_band1(const Check& check, const std::vector<double>& c, int channel) {
  const auto along = [&](const Vector3& axis) { return radiance_of_band(check, c, 1, axis, channel); };
  return {along({1, 0, 0}), along({0, 1, 0}), along({0, 0, 1})};
}

// Irradiance of bands 0 and 1, and of a band 2 about the axis whose radiance is `mean` (0.08 r + 0.6 r^2) sqrt(5) P_2:
// r = the share of band 1 along the axis in a mean of 1 [RoughtonSloan24].
double zh3(const Check& check, const std::vector<double>& c, const Vector3& n, int channel, const Vector3& axis) {
  const double mean = radiance_of_band(check, c, 0, n, channel);
  const double size = std::abs(dot(gradient_of_band1(check, c, channel), axis)) / std::sqrt(3.0);
  const double quotient = mean > 0 ? std::min(size / mean, std::sqrt(3.0)) : std::sqrt(3.0);
  const double band2 = size * (0.08 + 0.6 * quotient) * std::sqrt(5.0) * legendre(2, dot(axis, n));
  return clamped_cosine(0) * mean + clamped_cosine(1) * radiance_of_band(check, c, 1, n, channel) +
         clamped_cosine(2) * band2;
}

void check_zh3(Check& check) {
  const auto c = check.coefficients();
  const Vector3 n = check.direction();
  check.expect(check.call("irradiance_zh3", Check::with({{"c", c}}, n)).at("irradiance")[0],
               zh3(check, c, n, 0, unit(gradient_of_band1(check, c, 0))));
}

void check_zh3_rgb(Check& check) {
  const auto c = check.coefficients(3);
  const Vector3 n = check.direction();
  Vector3 axis{};
  for (int channel = 0; channel < 3; ++channel) {
    const Vector3 gradient = gradient_of_band1(check, c, channel);
    const double weight = std::array{0.2126, 0.7152, 0.0722}.at(static_cast<std::size_t>(channel));
    for (std::size_t i = 0; i < 3; ++i) axis.at(i) += weight * gradient.at(i);
  }
  const auto rgb = check.call("irradiance_zh3_rgb", Check::with({{"c", c}}, n)).at("irradiance");
  for (int channel = 0; channel < 3; ++channel) {
    check.expect(rgb.at(static_cast<std::size_t>(channel)), zh3(check, c, n, channel, unit(axis)));
  }
}

double linear_form(const std::vector<double>& e, const Vector3& n) {
  return e.at(0) + e.at(1) * n[1] + e.at(2) * n[2] + e.at(3) * n[0];
}

void check_lightmap(Check& check) {
  const auto c = check.coefficients();
  const auto form = check.call("lightmap", {{"c", c}}).at("out");
  for (int i = 0; i < 5; ++i) {
    const Vector3 n = check.direction();
    check.expect(linear_form(form, n), check.irradiance(c, n));
  }
}

void check_lightmap_project(Check& check) {
  const std::vector<double> before{check.any(), check.any(), check.any(), check.any()};
  const Vector3 d = check.direction();
  const double weight = check.any();
  const auto form = check.call("lightmap_project", Check::with({{"weight", {weight}}, {"sum", before}}, d)).at("sum");
  for (int i = 0; i < 5; ++i) {
    const Vector3 n = check.direction();
    const double added = weight * (clamped_cosine(0) + 3 * clamped_cosine(1) * dot(d, n)) / (4 * kPi);
    check.expect(linear_form(form, n), linear_form(before, n) + added);
  }
}

void check_lightmap_evaluate(Check& check) {
  const std::vector<double> form{check.any(), check.any(), check.any(), check.any()};
  const Vector3 n = check.direction();
  check.expect(check.call("lightmap_evaluate", Check::with({{"e", form}}, n)).at("irradiance")[0],
               linear_form(form, n));
}

// --- windows

void check_window(Check& check, const std::string& family, Arrays parameters,
                  const std::function<double(int l)>& window) {
  const auto c = check.coefficients();
  parameters["c"] = c;
  check.expect_function(check.call(family, parameters).at("c"),
                        [&](const Vector3& d) { return check.sum(c, d, window, check.degree); });
}

void check_hann(Check& check) {
  check_window(check, "window_hann", {{"cos_pi_over_w", {std::cos(kPi / 5)}}},
               [](int l) { return (1 + std::cos(kPi * l / 5)) / 2; });
}

void check_lanczos(Check& check, const std::string& family, int power) {
  const auto sinc = [](double t) { return t == 0 ? 1 : std::sin(t) / t; };
  check_window(check, family, {{"cos_pi_over_w", {std::cos(kPi / 5)}}, {"sinc_pi_over_w", {sinc(kPi / 5)}}},
               [&](int l) { return std::pow(sinc(kPi * l / 5), power); });
}

void check_gaussian(Check& check) {
  check_window(check, "window_gaussian", {{"g", {0.75}}}, [](int l) { return std::pow(0.75, l * l); });
}

void check_laplacian(Check& check) {
  check_window(check, "window_laplacian", {{"lambda", {0.125}}},
               [](int l) { return 1 / (1 + 0.125 * l * l * (l + 1) * (l + 1)); });
}

}  // namespace

std::vector<Meaning> light_meanings() {
  return {{"cap", check_cap},
          {"zonal", check_zonal},
          {"add_cap", check_add_cap},
          {"add_cap_rgb", check_add_cap_rgb},
          {"irradiance", check_irradiance},
          {"irradiance_matrix", check_irradiance_matrix},
          {"irradiance_evaluate", check_irradiance_evaluate},
          {"irradiance_zh3", check_zh3},
          {"irradiance_zh3_rgb", check_zh3_rgb},
          {"lightmap", check_lightmap},
          {"lightmap_project", check_lightmap_project},
          {"lightmap_evaluate", check_lightmap_evaluate},
          {"window_hann", check_hann},
          {"window_lanczos", [](Check& check) { check_lanczos(check, "window_lanczos", 1); }},
          {"window_lanczos2", [](Check& check) { check_lanczos(check, "window_lanczos2", 2); }},
          {"window_lanczos4", [](Check& check) { check_lanczos(check, "window_lanczos4", 4); }},
          {"window_gaussian", check_gaussian},
          {"window_laplacian", check_laplacian}};
}

}  // namespace sh::codegen::test
