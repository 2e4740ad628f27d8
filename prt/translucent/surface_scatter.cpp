#include "prt/translucent/surface_scatter.hpp"

#include <tbb/enumerable_thread_specific.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "numeric/output/progress.hpp"
#include "prt/arrays.hpp"
#include "prt/chunks.hpp"
#include "prt/translucent/dipole.hpp"

namespace sh::prt {

namespace {

constexpr std::size_t kLeafFaces = 4;
constexpr double kNegligible = 20.0;  // of decay * distance
constexpr int kMostCuts = 40;         // of a face in four

using Corners = std::array<Eigen::Vector3d, 3>;

// The dipoles of a material by color; equal ones are evaluated once.
class Colors {
 public:
  // `unit`: the unit of positions in that of the scene.
  Colors(const Translucence& material, double unit) {
    for (int c = 0; c < 3; ++c) {
      const std::pair<float, float> rates = {material.absorption[c], material.scattering[c]};
      const auto same = std::find(rates_.begin(), rates_.end(), rates);
      dipole_of_[c] = static_cast<std::size_t>(same - rates_.begin());
      if (same != rates_.end()) continue;
      rates_.push_back(rates);
      dipoles_.emplace_back(unit * static_cast<double>(rates.first), unit * static_cast<double>(rates.second),
                            static_cast<double>(material.ior));
    }
    depth_ = slowest_ = fastest_ = 0.0;
    for (std::size_t i = 0; i < dipoles_.size(); ++i) {
      const Dipole& dipole = dipoles_[i];
      depth_ = i == 0 ? dipole.depth() : std::min(depth_, dipole.depth());
      slowest_ = i == 0 ? dipole.decay() : std::min(slowest_, dipole.decay());
      fastest_ = std::max(fastest_, dipole.decay());
    }
  }
  [[nodiscard]] Eigen::Array3d at(double squared_distance) const {
    std::array<double, 3> values{};
    for (std::size_t i = 0; i < dipoles_.size(); ++i) values[i] = dipoles_[i].at(squared_distance);
    return {values[dipole_of_[0]], values[dipole_of_[1]], values[dipole_of_[2]]};
  }
  // True if nothing at this distance or farther counts.
  [[nodiscard]] bool is_negligible(double distance) const { return slowest_ * distance > kNegligible; }
  // True if R_d is smooth over an extent around a point at this distance. Far away it may change more: it is small there.
  [[nodiscard]] bool is_smooth(double extent, double squared_distance, double far) const {
    const double distance = std::sqrt(squared_distance + depth_ * depth_);
    return extent <= far * distance && fastest_ * extent <= far * (1.0 + 0.25 * fastest_ * distance);
  }

 private:
  std::vector<std::pair<float, float>> rates_;
  std::vector<Dipole> dipoles_;
  std::array<std::size_t, 3> dipole_of_{};
  double depth_;
  double slowest_;
  double fastest_;
};

// A group of faces, taken as one point from afar.
struct Node {
  Eigen::Vector3d center;  // weighted by area
  double radius = 0.0;     // to the farthest corner
  std::size_t first = 0;   // of `faces`
  std::size_t count = 0;
  std::size_t left = 0;  // the children are left and right; 0: a leaf
  std::size_t right = 0;
};

// The faces of one body, in a tree, with the light that arrives on them.
class Body {
 public:
  Body(const Mesh& mesh, std::vector<std::uint32_t> faces, const Translucence& material,
       const std::vector<float>& arriving, std::size_t count, double far)
      : mesh_(mesh),
        colors_(material, mesh.frame.unit),
        arriving_(arriving),
        count_(count),
        far_(far),
        faces_(std::move(faces)) {
    add_node(0, faces_.size());
    light_.resize(nodes_.size() * count_, 0.0);
    // Children stand behind their parents.
    for (std::size_t n = nodes_.size(); n-- > 0;) sum_light(n);
  }

  // sum (3, count) += the light that scatters to a point.
  void gather(const Eigen::Vector3d& point, std::vector<std::size_t>& open, double* sum) const {
    open.assign(1, 0);
    while (!open.empty()) {
      const std::size_t n = open.back();
      open.pop_back();
      const Node& node = nodes_[n];
      const double squared = (node.center - point).squaredNorm();
      if (colors_.is_negligible(std::sqrt(squared) - node.radius)) continue;
      if (colors_.is_smooth(node.radius, squared, far_)) {
        add(colors_.at(squared), light_.data() + n * count_, sum);
      } else if (node.left == 0) {
        for (std::size_t f = node.first; f < node.first + node.count; ++f) add_face(faces_[f], point, sum);
      } else {
        open.push_back(node.right);
        open.push_back(node.left);
      }
    }
  }

 private:
  [[nodiscard]] Corners corners(std::uint32_t face) const {
    const Face& of = mesh_.faces[face];
    return {mesh_.positions[of[0]].cast<double>(), mesh_.positions[of[1]].cast<double>(),
            mesh_.positions[of[2]].cast<double>()};
  }
  static Eigen::Vector3d middle(const Corners& p) { return (p[0] + p[1] + p[2]) / 3.0; }
  static double area(const Corners& p) { return 0.5 * (p[1] - p[0]).cross(p[2] - p[0]).norm(); }

  [[nodiscard]] auto arriving(std::uint32_t vertex) const {
    return as_array(arriving_.data() + vertex * count_, count_).cast<double>();
  }

  std::size_t add_node(std::size_t first, std::size_t count) {
    const std::size_t n = nodes_.size();
    nodes_.emplace_back();
    Node node{.center = Eigen::Vector3d::Zero(), .first = first, .count = count};
    Eigen::AlignedBox3d middles;
    double whole = 0.0;
    for (std::size_t f = first; f < first + count; ++f) {
      const Corners p = corners(faces_[f]);
      middles.extend(middle(p));
      node.center += area(p) * middle(p);
      whole += area(p);
    }
    node.center = whole > 0.0 ? Eigen::Vector3d(node.center / whole) : middles.center();
    for (std::size_t f = first; f < first + count; ++f) {
      for (const Eigen::Vector3d& p : corners(faces_[f])) node.radius = std::max(node.radius, (p - node.center).norm());
    }
    if (count > kLeafFaces) {
      int axis = 0;
      middles.sizes().maxCoeff(&axis);
      const auto begin = faces_.begin() + static_cast<std::ptrdiff_t>(first);
      const std::size_t half = count / 2;
      std::nth_element(begin, begin + static_cast<std::ptrdiff_t>(half), begin + static_cast<std::ptrdiff_t>(count),
                       [&](std::uint32_t a, std::uint32_t b) {
                         return std::pair(middle(corners(a))[axis], a) < std::pair(middle(corners(b))[axis], b);
                       });
      node.left = add_node(first, half);
      node.right = add_node(first + half, count - half);
    }
    nodes_[n] = node;
    return n;
  }

  // The light of a node: the integral of what arrives.
  void sum_light(std::size_t n) {
    const Node& node = nodes_[n];
    double* sum = light_.data() + n * count_;
    if (node.left != 0) {
      as_array(sum, count_) =
          as_array(light_.data() + node.left * count_, count_) + as_array(light_.data() + node.right * count_, count_);
      return;
    }
    for (std::size_t f = node.first; f < node.first + node.count; ++f) {
      const double third = area(corners(faces_[f])) / 3.0;
      for (const std::uint32_t v : mesh_.faces[faces_[f]]) as_array(sum, count_) += third * arriving(v);
    }
  }

  template <class Light>
  void add_color(double weight, const Light& light, std::size_t color, double* sum) const {
    as_array(sum + color * count_, count_) += weight * light;
  }
  void add(const Eigen::Array3d& weights, const double* light, double* sum) const {
    for (std::size_t c = 0; c < 3; ++c) {
      add_color(weights[static_cast<Eigen::Index>(c)], as_array(light, count_), c, sum);
    }
  }

  void add_face(std::uint32_t face, const Eigen::Vector3d& point, double* sum) const {
    const Corners whole = {Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ()};
    const Corners p = corners(face);
    Eigen::Matrix3d weights = Eigen::Matrix3d::Zero();  // (colors, corners)
    integrate(p, whole, area(p), point, kMostCuts, weights);
    for (int k = 0; k < 3; ++k) {
      for (std::size_t c = 0; c < 3; ++c) {
        add_color(weights(static_cast<int>(c), k), arriving(mesh_.faces[face][static_cast<std::size_t>(k)]), c, sum);
      }
    }
  }

  // weights += the integral over a piece of R_d times the parts of the face's corners; `parts` are those at the corners
  // of the piece.
  void integrate(const Corners& p, const Corners& parts, double piece, const Eigen::Vector3d& point, int cuts,
                 Eigen::Matrix3d& weights) const {
    const Eigen::Vector3d center = middle(p);
    const double extent = std::sqrt(
        std::max({(p[0] - center).squaredNorm(), (p[1] - center).squaredNorm(), (p[2] - center).squaredNorm()}));
    const double squared = (center - point).squaredNorm();
    if (colors_.is_negligible(std::sqrt(squared) - extent)) return;
    if (cuts > 0 && !colors_.is_smooth(extent, squared, 2.0 * far_)) {
      const auto between = [](const Corners& of, std::size_t i, std::size_t j) {
        return Eigen::Vector3d(0.5 * (of[i] + of[j]));
      };
      const Corners q = {between(p, 0, 1), between(p, 1, 2), between(p, 2, 0)};
      const Corners r = {between(parts, 0, 1), between(parts, 1, 2), between(parts, 2, 0)};
      integrate({p[0], q[0], q[2]}, {parts[0], r[0], r[2]}, 0.25 * piece, point, cuts - 1, weights);
      integrate({q[0], p[1], q[1]}, {r[0], parts[1], r[1]}, 0.25 * piece, point, cuts - 1, weights);
      integrate({q[2], q[1], p[2]}, {r[2], r[1], parts[2]}, 0.25 * piece, point, cuts - 1, weights);
      integrate({q[0], q[1], q[2]}, {r[0], r[1], r[2]}, 0.25 * piece, point, cuts - 1, weights);
      return;
    }
    // [Dunavant85], degree 4: the parts of the corner that differs, and the weights.
    constexpr std::array<std::array<double, 2>, 2> kRule = {
        {{0.108103018168070, 0.223381589678011}, {0.816847572980459, 0.109951743655322}}};
    for (const auto& [own, weight] : kRule) {
      const double other = 0.5 * (1.0 - own);
      for (std::size_t k = 0; k < 3; ++k) {
        std::array<double, 3> mix = {other, other, other};
        mix[k] = own;
        const Eigen::Vector3d y = mix[0] * p[0] + mix[1] * p[1] + mix[2] * p[2];
        const Eigen::Vector3d part = mix[0] * parts[0] + mix[1] * parts[1] + mix[2] * parts[2];
        weights += (weight * piece * colors_.at((y - point).squaredNorm()).matrix()) * part.transpose();
      }
    }
  }

  const Mesh& mesh_;
  Colors colors_;
  const std::vector<float>& arriving_;
  std::size_t count_;
  double far_;
  std::vector<std::uint32_t> faces_;
  std::vector<Node> nodes_;
  std::vector<double> light_;  // (nodes, count)
};

}  // namespace

void add_scattered(const Mesh& mesh, const std::vector<float>& arriving, std::size_t count, std::vector<float>& rows,
                   double far_faces) {
  const std::vector<Translucence>& materials = mesh.translucences.heads;
  std::vector<std::optional<Body>> bodies(materials.size());
  for (std::size_t m = 0; m < materials.size(); ++m) {
    if (!materials[m].scatters()) continue;
    std::vector<std::uint32_t> faces;
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
      if (mesh.translucence[mesh.faces[f][0]] == m + 1) faces.push_back(f);  // a face has one
    }
    if (!faces.empty()) bodies[m].emplace(mesh, std::move(faces), materials[m], arriving, count, far_faces);
  }
  const std::size_t vertices = mesh.positions.size();
  output::Progress progress("scatter", vertices);
  struct Worker {
    std::vector<std::size_t> open;
    std::vector<double> sum;
  };
  tbb::enumerable_thread_specific<Worker> workers;
  for_chunks(vertices, [&](std::size_t chunk) {
    Worker& worker = workers.local();
    const VertexRange range = chunk_range(chunk, vertices);
    for (std::size_t v = range.first; v < range.last; ++v) {
      output::check_interrupt();
      const std::uint16_t number = mesh.translucence[v];
      if (number == 0 || !bodies[number - 1U]) continue;
      worker.sum.assign(3 * count, 0.0);
      bodies[number - 1U]->gather(mesh.positions[v].cast<double>(), worker.open, worker.sum.data());
      as_array(rows.data() + v * 3 * count, 3 * count) += as_array(worker.sum).cast<float>();
    }
    progress.advance(range.size());
  });
  progress.finish();
}

}  // namespace sh::prt
