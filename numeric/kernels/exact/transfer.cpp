// Transferred radiance: transfer_prepare(light) -> the light at the nodes of a quadrature, transfer_apply(visibility,
// samples) -> the coefficients of their product, for the samples of one channel or three, and transfer_glossy(visibility,
// samples, lobe, direction) -> that product convolved with a zonal lobe, in one direction.
//
// The nodes for degree n, at least 1: the poles and n pairs of rings at the inner nodes of the Lobatto rule of 2n + 2
// points, the largest z first, z before -z; on each ring phi, pi + phi, -phi, pi - phi for phi = (j + 1/2) pi / (2n),
// j = 0 .. n-1. Two further samples are K times the light's coefficients of order n and -n, K the integral of
// Y_2n,2n Y_nn Y_nn: what the nodes cannot tell from order n. A light of degree 0 has one sample, its value.
#include <map>
#include <utility>
#include <vector>

#include "numeric/kernels/exact/exact.hpp"
#include "numeric/kernels/inputs.hpp"
#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/quadrature.hpp"
#include "numeric/oracle/zonal.hpp"

namespace sh::numeric {
namespace {

// P_m(z) and P'_m(z), |z| < 1.
template <class Real>
std::pair<Real, Real> legendre(int m, const Real& z) {
  Real before = 1;
  Real value = z;
  for (int l = 2; l <= m; ++l) {
    const Real next = ((2 * l - 1) * z * value - (l - 1) * before) / l;
    before = value;
    value = next;
  }
  return {value, m * (before - z * value) / (1 - z * z)};
}

// The zeros of P'_m above 0, the largest first. They lie between the zeros of P_m; (1-z^2) P'' = 2 z P' - m(m+1) P.
template <class Real>
std::vector<Real> extrema(int m) {
  const std::vector<Real> zeros = gauss_legendre<Real>(m).nodes;
  std::vector<Real> found;
  for (int k = m - 1; 2 * k > m; --k) {
    Real z = (zeros[k] + zeros[k - 1]) / 2;
    constexpr int kSteps = 10;
    for (int step = 0; step < kSteps; ++step) {
      const auto [value, slope] = legendre<Real>(m, z);
      z -= slope * (1 - z * z) / (2 * z * slope - m * (m + 1) * value);
    }
    found.push_back(z);
  }
  return found;
}

// The nodes of one degree with the values of the basis of degree 2n there.
template <class Real>
struct TransferRule {
  std::size_t light = 0;       // coefficients
  std::size_t visibility = 0;  // coefficients
  std::vector<Real> weights;   // (nodes)
  std::vector<Real> basis;     // (nodes, visibility)
  Real alias = 0;              // K

  explicit TransferRule(int degree) : light(coefficient_count(degree)), visibility(coefficient_count(2 * degree)) {
    using std::cos, std::sin, std::sqrt, std::acos;
    const Real pi = acos(Real(-1));
    if (degree == 0) {
      add(degree, {0, 0, 1}, 4 * pi);
      return;
    }
    const int m = 2 * degree + 1;
    for (const Real& height : extrema<Real>(m)) {
      const Real value = legendre<Real>(m, height).first;
      const Real weight = 2 / (m * (m + 1) * value * value) * 2 * pi / (4 * degree);
      const Real radius = sqrt(1 - height * height);
      for (const Real& z : {height, Real(-height)}) {
        for (int j = 0; j < degree; ++j) {
          const Real phi = (2 * j + 1) * pi / (4 * degree);
          const Real x = radius * cos(phi), y = radius * sin(phi);
          add(degree, {x, y, z}, weight);
          add(degree, {-x, -y, z}, weight);
          add(degree, {x, -y, z}, weight);
          add(degree, {-x, y, z}, weight);
        }
      }
    }
    const Real weight = Real(2) / (m * (m + 1)) * 2 * pi;
    add(degree, {0, 0, 1}, weight);
    add(degree, {0, 0, -1}, weight);
    const std::size_t top = coefficient_index(2 * degree, 2 * degree), order = coefficient_index(degree, degree);
    for (const auto& node : sphere_rule<Real>(4 * degree)) {
      const std::vector<Real> y = sh::numeric::basis(2 * degree, node.x, node.y, node.z);
      alias += node.weight * y[top] * y[order] * y[order];
    }
  }

  void add(int degree, const std::vector<Real>& d, const Real& weight) {
    weights.push_back(weight);
    const std::vector<Real> y = sh::numeric::basis(2 * degree, d[0], d[1], d[2]);
    basis.insert(basis.end(), y.begin(), y.end());
  }

  [[nodiscard]] Real value(std::size_t node, std::size_t count, const Real* c) const {
    Real sum = 0;
    for (std::size_t i = 0; i < count; ++i) sum += c[i] * basis[node * visibility + i];
    return sum;
  }
};

template <class Real>
const TransferRule<Real>& rule_of(int degree) {
  static std::map<int, TransferRule<Real>> rules;
  return rules.try_emplace(degree, degree).first->second;
}

// The samples of one light; returns their end.
template <class Real>
Real* prepare(int degree, const Real* light, Real* samples) {
  const auto& rule = rule_of<Real>(degree);
  for (std::size_t k = 0; k < rule.weights.size(); ++k) *samples++ = rule.value(k, rule.light, light);
  if (degree == 0) return samples;
  *samples++ = rule.alias * light[coefficient_index(degree, degree)];
  *samples++ = rule.alias * light[coefficient_index(degree, -degree)];
  return samples;
}

// The visibility at the nodes, times their weights.
template <class Real>
std::vector<Real> weighted(int degree, const Real* visibility) {
  const auto& rule = rule_of<Real>(degree);
  std::vector<Real> seen;
  for (std::size_t k = 0; k < rule.weights.size(); ++k) {
    seen.push_back(rule.weights[k] * rule.value(k, rule.visibility, visibility));
  }
  return seen;
}

// The result of one channel; returns the end of its samples. seen: the visibility, `weighted`.
template <class Real>
const Real* apply(int degree, const Real* visibility, const std::vector<Real>& seen, const Real* samples, Real* out) {
  const auto& rule = rule_of<Real>(degree);
  for (std::size_t i = 0; i < rule.light; ++i) out[i] = 0;
  for (std::size_t k = 0; k < rule.weights.size(); ++k) {
    const Real value = seen[k] * *samples++;
    for (std::size_t i = 0; i < rule.light; ++i) out[i] += value * rule.basis[k * rule.visibility + i];
  }
  if (degree == 0) return samples;
  const Real& vc = visibility[coefficient_index(2 * degree, 2 * degree)];
  const Real& vs = visibility[coefficient_index(2 * degree, -2 * degree)];
  out[coefficient_index(degree, degree)] += vc * samples[0] - vs * samples[1];
  out[coefficient_index(degree, -degree)] -= vc * samples[1] + vs * samples[0];
  return samples + 2;
}

auto applies(int channels) {
  return [channels](int degree, const auto* in, auto* out) {
    const auto seen = weighted(degree, in);
    const auto* samples = in + coefficient_count(2 * degree);
    for (int i = 0; i < channels; ++i) samples = apply(degree, in, seen, samples, out + i * coefficient_count(degree));
  };
}

// The products of `applies`, convolved band by band: lobe (degree + 1) and a direction follow the samples.
auto reflects(int channels) {
  return [channels](int degree, const auto* in, auto* out) {
    using std::sqrt;
    using Real = std::remove_cvref_t<decltype(*in)>;
    const std::size_t count = coefficient_count(degree);
    std::vector<Real> transferred(channels * count);
    const std::vector<Real> seen = weighted(degree, in);
    const Real* samples = in + coefficient_count(2 * degree);
    for (int i = 0; i < channels; ++i) samples = apply(degree, in, seen, samples, transferred.data() + i * count);
    const Real *const lobe = samples, *const d = lobe + degree + 1;
    const std::vector<Real> basis = sh::numeric::basis(degree, d[0], d[1], d[2]);
    for (int i = 0; i < channels; ++i) {
      Real value = 0;
      for (int l = 0; l <= degree; ++l) {
        const Real factor = sqrt(Real(4 * pi<Real>() / static_cast<Real>(2 * l + 1))) * lobe[l];
        for (int k = l * l; k < (l + 1) * (l + 1); ++k) value += factor * transferred[i * count + k] * basis[k];
      }
      out[i] = value;
    }
  };
}

// Samples of lights of length 1.
auto prepared_lights(int channels) {
  return [channels](int degree) {
    constexpr int kVectors = 61;
    std::vector<NamedInput> inputs;
    const auto lights = coefficient_inputs(degree, kVectors, 702);
    for (std::size_t i = 0; i < lights.size(); ++i) {
      NamedInput samples{"prepared, " + lights[i].name, {}};
      for (int channel = 0; channel < channels; ++channel) {
        const std::vector<double>& light = lights[(i + channel) % lights.size()].values;
        std::vector<double> of_channel(rule_of<double>(degree).weights.size() + 2);
        of_channel.resize(prepare(degree, light.data(), of_channel.data()) - of_channel.data());
        samples.values.insert(samples.values.end(), of_channel.begin(), of_channel.end());
      }
      inputs.push_back(std::move(samples));
    }
    return inputs;
  };
}

}  // namespace

std::vector<ExactFamily> exact_transfer() {
  return {{"transfer_prepare", [](int degree, const auto* in, auto* out) { prepare(degree, in, out); }},
          {"transfer_apply", applies(1), prepared_lights(1)},
          {"transfer_apply_rgb", applies(3), prepared_lights(3)},
          {"transfer_glossy", reflects(1), prepared_lights(1)},
          {"transfer_glossy_rgb", reflects(3), prepared_lights(3)}};
}

}  // namespace sh::numeric
