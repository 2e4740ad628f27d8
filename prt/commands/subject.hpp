// The subject of `relight` and `render` (a transfer file, or a stage of several moving objects, under a light), and the
// files of their frames.
#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "numeric/output/webp.hpp"
#include "prt/commands/commands.hpp"
#include "prt/runtime/glossy.hpp"
#include "prt/runtime/local_relight.hpp"
#include "prt/runtime/relight_stage.hpp"
#include "prt/runtime/shading.hpp"
#include "prt/runtime/sharp_layer.hpp"
#include "prt/scene/stage.hpp"

namespace sh::prt {

struct SubjectOptions {
  std::string file;       // a transfer file, or a stage if it ends in .json
  std::string transfers;  // folder of a stage's transfer files; empty: beside it
  LightOptions light;
  Shading shading;
  bool sharp = false;  // lobes show more of the light than the transfer holds
  std::string local;   // empty: light is sampled once, at each light's `from`; else a number of points, or octahedron
  std::vector<std::string> without;  // names of a stage's objects that are not there

  void add_to(CLI::App& command);
};

class Subject {
 public:
  /// Light and camera come from the options, else from the stage. Throws one line that names the input that cannot be
  /// read or does not fit. Prints a message if a time limit made the transfer coarser than requested, or if `--local`
  /// has no effect.
  explicit Subject(const SubjectOptions& options);
  /// The same of transfer that is in memory; the options' file is its name for messages.
  Subject(const SubjectOptions& options, Transfer transfer);
  Subject(const Subject&) = delete;
  Subject& operator=(const Subject&) = delete;

  [[nodiscard]] bool is_stage() const { return is_stage_; }
  /// That of the file, or of the first object of a stage.
  [[nodiscard]] const Transfer& transfer() const { return *stage_.objects.front().transfer; }
  [[nodiscard]] const std::vector<Light>& lights() const { return chosen_.lights; }
  [[nodiscard]] const std::optional<Camera>& camera() const { return chosen_.camera; }
  /// Throws std::runtime_error if `output` is one of the files that this subject is read from.
  void require_no_input(const std::string& output) const;
  /// Prints a message about objects that overlap, once for each pair.
  [[nodiscard]] std::vector<Pose> poses_at(double time);
  [[nodiscard]] Mesh mesh(const std::vector<Pose>& poses) const { return merged_mesh(stage_, poses); }
  /// Whether exit radiance depends on the direction of view.
  [[nodiscard]] bool is_glossy() const { return is_glossy_; }
  /// Exit radiance of the vertices, of glossy ones towards the point `eye` of the world. With `--local`, a near light
  /// turns about its `from`. Throws std::runtime_error if it exceeds single precision.
  [[nodiscard]] std::vector<Eigen::Vector3f> radiance(const std::vector<Pose>& poses, const Eigen::Matrix3d& light_turn,
                                                      const Eigen::Vector3d& eye) const;
  /// The albedo of the vertices of transfer(), by the user's choice.
  [[nodiscard]] std::vector<Eigen::Vector3f> albedo() const { return shading_.albedo(transfer().mesh); }
  /// The radiance that reaches the vertices of a glossy transfer file.
  [[nodiscard]] TransferredRadiance reaching(const Eigen::Matrix3d& light_turn) const;
  /// What a picture of mesh(poses) shows. This object must outlive it.
  [[nodiscard]] Surface surface(const std::vector<Pose>& poses, const Eigen::Matrix3d& light_turn) const;
  /// The same with the media before it, as an eye sees them; no veil without any. Throws like radiance().
  struct Seen {
    Surface surface;
    Veil veil;
  };
  [[nodiscard]] Seen seen(const std::vector<Pose>& poses, const Eigen::Matrix3d& light_turn,
                          const Eigen::Vector3d& eye) const;
  [[nodiscard]] bool has_media() const;

 private:
  Subject(const SubjectOptions& options, bool is_stage, Stage stage);
  [[nodiscard]] std::vector<Eigen::Vector3f> local_radiance(const Eigen::Matrix3d& light_turn) const;
  [[nodiscard]] Surface surface(const LitStage& stage, const std::vector<Pose>& poses,
                                const Eigen::Matrix3d& light_turn) const;
  [[nodiscard]] Veil veil(const LitStage& stage, const std::vector<Pose>& poses, const Eigen::Vector3d& eye) const;
  /// What an object shows to rays in its own axes.
  [[nodiscard]] Surface object_surface(const LitStage& stage, std::size_t index,
                                       const Eigen::Matrix3d& light_turn) const;
  /// The albedo that pictures of an object's mesh show.
  [[nodiscard]] SurfaceColors colors(const Mesh& mesh) const;
  void make_sharp();
  void tell_once(const std::string& line);

  std::string file_;
  bool is_stage_;
  bool is_glossy_ = false;
  OnFlaw on_flaw_;
  Shading shading_;
  Stage stage_;
  ChosenLight chosen_;
  StageLighting lighting_;
  std::optional<LightSamples> local_;  // of `--local`
  std::optional<SharpLayer> sharp_;    // of `--sharp`
  std::set<std::string> told_;
  mutable std::map<const Mesh*, DecodedPictures> pictures_;  // of objects that were shown
};

/// Throws std::invalid_argument unless 1 <= frames <= 1000, so that frame numbers have three digits.
void require_frames(int frames);

/// out.png -> out_000.png, ...; a single frame keeps its name.
std::string frame_name(const std::string& output, int frame, int frames);

struct AnimationOptions {
  double frames_a_second = 24.0;
  int quality = 90;  // 100: lossless
};

/// Writes one PNG file for each frame, or one WebP file with all frames if `output` ends in .webp.
class PictureFiles {
 public:
  /// Throws if the first file cannot be written or has a name of another format, or if the options are invalid.
  PictureFiles(std::string output, int frames, int width, int height, const AnimationOptions& options);
  /// The file to which frame `frame` is written.
  [[nodiscard]] std::string name(int frame) const;
  /// Adds the next frame, in 8-bit sRGB. Frames must come in order.
  void add(int frame, std::span<const std::uint8_t> rgb);
  void finish();

 private:
  std::string output_;
  int frames_;
  int width_;
  int height_;
  std::unique_ptr<output::AnimatedWebp> animation_;  // none: PNG files
};

}  // namespace sh::prt
