// The subject of `relight` and `render`: a transfer file, or a stage of several moving objects, under a light.
#pragma once
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "prt/commands/commands.hpp"
#include "prt/runtime/local_relight.hpp"
#include "prt/runtime/relight_stage.hpp"
#include "prt/runtime/shading.hpp"
#include "prt/scene/stage.hpp"

namespace sh::prt {

struct SubjectOptions {
  std::string file;       // a transfer file, or a stage if it ends in .json
  std::string transfers;  // folder of a stage's transfer files; empty: beside it
  LightOptions light;
  Shading shading;
  std::string local;  // empty: light is sampled once, at each light's `from`; else a number of points, or octahedron

  void add_to(CLI::App& command);
};

/// Samples near lights according to `--local` (prt/runtime/local_relight.hpp).
class LocalLighting {
 public:
  /// Stage and lights must outlive this object. Throws std::runtime_error, one line, if the option does not fit; prints
  /// a message if it has no effect.
  LocalLighting(const SubjectOptions& options, const Stage& stage, bool is_stage, const std::vector<Light>& lights);

  /// Exit radiance of the vertices. A near light turns about its `from`.
  [[nodiscard]] std::vector<Eigen::Vector3f> radiance(const Eigen::Matrix3d& light_turn) const;

 private:
  const Transfer& transfer_;
  const std::vector<Light>& lights_;
  Shading shading_;
  LightSamples samples_;
};

class Subject {
 public:
  /// Light and camera come from the options, else from the stage. Throws one line that names the input that cannot be
  /// read or does not fit. Prints a message if a time limit made the transfer coarser than requested.
  explicit Subject(const SubjectOptions& options);
  Subject(const Subject&) = delete;
  Subject& operator=(const Subject&) = delete;

  [[nodiscard]] bool is_stage() const { return is_stage_; }
  [[nodiscard]] const std::vector<Light>& lights() const { return lights_; }
  [[nodiscard]] const std::vector<Camera>& camera() const { return camera_; }  // none or one
  /// Prints a message about objects that overlap, once for each pair.
  [[nodiscard]] std::vector<Pose> poses_at(double time);
  [[nodiscard]] Mesh mesh(const std::vector<Pose>& poses) const { return merged_mesh(stage_, poses); }
  [[nodiscard]] std::vector<Eigen::Vector3f> radiance(const std::vector<Pose>& poses,
                                                      const Eigen::Matrix3d& light_turn) const {
    return local_ ? local_->radiance(light_turn) : lighting_.radiance(poses, light_turn);
  }

 private:
  void tell_once(const std::string& line);

  bool is_stage_;
  OnFlaw on_flaw_;
  Stage stage_;
  std::vector<Camera> camera_;
  std::vector<Light> lights_;
  StageLighting lighting_;
  std::optional<LocalLighting> local_;
  std::set<std::string> told_;
};

}  // namespace sh::prt
