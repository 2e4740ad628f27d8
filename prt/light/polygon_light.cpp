// Exact projection of a flat emitting polygon. Y_lm is an eigenfunction of the Laplacian on the sphere, so that its
// integral over a region equals an integral over the border,
//   integral of Y_lm = 1 / (l(l+1)) * sum over edges of the integral of grad Y_lm . N along the edge,   l > 0,
// where N is the unit normal of the edge's great circle, pointing inwards. On an edge the integrand is a trigonometric
// polynomial of degree l in the arc, which Gauss-Legendre nodes integrate to rounding. The result equals that of the
// recurrences over zonal lobes in [WangRamamoorthi18], but needs no recurrences. Band 0 is the solid angle by
// [VanOosteromStrackee83] eq. 8.
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "generated/cpp/basis_gradient.hpp"
#include "numeric/oracle/quadrature.hpp"
#include "prt/basis.hpp"
#include "prt/light/light_coefficients.hpp"
#include "prt/light/light_shapes.hpp"

namespace sh::prt {
namespace {

using Corners = std::vector<Eigen::Vector3d>;
constexpr double kFlat = 1e-5;     // of the extent
constexpr double kEdgeOn = 1e-6;   // height over the plane, of the largest distance
constexpr double kNoArea = 1e-10;  // of the extent squared
constexpr int kArcNodes = 32;      // integrate cos(10 s) over half a circle to rounding

const Eigen::Vector3d& after(const Corners& corners, std::size_t i) { return corners[(i + 1) % corners.size()]; }

double extent(const Corners& corners) {
  double largest = 0.0;
  for (const Eigen::Vector3d& corner : corners) largest = std::max(largest, (corner - corners.front()).norm());
  return largest;
}

/// Twice the area times the normal; the corners run counterclockwise as seen from the front.
Eigen::Vector3d area_vector(const Corners& corners) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    sum += (corners[i] - corners.front()).cross(after(corners, i) - corners.front());
  }
  return sum;
}

/// Coordinates in a polygon's plane.
struct Plane {
  Eigen::Vector3d x;
  Eigen::Vector3d y;
  explicit Plane(const Eigen::Vector3d& normal) : x(normal.unitOrthogonal()), y(normal.cross(x)) {}
  [[nodiscard]] Eigen::Vector2d operator()(const Eigen::Vector3d& p) const { return {p.dot(x), p.dot(y)}; }
};

double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

bool cross_each_other(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                      const Eigen::Vector2d& d) {
  return turn(a, b, c) * turn(a, b, d) < 0.0 && turn(c, d, a) * turn(c, d, b) < 0.0;
}

bool edges_cross(const Corners& corners, const Plane& plane) {
  std::vector<Eigen::Vector2d> flat;
  for (const Eigen::Vector3d& corner : corners) flat.push_back(plane(corner - corners.front()));
  const std::size_t n = flat.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 2; j < n; ++j) {
      if ((j + 1) % n != i && cross_each_other(flat[i], flat[(i + 1) % n], flat[j], flat[(j + 1) % n])) return true;
    }
  }
  return false;
}

/// Adds the border integral of grad Y_lm . N over the arc from a to b, N = a x b / |a x b|.
void add_edge(const Eigen::Vector3d& a, const Eigen::Vector3d& b, int degree, std::vector<double>& sum) {
  static const auto kRule = numeric::gauss_legendre<double>(kArcNodes);
  const Eigen::Vector3d across = a.cross(b - a);
  if (!(across.norm() > 0.0)) {
    return;  // a corner given twice
  }
  const Eigen::Vector3d normal = across.normalized();
  const Eigen::Vector3d start = a.normalized();
  const Eigen::Vector3d ahead = normal.cross(start);
  const double length = std::atan2(across.norm(), a.dot(b));
  BasisValues y;
  std::array<BasisValues, 3> gradient;
  const auto along = [&](int axis) { return normal[axis] * as_array(gradient[axis].data(), sum.size()); };
  for (std::size_t k = 0; k < kRule.nodes.size(); ++k) {
    const double s = 0.5 * length * (1.0 + kRule.nodes[k]);
    const double weight = 0.5 * length * kRule.weights[k];
    const Eigen::Vector3d d = std::cos(s) * start + std::sin(s) * ahead;
    at_degree(degree, [&](auto known) {  // of r^l Y_lm, whose derivative along r does not count
      sh::basis_gradient<known()>(d.x(), d.y(), d.z(), y.data(), gradient[0].data(), gradient[1].data(),
                                  gradient[2].data());
    });
    as_array(sum) += weight * (along(0) + along(1) + along(2));
  }
}

/// The signed solid angle: positive if a, b, c run counterclockwise as seen from outside the sphere.
double triangle_solid_angle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const double la = a.norm();
  const double lb = b.norm();
  const double lc = c.norm();
  const double volume = a.dot((b - a).cross(c - a));
  return 2.0 * std::atan2(volume, la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

}  // namespace

std::string polygon_flaw(const Corners& corners) {
  if (corners.size() < 3 || corners.size() > kMaxCorners) return "3 to 1000 corners";
  const double size = extent(corners);
  const Eigen::Vector3d area = area_vector(corners);
  if (!(area.norm() > kNoArea * size * size)) return "corners that enclose an area";
  const Eigen::Vector3d normal = area.normalized();
  double farthest = 0.0;
  for (const Eigen::Vector3d& corner : corners) {
    if (!(std::abs((corner - corners.front()).dot(normal)) <= kFlat * size)) return "corners in one plane";
    farthest = std::max(farthest, corner.norm());
  }
  if (edges_cross(corners, Plane(normal))) return "edges that do not cross each other";
  const double height = -corners.front().dot(normal);  // of the point over the front
  if (!(std::abs(height) > kEdgeOn * farthest)) {
    return "a polygon whose plane does not go through the point it is seen from";
  }
  return height > 0.0 ? "" : "corners counterclockwise as seen from `from` (this is the back)";
}

double polygon_solid_angle(const Corners& corners) {
  double sum = 0.0;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    sum -= triangle_solid_angle(corners.front(), corners[i], corners[i + 1]);
  }
  return sum;
}

std::vector<double> project_polygon(const Corners& corners, int degree) {
  std::vector<double> sum(coefficient_count(degree), 0.0);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    add_edge(after(corners, i), corners[i], degree, sum);  // backwards: counterclockwise as seen from outside
  }
  for (int l = 1; l <= degree; ++l) band(sum.data(), l) /= l * (l + 1);
  sum[0] = polygon_solid_angle(corners) / std::sqrt(4.0 * std::numbers::pi);
  return sum;
}

bool polygon_covers(const Corners& corners, const Eigen::Vector3d& direction) {
  const Eigen::Vector3d normal = area_vector(corners).normalized();
  const double approach = direction.dot(normal);
  if (!(approach < 0.0)) return false;
  const Plane plane(normal);
  const Eigen::Vector2d p = plane(corners.front().dot(normal) / approach * direction);
  bool inside = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {  // even-odd rule, a ray along the plane's x
    const Eigen::Vector2d a = plane(corners[i]);
    const Eigen::Vector2d b = plane(after(corners, i));
    if ((a.y() > p.y()) != (b.y() > p.y()) && p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) {
      inside = !inside;
    }
  }
  return inside;
}

}  // namespace sh::prt
