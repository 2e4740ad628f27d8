// Bakes the space around an object [SloanKautzSnyder02, section 8]: the visibility of every point of a grid, by the rays of
// a shadowed bake over the whole sphere. A point far from the object keeps the whole sphere to the bit. A point inside a
// solid sees backs of faces only; it takes the mean of the points around it that lie outside (prt/bake/fill_closed.hpp),
// so that no darkness of the inside leaks through interpolation. Points whose neighbors are all inside stay dark: no
// receiver outside meets them.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "prt/bake/bake.hpp"
#include "prt/bake/estimate.hpp"
#include "prt/transfer/point_grid.hpp"

namespace sh::prt {

struct VolumeOptions {
  std::array<std::uint32_t, 3> counts = {64, 64, 8};
  std::optional<Eigen::AlignedBox3d> box = {};  // default: default_box()
  double faintest_shadow = 0.05;                // that the default box holds, as a part of the largest irradiance
  int degree = 2;                               // of the light, 0..kHighestProduct
  int result_degree = 4;                        // of the radiance that reaches a point, 0..kHighestProduct
  int directions = 2048;                        // over the sphere
  Sampler sampler = Sampler::kFibonacci;        // not the cosine
  std::uint32_t seed = 0;
  Element element = Element::kSingle;  // of the file
  bool reflects = false;               // matrices of what the object sends, too: kind NI
  double memory = 0.0;                 // bytes that the bake may take; 0: those of the machine
};

/// The parts of the radius of the object's bounding sphere by which the default box without lights exceeds the object on
/// every side. A sphere at its distance blocks 0.028 of the directions.
inline constexpr double kBoxMargin = 2.0;

/// The box, in the world, that holds the shadows of the scene's meshes or medium under its lights, of the degree of the
/// options, as far as the scene's plan lets these turn (shadow_box.hpp). Without lights, and for a volume that sends light, the box of
/// the object with this margin.
Eigen::AlignedBox3d default_box(const Scene& scene, const VolumeOptions& options);

/// A volume of this scene without numbers. Throws std::invalid_argument for options out of range, a box without sides or that
/// does not contain the meshes or the medium, or more memory than there is, with the counts that fit. Says how much it is.
Transfer empty_volume(const Scene& scene, const VolumeOptions& options, const BakeObserver& say);

/// The largest part of the sphere that the object blocks at a side of the box.
double blocked_at_border(const Transfer& volume);

/// What a point of the grid tells of a volume.
struct VolumeReport {
  BakeReport bake;
  std::size_t inside = 0;  // points inside solids; PointGrid::filled of them have numbers of points outside
  double border = 0.0;     // blocked_at_border
};

/// The transfer of kind N of the points around the scene's meshes; materials and the scene's bake are not used, lights for
/// the default box alone. Mirrors block rays. The same bits for any number of threads. Throws like empty_volume, and
/// like bake() for the rest: progress, interruption, checkpoint.
Transfer bake_volume(const Scene& scene, const VolumeOptions& options, const BakeSettings& settings,
                     VolumeReport* report = nullptr, const BakeObserver& say = {});

/// Traces the rays of the shard that the settings name into their checkpoint, which then is complete. The bake of all parts
/// traces no rays but those of what the object sends. Throws like bake_volume, and std::invalid_argument for a shard out of range.
void bake_volume_shard(const Scene& scene, const VolumeOptions& options, const BakeSettings& settings,
                       VolumeReport* report = nullptr, const BakeObserver& say = {});

/// The time and memory of the rays, without those of what the object sends. Throws like empty_volume.
BakeEstimate estimate_volume(const Scene& scene, const VolumeOptions& options, const BakeSettings& settings);

/// Bakes into a transfer file, then deletes the checkpoint.
Transfer bake_volume_to_file(const std::string& file, const Scene& scene, const VolumeOptions& options,
                             const BakeSettings& settings, VolumeReport* report = nullptr,
                             const BakeObserver& say = {});

}  // namespace sh::prt
