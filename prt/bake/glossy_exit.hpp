// What leaves surfaces with lobes, linear in the light [SloanKautzSnyder02, section 5]. The radiance that reaches a vertex q
// is a matrix F_q (rows x columns, for each channel). What leaves it towards d is
//   u_q(d) = albedo (A Y(n))^T F_q + specular (lambda Y(R(d)))^T F_q,
// the same convolutions as at run time (prt/runtime/glossy.hpp), A those of the clamped cosine, lambda those of the lobe.
// A ray along s meets the eye at d = -s and is mirrored to R(d) = H s, H = 1 - 2 n n^T. Each band is turned in itself,
// Y(H s) = D Y(s), so that what leaves a vertex is linear in Y(s), too:
//   u_q(-s) = Y(s)^T U_q,  U_q = specular D lambda F_q, and albedo (A Y(n))^T F_q / Y_00 in its first row.
// It is interpolated between the corners of a face as in pictures; one-sided faces are black from behind.
#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "prt/rays/gather.hpp"
#include "prt/transfer/rows.hpp"
#include "prt/transfer/shape.hpp"

namespace sh::prt {

/// The shape of the matrices that bring light over other surfaces of this mesh: one channel where every material is gray.
TransferShape glossy_matrix_shape(const Mesh& mesh, int degree);

/// A matrix from the light to the radiance that reaches it for each vertex of a mesh, rows padded for SIMD.
struct MatrixTable {
  /// Of zeros.
  MatrixTable(const Mesh& mesh, int degree);
  /// Visibility times light: column j is the visibility (vertices, (2 degree + 1)^2) times Y_j.
  void take_direct(const Rows& visibility);
  /// Adds matrices (vertices, shape.length()) of these channels and of this degree or a higher one, of which it takes the
  /// lower bands, times `part`.
  void add(const std::vector<float>& matrices, const TransferShape& shape, float part = 1.0F);
  /// Adds a table of the same size times `part`.
  void add(const MatrixTable& other, float part = 1.0F);
  /// Writes one matrix of a table like this, without padding, as the lower bands of `out` (shape.length()), a matrix of
  /// these channels and of this degree or a higher one.
  void copy(const float* matrix, const TransferShape& shape, float* out) const;
  /// All matrices without padding, (vertices, shape.length()); `shape` as in copy().
  [[nodiscard]] std::vector<float> copies(const TransferShape& shape) const;

  [[nodiscard]] float* of(std::size_t vertex) { return values.data() + vertex * size; }
  [[nodiscard]] const float* of(std::size_t vertex) const { return values.data() + vertex * size; }

  int degree;
  std::size_t count;  // coefficients: rows, and columns of a channel
  std::size_t channels;
  std::size_t row;   // channels x columns, padded
  std::size_t size;  // numbers of a vertex: count rows
  std::vector<float> values;
};

/// A ray that is blocked by the front of a face.
struct BlockedAt {
  Eigen::Vector3f direction;
  Hit hit;
};

/// The rays of a vertex that meet fronts.
std::vector<BlockedAt> rays_to_fronts(Gatherer& gatherer, std::size_t vertex);

class GlossyExit {
 public:
  /// Of surfaces that `reaching` reaches; both must outlive the result. Overwrites the matrices of vertices with lobes by
  /// what leaves them. Runs on the threads of the caller's arena.
  GlossyExit(const Mesh& mesh, MatrixTable& reaching);

  /// out (reaching.size), the matrix of a vertex whose rays, of this many directions, meet fronts here:
  ///   M_p = sum over j of w_j Y(s_j) u_qj(-s_j)^T.
  void collect(const std::vector<BlockedAt>& rays, std::size_t directions, float* out) const;

 private:
  void add_weighed(const float* weights, std::size_t vertex, const Eigen::Vector3f& color, float* row) const;
  void turn(std::size_t vertex);
  void add_exit(const BlockedAt& ray, const float* basis, float* row) const;
  [[nodiscard]] bool has_lobe(std::size_t vertex) const {
    return !mesh_.specular.empty() && !mesh_.specular[vertex].isZero(0.0F);
  }

  const Mesh& mesh_;
  MatrixTable& matrices_;                // of vertices with a lobe U, of others F
  std::vector<std::uint32_t> in_order_;  // 0, 1, 2, ...
  std::vector<float> diffuse_;           // what leaves each vertex diffusely, (vertices, row)
};

}  // namespace sh::prt
