// Windows: they damp the higher degrees of a projection.
#include "symbolic/zonal/window.hpp"

#include "codegen/families/exact.hpp"
#include "codegen/measure/domains.hpp"
#include "codegen/recipes/zonal/zonal.hpp"

namespace sh::codegen {
namespace {

constexpr int kInputs = 300;

// Rows of parameters, each followed by coefficients; factor(l, row) is the exact window.
template <class Factor>
Reference window_reference(int degree, const std::vector<Rationals>& parameters, const Factor& factor) {
  const int count = coefficient_count(degree);
  const auto vectors = rational_vectors(static_cast<int>(parameters.size()), count, 91);
  Reference reference;
  for (Rationals& inputs : joined(parameters, vectors)) {
    const std::size_t row = reference.size();
    reference.push_back({std::move(inputs), precise_values(count, [&](int i) {
                           return Surd(factor(symbolic::degree_order(i).degree, row) * vectors[row][i]);
                         })});
  }
  return reference;
}

std::vector<Rationals> circle_points(int points) {
  std::vector<Rationals> circle;
  for (const Rationals& v : rational_vectors(points, 1, 92)) {
    const cln::cl_RA square = v[0] * v[0];
    circle.push_back({(square - 1) / (square + 1), 2 * v[0] / (square + 1)});
  }
  return circle;
}

Reference hann_reference(int degree, int points) {
  const auto circle = circle_points(points);
  std::vector<Rationals> cosines = circle;
  for (Rationals& row : cosines) row.resize(1);
  return window_reference(degree, cosines,
                          [&](int l, std::size_t k) { return symbolic::window_hann(l).evaluate(circle[k]); });
}

// The angles have rational sine and cosine. The formula is linear in 1 / angle, so any number can replace the angle.
Reference lanczos_reference(int degree, int points, int power) {
  const auto circle = circle_points(points);
  const auto any = rational_vectors(points, 1, 93);
  const auto angle = [&](std::size_t k) { return 1 + cln::abs(any[k][0]); };
  std::vector<Rationals> parameters = circle;
  for (std::size_t k = 0; k < circle.size(); ++k) parameters[k][1] = circle[k][1] / angle(k);
  return window_reference(degree, parameters, [&](int l, std::size_t k) {
    if (l == 0) return cln::cl_RA(1);
    return cln::expt(symbolic::window_lanczos_sine(l).evaluate(circle[k]) / (angle(k) * l), power);
  });
}

Reference gaussian_reference(int degree, int points) {
  auto g = rational_vectors(points, 1, 94);
  for (Rationals& row : g) row[0] = 1 / (1 + cln::abs(row[0]));
  return window_reference(
      degree, g, [&](int l, std::size_t k) { return cln::expt(g[k][0], symbolic::window_gaussian_exponent(l)); });
}

Reference laplacian_reference(int degree, int points) {
  auto lambda = rational_vectors(points, 1, 95);
  for (Rationals& row : lambda) row[0] = cln::abs(row[0]);
  return window_reference(degree, lambda, [&](int l, std::size_t k) {
    return 1 / (1 + lambda[k][0] * symbolic::window_laplacian_penalty(l));
  });
}

// Parameters from 0 to 1 (with `signs`: from -1 to 1), followed by coefficient vectors of norm 1.
Inputs window_inputs(int degree, int parameters, bool signs) {
  Inputs rows;
  for (int i = 0; i < kInputs; ++i) {
    const double t = static_cast<double>(i) / (kInputs - 1);
    // Wide windows lie near 1, so the parameters are twice as dense there.
    rows.push_back({1 - (1 - t) * (1 - t) * (signs ? 2 : 1)});
    if (parameters == 2) rows.back().push_back(static_cast<double>((i * 7) % kInputs) / kInputs);
  }
  return joined(std::move(rows), unit_vectors(kInputs, coefficient_count(degree), 96));
}

// parameters: the end of the description, " and g 0 to 1".
Domain window_domain(const std::string& parameters, int count, bool signs) {
  return {.inputs = "coefficient vectors (random, of norm 1)" + parameters,
          .unit = "|c_lm|",
          .test_inputs = [=](int degree) { return window_inputs(degree, count, signs); },
          .sizes = {"|c[i]|"}};
}

Family lanczos_family(const std::string& name, int power) {
  return {.name = name,
          .recipes = {{"recurrence", [power](int degree) { return recipes::window_lanczos(degree, power); }, 1}},
          .reference = [power](int degree, int points) { return lanczos_reference(degree, points, power); },
          .domain = window_domain(", cosines -1 to 1 and sincs 0 to 1", 2, true)};
}

}  // namespace

std::vector<Family> window_families() {
  return {{.name = "window_hann",
           .recipes = {{"halves", recipes::window_hann, 1}, {"chebyshev", recipes::window_hann_chebyshev, 1}},
           .reference = hann_reference,
           .domain = window_domain(" and cosines -1 to 1", 1, true)},
          lanczos_family("window_lanczos", 1),
          lanczos_family("window_lanczos2", 2),
          lanczos_family("window_lanczos4", 4),
          {.name = "window_gaussian",
           .recipes = {{"powers", recipes::window_gaussian, 1}},
           .reference = gaussian_reference,
           .domain = window_domain(" and g 0 to 1", 1, false)},
          {.name = "window_laplacian",
           .recipes = {{"quotients", recipes::window_laplacian, 1}},
           .reference = laplacian_reference,
           .domain = window_domain(" and lambda 0 to 1", 1, false)}};
}

}  // namespace sh::codegen
