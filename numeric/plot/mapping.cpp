#include "numeric/plot/mapping.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sh::numeric::plot {
namespace {

constexpr double kPi = std::numbers::pi;

Panel lat_long_panel() {
  Panel panel;
  panel.label = "+x";
  panel.direction = [](const Point& p) { return direction(kPi * p.y, kPi * (1 - 2 * p.x)); };
  panel.place = [](const Vector3& s) {
    const double theta = std::atan2(std::hypot(s[0], s[1]), s[2]);
    return std::optional<Point>({(1 - std::atan2(s[1], s[0]) / kPi) / 2, theta / kPi});
  };
  return panel;
}

Panel cube_face(const char* label, int column, int row, const Vector3& centre, const Vector3& right,
                const Vector3& down) {
  Panel panel{label, column, row, {}, {}};
  panel.direction = [=](const Point& p) { return unit(centre + (2 * p.x - 1) * right + (2 * p.y - 1) * down); };
  panel.place = [=](const Vector3& s) -> std::optional<Point> {
    const double depth = dot(s, centre);
    if (depth <= 0) return std::nullopt;
    const double u = dot(s, right) / depth;
    const double v = dot(s, down) / depth;
    constexpr double kEdge = 1 + 1e-12;
    if (std::abs(u) > kEdge || std::abs(v) > kEdge) return std::nullopt;
    return Point{(u + 1) / 2, (v + 1) / 2};
  };
  return panel;
}

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
    }
    if (here) pieces.back().push_back(*here);
    if (!here && was_inside) pieces.back().push_back(edge_between(before, t));
    was_inside = here.has_value();
  }
  return pieces;
}

}  // namespace

std::vector<Panel> panels_of(Projection projection) {
  if (projection == Projection::kLatLong) return {lat_long_panel()};
  const Vector3 x{1, 0, 0};
  const Vector3 y{0, 1, 0};
  const Vector3 z{0, 0, 1};
  return {cube_face("+z", 1, 0, z, -1 * y, x),      cube_face("+y", 0, 1, y, x, -1 * z),
          cube_face("+x", 1, 1, x, -1 * y, -1 * z), cube_face("-y", 2, 1, -1 * y, -1 * x, -1 * z),
          cube_face("-x", 3, 1, -1 * x, y, -1 * z), cube_face("-z", 1, 2, -1 * z, -1 * y, -1 * x)};
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
