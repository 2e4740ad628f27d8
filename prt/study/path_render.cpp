#include "prt/study/path_render.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

#include "generated/cpp/evaluate.hpp"
#include "numeric/output/progress.hpp"
#include "prt/angles.hpp"
#include "prt/chunks.hpp"
#include "prt/material/reflected.hpp"
#include "prt/mesh/corners.hpp"
#include "prt/runtime/glossy.hpp"
#include "prt/runtime/shading_normals.hpp"

namespace sh::prt {

namespace {

struct Path {
  std::size_t pixel;
  Hit hit;
  Eigen::Vector3f throughput;
  Eigen::Vector3f direction;  // of the ray that came to the hit
};

// Of the mesh's extent: keeps a ray off the face that it starts from, above the rounding of positions.
constexpr float kOffset = 1e-5F;

class PathTracer {
 public:
  PathTracer(const Mesh& mesh, const Tracer& tracer, const Background& sky)
      : mesh_(mesh),
        normals_(mesh),
        tracer_(tracer),
        sky_(sky),
        offset_(kOffset * bounding_box(mesh.positions).diagonal().norm()) {}

  /// Adds what the paths meet to the sums of their pixels.
  void follow(std::vector<Path> paths, std::mt19937& random, std::vector<Eigen::Vector3f>& sums) const {
    std::vector<Eigen::Vector3f> origins;
    std::vector<Eigen::Vector3f> directions;
    std::vector<Hit> hits;
    while (!paths.empty()) {
      origins.clear();
      directions.clear();
      std::size_t kept = 0;
      for (Path path : paths) {
        if (!mesh_.emission.empty()) {
          sums[path.pixel] += path.throughput.cwiseProduct(interpolated(path.hit, mesh_, mesh_.emission));
        }
        const Eigen::Vector3f direction = reflect(path, random);
        if (direction.dot(flat(path.hit)) <= 0.0F || !survives(path, random)) continue;
        origins.emplace_back(interpolated(path.hit, mesh_, mesh_.positions) + offset_ * flat(path.hit));
        directions.push_back(direction);
        paths[kept++] = path;
      }
      paths.resize(kept);
      hits.resize(kept);
      tracer_.intersect(origins, directions, hits);
      kept = 0;
      for (std::size_t i = 0; i < hits.size(); ++i) {
        if (hits[i].face == Hit::kNothing) {
          sums[paths[i].pixel] += paths[i].throughput.cwiseProduct(sky_(directions[i].normalized()));
        } else if (flat(hits[i]).dot(directions[i]) < 0.0F) {
          paths[kept++] = {paths[i].pixel, hits[i], paths[i].throughput, directions[i]};
        }
      }
      paths.resize(kept);
    }
  }

 private:
  [[nodiscard]] Eigen::Vector3f flat(const Hit& hit) const {
    return face_normal(mesh_.positions, mesh_.faces[hit.face]);
  }

  // Takes the reflectance into the throughput; returns where the path goes on.
  [[nodiscard]] Eigen::Vector3f reflect(Path& path, std::mt19937& random) const {
    const Eigen::Vector3f normal = normals_.at(path.hit);
    const Eigen::Vector3f albedo = interpolated(path.hit, mesh_, mesh_.albedo);
    const std::uint32_t corner = corner_of(path.hit, random);
    const Material material = material_of(mesh_, corner, albedo);
    if (material.brdf) return reflect_by_brdf(material, normal, path, random);
    const Eigen::Vector3f specular =
        mesh_.specular.empty() ? Eigen::Vector3f::Zero().eval() : Eigen::Vector3f(mesh_.specular[corner]);
    const float gloss = specular.maxCoeff();
    if (gloss > 0.0F) {
      const float glossy = gloss / (gloss + albedo.maxCoeff());
      std::uniform_real_distribution<float> uniform(0.0F, 1.0F);
      if (uniform(random) < glossy) {
        path.throughput = path.throughput.cwiseProduct(specular) / glossy;
        return power_direction(mirrored(path.direction, normal), mesh_.exponent[corner], random);
      }
      path.throughput /= 1.0F - glossy;
    }
    path.throughput = path.throughput.cwiseProduct(albedo);
    return power_direction(normal, 1.0F, random);
  }

  // The corner whose material the path meets: as often as it is near where the corners differ.
  [[nodiscard]] std::uint32_t corner_of(const Hit& hit, std::mt19937& random) const {
    const Face& face = mesh_.faces[hit.face];
    if (has_one_finish(mesh_, face)) return face[0];
    const float at = std::uniform_real_distribution<float>(0.0F, 1.0F)(random);
    return at < hit.u ? face[1] : at < hit.u + hit.v ? face[2] : face[0];
  }

  // Directions are equally distributed over the hemisphere; a table holds BRDF times cosine to its highest degree.
  static Eigen::Vector3f reflect_by_brdf(const Material& material, const Eigen::Vector3f& normal, Path& path,
                                         std::mt19937& random) {
    Eigen::Vector3f next = power_direction(normal, 0.0F, random);
    Eigen::Vector3f reflected = Eigen::Vector3f::Zero();
    for_reflected_lobes(material.brdf, material.albedo, kMaxDegree, normal, -path.direction.normalized(),
                        [&](const Eigen::Vector3f& color, const float* weights) {
                          reflected += color * sh::evaluate<kMaxDegree>(weights, next.x(), next.y(), next.z());
                        });
    path.throughput = 2.0F * std::numbers::pi_v<float> * path.throughput.cwiseProduct(reflected);
    return next;
  }

  // With the density (e+1) / (2 pi) cos^e about an axis.
  static Eigen::Vector3f power_direction(const Eigen::Vector3f& axis, float exponent, std::mt19937& random) {
    std::uniform_real_distribution<float> uniform(0.0F, 1.0F);
    const float azimuth = 2.0F * std::numbers::pi_v<float> * uniform(random);
    const float cosine = std::pow(uniform(random), 1.0F / (exponent + 1.0F));
    const float sine = std::sqrt(std::max(0.0F, 1.0F - cosine * cosine));
    const Eigen::Vector3f local(sine * std::cos(azimuth), sine * std::sin(azimuth), cosine);
    return frame_about(axis) * local;
  }

  static bool survives(Path& path, std::mt19937& random) {
    constexpr float kLittle = 0.2F;
    const float most = path.throughput.cwiseAbs().maxCoeff();  // a table rings below 0
    if (most >= kLittle) return true;
    std::uniform_real_distribution<float> uniform(0.0F, kLittle);
    if (uniform(random) >= most) return false;
    path.throughput *= kLittle / most;
    return true;
  }

  const Mesh& mesh_;
  ShadingNormals normals_;
  const Tracer& tracer_;
  const Background& sky_;
  float offset_;
};

Picture black_picture(const PictureSize& size) {
  const auto pixels = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
  return {size.width, size.height, std::vector<Eigen::Vector3f>(pixels, Eigen::Vector3f::Zero()),
          std::vector<float>(pixels, 0.0F)};
}

// Calls each(pixel) where the mesh covers both pictures; returns the root of the mean over pixels and channels of what it
// returns, at least 0.
template <class Each>
double root_of_mean(const Picture& a, const Picture& b, const Each& each) {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < a.radiance.size(); ++i) {
    if (a.coverage[i] < 1.0F || b.coverage[i] < 1.0F) continue;
    sum += each(i);
    count += 3.0;
  }
  return std::sqrt(std::max(sum, 0.0) / std::max(count, 1.0));
}

Eigen::Vector3d mean_of(const PathPictures& paths, std::size_t pixel) {
  return 0.5 * (paths.first.radiance[pixel] + paths.second.radiance[pixel]).cast<double>();
}

// `root` over the rms of the mean of both pictures, where `other` covers them; NaN where that is 0.
double relative(double root, const Picture& other, const PathPictures& paths) {
  const double unit = root_of_mean(other, paths.first, [&](std::size_t i) { return mean_of(paths, i).squaredNorm(); });
  return unit > 0.0 ? root / unit : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

PathPictures path_render(const Mesh& mesh, const Tracer& tracer, const Background& sky, const Camera& camera,
                         const PictureSize& size, int paths) {
  require_picture_size(size);
  if (size.samples != 1) throw std::invalid_argument("path_render takes one sample a pixel");
  if (!mesh.mirror.empty()) throw std::invalid_argument("path_render does not follow mirrors; expected a mesh without");
  PathPictures pictures{black_picture(size), black_picture(size)};
  const PathTracer from(mesh, tracer, sky);
  output::Progress progress("paths", static_cast<std::size_t>(size.height));
  in_parallel(0, size.height, [&](int row) {
    RowOfRays rays;
    trace_row(tracer, camera, size, row, rays);
    std::mt19937 random(static_cast<unsigned>(row));
    for (Picture* picture : {&pictures.first, &pictures.second}) {
      std::vector<Path> starts;
      for (std::size_t column = 0; column < rays.hits.size(); ++column) {
        const std::size_t pixel = static_cast<std::size_t>(row) * rays.hits.size() + column;
        if (rays.hits[column].face == Hit::kNothing) continue;
        picture->coverage[pixel] = 1.0F;
        starts.insert(starts.end(), static_cast<std::size_t>(paths),
                      {pixel, rays.hits[column], Eigen::Vector3f::Ones(), rays.directions[column]});
      }
      from.follow(std::move(starts), random, picture->radiance);
    }
    progress.advance();
  });
  progress.finish();
  for (Picture* picture : {&pictures.first, &pictures.second}) {
    for (Eigen::Vector3f& radiance : picture->radiance) radiance /= static_cast<float>(paths);
  }
  return pictures;
}

double path_noise(const PathPictures& paths) {
  const double noise = root_of_mean(paths.first, paths.second, [&](std::size_t i) {
    return 0.25 * (paths.first.radiance[i] - paths.second.radiance[i]).cast<double>().squaredNorm();
  });
  return relative(noise, paths.first, paths);
}

double error_against_paths(const Picture& picture, const PathPictures& paths) {
  const double error = root_of_mean(picture, paths.first, [&](std::size_t i) {
    const Eigen::Vector3d value = picture.radiance[i].cast<double>();
    return (value - paths.first.radiance[i].cast<double>()).dot(value - paths.second.radiance[i].cast<double>());
  });
  return relative(error, picture, paths);
}

}  // namespace sh::prt
