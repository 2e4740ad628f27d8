// A scene: mesh, lights, camera and bake options, from a JSON file or, by the word `demo`, made in code.
// World axes: z up, right-handed. The JSON keys stand in prt/README.md.
#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "prt/bounces.hpp"
#include "prt/light_spec.hpp"
#include "prt/mend.hpp"
#include "prt/mesh.hpp"
#include "prt/transfer.hpp"

namespace sh::prt {

/// A pinhole camera; the field of view is vertical, in degrees.
struct Camera {
  Eigen::Vector3f position{4.0F, -4.0F, 3.0F};
  Eigen::Vector3f target{0.0F, 0.0F, 0.0F};
  Eigen::Vector3f up{0.0F, 0.0F, 1.0F};
  float vertical_field_of_view = 40.0F;
};

struct BakeOptions {
  int degree = 4;         // 0..kMaxDegree
  int directions = 2048;  // over the whole sphere
  TransferKind kind = TransferKind::kShadowed;
  BounceOptions bounces;  // interreflected only
};

struct Scene {
  std::string name;
  Mesh mesh;
  std::vector<LightSpec> lights;
  Camera camera;
  BakeOptions bake;
};

/// The scene in the JSON file `scene`, or the embedded one for the word `demo`. Meshes are loaded, welded and split;
/// light files are only named. Flaws that can be mended are counted and reported once each through `on_flaw`.
/// Throws std::runtime_error with one line that names file and JSON path.
Scene load_scene(const std::string& scene, OnFlaw on_flaw);

}  // namespace sh::prt
