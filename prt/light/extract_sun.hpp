// Extracts the sun of a picture as an analytic cap; the level of its surroundings fills its place in the picture. In: a
// picture and its mapping. Out: a direction, a half-angle, a radiance, and the picture without its sun. In each
// channel, the sum of radiance times solid angle over cap and rest equals that of the picture, to rounding.
//   region   all pixels that are connected to the brightest pixel and brighter than `threshold` times it
//            (luminance), and the pixels around them, which the edge of the disc crosses
//   level    the mean of the pixels around the region, which is the sky without a sun; the region is cut to it
//   cap      direction: the centroid of the removed part; solid angle: its luminance over the peak, so that a disc of
//            even radiance is recovered although its edge crosses pixels; radiance: the removed part over that angle
#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>

#include "prt/image/environment.hpp"

namespace sh::prt {

struct SunOptions {
  double threshold = 0.1;    // of the peak, 0..1
  double contrast = 10.0;    // least ratio of the sun's peak to the level around it
  double half_angle = 10.0;  // degrees; largest half-angle of a sun
};

struct ExtractedSun {
  Eigen::Vector3d direction;   // unit
  double one_minus_cos = 0.0;  // of the half-angle
  Eigen::Vector3d radiance;    // linear RGB, in the picture's unit
  double energy_share = 0.0;   // of the luminance over the sphere
  std::size_t pixels = 0;      // of the region
  Image rest;
};

/// The sun, or the reason why there is none, such as `the brightest place is 2.1 times its surroundings; a sun is 10
/// times`.
struct SunSearch {
  std::optional<ExtractedSun> sun;
  std::string why_none;
};

SunSearch extract_sun(const Image& image, ImageMapping mapping, const SunOptions& options = {});

/// `sun at elevation 31.2, azimuth -12.5 degrees, half-angle 0.27 degrees, radiance 4e+04 4e+04 3.8e+04, 61 % of the
/// picture's light, 9 pixels`.
std::string describe(const ExtractedSun& sun);

}  // namespace sh::prt
