#include "prt/mesh/atlas.hpp"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "numeric/output/progress.hpp"
#include "prt/mesh/corners.hpp"
#include "prt/mesh/mesh.hpp"
#include "prt/mesh/weld.hpp"

namespace sh::prt {

namespace {

using Point = Eigen::Vector2d;  // in texels, from the upper left corner of the atlas

constexpr double kNoArea = 1e-9;    // of a face in the atlas, in texels
constexpr double kWithin = 1e-3;    // in texels: how far inside of a face a center lies that the face covers
constexpr double kFromEdge = 1e-2;  // in texels: no sample lies nearer to an edge, where another surface may begin

double cross(const Point& a, const Point& b) { return a.x() * b.y() - a.y() * b.x(); }

// A face in the atlas, counterclockwise or not.
struct Flat {
  std::array<Point, 3> corners;
  double area = 0.0;  // twice, signed

  // The parts of the corners at a point of the plane.
  [[nodiscard]] Eigen::Vector3d parts(const Point& at) const {
    Eigen::Vector3d out;
    for (int k = 0; k < 3; ++k) {
      const Point& a = corners.at((k + 1) % 3);
      out[k] = cross(corners.at((k + 2) % 3) - a, at - a) / area;
    }
    return out;
  }
  // How far a point lies inside of the edges; negative outside.
  [[nodiscard]] double depth(const Point& at) const {
    const Eigen::Vector3d part = parts(at);
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k) {
      const double edge = (corners.at((k + 2) % 3) - corners.at((k + 1) % 3)).norm();
      least = std::min(least, part[k] * std::abs(area) / edge);
    }
    return least;
  }
};

Flat flat_of(const Mesh& mesh, const Face& face, int size) {
  Flat flat;
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector2d at = mesh.chart[face[k]].cast<double>();
    flat.corners[k] = {at.x() * size, (1.0 - at.y()) * size};
  }
  flat.area = cross(flat.corners[1] - flat.corners[0], flat.corners[2] - flat.corners[0]);
  return flat;
}

// The part of a face within a pixel: its area and its centroid [Sutherland and Hodgman 1974].
struct Covered {
  double area = 0.0;
  Point middle = Point::Zero();
};
Covered covered_of(const Flat& flat, int column, int row) {
  std::vector<Point> polygon(flat.corners.begin(), flat.corners.end());
  for (int side = 0; side < 4; ++side) {
    const int axis = side / 2;
    const double sign = side % 2 == 0 ? 1.0 : -1.0;
    const double limit = (axis == 0 ? column : row) + side % 2;
    const auto inside = [&](const Point& p) { return sign * (p[axis] - limit); };
    std::vector<Point> cut;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Point& a = polygon[i];
      const Point& b = polygon[(i + 1) % polygon.size()];
      const double from = inside(a);
      const double to = inside(b);
      if (from >= 0.0) cut.push_back(a);
      if ((from >= 0.0) != (to >= 0.0)) cut.emplace_back(a + (b - a) * (from / (from - to)));
    }
    polygon = std::move(cut);
  }
  Covered covered;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const double area = 0.5 * std::abs(cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]));
    covered.area += area;
    covered.middle += area * (polygon[0] + polygon[i - 1] + polygon[i]) / 3.0;
  }
  if (covered.area > 0.0) covered.middle /= covered.area;
  return covered;
}

// What a pixel shows: the face that covers its center, or else most of it.
struct Shown {
  std::uint32_t face = kNoVertex;
  bool is_center = false;
  double depth = 0.0;  // of the center inside of the face
  double area = 0.0;
  Point at = Point::Zero();
};

class Raster {
 public:
  Raster(const Mesh& mesh, int size, const std::string& name)
      : mesh_(mesh), size_(size), name_(name), pixels_(std::size_t(size) * std::size_t(size)) {}

  void add(std::uint32_t face) {
    require_within(mesh_.faces[face]);
    const Flat flat = flat_of(mesh_, mesh_.faces[face], size_);
    if (!(std::abs(flat.area) > kNoArea)) return;
    Eigen::AlignedBox2d box;
    for (const Point& corner : flat.corners) box.extend(corner);
    const auto within = [this](double at) { return std::clamp(static_cast<int>(std::floor(at)), 0, size_ - 1); };
    for (int row = within(box.min().y()); row <= within(box.max().y()); ++row) {
      for (int column = within(box.min().x()); column <= within(box.max().x()); ++column) {
        show(face, flat, column, row);
      }
    }
  }
  [[nodiscard]] const Shown& at(std::size_t pixel) const { return pixels_[pixel]; }
  [[nodiscard]] std::size_t size() const { return pixels_.size(); }

 private:
  void require_within(const Face& face) const {
    constexpr float kRounding = 1e-5F;
    for (const std::uint32_t v : face) {
      const Eigen::Vector2f& at = mesh_.chart[v];
      if (!at.allFinite()) {
        throw std::runtime_error(fmt::format(
            "{}: texels need texture coordinates, and a face has none; expected a set for every face", name_));
      }
      if (at.minCoeff() < -kRounding || at.maxCoeff() > 1.0F + kRounding) {
        throw std::runtime_error(fmt::format(
            "{}: texels need texture coordinates from 0 to 1, got {:.4g} {:.4g}; expected a second set that "
            "covers each place of the surface once",
            name_, at.x(), at.y()));
      }
    }
  }

  void show(std::uint32_t face, const Flat& flat, int column, int row) {
    Shown& shown = pixels_[std::size_t(row) * std::size_t(size_) + std::size_t(column)];
    const Point center(column + 0.5, row + 0.5);
    const double depth = flat.depth(center);
    if (depth >= 0.0) {
      if (shown.is_center && std::min(depth, shown.depth) > kWithin) refuse_overlap(face, shown.face, center);
      if (!shown.is_center || depth > shown.depth) shown = {face, true, depth, 0.0, center};
    } else if (!shown.is_center) {
      const Covered covered = covered_of(flat, column, row);
      if (covered.area > shown.area) shown = {face, false, depth, covered.area, covered.middle};
    }
  }

  [[noreturn]] void refuse_overlap(std::uint32_t a, std::uint32_t b, const Point& at) const {
    throw std::runtime_error(fmt::format(
        "{}: its texture coordinates overlap: faces {} and {} cover {:.4g} {:.4g}; expected a second set that "
        "covers each place of the surface once",
        name_, std::min(a, b), std::max(a, b), at.x() / size_, 1.0 - at.y() / size_));
  }

  const Mesh& mesh_;
  int size_;
  const std::string& name_;
  std::vector<Shown> pixels_;
};

// The parts of the corners at the sample of a pixel, moved into what the face covers of it as far as kFromEdge asks.
Eigen::Vector3f parts_of(const Flat& flat, const Shown& shown, std::uint32_t pixel, int size) {
  const Covered covered = covered_of(flat, static_cast<int>(pixel) % size, static_cast<int>(pixel) / size);
  const Point inside = covered.area > 0.0 ? covered.middle : shown.at;
  const double depth = flat.depth(shown.at);
  const double deepest = flat.depth(inside);
  const double part = deepest > depth ? std::clamp((kFromEdge - depth) / (deepest - depth), 0.0, 1.0) : 0.0;
  const Eigen::Vector3d parts = flat.parts(shown.at + part * (inside - shown.at)).cwiseMax(0.0);
  return (parts / parts.sum()).cast<float>();
}

// Half the distance on the surface between texels beside each other.
float reach_of(const Mesh& mesh, const Face& face, const Flat& flat) {
  const Eigen::Vector3d a = mesh.positions[face[0]].cast<double>();
  const Eigen::Vector3d b = mesh.positions[face[1]].cast<double>();
  const Eigen::Vector3d c = mesh.positions[face[2]].cast<double>();
  return static_cast<float>(0.5 * std::sqrt((b - a).cross(c - a).norm() / std::abs(flat.area)));
}

// Between the corners of the face.
void add_texel(Mesh& mesh, const Face& face, const Eigen::Vector3f& part) {
  const auto between = [&](const auto& values) {
    return (part[0] * values[face[0]] + part[1] * values[face[1]] + part[2] * values[face[2]]).eval();
  };
  const Eigen::Vector3f normal = between(mesh.normals);
  const Eigen::Vector3f flat = face_normal(mesh.positions, face);
  mesh.positions.push_back(between(mesh.positions));
  mesh.normals.push_back(normal.norm() > 0.0F ? normal.normalized() : flat);
  mesh.geometric_normals.push_back(flat.dot(normal) < 0.0F ? (-flat).eval() : flat);
  mesh.albedo.emplace_back(between(mesh.albedo).cwiseMin(1.0F));
  if (!mesh.texture.empty()) mesh.texture.push_back(between(mesh.texture));
  repeat_finish(mesh, face[0]);
  if (!mesh.emission.empty()) mesh.emission.back() = between(mesh.emission);
  if (!mesh.tint.empty()) mesh.tint.back() = between(mesh.tint).cwiseMin(1.0F);
}

}  // namespace

Eigen::Vector2f center_of_pixel(const Atlases::Head& atlas, std::uint32_t pixel) {
  const auto width = static_cast<std::uint32_t>(atlas.width);
  const std::uint32_t row = pixel / width;
  return {(static_cast<float>(pixel % width) + 0.5F) / static_cast<float>(atlas.width),
          1.0F - (static_cast<float>(row) + 0.5F) / static_cast<float>(atlas.height)};
}

std::vector<std::uint32_t> add_atlas(Mesh& mesh, std::size_t faces, int size, const std::string& name) {
  if (mesh.chart.empty()) {
    throw std::runtime_error(
        fmt::format("{}: texels need texture coordinates, and the mesh has none; expected a set for every face", name));
  }
  Raster raster(mesh, size, name);
  for (std::uint32_t f = 0; f < faces; ++f) {
    output::check_interrupt();
    raster.add(f);
  }
  mesh.atlas.assign(mesh.positions.size(), 0);
  for (std::size_t f = 0; f < faces; ++f) {
    for (const std::uint32_t v : mesh.faces[f]) mesh.atlas[v] = 1;
  }
  Atlases::Head head{size, size, static_cast<std::uint32_t>(mesh.positions.size()), 0};
  std::vector<std::uint32_t> faces_of_texels;
  for (std::uint32_t pixel = 0; pixel < raster.size(); ++pixel) {
    const Shown& shown = raster.at(pixel);
    if (shown.face == kNoVertex) continue;
    const Face face = mesh.faces[shown.face];
    const Flat flat = flat_of(mesh, face, size);
    add_texel(mesh, face, parts_of(flat, shown, pixel, size));
    mesh.chart.push_back(center_of_pixel(head, pixel));
    mesh.atlas.push_back(0);
    mesh.atlases.pixels.push_back(pixel);
    mesh.atlases.reach.push_back(reach_of(mesh, face, flat));
    faces_of_texels.push_back(shown.face);
    ++head.count;
  }
  if (head.count == 0) {
    throw std::runtime_error(
        fmt::format("{}: its texture coordinates cover no texel of {} x {}; expected coordinates that spread over 0..1",
                    name, size, size));
  }
  mesh.atlases.heads.push_back(head);
  if (!mesh.halving.empty()) mesh.halving.ends.resize(mesh.positions.size(), {kNoVertex, kNoVertex});
  return faces_of_texels;
}

std::vector<std::array<std::uint32_t, 2>> neighboring_texels(const Mesh& mesh) {
  constexpr float kFarthest = 4.0F;  // times the sum of both reaches
  const Atlases& atlases = mesh.atlases;
  std::vector<std::array<std::uint32_t, 2>> pairs;
  for (std::size_t a = 0; a < atlases.heads.size(); ++a) {
    const Atlases::Head& head = atlases.heads[a];
    const std::size_t entry = atlases.entry(a);
    const auto* first = atlases.pixels.data() + entry;
    const auto join = [&](std::uint32_t i, std::uint32_t pixel) {
      const auto* found = std::lower_bound(first, first + head.count, pixel);
      if (found == first + head.count || *found != pixel) return;
      const auto j = static_cast<std::uint32_t>(found - first);
      const float reach = atlases.reach[entry + i] + atlases.reach[entry + j];
      const float distance = (mesh.positions[head.first + i] - mesh.positions[head.first + j]).norm();
      if (distance <= kFarthest * reach) pairs.push_back({head.first + i, head.first + j});
    };
    const auto width = static_cast<std::uint32_t>(head.width);
    for (std::uint32_t i = 0; i < head.count; ++i) {
      if ((first[i] + 1) % width != 0) join(i, first[i] + 1);
      join(i, first[i] + width);
    }
  }
  return pairs;
}

}  // namespace sh::prt
