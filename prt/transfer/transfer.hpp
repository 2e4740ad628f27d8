// The result of a bake: a mesh and the transfer of every vertex, or a grid and the transfer of every point
// (prt/transfer/shape.hpp describes the numbers of a receiver). L (3, bands^2) are the coefficients of the incident radiance.
//   without the albedo, one channel     exit radiance (RGB) = albedo * sum_i T_i L_i: it can be recolored
//   with the albedo, three channels     exit radiance of channel c = sum_i T_ci L_ci, since the light that bounces
//                                       depends on every albedo
// A vertex under constant unit radiance and an open sky therefore has sum_i T_i L_i = 1. Emitting surfaces add
// `emitted` to both, under any light.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "prt/kinds/kinds.hpp"
#include "prt/mesh/mesh.hpp"
#include "prt/names.hpp"
#include "prt/transfer/clusters.hpp"
#include "prt/transfer/point_grid.hpp"
#include "prt/transfer/rows.hpp"

namespace sh::prt {

/// The method that chooses the ray directions; prt/rays/directions.hpp makes them.
enum class Sampler : std::uint32_t { kFibonacci, kStratified, kSobol, kRandom, kCosine };

/// The names of the samplers, in the order of Sampler.
inline constexpr std::array<std::string_view, 5> kSamplerNames = {"fibonacci", "stratified", "sobol", "random",
                                                                  "cosine"};

constexpr std::string_view name_of(Sampler sampler) { return word_of(sampler, kSamplerNames); }

/// One decision of a plan: work or numbers that a bake left out. `error` is relative to the plan's reference radiance
/// (prt/plan/plan.hpp). `basis` says how the error is known: exact (no error but rounding), bound (proved, for any
/// vertex), measured (RMS, on a probe of vertices, with 99 % confidence).
struct Decision {
  std::string name;
  std::string choice;
  std::string why;
  std::int64_t bytes_saved = 0;
  std::int64_t rays_saved = 0;
  double error = 0.0;
  std::string basis = "exact";
};

/// The decisions by which a file was baked. With `budget` 0 all of them are exact under any light.
struct PlanRecord {
  double budget = 0.0;
  double error = 0.0;       // of all decisions together
  std::string light_turns;  // for which the errors hold: none, about_z or any; empty without a budget
  std::vector<Decision> decisions;
};

/// The solution of the bounces (prt/bake/bounces.hpp). Errors are bounds for all numbers of the solution.
struct BounceReport {
  std::string solver;           // series or bicgstab; empty if there are no bounces
  int applications = 0;         // of the form factors; each is one bounce of the series
  bool certified = false;       // bound <= tolerance * largest, or time ended first and the bound holds
  double bound = 0.0;           // certified: no number is further from the system's solution
  double residual = 0.0;        // largest number of b - (I - A) x
  double largest = 0.0;         // number of the solution
  double spectral_bound = 0.0;  // certified: no eigenvalue of albedo times form factors is larger
  double emitted_bound = 0.0;   // as `bound`, of the surfaces' own light
  double emitted_largest = 0.0;
  /// Not certified but measured: how far light between vertices is from its interpolation, rms over rms
  /// (prt/bake/between_vertices.hpp). 0 where it was not measured.
  double between_vertices = 0.0;
  std::uint32_t directions = 0;  // of the form factors; 0: those of the transfer
};

/// The requested settings that a time limit did not allow (prt/bake/estimate.hpp).
struct Shortfall {
  std::uint32_t directions = 0;  // requested; 0 if the bake used as many
  double tolerance = 0.0;        // requested for the bounces; 0 if it was reached
  [[nodiscard]] bool any() const { return directions > 0 || tolerance > 0.0; }
};

/// The medium around receivers inside it.
struct MediumRecord {
  std::array<float, 3> albedo{};  // linear RGB, 0..1
  double anisotropy = 0.0;        // g of the phase function [HenyeyGreenstein41]
  std::uint32_t directions = 0;   // in which light was followed
};

/// The transfer of every receiver: the vertices of `mesh`, or the points of `grid`.
struct Transfer {
  std::string scene;              // the scene's name, for people
  Mesh mesh;                      // empty where the receivers are points
  std::optional<PointGrid> grid;  // only of the kinds whose receivers are points
  const TransferKind* kind = &kUnshadowed;
  TransferShape shape;  // of a receiver's numbers; `element` and `kept` apply to files and to what is read from them
  std::uint32_t directions = 0;  // over the whole sphere; 0 where no ray was traced
  Sampler sampler = Sampler::kFibonacci;
  std::uint32_t seed = 0;           // of the sampler
  std::string instruction_set;      // on which the bits are reproducible
  BounceReport bounces;             // of kinds with bounces, and of media
  MediumRecord medium;              // of kinds inside a medium
  std::vector<float> density;       // of the medium, (receivers): its extinction, 1 / unit of the scene
  std::vector<float> coefficients;  // (receivers, channels, rows, columns), row-major; columns i = l(l+1)+m
  Encoded stored;     // in place of `coefficients` where a file has other numbers than these: the file's, as they are
  Clusters clusters;  // in place of `coefficients` where shape.storage is clustered
  TransferShape indirect_shape;  // of the matrices, where the kind has them: dot
  /// Matrices that bring the light to a vertex over other surfaces, (vertices, channels, rows, columns): they add to the
  /// radiance that reaches it directly. One channel where every material is gray. Empty where the kind has none.
  std::vector<float> indirect;
  Encoded stored_indirect;     // in place of `indirect` where they come from a file
  Clusters indirect_clusters;  // in place of `indirect` where indirect_shape.storage is clustered
  /// Linear RGB exit radiance of the light that surfaces emit, with its bounces, (vertices); empty if no surface emits.
  std::vector<Eigen::Vector3f> emitted;
  PlanRecord plan;  // decisions of the bake
  Shortfall missing;

  /// A transfer of this kind for light of this degree, without numbers.
  static Transfer of(const TransferKind& kind, int degree) {
    Transfer transfer;
    transfer.kind = &kind;
    transfer.shape = kind.shape(degree);
    return transfer;
  }
  [[nodiscard]] int degree() const { return shape.degree; }
  [[nodiscard]] std::size_t receivers() const { return grid ? grid->points() : mesh.positions.size(); }
  /// The numbers of a receiver, where `coefficients` holds them.
  [[nodiscard]] float* row(std::size_t vertex) { return coefficients.data() + vertex * shape.length(); }
  [[nodiscard]] const float* row(std::size_t vertex) const { return coefficients.data() + vertex * shape.length(); }
  /// The same wherever they are: if need be, they are made in `room`.
  [[nodiscard]] const float* row(std::size_t vertex, std::vector<float>& room) const {
    if (clusters.empty()) return rows().some(vertex, 1, room);
    room.resize(shape.length());
    clusters.row(vertex, room.data());
    return room.data();
  }
  /// The rows of all vertices, and their matrices, unless they are clustered. The transfer must outlive the results.
  [[nodiscard]] Rows rows() const { return {coefficients, stored, shape}; }
  [[nodiscard]] Rows matrices() const { return {indirect, stored_indirect, indirect_shape}; }
  /// The rows (or those of the clusters) and matrices as a file stores them: what is stored, or made in `room`. Throws like
  /// encode().
  [[nodiscard]] const Encoded& encoded_rows(Encoded& room) const {
    return encoded(coefficients, stored, clusters, shape, room);
  }
  [[nodiscard]] const Encoded& encoded_matrices(Encoded& room) const {
    return encoded(indirect, stored_indirect, indirect_clusters, indirect_shape, room);
  }

 private:
  static const Encoded& encoded(const std::vector<float>& complete, const Encoded& stored, const Clusters& clusters,
                                const TransferShape& shape, Encoded& room) {
    if (!stored.empty() && !stored.in_blocks) return stored;
    if (!stored.empty()) return room = in_rows(stored, shape);
    room = encode(shape.storage.is_clustered() ? clusters.basis : complete, shape);
    return room;
  }
};

}  // namespace sh::prt
