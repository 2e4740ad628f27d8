// A scene: mesh, lights, camera and bake options. It comes from a JSON file, or from code for the names `demo` and
// `disc`. World axes: z up, right-handed. prt/FILES.md lists the JSON keys.
#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "prt/light/light.hpp"
#include "prt/medium/medium.hpp"
#include "prt/mesh/mend.hpp"
#include "prt/mesh/mesh.hpp"
#include "prt/scene/camera.hpp"
#include "prt/scene/options.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {

/// A disc above the origin that faces straight up, over a ground z = 0; prt/study/study_setup.hpp has its transfer
/// vectors.
struct Disc {
  float radius;
  float height;
};

struct Scene {
  std::string name;
  Mesh mesh;                     // empty if there is a medium
  std::optional<Medium> medium;  // in place of a mesh
  std::vector<LightSpec> lights;
  Camera camera;
  BakeOptions bake;
  PlanOptions plan;                // made in code: none; from a file: lossy if the file has a plan, else exact
  std::optional<Disc> disc;        // only in the scene `disc`
  std::string normal_map_entry;    // `file: path` of the first entry that asks for a normal map; empty: none
  std::vector<std::string> files;  // that it is read from: its own, meshes, pictures
};

/// Loads the scene in the JSON file `scene`, or an embedded scene for `demo` and `disc`, or a mesh file alone, with a
/// ground and the default sky. Meshes are loaded, welded and split; light files must be readable but are not loaded
/// yet. Each kind of mended flaw is counted and reported once through `on_flaw`. Throws std::runtime_error with one
/// line that names file and JSON path.
Scene load_scene(const std::string& scene, OnFlaw on_flaw);

}  // namespace sh::prt
