// Traces rays against a mesh: a thin wrapper, the only place that knows Embree. Embree 4 has no stream calls; packets
// would replace the two stream calls in tracer.cpp.
#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>

#include "prt/mesh/mesh.hpp"
#include "prt/rays/sheets.hpp"

namespace sh::prt {

/// A ray that only asks whether anything blocks it. It has Embree's memory layout, so that no copy is made.
struct alignas(16) ShadowRay {
  Eigen::Matrix<float, 3, 1, Eigen::DontAlign> origin;
  float near = 0.0F;
  Eigen::Matrix<float, 3, 1, Eigen::DontAlign> direction;
  float time = 0.0F;
  float far = std::numeric_limits<float>::infinity();  // the tracer writes -infinity if something blocks the ray
  std::uint32_t mask = 0xFFFFFFFFU;
  std::uint32_t id = 0;
  std::uint32_t flags = 0;

  void aim(const Eigen::Vector3f& from, const Eigen::Vector3f& along) {
    origin = from;
    direction = along;
    far = std::numeric_limits<float>::infinity();
  }
  [[nodiscard]] bool blocked() const { return far < 0.0F; }
};

/// The wanted instruction set, or the best up to avx2 that the processor has. Throws std::invalid_argument for one that it
/// does not have.
std::string choose_instruction_set(const std::string& wanted = "");

/// Faces of copies from which on the memory of their trees counts more than the time of rays.
inline constexpr std::size_t kSharedCopies = std::size_t{1} << 23U;

/// A mesh ready for rays. If two faces coincide with opposite orientation (the sides of one sheet), a ray hits the one
/// that faces it. Const calls may come from any thread. The tracer does not refer to the mesh after construction.
class Tracer {
 public:
  /// Builds the tree with `threads` threads; 0 uses every core. `instruction_set` is sse4.2, avx, avx2 or avx512; empty
  /// selects the best up to avx2 that the processor has. Copies (prt/rays/copies.hpp) share a tree if they have `shared`
  /// faces or more: this saves the memory of the others, and rays take longer. Throws std::invalid_argument for an unknown
  /// or unsupported instruction set, std::runtime_error if Embree reports an error.
  explicit Tracer(const Mesh& mesh, int threads = 0, const std::string& instruction_set = "",
                  std::size_t shared = kSharedCopies);
  ~Tracer();
  Tracer(const Tracer&) = delete;
  Tracer& operator=(const Tracer&) = delete;

  /// Closest hits of origins[i] + t directions[i], t > 0; the three spans have one length.
  void intersect(std::span<const Eigen::Vector3f> origins, std::span<const Eigen::Vector3f> directions,
                 std::span<Hit> hits) const;

  /// The same, but the face of a hit and its place in it are not those of the mesh, which take time to find.
  void meet(std::span<const Eigen::Vector3f> origins, std::span<const Eigen::Vector3f> directions,
            std::span<Hit> hits) const;

  /// Sets `far` of the rays that hit anything to -infinity.
  void occluded(std::span<ShadowRay> rays) const;

  /// The frame of the mesh, in which rays are, too.
  [[nodiscard]] const Frame& frame() const;

  /// Where a ray from a point of the world starts in the frame. Throws std::runtime_error, one line, for a point so far
  /// away that Embree has no numbers for it.
  [[nodiscard]] Eigen::Vector3f start(const Eigen::Vector3d& point) const;

  /// The instruction set in use: results have the same bits on every machine that has it.
  [[nodiscard]] const std::string& instruction_set() const;

  /// The faces of copies that share the tree of their original.
  [[nodiscard]] std::size_t shared_faces() const;

  /// The number of rays of both types that were traced so far.
  [[nodiscard]] std::uint64_t rays() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace sh::prt
