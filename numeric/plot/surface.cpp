// The surfaces of lobes.hpp.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "numeric/plot/lobes.hpp"

namespace sh::numeric::plot {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr Color kAxis{96, 96, 96};

// [SutherlandHodgman74] against f = 0; the cut ends at the origin, where r = |f| = 0.
class LobeBuilder {
 public:
  LobeBuilder(Surface& surface, const SphereFunction& f, double radius, int rings)
      : surface_(surface), rings_(rings), columns_(2 * rings), first_(static_cast<int>(surface.vertices.size())) {
    for (int i = 0; i <= rings_; ++i) {
      for (int j = 0; j < columns_; ++j) {
        const Vector3 s = direction(kPi * i / rings_, 2 * kPi * j / columns_);
        const double value = f.value(s)[0];
        values_.push_back(value);
        surface_.vertices.push_back({std::abs(value) * radius * s});
      }
    }
  }

  void build() {
    const std::size_t first_facet = surface_.facets.size();
    for (int i = 0; i < rings_; ++i) {
      for (int j = 0; j < columns_; ++j) {
        const int next = (j + 1) % columns_;
        const std::array<int, 4> cell{index(i, j), index(i + 1, j), index(i + 1, next), index(i, next)};
        add_part(cell, 1, positive_);
        add_part(cell, -1, negative_);
      }
    }
    set_normals(first_facet);
  }

 private:
  [[nodiscard]] int index(int ring, int column) const { return ring * columns_ + column; }

  void add_part(const std::array<int, 4>& cell, double sign, const LinearColor& paint) {
    Facet facet{{}, 0, paint};
    const auto value = [&](std::size_t k) { return sign * values_[cell[k % 4]]; };
    bool inside = false;
    for (std::size_t k = 0; k < 4; ++k) {
      const bool cut = value(k) * value(k + 1) < 0;
      if (value(k) >= 0) add_corner(facet, first_ + cell[k]);
      if (cut) add_corner(facet, origin());
      inside = inside || value(k) > 0;
    }
    if (inside && facet.count >= 3) surface_.facets.push_back(facet);
  }

  // The saddle of four alternating signs would have six corners: two of them are the origin, and one is enough.
  static void add_corner(Facet& facet, int vertex) {
    const auto end = facet.corners.begin() + facet.count;
    if (facet.count < 5 && std::find(facet.corners.begin(), end, vertex) == end) {
      facet.corners[facet.count++] = vertex;
    }
  }

  int origin() {
    if (origin_ < 0) {
      origin_ = static_cast<int>(surface_.vertices.size());
      surface_.vertices.push_back({});
    }
    return origin_;
  }

  // The mean of the normals around a vertex, weighed by area; the vertices of a pole share theirs.
  void set_normals(std::size_t first_facet) {
    for (std::size_t i = first_facet; i < surface_.facets.size(); ++i) {
      const auto& facet = surface_.facets[i];
      const auto normal = area_normal(facet);
      for (int k = 0; k < facet.count; ++k) vertex(facet, k).normal += normal;
    }
    share_normals(0);
    share_normals(rings_);
    for (auto v = surface_.vertices.begin() + first_; v != surface_.vertices.end(); ++v) v->normal.normalize();
  }

  void share_normals(int ring) {
    Vector3 sum = Vector3::Zero();
    for (int j = 0; j < columns_; ++j) sum += at(ring, j).normal;
    for (int j = 0; j < columns_; ++j) at(ring, j).normal = sum;
  }

  [[nodiscard]] Vector3 area_normal(const Facet& facet) {
    Vector3 sum = Vector3::Zero();
    for (int k = 1; k + 1 < facet.count; ++k) {
      const Vector3& a = vertex(facet, 0).position;
      sum += (vertex(facet, k).position - a).cross(vertex(facet, k + 1).position - a);
    }
    return sum;
  }

  Vertex& vertex(const Facet& facet, int k) { return vertex_at(facet.corners[k]); }
  Vertex& at(int ring, int column) { return vertex_at(first_ + index(ring, column)); }
  Vertex& vertex_at(int i) { return surface_.vertices[i]; }

  Surface& surface_;
  LinearColor positive_ = decode(kPositive), negative_ = decode(kNegative);
  int rings_, columns_, first_;
  int origin_ = -1;
  std::vector<double> values_;
};

// A surface of revolution about `axis`: radius over place along it, in straight pieces.
struct ProfilePoint {
  double along, radius;
};

void add_revolution(Surface& surface, const Vector3& axis, const std::vector<ProfilePoint>& profile) {
  constexpr int kSides = 10;
  const LinearColor paint = decode(kAxis);
  const Vector3 a{axis[2], axis[0], axis[1]};
  const Vector3 b = axis.cross(a);
  const auto first = static_cast<int>(surface.vertices.size());
  for (const auto& p : profile) {
    for (int k = 0; k < kSides; ++k) {
      const Vector3 out = std::cos(2 * kPi * k / kSides) * a + std::sin(2 * kPi * k / kSides) * b;
      surface.vertices.push_back({p.along * axis + p.radius * out, out});
    }
  }
  for (int i = 0; i + 1 < static_cast<int>(profile.size()); ++i) {
    for (int k = 0; k < kSides; ++k) {
      const int here = first + i * kSides;
      const int next = (k + 1) % kSides;
      surface.facets.push_back({{here + k, here + next, here + kSides + next, here + kSides + k, 0}, 4, paint});
    }
  }
}

}  // namespace

void add_lobes(Surface& surface, const SphereFunction& f, double radius, int rings) {
  LobeBuilder(surface, f, radius, rings).build();
}

void add_axes(Surface& surface, double length) {
  constexpr double kRod = 0.008;
  constexpr int kPieces = 24;  // short ones, so that facets sort by depth
  std::vector<ProfilePoint> profile;
  for (int i = 0; i <= kPieces; ++i) profile.push_back({length * (1.85 * i / kPieces - 0.85), kRod});
  profile.back().along = length - 0.1;
  profile.push_back({length - 0.1, 4 * kRod});
  profile.push_back({length, 0});
  add_revolution(surface, {1, 0, 0}, profile);
  add_revolution(surface, {0, 1, 0}, profile);
  add_revolution(surface, {0, 0, 1}, profile);
}

}  // namespace sh::numeric::plot
