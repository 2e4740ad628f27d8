// Transferred radiance: visibility of degree 2n times light of degree n on the bands of the light.
//
// `transfer_prepare` evaluates a light at the nodes of a quadrature, `transfer_apply` multiplies with the visibility there
// and projects, `transfer_glossy` multiplies with a lobe, too, and integrates (codegen/recipes/product/transfer.cpp). The
// references know the nodes by their definition, and the result by the Gaunt tensor.
#include <cln/real.h>

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <span>
#include <utility>

#include "codegen/families/exact.hpp"
#include "codegen/ir/evaluate.hpp"
#include "codegen/measure/directions.hpp"
#include "codegen/measure/domains.hpp"
#include "codegen/recipes/product/product.hpp"
#include "symbolic/product/gaunt.hpp"
#include "symbolic/product/product_form.hpp"
#include "symbolic/zonal/convolution.hpp"

namespace sh::codegen {
namespace {

constexpr int kDigits = kCheckDigits + 20;
constexpr unsigned long kSeed = 20020701;
constexpr int kInputs = 120;
constexpr int kLargest = symbolic::kMaxProductDegree / 2;
constexpr const char* kLimit = "visibility has twice the degree, and the Gaunt tensor is derived to that degree only";

using Node = std::array<cln::cl_RA, 3>;
using Numbers = std::vector<cln::cl_F>;

cln::cl_F number(const cln::cl_RA& value) { return Surd(value).evaluate(kDigits); }

// P_m(z) and its derivative.
std::array<cln::cl_F, 2> legendre(int m, const cln::cl_F& z) {
  cln::cl_F before = number(1), value = z;
  for (int l = 2; l <= m; ++l) {
    const cln::cl_F next = (number(2 * l - 1) * z * value - number(l - 1) * before) / number(l);
    before = value;
    value = next;
  }
  return {value, number(m) * (before - z * value) / (number(1) - z * z)};
}

// The zeros of P'_m above 0, the largest first (Newton's method; (1-z^2) P'' = 2 z P' - m(m+1) P).
Numbers heights(int m) {
  Numbers zeros;
  for (int k = 1; 2 * k < m; ++k) {
    const double start = std::cos(std::numbers::pi * k / m);  // near the extremum k of P_m
    cln::cl_F z = cln::cl_float(start, cln::float_format(kDigits));
    constexpr int kSteps = 12;
    for (int step = 0; step < kSteps; ++step) {
      const auto [value, slope] = legendre(m, z);
      const cln::cl_F bend = (number(2) * z * slope - number(m * (m + 1)) * value) / (number(1) - z * z);
      z = z - slope / bend;
    }
    zeros.push_back(z);
  }
  return zeros;
}

// The nodes for functions of a degree, at least 1, in the order of the samples; coordinates to kDigits digits.
std::vector<Node> nodes_of(int degree) {
  const cln::cl_F pi = cln::pi(cln::float_format(kDigits));
  std::vector<Node> nodes;
  for (const cln::cl_F& z : heights(2 * degree + 1)) {
    const cln::cl_F radius = cln::sqrt(number(1) - z * z);
    for (const int side : {1, -1}) {
      for (int j = 0; j < degree; ++j) {
        const cln::cl_F phi = number(2 * j + 1) * pi / number(4 * degree);
        const cln::cl_RA x = cln::rational(radius * cln::cos(phi)), y = cln::rational(radius * cln::sin(phi));
        const cln::cl_RA height = side * cln::rational(z);
        nodes.insert(nodes.end(), {Node{x, y, height}, {-x, -y, height}, {x, -y, height}, {-x, y, height}});
      }
    }
  }
  nodes.insert(nodes.end(), {Node{0, 0, 1}, {0, 0, -1}});
  return nodes;
}

// The basis at the nodes: a row for each node.
const std::vector<Numbers>& basis_at_nodes(int degree) {
  static std::map<int, std::vector<Numbers>> known;
  const auto [position, added] = known.try_emplace(degree);
  if (added) {
    for (const Node& node : nodes_of(degree)) {
      Numbers& row = position->second.emplace_back();
      for (int i = 0; i < coefficient_count(degree); ++i) row.push_back(basis_value(i, node).evaluate(kDigits));
    }
  }
  return position->second;
}

// The samples of a light.
Numbers samples_of(int degree, std::span<const cln::cl_RA> light) {
  if (degree == 0) return {(symbolic::gaunt(0, 0, 0) * Surd(light[0])).evaluate(kDigits)};
  Numbers samples;
  for (const Numbers& basis : basis_at_nodes(degree)) {
    cln::cl_F sum = number(0);
    for (std::size_t i = 0; i < light.size(); ++i) sum = sum + number(light[i]) * basis[i];
    samples.push_back(sum);
  }
  const int cosine = numeric::coefficient_index(degree, degree), sine = numeric::coefficient_index(degree, -degree);
  const Surd top = symbolic::gaunt(numeric::coefficient_index(2 * degree, 2 * degree), cosine, cosine);
  samples.push_back((top * Surd(light[cosine])).evaluate(kDigits));
  samples.push_back((top * Surd(light[sine])).evaluate(kDigits));
  return samples;
}

// The channels of a light, one after the other.
std::vector<std::span<const cln::cl_RA>> channels_of(std::span<const cln::cl_RA> lights, int degree) {
  const int count = coefficient_count(degree);
  std::vector<std::span<const cln::cl_RA>> channels;
  for (std::size_t first = 0; first < lights.size(); first += count) channels.push_back(lights.subspan(first, count));
  return channels;
}

Reference prepare_reference(int degree, int points) {
  return reference_at(rational_vectors(points, coefficient_count(degree), kSeed),
                      [=](const Rationals& light) { return samples_of(degree, light); });
}

// The matrix T_ij = integral of V y_i y_j times the light [SloanKautzSnyder02, equation 11].
Numbers transferred(int degree, std::span<const cln::cl_RA> visibility, std::span<const cln::cl_RA> light) {
  Numbers result;
  for (const symbolic::BilinearForm& form : symbolic::product_form({2 * degree, degree, degree})) {
    cln::cl_F sum = number(0);
    for (const symbolic::BilinearTerm& term : form.terms) {
      sum = sum + (term.factor * Surd(visibility[term.i] * light[term.j])).evaluate(kDigits);
    }
    result.push_back(sum);
  }
  return result;
}

Reference apply_reference(int degree, int points, int channels) {
  const auto visibilities = rational_vectors(points, coefficient_count(2 * degree), kSeed + 1);
  const auto lights = rational_vectors(points, channels * coefficient_count(degree), kSeed + 2);
  Reference reference;
  for (int point = 0; point < points; ++point) {
    ReferencePoint known{visibilities[point], {}};
    for (const auto& channel : channels_of(lights[point], degree)) {
      for (const cln::cl_F& sample : samples_of(degree, channel)) known.inputs.push_back(cln::rational(sample));
      const Numbers result = transferred(degree, visibilities[point], channel);
      known.outputs.insert(known.outputs.end(), result.begin(), result.end());
    }
    reference.push_back(std::move(known));
  }
  return reference;
}

// The lobe, a zonal function about the direction, as coefficients.
Numbers turned(int degree, std::span<const cln::cl_RA> lobe, std::span<const cln::cl_RA> direction) {
  Numbers result;
  for (const symbolic::TurnedZonal& f : symbolic::turned_zonal(degree)) {
    result.push_back((Surd(f.polynomial.evaluate(direction) * lobe[f.degree]) * f.factor).evaluate(kDigits));
  }
  return result;
}

// The points of apply with a lobe and a direction; of each channel the scalar product with the turned lobe.
Reference glossy_reference(int degree, int points, int channels) {
  const auto lobes = joined(rational_vectors(points, degree + 1, kSeed + 3), rational_directions(points));
  Reference reference = apply_reference(degree, points, channels);
  for (int point = 0; point < points; ++point) {
    const std::span lobe(lobes[point]);
    const Numbers weights = turned(degree, lobe.first(degree + 1), lobe.last(3));
    const Numbers transferred = std::exchange(reference[point].outputs, {});
    for (auto first = transferred.begin(); first != transferred.end(); first += weights.size()) {
      reference[point].outputs.push_back(std::inner_product(weights.begin(), weights.end(), first, number(0)));
    }
    reference[point].inputs.insert(reference[point].inputs.end(), lobe.begin(), lobe.end());
  }
  return reference;
}

Inputs lights(int degree, unsigned long seed) { return unit_vectors(kInputs, coefficient_count(degree), seed); }

Inputs apply_inputs(int degree, int channels) {
  const Kernel prepare = recipes::transfer_prepare(degree);
  Evaluator<double> evaluator(prepare);
  Inputs inputs = unit_vectors(kInputs, coefficient_count(2 * degree), kSeed + 5);
  for (int channel = 0; channel < channels; ++channel) {
    Inputs samples;
    for (const auto& light : lights(degree, kSeed + channel)) samples.push_back(evaluator(light));
    inputs = joined(std::move(inputs), samples);
  }
  return inputs;
}

Inputs glossy_inputs(int degree, int channels) {
  const auto lobes = joined(unit_vectors(kInputs, degree + 1, kSeed + 6), some_test_directions(kInputs));
  return joined(apply_inputs(degree, channels), lobes);
}

// Straight-line code of a higher degree does not fit into the instruction cache.
constexpr int kLargestStraight = 3;

std::vector<Recipe> recipes_of(Kernel (*make)(int degree, int channels, bool looped), int channels) {
  return {{"rings", [=](int degree) { return make(degree, channels, false); }, 0, kLargestStraight},
          {"looped", [=](int degree) { return make(degree, channels, true); }, kLargestStraight}};
}

Family prepare_family() {
  return {.name = "transfer_prepare",
          .largest_written = kLargest,
          .largest_emitted = kLargest,
          .limit = kLimit,
          .recipes = {{"rings", recipes::transfer_prepare}},
          .reference = prepare_reference,
          .domain = {.inputs = "lights (random, of norm 1)",
                     .unit = "|light| sqrt((L+1)^2/(4 pi)), the largest value of such a light",
                     .test_inputs = [](int degree) { return lights(degree, kSeed); },
                     .sizes = {"|light| Y(0..L)"}}};
}

Family apply_family(const std::string& name, int channels, const std::string& what) {
  return {
      .name = name,
      .largest_written = kLargest,
      .largest_emitted = kLargest,
      .limit = kLimit,
      .recipes = recipes_of(recipes::transfer_apply, channels),
      .reference = [=](int degree, int points) { return apply_reference(degree, points, channels); },
      .domain = {.inputs = "visibility (random, of norm 1) with prepared lights (random, of norm 1 in each channel)",
                 .unit = "|visibility| |light|, |light| = 1",
                 .test_inputs = [=](int degree) { return apply_inputs(degree, channels); },
                 .sizes = {"|visibility|"}},
      .batch = BatchDriver{.what = what, .half = true, .rings = true, .largest = kLargest}};
}

Family glossy_family(const std::string& name, int channels, const std::string& what) {
  return {
      .name = name,
      .largest_written = kLargest,
      .largest_emitted = kLargest,
      .limit = kLimit,
      .recipes = recipes_of(recipes::transfer_glossy, channels),
      .reference = [=](int degree, int points) { return glossy_reference(degree, points, channels); },
      .domain = {.inputs = "visibility and lobes (random, of norm 1) with prepared lights (random, of norm 1 in each "
                           "channel) and directions (random, axes, poles, near poles)",
                 .unit = "|visibility| |light| |lobe|, |light| = 1",
                 .test_inputs = [=](int degree) { return glossy_inputs(degree, channels); },
                 .sizes = {"|visibility| |lobe|"}},
      .batch = BatchDriver{.what = what, .half = true, .largest = kLargest}};
}

}  // namespace

std::vector<Family> transfer_families() {
  return {
      prepare_family(), apply_family("transfer_apply", 1, "Transferred radiance of visibility under a prepared light"),
      apply_family("transfer_apply_rgb", 3, "The same of three channels, which share the samples of the visibility"),
      glossy_family("transfer_glossy", 1, "Radiance that glossy vertices reflect under a prepared light"),
      glossy_family("transfer_glossy_rgb", 3, "The same of three channels")};
}

}  // namespace sh::codegen
