#include "prt/runtime/sampled_light.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "prt/angles.hpp"
#include "prt/chunks.hpp"
#include "prt/image/environment.hpp"
#include "prt/rays/mirror_paths.hpp"

namespace sh::prt {
namespace {

constexpr double kSmallCap = 0.0038;  // 1 - cos of 5 degrees: it covers about one pixel of the paper's pictures
constexpr int kCapRays = 64;
constexpr int kLookups = 256;  // of the distant light along a face

bool is_near(const Light& light) { return varies({light}); }

bool is_small(const Light& light) {
  return light.spec.type == LightType::kDirectional ||
         (light.spec.type == LightType::kCap && light.spec.one_minus_cos <= kSmallCap);
}

// Directions that fill a cap evenly: a spiral of equal areas. One direction is the cap's middle.
std::vector<Eigen::Vector3f> cap_directions(const Light& light) {
  const Eigen::Vector3d middle = light.rotation * light.spec.direction;
  if (light.spec.type == LightType::kDirectional) return {middle.cast<float>()};
  const Eigen::Matrix3d axes = frame_about(middle);
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

// A pixel of one of the faces.
struct Pixel {
  const CubeFace& face;
  int column;
  int row;
  int pixels;  // along the face

  [[nodiscard]] std::size_t index() const { return std::size_t(row) * 6 * pixels + face.column * pixels + column; }
  /// Calls visit(unit direction, weight) for parts x parts places; the weight is the solid angle, but for a factor.
  template <class Visit>
  void for_parts(int parts, const Visit& visit) const {
    for (int j = 0; j < parts; ++j) {
      for (int i = 0; i < parts; ++i) {
        const double s = (column + (i + 0.5) / parts) / pixels;
        const double t = (row + (j + 0.5) / parts) / pixels;
        const double x = 2.0 * s - 1.0;
        const double y = 2.0 * t - 1.0;
        visit(face.direction(s, t), std::pow(1.0 + x * x + y * y, -1.5));
      }
    }
  }
};

// Calls each(row of all faces, pixel) for every pixel; rows in parallel.
template <class Each>
void for_pixels(int pixels, const Each& each) {
  in_parallel(0, 6 * pixels, [&](int row) {
    const CubeFace& face = numeric::cube_faces(ImageMapping::kCubeStrip)[std::size_t(row / pixels)];
    for (int column = 0; column < pixels; ++column) each(row, Pixel{face, column, row % pixels, pixels});
  });
}

Eigen::Vector3d mean_of(const std::vector<Light>& lights, const Pixel& pixel, int parts) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double weight = 0.0;
  pixel.for_parts(parts, [&](const Eigen::Vector3d& direction, double part) {
    sum += part * radiance(lights, direction).cast<double>();
    weight += part;
  });
  return sum / weight;
}

int lookups(const CubeSize& size) { return std::max(size.samples, kLookups / size.face); }

}  // namespace

void require_size(const CubeSize& size) {
  const auto require = [](const char* what, int value, int most) {
    if (value < 1 || value > most) {
      throw std::invalid_argument(fmt::format("{} {}: expected 1 to {}", what, value, most));
    }
  };
  require("pixels along a face", size.face, kMostFacePixels);
  require("rays along a pixel", size.samples, kMostPixelRays);
}

// What one point sees.
class CubeView {
 public:
  CubeView(const LightSampler& scene, const Eigen::Vector3d& point)
      : scene_(scene), mirrors_(scene.mesh_, scene.tracer_), small_(scene.small_), wide_(scene.far_) {
    eye_ = scene.tracer_.start(point);
    for (const Light& light : seen_from(scene.near_, point)) (is_small(light) ? small_ : near_).push_back(light);
    wide_.insert(wide_.end(), near_.begin(), near_.end());
  }

  SampledLight run(int degree) {
    const int pixels = scene_.size_.face;
    Image faces{6 * pixels, pixels, std::vector<Eigen::Vector3f>(std::size_t(6) * pixels * pixels)};
    std::vector<Sums> sums(std::size_t(6) * pixels);
    for_pixels(pixels, [&](int row, const Pixel& pixel) { faces.pixels[pixel.index()] = seen(pixel, sums[row]); });
    Sums all;
    for (const Sums& of_row : sums) all += of_row;  // in order, for any number of threads
    SampledLight result;
    result.surface_share = all.hits / all.weight;
    result.back_share = all.hits > 0.0 ? all.backs / all.hits : 0.0;
    result.light = project_image(faces, ImageMapping::kCubeStrip, degree);
    for (const Light& light : small_) add_small(light, result.light);
    return result;
  }

 private:
  Eigen::Vector3f seen(const Pixel& pixel, Sums& sums) const {
    std::vector<Eigen::Vector3f> directions;
    std::vector<double> weights;
    pixel.for_parts(scene_.size_.samples, [&](const Eigen::Vector3d& direction, double weight) {
      directions.emplace_back(direction.cast<float>());
      weights.push_back(weight);
    });
    const std::vector<Hit> hits = traced(directions);
    const std::vector<Eigen::Vector3f> radiance = radiance_along(directions, hits);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double weight = 0.0;
    double missed = 0.0;
    for (std::size_t k = 0; k < hits.size(); ++k) {
      weight += weights[k];
      if (hits[k].face == Hit::kNothing) {
        missed += weights[k];
        continue;
      }
      sum += weights[k] * radiance[k].cast<double>();
      sums.hits += weights[k];
      if (is_back(hits[k], directions[k])) sums.backs += weights[k];
    }
    sums.weight += weight;
    if (missed > 0.0) sum += missed * distant(pixel);
    return (sum / weight).cast<float>();
  }

  [[nodiscard]] Eigen::Vector3d distant(const Pixel& pixel) const {
    const Eigen::Vector3d& far = scene_.distant_[pixel.index()];
    return near_.empty() ? far : far + mean_of(near_, pixel, lookups(scene_.size_));
  }

  [[nodiscard]] std::vector<Hit> traced(const std::vector<Eigen::Vector3f>& directions) const {
    std::vector<Hit> hits(directions.size());
    scene_.tracer_.intersect(std::vector<Eigen::Vector3f>(directions.size(), eye_), directions, hits);
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
      out[leg.ray] += leg.throughput.cwiseProduct(hit ? scene_.surface_(leg.hit, leg.direction)
                                                      : radiance(wide_, leg.direction.cast<double>()));
    }
    return out;
  }

  [[nodiscard]] bool is_back(const Hit& hit, const Eigen::Vector3f& direction) const {
    const Mesh& mesh = scene_.mesh_;
    const Face& face = mesh.faces[hit.face];
    const Eigen::Vector3f& a = mesh.positions[face[0]];
    return (mesh.positions[face[1]] - a).cross(mesh.positions[face[2]] - a).dot(direction) > 0.0F;
  }

  void add_small(const Light& light, LightCoefficients& sum) const {
    const std::vector<Hit> hits = traced(cap_directions(light));
    const auto visible =
        std::count_if(hits.begin(), hits.end(), [](const Hit& hit) { return hit.face == Hit::kNothing; });
    if (visible == 0) return;
    LightCoefficients whole = project(std::vector<Light>{light}, sum.degree);
    for (double& value : whole.values) value *= static_cast<double>(visible) / static_cast<double>(hits.size());
    accumulate(sum, whole);
  }

  const LightSampler& scene_;
  MirrorPaths mirrors_;
  Eigen::Vector3f eye_;
  std::vector<Light> small_;
  std::vector<Light> near_;
  std::vector<Light> wide_;  // far_ and near_
};

LightSampler::LightSampler(const Mesh& mesh, const Tracer& tracer, Surface surface, const std::vector<Light>& lights,
                           const CubeSize& size)
    : mesh_(mesh), tracer_(tracer), surface_(std::move(surface)), size_(size) {
  require_size(size);
  for (const Light& light : lights) (is_near(light) ? near_ : is_small(light) ? small_ : far_).push_back(light);
  distant_.assign(std::size_t(6) * size.face * size.face, Eigen::Vector3d::Zero());
  if (far_.empty()) return;
  for_pixels(size.face,
             [&](int /*row*/, const Pixel& pixel) { distant_[pixel.index()] = mean_of(far_, pixel, lookups(size)); });
}

SampledLight LightSampler::at(const Eigen::Vector3d& point, int degree) const {
  require_degree(degree);
  return CubeView(*this, point).run(degree);
}

}  // namespace sh::prt
