// Frames of the study of the run time: what one costs, and what it shows, with the light and the view free or at rest.
#pragma once
#include <Eigen/Core>
#include <utility>

#include "prt/light/light_coefficients.hpp"
#include "prt/runtime/render.hpp"
#include "prt/study/study_setup.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {

/// Times are the least of so many.
inline constexpr int kFramePasses = 5;

/// Processor time of one thread, and what a picture shows of it. `surface` refers to the transfer.
struct ShownFrame {
  double seconds;
  double bytes;  // a vertex, that it reads
  Radiances at_vertices;
  Surface surface;
};

/// Frames under one light, seen from one point of the world. A transfer of lower degree takes the first bands of the light.
class Frames {
 public:
  Frames(LightCoefficients light, Eigen::Vector3d eye) : light_(std::move(light)), eye_(std::move(eye)) {}

  /// Light and view may change from frame to frame.
  [[nodiscard]] ShownFrame free(const Transfer& transfer) const;
  /// Only the view, or only the light, may change: of glossy transfer.
  [[nodiscard]] ShownFrame light_at_rest(const Transfer& transfer) const;
  [[nodiscard]] ShownFrame view_at_rest(const Transfer& transfer) const;

 private:
  [[nodiscard]] LightCoefficients light(const Transfer& transfer) const;
  [[nodiscard]] ShownFrame relit(const Transfer& rows, const Transfer& transfer) const;
  [[nodiscard]] ShownFrame shown(const Transfer& transfer, double seconds, double bytes) const;

  LightCoefficients light_;
  Eigen::Vector3d eye_;
};

}  // namespace sh::prt
