// A lit scene in which light is sampled: for light-at and probes.
#pragma once
#include <string>
#include <vector>

#include "prt/commands/subject.hpp"
#include "prt/runtime/sampled_light.hpp"

namespace sh::prt {

struct LitPlaceOptions {
  SubjectOptions subject;  // its file may also be a scene, which is baked first
  int degree = 2;          // of the light, 0..kMaxDegree
  CubeSize size;
  double time = 0.0;  // of a stage that moves, 0..1

  void add_to(CLI::App& command);
};

/// A subject at one time, ready for rays.
class LitPlace {
 public:
  /// Throws one line for options out of range and for input that cannot be read, like Subject and bake.
  explicit LitPlace(const LitPlaceOptions& options);

  [[nodiscard]] LightSampler sampler(const CubeSize& size) const {
    return {mesh_, tracer_, surface_, subject_.lights(), size};
  }
  [[nodiscard]] const Mesh& mesh() const { return mesh_; }
  [[nodiscard]] const Subject& subject() const { return subject_; }

 private:
  Subject subject_;
  std::vector<Pose> poses_;
  Mesh mesh_;
  Tracer tracer_;
  Surface surface_;
};

}  // namespace sh::prt
