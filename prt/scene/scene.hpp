// A scene: mesh, lights, camera and bake options, from a JSON file or, by the words `demo` and `disc`, made in code.
// World axes: z up, right-handed. The JSON keys stand in prt/README.md.
#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "prt/light/light_spec.hpp"
#include "prt/mesh/mend.hpp"
#include "prt/mesh/mesh.hpp"
#include "prt/scene/bake_options.hpp"
#include "prt/scene/camera.hpp"
#include "prt/scene/plan_options.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {

/// A disc over the origin that faces straight up, over a ground z = 0: prt/study/exact.hpp has its transfer vectors.
struct Disc {
  float radius;
  float height;
};

struct Scene {
  std::string name;
  Mesh mesh;
  std::vector<LightSpec> lights;
  Camera camera;
  BakeOptions bake;
  PlanOptions plan;          // none of a scene made in code, lossy where the file has one, else exact
  std::optional<Disc> disc;  // of the scene `disc`
};

/// The scene in the JSON file `scene`, or an embedded one for the words `demo` and `disc`. Meshes are loaded, welded
/// and split; light files are only named. Flaws that can be mended are counted and reported once each through
/// `on_flaw`. Throws std::runtime_error with one line that names file and JSON path.
Scene load_scene(const std::string& scene, OnFlaw on_flaw);

}  // namespace sh::prt
