#include "prt/medium/medium_directions.hpp"

#include <cmath>
#include <numbers>

#include "numeric/oracle/quadrature.hpp"

namespace sh::prt {
namespace {

struct Node {
  double u;  // on the edge of a face, -1..1
  double weight;
};

// Gauss-Legendre in the angle on both halves of an edge.
std::vector<Node> edge_nodes(int along) {
  const auto rule = numeric::gauss_legendre<double>(along);
  std::vector<Node> nodes;
  for (const double half : {-1.0, 1.0}) {
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
      const double u = half * std::tan((1.0 + rule.nodes[i]) * std::numbers::pi / 8.0);
      nodes.push_back({u, rule.weights[i] * (1.0 + u * u)});
    }
  }
  return nodes;
}

}  // namespace

std::vector<MediumDirection> medium_directions(int along) {
  const std::vector<Node> nodes = edge_nodes(along);
  std::vector<MediumDirection> directions;
  double sum = 0.0;
  for (int face = 0; face < 6; ++face) {
    for (const auto& [u, weight_u] : nodes) {
      for (const auto& [v, weight_v] : nodes) {
        const double squared = 1.0 + (u * u + v * v);
        Eigen::Vector3d direction;
        direction[face % 3] = face < 3 ? 1.0 : -1.0;
        direction[(face + 1) % 3] = u;
        direction[(face + 2) % 3] = v;
        const double weight = weight_u * weight_v / (squared * std::sqrt(squared));
        directions.push_back({direction.normalized(), weight});
        sum += weight;
      }
    }
  }
  for (MediumDirection& direction : directions) direction.weight /= sum;
  return directions;
}

int directions_along(int directions) {
  int along = 1;
  while (24 * (along + 1) * (along + 1) <= directions) ++along;
  return along;
}

}  // namespace sh::prt
