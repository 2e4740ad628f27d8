// The meaning of rotations, (R f)(R d) = f(d), and of products.
#include "tests/codegen/meaning_check.hpp"

namespace sh::codegen::test {
namespace {

// --- rotations: (R f)(R d) = f(d)

void expect_turned(Check& check, const std::vector<double>& out, const std::vector<double>& c, const Matrix3& r) {
  for (int i = 0; i < 10; ++i) {
    const Vector3 d = check.direction();
    check.expect(check.value(out, turned(r, d)), check.value(c, d));
  }
  check.expect_holes(out, check.degree);
}

// Any rotation, then those that kernels with Euler angles treat on their own: none, about z, half turns.
std::vector<std::vector<double>> quaternions(Check& check) {
  return {check.quaternion(), {1, 0, 0, 0}, {0.8, 0, 0, 0.6}, {0, 1, 0, 0}, {0, 0.6, 0.8, 0}, {0.6, 0, -0.8, 0}};
}

void check_rotate(Check& check) {
  for (const auto& q : quaternions(check)) {
    const Matrix3 r = matrix_of(q);
    const auto c = check.coefficients();
    expect_turned(check, check.call("rotate", {{"r", flat(r)}, {"c", c}}).at("out"), c, r);
  }
}

void check_rotate_quaternion(Check& check) {
  for (const auto& q : quaternions(check)) {
    const auto c = check.coefficients();
    expect_turned(check, check.call("rotate_quaternion", {{"q", q}, {"c", c}}).at("out"), c, matrix_of(q));
  }
}

// By build, then apply.
void check_rotate_matrices(Check& check) {
  const Matrix3 r = matrix_of(check.quaternion());
  const auto c = check.coefficients();
  const auto m = check.call("rotate_build", {{"r", flat(r)}}).at("m");
  expect_turned(check, check.call("rotate_apply", {{"m", m}, {"c", c}}).at("out"), c, r);
}

// The matrices alone: a column of D' times a function.
void check_rotate_build(Check& check) {
  const Matrix3 r = matrix_of(check.quaternion());
  const auto m = check.call("rotate_build", {{"r", flat(r)}}).at("m");
  const auto c = check.coefficients();
  std::vector<double> out(c.size(), 0);
  std::size_t first = 0;
  for (int l = 0; l <= check.degree; ++l) {
    std::vector<std::size_t> places;
    for (int order = -l; order <= l; ++order)
      places.push_back(static_cast<std::size_t>(check.world.definition.place(check.degree, l, order)));
    std::sort(places.begin(), places.end());
    for (const std::size_t row : places) {
      for (const std::size_t column : places) out[row] += m.at(first++) * c[column];
    }
  }
  expect_turned(check, out, c, r);
}

// About the polar axis of the functions.
void check_rotate_z(Check& check) {
  const double angle = 0.7;
  const auto c = check.coefficients();
  const auto out =
      check.call("rotate_z", {{"cos_angle", {std::cos(angle)}}, {"sin_angle", {std::sin(angle)}}, {"c", c}}).at("out");
  const auto at = [&](const std::vector<double>& array, double theta, double phi) {
    const Vector3 polar{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
    const Vector3 d = check.world.definition.own_axes ? Vector3{polar[1], polar[2], polar[0]} : polar;
    double total = 0;
    for (int l = 0; l <= check.degree; ++l) {
      for (int m = -l; m <= l; ++m)
        total += array.at(check.world.definition.place(check.degree, l, m)) * check.world.definition.function(l, m, d);
    }
    return total;
  };
  for (const double phi : {-2.0, -1.0, 0.3, 1.5, 3.0})
    check.expect(at(out, 1 + phi / 9, phi + angle), at(c, 1 + phi / 9, phi));
  check.expect_holes(out, check.degree);
}

void check_rotate_evaluate(Check& check) {
  const Matrix3 r = matrix_of(check.quaternion());
  const auto c = check.coefficients();
  const Vector3 d = check.direction();
  const Arrays arrays = check.call("rotate_evaluate", Check::with({{"r", flat(r)}, {"c", c}}, turned(r, d)));
  check.expect(arrays.at("value")[0], check.value(c, d));
}

// --- products

void check_product(Check& check, const std::string& family, int result_degree) {
  const auto a = check.coefficients();
  const auto b = family == "square" ? a : check.coefficients();
  Arrays parameters{{"a", a}};
  if (family != "square") parameters["b"] = b;
  const auto out = check.call(family, parameters).at("out");
  const Function product = [&](const Vector3& s) { return check.value(a, s) * check.value(b, s); };
  check.expect_function(
      out, [&](const Vector3& d) { return Check::projected(product, 2 * check.degree, result_degree, d); },
      result_degree);
}

void check_product_zonal(Check& check) {
  const auto a = check.coefficients();
  const auto zonal = check.zonal_coefficients();
  const auto out = check.call("product_zonal", {{"a", a}, {"zonal", zonal}}).at("out");
  const std::string polar = check.world.definition.own_axes ? "z,x,y" : "x,y,z";
  const Function product = [&](const Vector3& s) {
    const Vector3 own = named_coordinates(polar, named_coordinates(check.world.axes, s));
    return check.value(a, s) * check.zonal(zonal, own[2]);
  };
  check.expect_function(out,
                        [&](const Vector3& d) { return Check::projected(product, 2 * check.degree, check.degree, d); });
}

void check_triple(Check& check) {
  const auto a = check.coefficients();
  const auto b = check.coefficients();
  const auto c = check.coefficients();
  double total = 0;
  for (const auto& node : numeric::sphere_rule<double>(3 * check.degree)) {
    const Vector3 s{node.x, node.y, node.z};
    total += node.weight * check.value(a, s) * check.value(b, s) * check.value(c, s);
  }
  check.expect(check.call("triple", {{"a", a}, {"b", b}, {"c", c}}).at("integral")[0], total);
}

// The integral of transfer times light, channel by channel.
void check_relight(Check& check, const std::string& family, const std::string& result, std::size_t transfer_channels,
                   std::size_t light_channels) {
  std::vector<std::vector<double>> transfers;
  std::vector<std::vector<double>> lights;
  const auto joined_channels = [&check](std::vector<std::vector<double>>& channels, std::size_t count) {
    std::vector<double> all;
    while (channels.size() < count) {
      channels.push_back(check.coefficients());
      all.insert(all.end(), channels.back().begin(), channels.back().end());
    }
    return all;
  };
  const auto transfer = joined_channels(transfers, transfer_channels);
  const auto light = joined_channels(lights, light_channels);
  const auto out = check.call(family, {{"transfer", transfer}, {"light", light}}).at(result);
  for (std::size_t channel = 0; channel < light_channels; ++channel) {
    double total = 0;
    for (const auto& node : numeric::sphere_rule<double>(2 * check.degree)) {
      const Vector3 s{node.x, node.y, node.z};
      total += node.weight * check.value(transfers[channel % transfer_channels], s) * check.value(lights[channel], s);
    }
    check.expect(out.at(channel), total);
  }
}

// Visibility and lights, prepared by transfer_prepare.
struct Transfer {
  std::vector<double> visibility;
  std::vector<std::vector<double>> lights;
  std::vector<double> samples;

  Transfer(Check& check, std::size_t channels) : visibility(check.coefficients_to(2 * check.degree)) {
    while (lights.size() < channels) {
      lights.push_back(check.coefficients());
      const auto one = check.call("transfer_prepare", {{"light", lights.back()}}).at("samples");
      samples.insert(samples.end(), one.begin(), one.end());
    }
  }

  // The product in one direction, all bands.
  [[nodiscard]] double product(const Check& check, std::size_t channel, const Vector3& s) const {
    const auto one = [](int) { return 1; };
    return check.sum(visibility, s, one, 2 * check.degree) * check.value(lights[channel], s);
  }
};

// By prepare, then apply: the product of visibility and light, on the bands of the light.
void check_transfer(Check& check, const std::string& family, std::size_t channels) {
  const Transfer transfer(check, channels);
  const auto out = check.call(family, {{"visibility", transfer.visibility}, {"samples", transfer.samples}}).at("out");
  const auto size = static_cast<std::size_t>(check.world.definition.size(check.degree));
  for (std::size_t channel = 0; channel < channels; ++channel) {
    const std::vector<double> one(out.begin() + channel * size, out.begin() + (channel + 1) * size);
    const Function product = [&](const Vector3& s) { return transfer.product(check, channel, s); };
    check.expect_function(
        one, [&](const Vector3& d) { return Check::projected(product, 3 * check.degree, check.degree, d); });
  }
}

// The integral of visibility, light and the lobe about a direction.
void check_glossy(Check& check, const std::string& family, const std::string& result, std::size_t channels) {
  const Transfer transfer(check, channels);
  const auto lobe = check.zonal_coefficients();
  const Vector3 d = check.direction();
  const auto out =
      check
          .call(family,
                Check::with({{"visibility", transfer.visibility}, {"samples", transfer.samples}, {"lobe", lobe}}, d))
          .at(result);
  for (std::size_t channel = 0; channel < channels; ++channel) {
    double integral = 0;
    for (const auto& node : numeric::sphere_rule<double>(4 * check.degree)) {
      const Vector3 s{node.x, node.y, node.z};
      integral += node.weight * transfer.product(check, channel, s) * check.zonal(lobe, dot(d, s));
    }
    check.expect(out.at(channel), integral);
  }
}

}  // namespace

std::vector<Meaning> rotation_and_product_meanings() {
  return {{"rotate", check_rotate},
          {"rotate_quaternion", check_rotate_quaternion},
          {"rotate_z", check_rotate_z},
          {"rotate_build", check_rotate_build},
          {"rotate_apply", check_rotate_matrices},
          {"rotate_evaluate", check_rotate_evaluate},
          {"product", [](Check& check) { check_product(check, "product", check.degree); }},
          {"product_full", [](Check& check) { check_product(check, "product_full", 2 * check.degree); }},
          {"square", [](Check& check) { check_product(check, "square", check.degree); }},
          {"product_zonal", check_product_zonal},
          {"triple", check_triple},
          {"relight", [](Check& check) { check_relight(check, "relight", "value", 1, 1); }},
          {"relight_rgb", [](Check& check) { check_relight(check, "relight_rgb", "rgb", 1, 3); }},
          {"relight_colored", [](Check& check) { check_relight(check, "relight_colored", "rgb", 3, 3); }},
          {"transfer_prepare", [](Check& check) { check_transfer(check, "transfer_apply", 1); }},
          {"transfer_apply", [](Check& check) { check_transfer(check, "transfer_apply", 1); }},
          {"transfer_apply_rgb", [](Check& check) { check_transfer(check, "transfer_apply_rgb", 3); }},
          {"transfer_glossy", [](Check& check) { check_glossy(check, "transfer_glossy", "value", 1); }},
          {"transfer_glossy_rgb", [](Check& check) { check_glossy(check, "transfer_glossy_rgb", "rgb", 3); }}};
}

}  // namespace sh::codegen::test
