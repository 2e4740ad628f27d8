// Finds the visible part of the shared directions at one receiver, a vertex or a point of space: the inner loop of the
// shadowed bake.
#pragma once
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "prt/mesh/mesh.hpp"
#include "prt/rays/tracer.hpp"
#include "prt/scene/options.hpp"

namespace sh::prt {

/// The origin of the rays of a receiver, and the reach of the mesh around it: the mean distance to the centers of its
/// faces, about half an edge; 0 for a point of space, which has no horizon. The others are the vertices of the mesh.
struct RayStart {
  Eigen::Vector3f origin;
  float reach;
  bool in_space = false;
};

/// Each origin lies slightly off the surface along the geometric normal, and as far towards the center of the faces
/// around. A vertex at the foot of a wall is therefore in front of the wall and not inside it.
std::vector<RayStart> ray_starts(const Mesh& mesh);

/// The directions with their basis values; zeros pad the rows to whole SIMD registers. Directions of the cosine sampler
/// are about +z: they and their sums are turned into the frame of each vertex.
class SharedDirections {
 public:
  explicit SharedDirections(const BakeOptions& options);
  /// The directions of the options for receivers of this shape, of one channel.
  SharedDirections(const BakeOptions& options, const TransferShape& traced);
  /// Uses other functions instead of the basis: row(direction, out) writes `columns` values, of which the first is 1.
  /// For directions of any sampler except cosine.
  using Row = std::function<void(const Eigen::Vector3f& direction, float* out)>;
  SharedDirections(std::vector<Eigen::Vector3f> directions, std::size_t columns, const Row& row);
  [[nodiscard]] std::size_t size() const { return directions_.size(); }
  [[nodiscard]] std::size_t row_length() const { return row_length_; }
  [[nodiscard]] bool about_normal() const { return about_normal_; }
  /// True if directions weigh by the cosine with the shading normal; else all above the horizon weigh the same.
  [[nodiscard]] bool weighs_cosine() const { return weighs_cosine_; }
  [[nodiscard]] const Eigen::Vector3f& direction(std::size_t j) const { return directions_[j]; }
  /// out (size) = the dot product of `normal` and every direction.
  void cosines_with(const Eigen::Vector3f& normal, float* out) const;
  /// result (row_length) = the sum of weights[j] Y(direction j) over the first `count` indices j in `chosen`.
  void sum(const std::vector<std::uint32_t>& chosen, std::size_t count, const float* weights, float* result) const;
  /// Turns the function in row (row_length) by a rotation matrix.
  void turn(const Eigen::Matrix3f& frame, float* row) const;

 private:
  int degree_ = 0;
  bool about_normal_ = false;
  bool weighs_cosine_ = true;
  std::vector<Eigen::Vector3f> directions_;
  std::size_t row_length_;
  std::vector<float> values_;      // (directions, row_length)
  std::vector<float> components_;  // (3, directions)
};

inline constexpr std::size_t kMaxRow = 128;

/// Quadrature sums of Y_lm over the hemisphere of the shading normal. The weights are 4/N cos, or 1/N for directions of
/// the cosine sampler. Without the cosine the sums are over the hemisphere of the geometric normal, or over the sphere in
/// space, the weights 4 pi/N, and parts of the cosine below are parts of this hemisphere or sphere.
struct Gathered {
  alignas(64) std::array<float, kMaxRow> visible;
  alignas(64) std::array<float, kMaxRow> all;
  /// The visible part of the cosine, 0..1. Y_00 is constant, so that the first sums are proportional to the cosine.
  [[nodiscard]] float fraction() const { return all[0] > 0.0F ? visible[0] / all[0] : 0.0F; }
};

/// Replaces an unshadowed vector (count) by the shadowed one, f DU + (S - f S_all).
void control_with_unshadowed(const Gathered& seen, std::size_t count, float* transfer);

/// A blocked ray and its share of the cosine weight, which sums to 1 over the hemisphere.
struct BlockedRay {
  Eigen::Vector3f direction;
  Hit hit;
  double part;
};

/// Vertices that see less of the cosine are looked at more closely, at their closest hits.
inline constexpr double kNearlyDark = 0.05;

/// What the rays of a vertex tell about its place. All numbers are 0..1 and continuous in shares of the cosine that the
/// rays measure, so that they converge as rays grow: one more ray changes none of them much.
struct Sight {
  float visible = 1.0F;  // part of the cosine that sees the sky, directly or over mirrors
  float buried = 0.0F;   // 1: inside something, since many rays hit backs of faces and hardly any leaves the scene
  float covered = 0.0F;  // 1: nearly all rays hit something nearer than an edge's length
  /// The part of the vertex's light that its neighbors decide (prt/bake/fill_closed.hpp).
  [[nodiscard]] float closed() const { return std::max(buried, covered); }
};

/// Traces the rays of receivers, with the reusable buffers of one thread. All arguments must outlive it.
class Gatherer {
 public:
  Gatherer(const Mesh& mesh, const std::vector<RayStart>& starts, const Tracer& tracer,
           const SharedDirections& directions);
  /// Traces the rays of one vertex; the result stays valid until the next call.
  const Gathered& gather(std::size_t vertex);
  /// The closest hits of the rays that the last gather() found blocked; valid until the next call of gather().
  const std::vector<BlockedRay>& closest_hits();
  /// What the rays of the last gather(vertex) tell. The vertex sees `visible` of its cosine; the closest hits are found
  /// only if this is little.
  Sight sight(std::size_t vertex, float visible);
  /// The rays that gather() would trace for one vertex, for measurements.
  std::vector<ShadowRay> rays(std::size_t vertex);

 private:
  // What is known of closest hits: distances and sides, or faces, too.
  enum class Known { kNothing, kDistances, kFaces };
  // The weights and heights of all directions.
  void weigh_hemisphere(std::size_t vertex);
  void begin_in_space();
  std::size_t aim_in_space(const Eigen::Vector3f& origin);
  const Gathered& gathered_in_space();
  // Selects directions: fills `chosen_`, which are to be traced, and `blocked_`, which lie under the horizon. Returns
  // how many to trace.
  std::size_t aim(std::size_t receiver);
  // The closest hits, with faces or without.
  void find_closest(Known what);
  // Direction j in world axes.
  [[nodiscard]] Eigen::Vector3f towards(std::uint32_t j) const {
    return directions_.about_normal() ? (frame_ * directions_.direction(j)).eval() : directions_.direction(j);
  }

  const Mesh& mesh_;
  const std::vector<RayStart>& starts_;
  const Tracer& tracer_;
  const SharedDirections& directions_;
  std::vector<ShadowRay> rays_;
  std::vector<std::uint32_t> chosen_;  // directions to trace
  std::vector<std::uint32_t> visible_;
  std::vector<std::uint32_t> blocked_;  // the first below_ lie under the horizon
  std::size_t below_ = 0;
  std::size_t visible_count_ = 0;
  std::size_t blocked_count_ = 0;       // with those under the horizon
  std::vector<Eigen::Vector3f> along_;  // of intersect()
  std::vector<Hit> hits_;
  std::vector<BlockedRay> closest_;
  Known closest_known_ = Known::kNothing;  // for the last gather()
  Eigen::Matrix3f frame_;                  // of the vertex, where directions are about the normal
  std::vector<float> weights_;             // of every direction, as in Gathered; none is negative where it counts
  std::vector<float> heights_;             // cosine with the geometric normal
  bool in_space_ = false;                  // the last receiver was a point of space; then the next member is known
  alignas(64) std::array<float, kMaxRow> sphere_;  // sums over all directions
  Gathered result_;
};

/// Calls each(gatherer, gathered, i) for the rays of every vertices[i], on all threads of the caller's arena.
void gather_all(const Mesh& mesh, const std::vector<RayStart>& starts, const Tracer& tracer,
                const SharedDirections& directions, const std::vector<std::uint32_t>& vertices,
                const std::function<void(Gatherer&, const Gathered&, std::size_t)>& each);

}  // namespace sh::prt
