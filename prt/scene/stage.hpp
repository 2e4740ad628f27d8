// A stage: baked objects that stand or move rigidly under one distant light, from a JSON file. prt/README.md lists the
// keys. prt/runtime/relight_stage.hpp relights it. World axes: z up, right-handed.
#pragma once
#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "prt/light/light_spec.hpp"
#include "prt/scene/camera.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {

/// Where an object stands: its point p (in its own axes) is at rotation p + position.
struct Pose {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  bool operator==(const Pose& other) const { return rotation == other.rotation && position == other.position; }
};

/// Where an object stands during a sequence, which runs from time 0 to 1.
struct Motion {
  struct Key {
    double time = 0.0;
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    double degrees = 0.0;  // right-handed about the axis
  };
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  // unit, through the object's origin
  std::vector<Key> keys{Key()};                     // one or more, times rising

  /// Position and angle are linear between keys, the first key's before it, the last one's after.
  [[nodiscard]] Pose at(double time) const;
};

struct Sphere {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double radius = 0.0;
};

struct StageObject {
  std::string name;  // for people: the transfer file as the stage names it
  std::shared_ptr<const Transfer> transfer;
  Motion motion;
  Sphere proxy;             // own axes: what stands for it where it takes light from others; 0 takes none
  bool per_vertex = false;  // light is gathered at every vertex, else once, at the proxy's centre
};

struct Stage {
  std::string name;
  std::vector<StageObject> objects;
  std::vector<LightSpec> lights;
  std::vector<Camera> camera;  // none or one
};

/// The sphere around the middle of the mesh's extent that holds it.
Sphere bounding_sphere(const Mesh& mesh);

/// One object at rest at the origin.
Stage stage_of(Transfer transfer);

/// Reads the stage and the transfer files it names, each once; those with relative paths lie in `folder`, or beside the
/// stage where that is empty. Throws std::runtime_error with one line that names file
/// and JSON path, or the transfer file.
Stage load_stage(const std::string& file, const std::string& folder = {});

}  // namespace sh::prt
