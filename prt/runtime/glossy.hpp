// Relighting of glossy transfer [SloanKautzSnyder02, section 4.2]: a vertex keeps the visibility V. Its product with the
// light, projected, is the radiance that reaches the vertex (equation 11, from V alone: as many numbers as V has in twice
// the degree of the light, and exact). Where the bake has bounces, a matrix adds what other surfaces send. What leaves
// towards the eye is this radiance, convolved with the lobe and evaluated at the mirrored direction of view (equation 12),
// plus the same about the normal with the clamped cosine for the diffuse part. Since only the second step knows the normal,
// it may be another one at every pixel: that of a normal map (prt/runtime/shading_normals.hpp).
#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "prt/light/light_coefficients.hpp"
#include "prt/rays/receivers_at.hpp"
#include "prt/runtime/exit_lobes.hpp"
#include "prt/runtime/render.hpp"
#include "prt/transfer/grid_cell.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {

/// The radiance that reaches every receiver, a vertex or a point of space. The same bits on one instruction set
/// (generated/batch/records.hpp).
class TransferredRadiance {
 public:
  /// A light of lower degree than the transfer is zero in the bands above. Around an object the light may have a higher
  /// degree, too: a point gets of the bands above the part that the object does not block of the sphere. Throws
  /// std::invalid_argument for transfer that is not glossy, and if the light has a higher degree; std::runtime_error if a
  /// number exceeds single precision.
  TransferredRadiance(const Transfer& transfer, const LightCoefficients& light) { meet(transfer, light); }
  /// The same again, for the next frame, in the memory that is there.
  void meet(const Transfer& transfer, const LightCoefficients& light);
  /// Under a light of its own at every vertex, light(vertex): of a light of its degree. Not for transfer with bounces. Throws
  /// like the constructor.
  static TransferredRadiance at_vertices(const Transfer& transfer,
                                         const std::function<LightCoefficients(std::size_t vertex)>& light);
  /// Around an object only what the object sends: its matrices times the light. Of the degree of the result.
  static TransferredRadiance sent(const Transfer& volume, const LightCoefficients& light);

  /// That of the light; around an object that of the result or of the light, whichever is higher.
  [[nodiscard]] int degree() const { return degree_; }
  /// (3, bands^2): red, green, blue.
  [[nodiscard]] const float* at(std::size_t vertex) const { return values_.data() + vertex * stride_; }
  /// The same between receivers, into `out`.
  void at(const ReceiversAt& place, float* out) const;
  /// The same between the points of a grid, times factors (3, bands^2) if there are any.
  void at(const GridCell& cell, float* out, const float* factors = nullptr) const {
    cell.mix(values_.data(), stride_, out, factors);
  }

 private:
  TransferredRadiance() = default;
  int degree_ = 0;
  std::size_t stride_ = 0;  // then one radiance reaches every vertex
  std::vector<float> values_;
};

/// The material of a vertex. `mesh` must outlive the result.
Material material_of(const Mesh& mesh, std::size_t vertex, const Eigen::Vector3f& albedo);

/// Whether the corners of a face have one BRDF, or one lobe. Where they have several, radiance is interpolated between them.
bool has_one_finish(const Mesh& mesh, const Face& face);
/// Whether that is so of all faces.
bool has_one_finish(const Mesh& mesh);

/// Exit radiance, linear RGB, W m^-2 sr^-1, where `reaching` (3, bands^2) reaches a surface. `normal` and `to_eye` are
/// unit. Slightly negative where a band-limited product rings.
Eigen::Vector3f exit_radiance(const Material& material, int degree, const float* reaching,
                              const Eigen::Vector3f& normal, const Eigen::Vector3f& to_eye);

/// The largest exponent of a lobe on the mesh, and the part of it that the degree of the transfer holds (lobe.hpp); nothing
/// without lobes or for diffuse transfer.
struct SharpestLobe {
  double exponent;
  double share;
};
std::optional<SharpestLobe> sharpest_lobe(const Transfer& transfer);

/// The part of each BRDF of the mesh that the degree of the transfer holds (reflectance.hpp); nothing for diffuse transfer.
std::vector<double> held_shares_of_brdfs(const Transfer& transfer);

/// Radiance that the lobe of a vertex sends besides, of linear RGB, from about a unit direction at a place.
using MoreOfLobe = std::function<Eigen::Vector3f(const Hit& hit, std::size_t vertex, const Eigen::Vector3f& direction)>;

/// What a picture shows, shaded at every hit with the albedo of `colors`. `transfer` must outlive the result. more: empty, or
/// the part of lobes that the transfer cannot hold (prt/runtime/sharp_layer.hpp).
Surface glossy_surface(const Transfer& transfer, TransferredRadiance reaching, SurfaceColors colors,
                       MoreOfLobe more = {});
/// The same without pictures; `albedo` (vertices) serves in place of the mesh's.
inline Surface glossy_surface(const Transfer& transfer, TransferredRadiance reaching,
                              std::vector<Eigen::Vector3f> albedo, MoreOfLobe more = {}) {
  return glossy_surface(transfer, std::move(reaching), SurfaceColors(transfer.mesh, std::move(albedo)),
                        std::move(more));
}

/// Exit radiance of the vertices of `transfer` towards a point `eye` of the world, without the emitted light; `albedo`
/// (vertices) serves in place of the mesh's.
std::vector<Eigen::Vector3f> reflected_radiance(const Transfer& transfer, const TransferredRadiance& reaching,
                                                const Eigen::Vector3d& eye, const std::vector<Eigen::Vector3f>& albedo);

/// The same with the emitted light.
std::vector<Eigen::Vector3f> exit_radiance(const Transfer& transfer, const TransferredRadiance& reaching,
                                           const Eigen::Vector3d& eye, const std::vector<Eigen::Vector3f>& albedo);

}  // namespace sh::prt
