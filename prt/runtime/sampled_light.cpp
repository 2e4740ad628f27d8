#include "prt/runtime/sampled_light.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "prt/chunks.hpp"
#include "prt/image/environment.hpp"
#include "prt/rays/mirror_paths.hpp"

namespace sh::prt {
namespace {

constexpr double kSmallCap = 0.0038;  // 1 - cos of 5 degrees: it covers about one pixel of the paper's pictures
constexpr int kCapRays = 64;
constexpr int kLookups = 256;  // of the distant light along a face

bool is_small(const Light& light) {
  return light.spec.type == LightType::kDirectional ||
         (light.spec.type == LightType::kCap && light.spec.one_minus_cos <= kSmallCap);
}

// Directions that fill a cap evenly: a spiral of equal areas. One direction is the cap's middle.
std::vector<Eigen::Vector3f> cap_directions(const Light& light) {
  const Eigen::Vector3d middle = light.rotation * light.spec.direction;
  if (light.spec.type == LightType::kDirectional) return {middle.cast<float>()};
  const Eigen::Matrix3d axes = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), middle).toRotationMatrix();
  const double turn = std::numbers::pi * (3.0 - std::sqrt(5.0));
  std::vector<Eigen::Vector3f> directions;
  for (int k = 0; k < kCapRays; ++k) {
    const double below_pole = light.spec.one_minus_cos * (k + 0.5) / kCapRays;
    const double radius = std::sqrt(below_pole * (2.0 - below_pole));
    const Eigen::Vector3d local(radius * std::cos(k * turn), radius * std::sin(k * turn), 1.0 - below_pole);
    directions.emplace_back((axes * local).cast<float>());
  }
  return directions;
}

class CubeView {
 public:
  CubeView(const Mesh& mesh, const Tracer& tracer, const Surface& surface, const std::vector<Light>& lights,
           const Eigen::Vector3d& point, const CubeSize& size)
      : mesh_(mesh), tracer_(tracer), surface_(surface), mirrors_(mesh, tracer), size_(size) {
    eye_ = tracer.frame().local(point).cast<float>();
    for (const Light& light : seen_from(lights, point)) (is_small(light) ? small_ : wide_).push_back(light);
    result_.faces.width = 6 * size.face;
    result_.faces.height = size.face;
    result_.faces.pixels.resize(std::size_t(6) * size.face * size.face);
  }

  SampledLight run(int degree) {
    const int rows = 6 * size_.face;
    std::vector<Sums> sums(rows);
    in_parallel(0, rows, [&](int row) { sums[row] = draw_row(row / size_.face, row % size_.face); });
    Sums all;
    for (const Sums& of_row : sums) all += of_row;  // in order, for any number of threads
    result_.surface_share = all.hits / all.weight;
    result_.back_share = all.hits > 0.0 ? all.backs / all.hits : 0.0;
    result_.light = project_image(result_.faces, ImageMapping::kCubeStrip, degree);
    for (const Light& light : small_) add_small(light, degree);
    return std::move(result_);
  }

 private:
  struct Sums {
    double weight = 0.0;  // of all rays, by solid angle
    double hits = 0.0;
    double backs = 0.0;
    void operator+=(const Sums& more) {
      weight += more.weight;
      hits += more.hits;
      backs += more.backs;
    }
  };

  // The place of a part of a pixel on its face, and its solid angle but for a factor.
  struct Place {
    Eigen::Vector3f direction;
    double weight;
  };
  static Place place(const CubeFace& face, double s, double t) {
    const double x = 2.0 * s - 1.0;
    const double y = 2.0 * t - 1.0;
    return {face.direction(s, t).cast<float>(), std::pow(1.0 + x * x + y * y, -1.5)};
  }

  Sums draw_row(int face_number, int row) {
    const CubeFace& face = numeric::cube_faces(ImageMapping::kCubeStrip)[std::size_t(face_number)];
    Sums sums;
    for (int column = 0; column < size_.face; ++column) {
      const std::size_t pixel = std::size_t(row) * result_.faces.width + face.column * size_.face + column;
      result_.faces.pixels[pixel] = pixel_radiance(face, column, row, sums);
    }
    return sums;
  }

  // Calls visit(place) for parts x parts places of a pixel.
  template <class Visit>
  void for_places(const CubeFace& face, int column, int row, int parts, const Visit& visit) const {
    const double pixels = size_.face;
    for (int j = 0; j < parts; ++j) {
      for (int i = 0; i < parts; ++i) {
        visit(place(face, (column + (i + 0.5) / parts) / pixels, (row + (j + 0.5) / parts) / pixels));
      }
    }
  }

  Eigen::Vector3f pixel_radiance(const CubeFace& face, int column, int row, Sums& sums) const {
    std::vector<Eigen::Vector3f> directions;
    std::vector<double> weights;
    for_places(face, column, row, size_.samples, [&](const Place& at) {
      directions.push_back(at.direction);
      weights.push_back(at.weight);
    });
    const std::vector<Hit> hits = traced(directions);
    const std::vector<Eigen::Vector3f> seen = radiance_along(directions, hits);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double weight = 0.0;
    double missed = 0.0;
    for (std::size_t k = 0; k < hits.size(); ++k) {
      weight += weights[k];
      if (hits[k].face == Hit::kNothing) {
        missed += weights[k];
        continue;
      }
      sum += weights[k] * seen[k].cast<double>();
      sums.hits += weights[k];
      if (is_back(hits[k], directions[k])) sums.backs += weights[k];
    }
    sums.weight += weight;
    if (missed > 0.0) sum += missed * distant_mean(face, column, row);
    return (sum / weight).cast<float>();
  }

  [[nodiscard]] Eigen::Vector3d distant_mean(const CubeFace& face, int column, int row) const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double weight = 0.0;
    for_places(face, column, row, std::max(size_.samples, kLookups / size_.face), [&](const Place& at) {
      sum += at.weight * radiance(wide_, at.direction.cast<double>()).cast<double>();
      weight += at.weight;
    });
    return sum / weight;
  }

  [[nodiscard]] std::vector<Hit> traced(const std::vector<Eigen::Vector3f>& directions) const {
    std::vector<Hit> hits(directions.size());
    tracer_.intersect(std::vector<Eigen::Vector3f>(directions.size(), eye_), directions, hits);
    return hits;
  }

  // Also over mirrors, in which small lights do not show.
  [[nodiscard]] std::vector<Eigen::Vector3f> radiance_along(const std::vector<Eigen::Vector3f>& directions,
                                                            const std::vector<Hit>& hits) const {
    std::vector<Leg> legs;
    for (std::uint32_t k = 0; k < hits.size(); ++k) {
      if (hits[k].face != Hit::kNothing) legs.push_back({eye_, directions[k], hits[k], k});
    }
    mirrors_.follow(legs);
    std::vector<Eigen::Vector3f> out(hits.size(), Eigen::Vector3f::Zero());
    for (const Leg& leg : legs) {
      const bool hit = leg.hit.face != Hit::kNothing;
      out[leg.ray] += leg.throughput.cwiseProduct(hit ? surface_(leg.hit, leg.direction)
                                                      : radiance(wide_, leg.direction.cast<double>()));
    }
    return out;
  }

  [[nodiscard]] bool is_back(const Hit& hit, const Eigen::Vector3f& direction) const {
    const Face& face = mesh_.faces[hit.face];
    const Eigen::Vector3f& a = mesh_.positions[face[0]];
    return (mesh_.positions[face[1]] - a).cross(mesh_.positions[face[2]] - a).dot(direction) > 0.0F;
  }

  void add_small(const Light& light, int degree) {
    const std::vector<Hit> hits = traced(cap_directions(light));
    const auto visible =
        std::count_if(hits.begin(), hits.end(), [](const Hit& hit) { return hit.face == Hit::kNothing; });
    if (visible == 0) return;
    LightCoefficients whole = project(std::vector<Light>{light}, degree);
    for (double& value : whole.values) value *= static_cast<double>(visible) / static_cast<double>(hits.size());
    accumulate(result_.light, whole);
  }

  const Mesh& mesh_;
  const Tracer& tracer_;
  const Surface& surface_;
  MirrorPaths mirrors_;
  CubeSize size_;
  Eigen::Vector3f eye_;
  std::vector<Light> small_;
  std::vector<Light> wide_;
  SampledLight result_;
};

void require_size(const CubeSize& size) {
  const auto require = [](const char* what, int value, int most) {
    if (value < 1 || value > most) {
      throw std::invalid_argument(fmt::format("{} {}: expected 1 to {}", what, value, most));
    }
  };
  require("pixels along a face", size.face, kMostFacePixels);
  require("rays along a pixel", size.samples, kMostPixelRays);
}

}  // namespace

SampledLight sampled_light(const Mesh& mesh, const Tracer& tracer, const Surface& surface,
                           const std::vector<Light>& lights, const Eigen::Vector3d& point, const CubeSize& size,
                           int degree) {
  require_size(size);
  require_degree(degree);
  SampledLight result = CubeView(mesh, tracer, surface, lights, point, size).run(degree);
  if (result.back_share > 0.5) {
    throw std::invalid_argument(fmt::format(
        "the point ({:.6g}, {:.6g}, {:.6g}): {:.0f} % of the surfaces that it sees are backs; expected a point "
        "outside of solids",
        point.x(), point.y(), point.z(), 100.0 * result.back_share));
  }
  return result;
}

}  // namespace sh::prt
