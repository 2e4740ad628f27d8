// The panels of map.hpp.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "numeric/plot/map.hpp"

namespace sh::numeric::plot {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kJump = 0.2;  // between two steps of a line: it leaves by one edge and comes back by another

// The part of curve(0 .. 1) that lies in the panel, in pieces; ends at the panel's edge to 1e-6 of a step.
std::vector<std::vector<Point>> trace(const Panel& panel, const std::function<Vector3(double)>& curve, int steps) {
  std::vector<std::vector<Point>> pieces;
  const auto edge_between = [&](double inside, double outside) {
    for (int i = 0; i < 20; ++i) {
      const double middle = (inside + outside) / 2;
      (panel.place(curve(middle)) ? inside : outside) = middle;
    }
    return *panel.place(curve(inside));
  };
  bool was_inside = false;
  for (int i = 0; i <= steps; ++i) {
    const double t = double(i) / steps;
    const double before = double(i - 1) / steps;
    const auto here = panel.place(curve(t));
    if (here && !was_inside) {
      pieces.emplace_back();
      if (i > 0) pieces.back().push_back(edge_between(t, before));
    } else if (here && std::hypot(here->x - pieces.back().back().x, here->y - pieces.back().back().y) > kJump) {
      pieces.emplace_back();
    }
    if (here) pieces.back().push_back(*here);
    if (!here && was_inside) pieces.back().push_back(edge_between(before, t));
    was_inside = here.has_value();
  }
  return pieces;
}

}  // namespace

std::optional<Vector3> Panel::direction(const Point& p) const {
  return face != nullptr ? face->direction(p.x, p.y) : mapped_direction(mapping, p.x, p.y);
}

std::optional<Point> Panel::place(const Vector3& direction) const {
  if (face != nullptr && face->forward.dot(direction) <= 0) return std::nullopt;
  const Eigen::Vector2d p = face != nullptr ? face->place(direction) : mapped_place(mapping, direction);
  constexpr double kEdge = 1e-12;
  if (p.minCoeff() < -kEdge || p.maxCoeff() > 1 + kEdge) return std::nullopt;
  return Point{p.x(), p.y()};
}

Box Panel::box(const Box& area) const {
  if (face == nullptr) return area;
  const double side = area.width / mapping_shape(mapping).width;
  return {area.x + face->column * side, area.y + face->row * side, side, side};
}

std::vector<Panel> panels_of(ImageMapping mapping) {
  std::vector<Panel> panels;
  for (const CubeFace& face : cube_faces(mapping)) panels.push_back({mapping, &face});
  return panels.empty() ? std::vector<Panel>{{mapping}} : panels;
}

std::string axis_name(const Vector3& direction) {
  Eigen::Index axis = 0;
  direction.cwiseAbs().maxCoeff(&axis);
  return {direction[axis] < 0 ? '-' : '+', "xyz"[axis]};
}

std::vector<std::vector<Point>> graticule(const Panel& panel, int degrees) {
  constexpr int kSteps = 180;
  std::vector<std::vector<Point>> lines;
  const auto add = [&](const std::function<Vector3(double)>& curve) {
    for (auto& piece : trace(panel, curve, kSteps)) {
      if (piece.size() > 1) lines.push_back(std::move(piece));
    }
  };
  // Just inside +-180 degrees, so that a circle does not jump from one edge of the lat-long picture to the other.
  constexpr double kTurn = 2 * kPi * (1 - 1e-12);
  for (int theta = degrees; theta < 180; theta += degrees) {
    add([=](double t) { return direction(theta * kPi / 180, kTurn * (t - 0.5)); });
  }
  // Meridians leave out the poles, where their azimuth is lost.
  constexpr double kPole = 1e-9;
  for (int phi = degrees - 180; phi < 180; phi += degrees) {
    add([=](double t) { return direction(std::clamp(t, kPole, 1 - kPole) * kPi, phi * kPi / 180); });
  }
  if (panel.place({-1, 0, 1e-3})) {
    add([=](double t) { return direction(std::clamp(t, kPole, 1 - kPole) * kPi, kTurn / 2); });
  }
  return lines;
}

}  // namespace sh::numeric::plot
