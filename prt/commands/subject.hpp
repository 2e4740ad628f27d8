// What `relight` and `render` show: a transfer file, or a stage of several that move, under a light.
#pragma once
#include <set>
#include <string>
#include <vector>

#include "prt/commands/commands.hpp"
#include "prt/runtime/relight_stage.hpp"
#include "prt/runtime/shading.hpp"
#include "prt/scene/stage.hpp"

namespace sh::prt {

struct SubjectOptions {
  std::string file;       // a transfer file, or a stage where it ends in .json
  std::string transfers;  // folder of a stage's transfer files; empty: beside it
  LightOptions light;
  Shading shading;

  void add_to(CLI::App& command);
};

class Subject {
 public:
  /// The light and the camera are those the options name, else the stage's. Throws one line naming what cannot be read
  /// or does not fit. Tells of transfer that a limited time left coarser than was asked for.
  explicit Subject(const SubjectOptions& options);
  Subject(const Subject&) = delete;
  Subject& operator=(const Subject&) = delete;

  [[nodiscard]] bool is_stage() const { return is_stage_; }
  [[nodiscard]] const std::vector<Light>& lights() const { return lights_; }
  [[nodiscard]] const std::vector<Camera>& camera() const { return camera_; }  // none or one
  /// Tells of objects that overlap, of each pair once.
  [[nodiscard]] std::vector<Pose> poses_at(double time);
  [[nodiscard]] Mesh mesh(const std::vector<Pose>& poses) const { return merged_mesh(stage_, poses); }
  [[nodiscard]] std::vector<Eigen::Vector3f> radiance(const std::vector<Pose>& poses,
                                                      const Eigen::Matrix3d& light_turn) const {
    return lighting_.radiance(poses, light_turn);
  }

 private:
  void tell_once(const std::string& line);

  bool is_stage_;
  OnFlaw on_flaw_;
  Stage stage_;
  std::vector<Camera> camera_;
  std::vector<Light> lights_;
  StageLighting lighting_;
  std::set<std::string> told_;
};

}  // namespace sh::prt
