#include "prt/light/extract_sun.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "numeric/sampling/solid_angle.hpp"

namespace sh::prt {
namespace {

constexpr double kPi = std::numbers::pi;
using Pixels = std::set<std::size_t>;

double luminance(const Eigen::Vector3f& color) {  // Rec. 709
  return 0.2126 * static_cast<double>(color.x()) + 0.7152 * static_cast<double>(color.y()) +
         0.0722 * static_cast<double>(color.z());
}

/// The directions and solid angles of a picture's pixels.
class Mosaic {
 public:
  Mosaic(const Image& image, ImageMapping mapping) : image_(image), mapping_(mapping) {}

  [[nodiscard]] double solid_angle(std::size_t i) const {
    const int row = static_cast<int>(i / width());
    if (mapping_ == ImageMapping::kLatLong) return numeric::lat_long_solid_angle(row, image_.width, image_.height);
    pixel_nodes(mapping_, image_.width, static_cast<int>(i % width()), row, nodes_);
    double sum = 0.0;
    for (const PixelNode& node : nodes_) sum += node.weight;
    return sum;
  }

  /// The direction of the pixel's center; empty if the picture shows nothing there.
  [[nodiscard]] std::optional<Eigen::Vector3d> direction(std::size_t i) const {
    const std::size_t row = i / width();
    return mapped_direction(mapping_, (static_cast<double>(i % width()) + 0.5) / image_.width,
                            (static_cast<double>(row) + 0.5) / image_.height);
  }

  /// The neighbors of a pixel on the sphere, also across seams, edges and poles.
  [[nodiscard]] Pixels around(std::size_t i) const {
    Pixels out;
    const auto middle = direction(i);
    if (!middle) return out;
    const Eigen::Vector3d u = middle->unitOrthogonal();
    const Eigen::Vector3d v = middle->cross(u);
    const double reach = 1.1 * pixel_edge(i);
    for (int k = 0; k < 16; ++k) {
      const double angle = kPi * k / 8.0;
      const Eigen::Vector3d d = (*middle + reach * (std::cos(angle) * u + std::sin(angle) * v)).normalized();
      out.insert(at(mapped_place(mapping_, d)));
    }
    const auto column = static_cast<int>(i % width());
    for (const int beside : {column - 1, column + 1}) {  // thin pixels at the poles of a lat-long picture
      if (mapping_ == ImageMapping::kLatLong) {
        out.insert(i - i % width() + static_cast<std::size_t>((beside + image_.width) % image_.width));
      }
    }
    out.erase(i);
    return out;
  }

 private:
  [[nodiscard]] std::size_t width() const { return static_cast<std::size_t>(image_.width); }

  [[nodiscard]] double pixel_edge(std::size_t i) const {
    return mapping_ == ImageMapping::kLatLong ? kPi / image_.height : std::sqrt(std::max(solid_angle(i), 1e-12));
  }

  [[nodiscard]] std::size_t at(const Eigen::Vector2d& place) const {
    const int column = std::clamp(static_cast<int>(place.x() * image_.width), 0, image_.width - 1);
    const int row = std::clamp(static_cast<int>(place.y() * image_.height), 0, image_.height - 1);
    return row * width() + column;
  }

  const Image& image_;
  ImageMapping mapping_;
  mutable std::vector<PixelNode> nodes_;
};

/// The neighbors of a set of pixels, without the set.
Pixels rim_of(const Pixels& set, const Mosaic& mosaic) {
  Pixels rim;
  for (const std::size_t i : set) {
    for (const std::size_t j : mosaic.around(i)) {
      if (!set.contains(j)) rim.insert(j);
    }
  }
  return rim;
}

/// All pixels that are connected to the first and at least as bright as `least`, up to `most` steradian.
Pixels grown(const Image& image, const Mosaic& mosaic, std::size_t first, double least, double most) {
  Pixels region{first};
  std::vector<std::size_t> open{first};
  double size = mosaic.solid_angle(first);
  while (!open.empty() && size <= most) {
    const std::size_t i = open.back();
    open.pop_back();
    for (const std::size_t j : mosaic.around(i)) {
      if (luminance(image.pixels[j]) >= least && region.insert(j).second) {
        open.push_back(j);
        size += mosaic.solid_angle(j);
      }
    }
  }
  return region;
}

double luminance_total(const Image& image, const Mosaic& mosaic) {
  double sum = 0.0;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) sum += luminance(image.pixels[i]) * mosaic.solid_angle(i);
  return sum;
}

Eigen::Vector3f mean(const Image& image, const Mosaic& mosaic, const Pixels& pixels) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double size = 0.0;
  for (const std::size_t i : pixels) {
    sum += mosaic.solid_angle(i) * image.pixels[i].cast<double>();
    size += mosaic.solid_angle(i);
  }
  return (size > 0.0 ? Eigen::Vector3d(sum / size) : sum).cast<float>();
}

/// Cuts the region down to the level; the cap gets the removed part.
ExtractedSun cut_off(const Image& image, const Mosaic& mosaic, const Pixels& region, const Eigen::Vector3f& level,
                     double peak) {
  ExtractedSun sun;
  sun.rest = image;
  sun.pixels = region.size();
  Eigen::Vector3d energy = Eigen::Vector3d::Zero();
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  double bright = 0.0;
  for (const std::size_t i : region) {
    sun.rest.pixels[i] = image.pixels[i].cwiseMin(level);
    const Eigen::Vector3f excess = image.pixels[i] - sun.rest.pixels[i];
    const double size = mosaic.solid_angle(i);
    energy += size * excess.cast<double>();
    bright += size * luminance(excess);
    centroid += size * luminance(excess) * mosaic.direction(i).value_or(Eigen::Vector3d::Zero());
  }
  const double solid_angle = bright / (peak - luminance(level));
  sun.direction = centroid.normalized();
  sun.one_minus_cos = solid_angle / (2.0 * kPi);
  sun.radiance = energy / solid_angle;
  sun.energy_share = bright / luminance_total(image, mosaic);
  return sun;
}

}  // namespace

SunSearch extract_sun(const Image& image, ImageMapping mapping, const SunOptions& options) {
  const Mosaic mosaic(image, mapping);
  std::size_t first = 0;
  double peak = 0.0;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    if (luminance(image.pixels[i]) > peak && mosaic.direction(i)) {
      first = i;
      peak = luminance(image.pixels[i]);
    }
  }
  if (!(peak > 0.0)) return {std::nullopt, "the picture is black"};
  const double most = 4.0 * kPi * std::pow(std::sin(kPi / 360.0 * options.half_angle), 2.0);
  Pixels region = grown(image, mosaic, first, options.threshold * peak, most);
  double size = 0.0;
  for (const std::size_t i : region) size += mosaic.solid_angle(i);
  if (size > most && region.size() > 1) {
    return {std::nullopt,
            fmt::format("the region around the brightest place that is brighter than {} of it is larger than a "
                        "disc of half-angle {} degrees",
                        options.threshold, options.half_angle)};
  }
  region.merge(rim_of(region, mosaic));
  const Eigen::Vector3f level = mean(image, mosaic, rim_of(region, mosaic));
  if (!(peak >= options.contrast * luminance(level))) {
    return {std::nullopt, fmt::format("the brightest place is {:.3g} times its surroundings; a sun is {:g} times",
                                      peak / luminance(level), options.contrast)};
  }
  return {cut_off(image, mosaic, region, level, peak), ""};
}

std::string describe(const ExtractedSun& sun) {
  const Eigen::Vector3d& d = sun.direction;
  return fmt::format(
      "sun at elevation {:.2f}, azimuth {:.2f} degrees, half-angle {:.3g} degrees, radiance {:.4g} {:.4g} {:.4g}, "
      "{:.1f} % of the picture's light, {} pixels",
      180.0 / kPi * std::asin(std::clamp(d.z(), -1.0, 1.0)), 180.0 / kPi * std::atan2(d.y(), d.x()),
      360.0 / kPi * std::asin(std::sqrt(0.5 * sun.one_minus_cos)), sun.radiance.x(), sun.radiance.y(), sun.radiance.z(),
      100.0 * sun.energy_share, sun.pixels);
}

}  // namespace sh::prt
