#include "prt/material/microfacet.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "numeric/oracle/quadrature.hpp"
#include "prt/chunks.hpp"

namespace sh::prt {

namespace {

constexpr double kCoat = 0.04;  // F0 of a dielectric of index 1.5
constexpr int kPolar = 40;      // nodes of the quadratures
constexpr int kAround = 56;     // half a turn: the other half is its mirror image

struct Node {
  Eigen::Vector3d direction;
  double weight;  // the sum of all is 1
};

// Nodes with z = cosine(u), where u and the azimuth are equally distributed.
template <class Cosine>
std::vector<Node> nodes_of(const Cosine& cosine) {
  const numeric::GaussLegendreRule<double> rule = numeric::gauss_legendre<double>(kPolar);
  std::vector<Node> nodes;
  for (int i = 0; i < kPolar; ++i) {
    const double z = cosine(0.5 + 0.5 * rule.nodes[static_cast<std::size_t>(i)]);
    const double r = std::sqrt(1.0 - z * z);
    for (int j = 0; j < kAround; ++j) {
      const double azimuth = std::numbers::pi * (j + 0.5) / kAround;
      nodes.push_back({{r * std::cos(azimuth), r * std::sin(azimuth), z},
                       0.5 * rule.weights[static_cast<std::size_t>(i)] / kAround});
    }
  }
  return nodes;
}

// Half vectors distributed as D(h) (n.h) [WalterMarschnerLiTorrance07, equation 35].
std::vector<Node> half_vectors(double alpha) {
  return nodes_of([square = alpha * alpha](double u) { return std::sqrt((1.0 - u) / (1.0 + (square - 1.0) * u)); });
}

// (1 - v.h)^5 [Schlick94].
double grazing_part(double cosine) {
  const double x = 1.0 - cosine;
  return x * x * x * x * x;
}

// Shadowing and masking over 4 (n.l)(n.v), times n.l [Heitz14].
double shadowing(double to_light, double to_eye, double alpha) {
  const auto wall = [square = alpha * alpha](double z) { return std::sqrt(z * z * (1.0 - square) + square); };
  return 0.5 * to_light / (to_light * wall(to_eye) + to_eye * wall(to_light));
}

// The light that facets mirror: with F = 1 but for the grazing part in x, and the grazing part alone in y.
template <class Add>
void add_facets(const std::vector<Node>& halves, const Eigen::Vector3d& eye, double alpha, const Add& add) {
  for (const Node& half : halves) {
    const double cosine = eye.dot(half.direction);
    const Eigen::Vector3d light = mirrored_at(half.direction, eye);
    if (cosine <= 0.0 || light.z() <= 0.0) continue;
    const double sent = half.weight * 4.0 * cosine / half.direction.z() * shadowing(light.z(), eye.z(), alpha);
    const double grazing = grazing_part(cosine);
    add(light, sent * (1.0 - grazing), sent * grazing);
  }
}

// The part of constant light that the facets of the coat reflect at each view; linear between views.
using Reflected = std::array<double, kViews>;

double reflected_at(const Reflected& reflected, double cosine) {
  const double place = std::acos(std::min(cosine, 1.0)) * (kViews - 1) / (std::numbers::pi / 2.0);
  const int first = std::min(static_cast<int>(place), kViews - 2);
  const double part = place - first;
  return (1.0 - part) * reflected[static_cast<std::size_t>(first)] +
         part * reflected[static_cast<std::size_t>(first) + 1];
}

// What is left of the light that enters the coat, comes back diffusely from the base of albedo 1, and leaves the coat: in
// all as much as enters [KullaConty17]. The weights of `lights` become those of this light.
void enter_coat(const Reflected& reflected, std::vector<Node>& lights) {
  double sum = 0.0;
  for (Node& light : lights) {
    light.weight *= 1.0 - reflected_at(reflected, light.direction.z());
    sum += light.weight;
  }
  for (Node& light : lights) light.weight /= sum;
}

}  // namespace

MicrofacetSurfaces::MicrofacetSurfaces(float roughness) : roughness_(roughness), facets_(kViews) {
  const double alpha = static_cast<double>(roughness) * static_cast<double>(roughness);
  const std::vector<Node> halves = half_vectors(alpha);
  in_parallel(0, kViews, [&](int view) {
    const auto number = static_cast<std::size_t>(view);
    add_facets(halves, view_direction(view), alpha, [&](const Eigen::Vector3d& light, double ordinary, double grazing) {
      facets_[number].add(light, {ordinary, grazing, 0.0});
      coat_[number] += kCoat * ordinary + grazing;
    });
  });
  std::vector<Node> lights = nodes_of([](double u) { return std::sqrt(u); });  // as the cosine over pi
  enter_coat(coat_, lights);
  for (const Node& light : lights) base_.add(light.direction, {light.weight, 0.0, 0.0});
}

Reflectance MicrofacetSurfaces::reflectance(float metallic) const {
  const auto metal = static_cast<double>(metallic);
  Eigen::Matrix3d parts;  // from the two sums of facets to the colored parts
  parts << metal, 0.0, 0.0, (1.0 - metal) * kCoat, 1.0, 0.0, 0.0, 0.0, 0.0;
  Reflectance made{fmt::format("roughness {:g}, metallic {:g}", roughness_, metallic), false,
                   ReflectanceTable(kReflectanceTableSize)};
  for (int view = 0; view < kViews; ++view) {
    const auto number = static_cast<std::size_t>(view);
    ReflectanceRow row;
    row.add(parts, facets_[number]);
    row.add((1.0 - metal) * (1.0 - coat_[number]) * Eigen::Matrix3d::Identity(), base_);
    row.write(view, made.table);
  }
  return made;
}

Reflectance microfacet_reflectance(float roughness, float metallic) {
  return MicrofacetSurfaces(roughness).reflectance(metallic);
}

}  // namespace sh::prt
