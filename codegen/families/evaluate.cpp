#include "codegen/ir/evaluate.hpp"

#include <cmath>
#include <map>
#include <numbers>

#include "codegen/families/families.hpp"
#include "codegen/measure/directions.hpp"
#include "codegen/measure/domains.hpp"
#include "codegen/recipes/basis/basis.hpp"
#include "numeric/oracle/index.hpp"
#include "symbolic/basis/basis.hpp"

namespace sh::codegen {
namespace {

using symbolic::Surd;

constexpr std::size_t kInputs = 400;
constexpr std::size_t kPreparedInputs = 300;
constexpr const char* kUnit = "|c| sqrt((2L+1)/(4 pi)), the most that the top band alone can reach";

using numeric::coefficient_count;

cln::cl_F zero() { return cln::cl_float(0, cln::float_format(kCheckDigits)); }

// --- evaluate

// The sum of c_i Y_i(d) from the homogeneous forms.
cln::cl_F exact_value(const cln::cl_RA* c, int degree, const std::vector<cln::cl_RA>& d) {
  cln::cl_F sum = zero();
  for (int l = 0; l <= degree; ++l) {
    for (int m = -l; m <= l; ++m, ++c) {
      const symbolic::BasisFunction f = symbolic::basis_function(l, m);
      sum = sum + (Surd(*c * f.homogeneous.evaluate(d)) * f.factor).evaluate(kCheckDigits + 10);
    }
  }
  return sum;
}

Reference reference(int degree, int points, int channels) {
  Reference reference;
  const auto directions = rational_directions(points);
  const auto coefficients = rational_vectors(points, channels * coefficient_count(degree), 301);
  for (std::size_t k = 0; k < directions.size(); ++k) {
    const std::vector<cln::cl_RA> d(directions[k].begin(), directions[k].end());
    ReferencePoint point{coefficients[k], {}};
    for (int channel = 0; channel < channels; ++channel) {
      point.outputs.push_back(exact_value(coefficients[k].data() + channel * coefficient_count(degree), degree, d));
    }
    point.inputs.insert(point.inputs.end(), d.begin(), d.end());
    reference.push_back(std::move(point));
  }
  return reference;
}

// Each vector, followed by a direction.
std::vector<std::vector<double>> with_directions(std::vector<std::vector<double>> vectors) {
  const auto directions = some_test_directions(vectors.size());
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    const auto& d = directions[i * directions.size() / vectors.size()];
    vectors[i].insert(vectors[i].end(), d.begin(), d.end());
  }
  return vectors;
}

// One vector of norm 1 for each channel, then a direction.
template <int Channels>
std::vector<std::vector<double>> test_inputs(int degree) {
  std::vector<std::vector<double>> vectors(kInputs);
  for (int channel = 0; channel < Channels; ++channel) {
    const auto seed = static_cast<unsigned long>(302 + channel);
    vectors = joined(std::move(vectors), unit_vectors(static_cast<int>(kInputs), coefficient_count(degree), seed));
  }
  return with_directions(std::move(vectors));
}

template <int Channels>
Domain evaluation_domain() {
  return {.inputs = "coefficient vectors (random, of norm 1) with directions (random, axes, poles, near poles)",
          .unit = kUnit,
          .test_inputs = test_inputs<Channels>,
          .sizes = {"|c[k]| Y(L)"}};
}

// --- prepared

Reference prepare_reference(int degree, int points) {
  const auto matrix = recipes::polynomial_matrix(degree);
  Reference reference;
  for (const auto& c : rational_vectors(points, coefficient_count(degree), 305)) {
    ReferencePoint point{c, {}};
    for (const auto& row : matrix) {
      cln::cl_F sum = zero();
      for (std::size_t i = 0; i < c.size(); ++i) sum = sum + (Surd(c[i]) * row[i]).evaluate(kCheckDigits + 10);
      point.outputs.push_back(sum);
    }
    reference.push_back(std::move(point));
  }
  return reference;
}

std::vector<std::vector<double>> prepare_inputs(int degree) {
  return unit_vectors(static_cast<int>(kPreparedInputs), coefficient_count(degree), 306);
}

// The norm of a row of the matrix, which is the largest value of this coefficient for |c| = 1.
double prepare_gain(int degree, std::size_t output) {
  static std::map<int, std::vector<double>> norms;
  std::vector<double>& of_degree = norms[degree];
  if (of_degree.empty()) {
    for (const auto& row : recipes::polynomial_matrix(degree)) {
      double square = 0;
      for (const Surd& entry : row) square += std::pow(cln::double_approx(entry.evaluate(20)), 2);
      of_degree.push_back(std::sqrt(square));
    }
  }
  return of_degree[output];
}

// This reference takes the polynomial as given. The check of `prepare` shows that it belongs to the function.
Reference prepared_reference(int degree, int points) {
  Reference reference;
  const auto directions = rational_directions(points);
  const auto polynomials = rational_vectors(points, coefficient_count(degree), 307);
  for (std::size_t k = 0; k < directions.size(); ++k) {
    const auto& [x, y, z] = directions[k];
    cln::cl_RA sum = 0;
    for (const int with_z : {0, 1}) {
      for (int i = 0; i <= degree - with_z; ++i) {
        for (int j = 0; i + j <= degree - with_z; ++j) {
          const cln::cl_RA& p = polynomials[k][recipes::polynomial_index(degree, i, j, with_z == 1)];
          sum = sum + p * cln::expt(x, i) * cln::expt(y, j) * (with_z == 1 ? z : cln::cl_RA(1));
        }
      }
    }
    ReferencePoint point{polynomials[k], {cln::cl_float(sum, cln::float_format(kCheckDigits))}};
    for (const auto& component : directions[k]) point.inputs.push_back(component);
    reference.push_back(std::move(point));
  }
  return reference;
}

std::vector<std::vector<double>> prepared_inputs(int degree) {
  const Kernel prepare = recipes::evaluate_prepare(degree);
  Evaluator<double> evaluator(prepare);
  std::vector<std::vector<double>> polynomials;
  for (const auto& c : prepare_inputs(degree)) polynomials.push_back(evaluator(c));
  return with_directions(std::move(polynomials));
}

}  // namespace

Family evaluate_family() {
  return {.name = "evaluate",
          .recipes = {{"columns", recipes::evaluate_columns}, {"sum", recipes::evaluate_sum}},
          .reference = [](int degree, int points) { return reference(degree, points, 1); },
          .domain = evaluation_domain<1>(),
          .batch = BatchDriver{.what = "Functions given by coefficients, at directions",
                               .prepare = "evaluate_prepare",
                               .prepared = "evaluate_prepared",
                               .half = true}};
}

Family evaluate_rgb_family() {
  return {
      .name = "evaluate_rgb",
      .recipes = {{"columns", recipes::evaluate_rgb_columns}, {"sum", recipes::evaluate_rgb_sum}},
      .reference = [](int degree, int points) { return reference(degree, points, 3); },
      .domain = evaluation_domain<3>(),
      .batch = BatchDriver{.what = "Colours given by coefficients, channel by channel, at directions", .half = true}};
}

Family evaluate_prepare_family() {
  Domain domain;
  domain.inputs = "coefficient vectors (random, of norm 1)";
  domain.unit = "the largest that this coefficient of the polynomial gets from |c| = 1";
  domain.test_inputs = prepare_inputs;
  domain.sizes = {"gain |c|"};
  domain.gain = prepare_gain;
  return {.name = "evaluate_prepare",
          .recipes = {{"by-order", recipes::evaluate_prepare}},
          .reference = prepare_reference,
          .domain = domain};
}

Family evaluate_prepared_family() {
  return {
      .name = "evaluate_prepared",
      .recipes = {{"horner", recipes::evaluate_prepared}},
      .reference = prepared_reference,
      .domain = {.inputs = "prepared functions (random, |c| = 1) with directions (random, axes, poles, near poles)",
                 .unit = kUnit,
                 .test_inputs = prepared_inputs,
                 .sizes = {"Y(L)"}},
  };
}

}  // namespace sh::codegen
