#include "prt/image/environment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "numeric/oracle/quadrature.hpp"
#include "prt/image/bilinear.hpp"

namespace sh::prt {
namespace {

constexpr double kPi = std::numbers::pi;

/// The range of pixels that may be blended; columns may wrap around.
struct Frame {
  int left, right, top, bottom;
  bool wraps = false;
};

/// `place` in continuous pixel coordinates, column and row.
Eigen::Vector3f blend(const Image& image, const Eigen::Vector2d& place, const Frame& frame) {
  const auto column_of = [&](int column) {
    return frame.wraps ? (column + image.width) % image.width : std::clamp(column, frame.left, frame.right);
  };
  return bilinear(place, [&](int column, int row) -> const Eigen::Vector3f& {
    return image.at(column_of(column), std::clamp(row, frame.top, frame.bottom));
  });
}

constexpr int kMostNodes = 48;  // along an edge, for a picture of one pixel
using Rule = numeric::GaussLegendreRule<double>;

/// The number of nodes grows as an edge has fewer pixels; the basis has degree 10 at most.
const Rule& rule_for(int pixels, int more = 0) {
  static const std::vector<Rule> kRules = [] {
    std::vector<Rule> rules;
    for (int n = 1; n <= kMostNodes; ++n) rules.push_back(numeric::gauss_legendre<double>(n));
    return rules;
  }();
  const int n = pixels >= 256 ? 3 + more : std::min(4 + more + 96 / pixels, kMostNodes);
  return kRules[n - 1];
}

struct Interval {
  double low;
  double high;
  [[nodiscard]] double at(double node) const { return 0.5 * (low + high) + 0.5 * (high - low) * node; }
  [[nodiscard]] double half() const { return 0.5 * (high - low); }
};

/// The part of an interval on one side of 0, mirrored to the positive side; empty where low >= high.
Interval side_of(const Interval& range, double sign) {
  return sign > 0.0 ? Interval{std::max(range.low, 0.0), range.high} : Interval{std::max(-range.high, 0.0), -range.low};
}

/// The place (u, v) of a disc, u right, v up, w = sqrt(1 - u^2 - v^2), with its area on the disc.
PixelNode disc_node(ImageMapping mapping, double u, double v, double w, double area) {
  const double r = std::hypot(u, v);
  const double stretch = mapping == ImageMapping::kMirrorBall ? 4.0 : kPi * (r > 1e-9 ? std::sin(kPi * r) / r : kPi);
  return {disc_direction(mapping, u, v, w), stretch * area};
}

/// The pixel a x b, cut by the unit circle, 0 <= a, b, in the angles a = sin t, b = cos t sin s. These are the normals
/// of a ball; in them the picture of a mirror ball is smooth up to the rim.
template <class Emit>
void cut_pixel(const Interval& a, const Interval& b, const Rule& rule, const Emit& emit) {
  if (!(a.low < a.high && b.low < b.high && a.low * a.low + b.low * b.low < 1.0)) return;
  const double end = std::min(a.high, std::sqrt(1.0 - b.low * b.low));
  const double whole = std::clamp(std::sqrt(std::max(0.0, 1.0 - b.high * b.high)), a.low, end);
  for (const bool cut : {false, true}) {  // up to `whole` the circle is beyond b.high
    const Interval t{std::asin(cut ? whole : a.low), std::asin(cut ? end : whole)};
    for (std::size_t i = 0; t.low < t.high && i < rule.nodes.size(); ++i) {
      const double c = std::cos(t.at(rule.nodes[i]));
      const Interval s{std::asin(std::min(1.0, b.low / c)), cut ? 0.5 * kPi : std::asin(std::min(1.0, b.high / c))};
      for (std::size_t j = 0; j < rule.nodes.size(); ++j) {
        const double w = c * std::cos(s.at(rule.nodes[j]));
        emit(std::sin(t.at(rule.nodes[i])), c * std::sin(s.at(rule.nodes[j])), w,
             t.half() * rule.weights[i] * s.half() * rule.weights[j] * c * w);
      }
    }
  }
}

void disc_nodes(ImageMapping mapping, int size, int column, int row, std::vector<PixelNode>& nodes) {
  const Interval u{2.0 * column / size - 1.0, 2.0 * (column + 1) / size - 1.0};
  const Interval v{1.0 - 2.0 * (row + 1) / size, 1.0 - 2.0 * row / size};
  const double outer = std::hypot(std::max(-u.low, u.high), std::max(-v.low, v.high));
  const bool near_rim = outer > 1.0 - 4.0 / size;  // where the limits of s in cut_pixel bend
  const Rule& rule = rule_for(size, near_rim ? 12 : 0);
  for (const double u_sign : {1.0, -1.0}) {
    for (const double v_sign : {1.0, -1.0}) {
      cut_pixel(side_of(u, u_sign), side_of(v, v_sign), rule, [&](double a, double b, double w, double area) {
        nodes.push_back(disc_node(mapping, u_sign * a, v_sign * b, w, area));
      });
    }
  }
}

void texel_nodes(const CubeFace& face, int size, int column, int row, std::vector<PixelNode>& nodes) {
  const Rule& rule = rule_for(size);
  const Interval s{2.0 * column / size - 1.0, 2.0 * (column + 1) / size - 1.0};
  const Interval t{1.0 - 2.0 * (row + 1) / size, 1.0 - 2.0 * row / size};
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    for (std::size_t j = 0; j < rule.nodes.size(); ++j) {
      const Eigen::Vector3d p = face.forward + s.at(rule.nodes[i]) * face.right() + t.at(rule.nodes[j]) * face.up;
      const double length = p.norm();
      nodes.push_back(
          {p / length, s.half() * rule.weights[i] * t.half() * rule.weights[j] / (length * length * length)});
    }
  }
}

}  // namespace

void require_shape(const std::string& file, const Image& image, ImageMapping mapping) {
  const MappingShape shape = mapping_shape(mapping);
  if (image.width % shape.width == 0 && image.width / shape.width * shape.height == image.height) return;
  const std::string size = fmt::format("{}: the picture is {} x {} pixels", file, image.width, image.height);
  throw std::runtime_error(mapping == ImageMapping::kLatLong
                               ? size + "; a lat-long environment is twice as wide as high"
                               : fmt::format("{}; the mapping {} needs {}:{}, in whole faces", size, name_of(mapping),
                                             shape.width, shape.height));
}

Eigen::Vector3f lookup(const Image& image, ImageMapping mapping, const Eigen::Vector3d& direction) {
  if (!cube_faces(mapping).empty()) {
    const CubeFace& face = face_towards(mapping, direction);
    const int size = face_size(mapping, image.width);
    const Eigen::Vector2d place = size * (Eigen::Vector2d(face.column, face.row) + face.place(direction));
    return blend(image, place,
                 {face.column * size, (face.column + 1) * size - 1, face.row * size, (face.row + 1) * size - 1});
  }
  // On discs the pixel's center must not lie beyond the rim.
  const Eigen::Vector2d place = mapped_place(mapping, direction, 1.0 / image.width);
  const Eigen::Vector2d at(place.x() * image.width, place.y() * image.height);
  if (is_disc(mapping)) {
    return image.at(std::clamp(static_cast<int>(at.x()), 0, image.width - 1),
                    std::clamp(static_cast<int>(at.y()), 0, image.height - 1));
  }
  return blend(image, at, {0, image.width - 1, 0, image.height - 1, true});
}

void pixel_nodes(ImageMapping mapping, int width, int column, int row, std::vector<PixelNode>& nodes) {
  nodes.clear();
  const auto& faces = cube_faces(mapping);
  if (faces.empty()) return disc_nodes(mapping, width, column, row, nodes);
  const int size = face_size(mapping, width);
  for (const CubeFace& face : faces) {
    if (face.column == column / size && face.row == row / size) {
      return texel_nodes(face, size, column % size, row % size, nodes);
    }
  }
}

}  // namespace sh::prt
