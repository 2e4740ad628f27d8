// What `prt render` shows: a baked mesh, a stage, or a medium.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "prt/commands/subject.hpp"
#include "prt/runtime/render.hpp"

namespace sh::prt {

class Shown {
 public:
  Shown() = default;
  virtual ~Shown() = default;
  Shown(const Shown&) = delete;
  Shown& operator=(const Shown&) = delete;

  [[nodiscard]] virtual const std::vector<Light>& lights() const = 0;
  [[nodiscard]] virtual Turntable turntable() const = 0;  // unless the user names one
  /// Throws std::runtime_error if `output` is one of the files that it is read from.
  virtual void require_no_input(const std::string& output) const = 0;
  /// Moves everything to a time, 0..1, and gives the camera of the first time.
  virtual const Camera& place(double time) = 0;
  /// At the time of the last place().
  [[nodiscard]] virtual Picture picture(const View& view, const Background& background, const std::string& what) = 0;
  /// The exposure is that of pixels which are covered by no less than this part.
  [[nodiscard]] virtual float least_coverage() const { return 1.0F; }
};

/// A medium, if the subject's file is one.
std::unique_ptr<Shown> shown_medium(const SubjectOptions& options, const PictureSize& size);

}  // namespace sh::prt
