// The light around objects whose space has been baked (kind N) [SloanKautzSnyder02, section 8]. Once a frame the volume
// of an object meets the light at all of its points. Any receiver that enters the box then takes the radiance that reaches
// it by interpolation: a diffuse one by its normal, a glossy one by equation 12 (exit_radiance in prt/runtime/glossy.hpp),
// one with transfer of its own by its row, in its own turned axes.
//
// Where several boxes overlap, the visibilities of their objects are interpolated, turned and multiplied, and the product
// meets the light. Each product is projected on the bands of the visibilities, which is the error that this adds; it is
// none for a point that only one object darkens (tests/prt/neighborhood_test.cpp measures it).
//
// Approximations: the light is equally far away from all points of a box; an object and its box move rigidly; a receiver
// outside of the box gets the whole light, so that the box has to hold the shadow (`prt volume` says what is left of it at
// the sides). Light goes from the object to a receiver only if its volume has matrices (kind NI); where boxes overlap,
// no object stands in the way of what another one sends.
#pragma once
#include <Eigen/Core>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "prt/light/light_coefficients.hpp"
#include "prt/runtime/glossy.hpp"
#include "prt/scene/stage.hpp"
#include "prt/transfer/point_grid.hpp"

namespace sh::prt {

/// radiance (receivers) = exit radiance over albedo of diffuse receivers in the box of a volume, linear RGB. Positions and
/// unit normals in its axes; a receiver outside of the box has the light of the nearest side. In parallel; the same bits
/// for any number of threads. Throws std::invalid_argument for spans of different lengths.
void shade_diffuse(const PointGrid& grid, const TransferredRadiance& reaching,
                   std::span<const Eigen::Vector3f> positions, std::span<const Eigen::Vector3f> normals,
                   std::span<Eigen::Vector3f> radiance);

/// The volumes of a stage's objects in their poses under a light, which is in the world. The stage must outlive it.
class Neighborhoods {
 public:
  /// Turns the light into the axes of every volume and meets all of its points. Throws like TransferredRadiance.
  Neighborhoods(const Stage& stage, std::vector<Pose> poses, const LightCoefficients& light);

  /// The light at a point of the world, in the axes of the object `receiver`, whose own volume does not count; nothing
  /// where no volume reaches. Of the degree of the light.
  [[nodiscard]] std::optional<LightCoefficients> at(std::size_t receiver, const Eigen::Vector3d& point) const;

 private:
  struct Neighbor {
    std::size_t object;
    const Transfer* volume;
    Rows visibility;
    TransferredRadiance reaching;                  // in its axes
    std::optional<TransferredRadiance> sent = {};  // a part of it, where several volumes may overlap
  };
  // The radiance of a neighbor at a point of the world, in the axes of the receiver.
  [[nodiscard]] LightCoefficients taken(std::size_t receiver, const Neighbor& neighbor,
                                        const TransferredRadiance& radiance, const Eigen::Vector3d& point) const;
  [[nodiscard]] LightCoefficients behind_all(std::size_t receiver, std::span<const Neighbor* const> neighbors,
                                             const Eigen::Vector3d& point) const;
  [[nodiscard]] Eigen::Matrix3f turn(std::size_t receiver, const Neighbor& neighbor) const;
  [[nodiscard]] Eigen::Vector3d local(std::size_t object, const Eigen::Vector3d& point) const;

  std::vector<Pose> poses_;
  std::vector<Neighbor> neighbors_;
  TransferShape shape_;                       // of products of all visibilities
  std::vector<LightCoefficients> lights_;     // in the axes of every object
  std::vector<std::vector<float>> prepared_;  // the same for products, in the degree of the kernels
};

}  // namespace sh::prt
