#include <algorithm>
#include <cmath>
#include <functional>

#include "codegen/families/families.hpp"
#include "codegen/measure/domains.hpp"
#include "codegen/recipes/zonal/zonal.hpp"
#include "numeric/oracle/index.hpp"
#include "symbolic/basis/basis.hpp"

namespace sh::codegen {
namespace {

constexpr int kInputs = 300;
constexpr int kLargest = 20;
constexpr const char* kLimit =
    "straight-line code of a higher degree is too long to be useful; degree 0 needs no window";
constexpr const char* kUnit = "|c_lm|";

using numeric::coefficient_count;

// Points at which `factor(l, parameters)` is the exact window. parameters(k): the parameters of point k.
using Parameters = std::vector<cln::cl_RA>;
Reference window_reference(int degree, int points, const std::function<Parameters(std::size_t)>& parameters,
                           const std::function<cln::cl_RA(int, std::size_t)>& factor) {
  Reference reference;
  const auto vectors = rational_vectors(points, coefficient_count(degree), 91);
  for (std::size_t k = 0; k < vectors.size(); ++k) {
    ReferencePoint point{parameters(k), {}};
    point.inputs.insert(point.inputs.end(), vectors[k].begin(), vectors[k].end());
    for (std::size_t i = 0; i < vectors[k].size(); ++i) {
      const cln::cl_RA windowed = factor(static_cast<int>(std::sqrt(static_cast<double>(i))), k) * vectors[k][i];
      point.outputs.push_back(symbolic::Surd(windowed).evaluate(kCheckDigits));
    }
    reference.push_back(std::move(point));
  }
  return reference;
}

// cos(l angle) and sin(l angle) at a rational point (cos, sin) of the circle: the functions Re and Im (x + iy)^l.
cln::cl_RA multiple(int l, bool sine, const std::vector<cln::cl_RA>& circle) {
  if (l == 0) return sine ? 0 : 1;
  return symbolic::reduced_basis_function(l, sine ? -l : l).azimuthal.evaluate(circle);
}

std::vector<std::vector<cln::cl_RA>> circle_points(int points) {
  std::vector<std::vector<cln::cl_RA>> circle;
  for (const auto& v : rational_vectors(points, 1, 92)) {
    const cln::cl_RA square = v[0] * v[0];
    circle.push_back({(square - 1) / (square + 1), 2 * v[0] / (square + 1)});
  }
  return circle;
}

Reference hann_reference(int degree, int points) {
  const auto circle = circle_points(points);
  return window_reference(
      degree, points, [&](std::size_t k) { return Parameters{circle[k][0]}; },
      [&](int l, std::size_t k) { return (1 + multiple(l, false, circle[k])) / 2; });
}

// The angles have rational sine and cosine. The formula is linear in 1 / angle, so any number can replace the angle.
Reference lanczos_reference(int degree, int points, int power) {
  const auto circle = circle_points(points);
  const auto angles = rational_vectors(points, 1, 93);
  const auto angle = [&](std::size_t k) { return 1 + cln::abs(angles[k][0]); };
  return window_reference(
      degree, points,
      [&](std::size_t k) {
        return Parameters{circle[k][0], circle[k][1] / angle(k)};
      },
      [&](int l, std::size_t k) {
        return l == 0 ? cln::cl_RA(1) : cln::expt(multiple(l, true, circle[k]) / (angle(k) * l), power);
      });
}

Reference gaussian_reference(int degree, int points) {
  const auto g = rational_vectors(points, 1, 94);
  const auto parameter = [&](std::size_t k) { return 1 / (1 + cln::abs(g[k][0])); };
  return window_reference(
      degree, points, [&](std::size_t k) { return Parameters{parameter(k)}; },
      [&](int l, std::size_t k) { return cln::expt(parameter(k), l * l); });
}

Reference laplacian_reference(int degree, int points) {
  const auto lambda = rational_vectors(points, 1, 95);
  const auto parameter = [&](std::size_t k) { return cln::abs(lambda[k][0]); };
  return window_reference(
      degree, points, [&](std::size_t k) { return Parameters{parameter(k)}; },
      [&](int l, std::size_t k) { return 1 / (1 + parameter(k) * (l * l * (l + 1) * (l + 1))); });
}

// Parameters from 0 to 1 (with `signs`: from -1 to 1), followed by coefficient vectors of norm 1.
std::vector<std::vector<double>> inputs(int degree, std::size_t parameters, bool signs) {
  const std::vector<std::vector<double>> vectors = unit_vectors(kInputs, coefficient_count(degree), 96);
  std::vector<std::vector<double>> inputs;
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    const double t = static_cast<double>(i) / (kInputs - 1);
    // Wide windows lie near 1, so the parameters are twice as dense there.
    const double value = 1 - (1 - t) * (1 - t) * (signs ? 2 : 1);
    std::vector<double> input{value};
    if (parameters == 2) input.push_back(static_cast<double>((i * 7) % kInputs) / kInputs);
    input.insert(input.end(), vectors[i].begin(), vectors[i].end());
    inputs.push_back(std::move(input));
  }
  return inputs;
}

std::vector<std::vector<double>> cosine_inputs(int degree) { return inputs(degree, 1, true); }
std::vector<std::vector<double>> sinc_inputs(int degree) { return inputs(degree, 2, true); }
std::vector<std::vector<double>> positive_inputs(int degree) { return inputs(degree, 1, false); }

Family lanczos_family(const std::string& name, int power) {
  return {
      .name = name,
      .recipes = {{"recurrence", [power](int degree) { return recipes::window_lanczos(degree, power); }, 1}},
      .reference = [power](int degree, int points) { return lanczos_reference(degree, points, power); },
      .domain = {.inputs = "coefficient vectors (random, of norm 1), cosines -1 to 1 and sincs 0 to 1",
                 .unit = kUnit,
                 .test_inputs = sinc_inputs,
                 .sizes = {"|c[i]|"}},
  };
}

}  // namespace

Family window_hann_family() {
  return {
      .name = "window_hann",
      .recipes = {{"halves", recipes::window_hann, 1}, {"chebyshev", recipes::window_hann_chebyshev, 1}},
      .reference = hann_reference,
      .domain = {.inputs = "coefficient vectors (random, of norm 1) and cosines -1 to 1",
                 .unit = kUnit,
                 .test_inputs = cosine_inputs,
                 .sizes = {"|c[i]|"}},
  };
}

Family window_lanczos_family() { return lanczos_family("window_lanczos", 1); }
Family window_lanczos2_family() { return lanczos_family("window_lanczos2", 2); }
Family window_lanczos4_family() { return lanczos_family("window_lanczos4", 4); }

Family window_gaussian_family() {
  return {
      .name = "window_gaussian",
      .recipes = {{"powers", recipes::window_gaussian, 1}},
      .reference = gaussian_reference,
      .domain = {.inputs = "coefficient vectors (random, of norm 1) and g 0 to 1",
                 .unit = kUnit,
                 .test_inputs = positive_inputs,
                 .sizes = {"|c[i]|"}},
  };
}

Family window_laplacian_family() {
  return {
      .name = "window_laplacian",
      .recipes = {{"quotients", recipes::window_laplacian, 1}},
      .reference = laplacian_reference,
      .domain = {.inputs = "coefficient vectors (random, of norm 1) and lambda 0 to 1",
                 .unit = kUnit,
                 .test_inputs = positive_inputs,
                 .sizes = {"|c[i]|"}},
  };
}

}  // namespace sh::codegen
