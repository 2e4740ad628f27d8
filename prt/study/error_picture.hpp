// Shows errors of a mesh or a picture as colors: a logarithmic scale from dark to bright, the same in every picture, with a color bar.
//   1e-4 of the reference's root mean square, or less: nearly black; 1e-3 violet; 1e-2 red; 1e-1 orange; 1 or more:
//   pale yellow.
// Lightness rises evenly, so that the order is visible in gray and with any color vision.
#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "numeric/plot/color.hpp"
#include "prt/mesh/mesh.hpp"
#include "prt/rays/tracer.hpp"
#include "prt/scene/camera.hpp"

namespace sh::prt {

inline constexpr double kLeastShownError = 1e-4;
inline constexpr double kMostShownError = 1.0;

/// The place of an error on the scale: 0 up to kLeastShownError, 1 from kMostShownError on, logarithmic in between; 1
/// for NaN.
float error_place(double relative_error);

/// The color at a place, which is clamped to 0..1.
numeric::plot::Color false_color(double place);

/// The places of errors (height, width), and the part of each pixel that they cover (height, width); the rest is gray.
struct ErrorMap {
  int width = 0;
  int height = 0;
  std::vector<float> place;
  std::vector<float> coverage;
};

/// The bytes of a PNG file: the map with its title above and the scale below, at least sixteen pixels wide.
std::string error_png(const ErrorMap& map, const std::string& title);

/// The bytes of a PNG file: the errors of the vertices of a mesh, interpolated over faces on the logarithmic scale.
/// Progress is labeled `what`.
std::string error_picture(const Mesh& mesh, const Tracer& tracer, const std::vector<float>& relative_errors,
                          const Camera& camera, const PictureSize& size, const std::string& title,
                          const std::string& what);

}  // namespace sh::prt
