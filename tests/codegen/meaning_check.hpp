// One check of a family: random inputs, functions of its coefficients, and the differences that it finds.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <set>

#include "numeric/oracle/quadrature.hpp"
#include "numeric/oracle/zonal.hpp"
#include "tests/codegen/convention_meaning.hpp"

namespace sh::codegen::test {

inline constexpr double kPi = std::numbers::pi;
using Matrix3 = std::array<Vector3, 3>;
using Function = std::function<double(const Vector3& d)>;

inline double legendre(int l, double t) { return std::legendre(static_cast<unsigned>(l), t); }

inline Vector3 scaled(const Vector3& d, double s) { return {s * d[0], s * d[1], s * d[2]}; }
inline Vector3 unit(const Vector3& d) { return scaled(d, 1 / std::sqrt(dot(d, d))); }
inline Vector3 turned(const Matrix3& r, const Vector3& d) { return {dot(r[0], d), dot(r[1], d), dot(r[2], d)}; }
inline std::vector<double> flat(const Matrix3& r) {
  std::vector<double> list;
  for (const Vector3& row : r) list.insert(list.end(), row.begin(), row.end());
  return list;
}

// w, x, y, z -> the matrix of v -> q v q^-1
inline Matrix3 matrix_of(const std::vector<double>& q) {
  const double w = q[0];
  const double x = q[1];
  const double y = q[2];
  const double z = q[3];
  return {{{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
           {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
           {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}};
}

inline double clamped_cosine(int l) { return numeric::clamped_cosine_factor<double>(l); }

/// Inputs, functions and differences in a world.
class Check {
 public:
  Check(const World& in_world, const Call& by_call) : world(in_world), call(by_call), degree(in_world.degree) {}

  // --- inputs; numbers in -1 .. 1, rounded to float so that both scalars see the same
  double any() { return static_cast<double>(std::uniform_real_distribution<float>(-1, 1)(random_)); }
  Vector3 direction() { return unit({any(), any(), any() + 0.1}); }
  std::vector<double> quaternion() {
    std::vector<double> q{any() + 1.5, any(), any(), any()};
    const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    for (double& component : q) component /= length;
    return q;
  }
  std::vector<double> coefficients(int channels = 1) { return coefficients_to(degree, channels); }
  std::vector<double> coefficients_to(int of_degree, int channels = 1) {
    const int size = world.definition.size(of_degree);
    std::vector<double> c(static_cast<std::size_t>(channels * size), 0);
    for (int channel = 0; channel < channels; ++channel) {
      for (int l = 0; l <= of_degree; ++l) {
        for (int m = -l; m <= l; ++m) c.at(channel * size + world.definition.place(of_degree, l, m)) = any();
      }
    }
    return c;
  }
  std::vector<double> zonal_coefficients() {
    std::vector<double> zonal;
    for (int l = 0; l <= degree; ++l) zonal.push_back(any());
    return zonal;
  }
  static Arrays with(Arrays arrays, const Vector3& d) {
    arrays["x"] = {d[0]};
    arrays["y"] = {d[1]};
    arrays["z"] = {d[2]};
    return arrays;
  }

  // --- functions
  [[nodiscard]] double y(int l, int m, const Vector3& d) const {
    return world.definition.function(l, m, named_coordinates(world.axes, d));
  }
  // sum factor(l) c'_lm Y'_lm(d) of a channel of an array of degrees 0 to `of_degree`
  template <class Factor>
  [[nodiscard]] double sum(const std::vector<double>& c, const Vector3& d, const Factor& factor, int of_degree,
                           int channel = 0) const {
    double total = 0;
    for (int l = 0; l <= of_degree; ++l) {
      for (int m = -l; m <= l; ++m) {
        const int place = channel * world.definition.size(of_degree) + world.definition.place(of_degree, l, m);
        total += factor(l) * c.at(static_cast<std::size_t>(place)) * y(l, m, d);
      }
    }
    return total;
  }
  [[nodiscard]] double value(const std::vector<double>& c, const Vector3& d, int channel = 0) const {
    return sum(
        c, d, [](int) { return 1; }, degree, channel);
  }
  [[nodiscard]] double irradiance(const std::vector<double>& c, const Vector3& n) const {
    return sum(
        c, n, [&](int l) { return world.definition.convolved ? kPi : clamped_cosine(l); }, degree);
  }
  // The coefficients hold this factor of radiance.
  [[nodiscard]] double held(int l) const { return world.definition.convolved ? clamped_cosine(l) / kPi : 1; }
  // A function about an axis at the cosine t: sum z'_l Y'_l0.
  [[nodiscard]] double zonal(const std::vector<double>& z, double t) const {
    double total = 0;
    for (int l = 0; l <= degree; ++l) {
      // The axis of the convention is z of its own functions, wherever its source has it.
      total += z.at(static_cast<std::size_t>(l)) * y_about_axis(l, t);
    }
    return total;
  }
  // A sample of weight 1 at cosine t, in bands.
  [[nodiscard]] double sample(double t) const {
    double total = 0;
    for (int l = 0; l <= degree; ++l) total += held(l) * (2 * l + 1) / (4 * kPi) * legendre(l, t);
    return total;
  }
  // A cap of radiance 1 about an axis at cosine t.
  [[nodiscard]] double cap(double one_minus_cos, double t) const {
    std::vector<double> z(static_cast<std::size_t>(degree) + 1);
    numeric::cap_zonal<double>(degree, one_minus_cos, z.data());
    double total = 0;
    for (int l = 0; l <= degree; ++l)
      total += held(l) * z[static_cast<std::size_t>(l)] * std::sqrt((2 * l + 1) / (4 * kPi)) * legendre(l, t);
    return total;
  }
  // The projection of f on bands 0 to `to`, at d. f has bands 0 to `from`.
  static double projected(const Function& f, int from, int to, const Vector3& d) {
    double total = 0;
    for (const auto& node : numeric::sphere_rule<double>(from + to)) {
      const Vector3 s{node.x, node.y, node.z};
      double kernel = 0;
      for (int l = 0; l <= to; ++l) kernel += (2 * l + 1) / (4 * kPi) * legendre(l, dot(s, d));
      total += node.weight * f(s) * kernel;
    }
    return total;
  }

  // --- differences
  void expect(double got, double expected) {
    const double difference = std::abs(got - expected) / (1 + std::abs(expected));
    largest = std::isnan(difference) ? std::numeric_limits<double>::infinity() : std::max(largest, difference);
  }
  // The array holds the function, and zeros where it holds no coefficient.
  void expect_function(const std::vector<double>& c, const Function& f, int of_degree, int channel = 0) {
    for (int i = 0; i < of_degree * of_degree + 6; ++i) {
      const Vector3 d = direction();
      expect(sum(
                 c, d, [](int) { return 1; }, of_degree, channel),
             f(d));
    }
    expect_holes(c, of_degree, channel);
  }
  void expect_function(const std::vector<double>& c, const Function& f) { expect_function(c, f, degree); }
  void expect_holes(const std::vector<double>& c, int of_degree, int channel = 0) {
    std::set<int> places;
    for (int l = 0; l <= of_degree; ++l) {
      for (int m = -l; m <= l; ++m) places.insert(world.definition.place(of_degree, l, m));
    }
    const int size = world.definition.size(of_degree);
    for (int i = 0; i < size; ++i) {
      if (!places.contains(i)) expect(c.at(static_cast<std::size_t>(channel * size + i)), 0);
    }
  }

  const World& world;
  const Call& call;
  int degree;
  double largest = 0;

 private:
  [[nodiscard]] double y_about_axis(int l, double t) const {
    const Vector3 own{std::sqrt(std::max(0.0, 1 - t * t)), 0, t};
    return world.definition.function(l, 0, world.definition.own_axes ? Vector3{0, t, own[0]} : own);
  }

  std::mt19937 random_{7};
};

/// The check of one family.
struct Meaning {
  std::string family;
  std::function<void(Check&)> check;
};

std::vector<Meaning> basis_meanings();
std::vector<Meaning> light_meanings();
std::vector<Meaning> rotation_and_product_meanings();

}  // namespace sh::codegen::test
