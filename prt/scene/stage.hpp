// A stage from a JSON file: baked objects and media that rest or move rigidly under one distant light. prt/RUNTIME.md lists
// the keys; prt/runtime/relight_stage.hpp relights it. World axes: z up, right-handed.
#pragma once
#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "prt/light/light.hpp"
#include "prt/scene/camera.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {

/// The pose of an object: its point p (in its own axes) is at rotation p + position.
struct Pose {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  bool operator==(const Pose& other) const { return rotation == other.rotation && position == other.position; }
};

/// The poses of an object during a sequence, which runs from time 0 to 1.
struct Motion {
  struct Key {
    double time = 0.0;
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    double degrees = 0.0;  // right-handed about the axis
  };
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  // unit, through the object's origin
  std::vector<Key> keys{Key()};                     // one or more, with increasing times

  /// Position and angle are linear between keys, and constant before the first key and after the last one.
  [[nodiscard]] Pose at(double time) const;
};

struct Sphere {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double radius = 0.0;
};

struct StageObject {
  std::string name;  // for messages: the path of the transfer file as written in the stage
  std::string file;  // the path to it
  std::shared_ptr<const Transfer> transfer;
  Motion motion;
  Sphere proxy;  // in the object's axes; it blocks the light of other objects; a radius of 0 (of media) blocks nothing
  /// The space around the object, in its axes: it blocks the light of other objects in place of the proxy. Null: none.
  std::shared_ptr<const Transfer> volume;
  std::string volume_file;  // the path to it
  bool per_vertex = false;  // true: light is gathered at every vertex; false: once, at the proxy's center
  /// True: the light at the proxy's center is what the lit surfaces of the other objects and the sky around them send there,
  /// sampled for every frame. False: it is the distant light, less what the others block.
  bool from_scene = false;
};

struct Stage {
  std::string name;
  std::vector<StageObject> objects;
  std::vector<LightSpec> lights;
  std::optional<Camera> camera;
  std::vector<std::string> files;  // that it is read from, besides its own: transfer files, pictures
};

/// The sphere around the center of the mesh's bounding box that contains the mesh.
Sphere bounding_sphere(const Mesh& mesh);

/// A stage with one object at rest at the origin.
Stage stage_of(Transfer transfer);

/// Reads the stage and its transfer files, each file once. Relative paths start in `folder`, or in the folder of the
/// stage if `folder` is empty. Throws std::runtime_error with one line that names file and JSON path, or the transfer
/// file.
Stage load_stage(const std::string& file, const std::string& folder = {});

}  // namespace sh::prt
