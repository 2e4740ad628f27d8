// A path tracer of a scene under an SH light: an independent, slow reference for bakes with bounces. It uses no vertex
// but to interpolate albedo, emission and normals over a face. At the center of every pixel it follows random paths;
//   radiance = sum over the surfaces of a path of (product of the albedos so far) * emission
//            + (product of all albedos) * L(s) where the path leaves the scene in direction s.
// Directions have the density of the cosine about the shading normal, or of the lobe about the mirrored direction: chance
// decides by their reflectances. Paths end below the face, at backs of faces, and
// by chance where they carry little light (Russian roulette [ArvoKirk90]).
#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "tests/prt/reference_render.hpp"

namespace sh::prt {

/// Two pictures from independent paths; half of their difference is the noise of their mean.
struct PathPictures {
  Picture first;
  Picture second;
};

struct Path {
  std::size_t pixel;
  Hit hit;
  Eigen::Vector3f throughput;
  Eigen::Vector3f direction;  // of the ray that came to the hit
};

class PathTracer {
 public:
  PathTracer(const Mesh& mesh, const Tracer& tracer, const LightCoefficients& light)
      : mesh_(mesh), tracer_(tracer), light_(light), offset_(1e-4F * bounding_box(mesh.positions).diagonal().norm()) {}

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
          const Eigen::Vector3f sky = radiance(light_, directions[i].cast<double>().normalized()).cast<float>();
          sums[paths[i].pixel] += paths[i].throughput.cwiseProduct(sky);
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
    const Eigen::Vector3f normal = interpolated(path.hit, mesh_, mesh_.normals).normalized();
    const Eigen::Vector3f albedo = interpolated(path.hit, mesh_, mesh_.albedo);
    const std::uint32_t corner = mesh_.faces[path.hit.face][0];
    const Eigen::Vector3f specular =
        mesh_.specular.empty() ? Eigen::Vector3f::Zero().eval() : Eigen::Vector3f(mesh_.specular[corner]);
    const float gloss = specular.maxCoeff();
    if (gloss > 0.0F) {
      const float glossy = gloss / (gloss + albedo.maxCoeff());
      std::uniform_real_distribution<float> uniform(0.0F, 1.0F);
      if (uniform(random) < glossy) {
        path.throughput = path.throughput.cwiseProduct(specular) / glossy;
        const Eigen::Vector3f mirrored = path.direction - 2.0F * normal.dot(path.direction) * normal;
        return power_direction(mirrored.normalized(), mesh_.exponent[corner], random);
      }
      path.throughput /= 1.0F - glossy;
    }
    path.throughput = path.throughput.cwiseProduct(albedo);
    return power_direction(normal, 1.0F, random);
  }

  // With the density (e+1) / (2 pi) cos^e about an axis.
  static Eigen::Vector3f power_direction(const Eigen::Vector3f& axis, float exponent, std::mt19937& random) {
    std::uniform_real_distribution<float> uniform(0.0F, 1.0F);
    const float azimuth = 2.0F * std::numbers::pi_v<float> * uniform(random);
    const float cosine = std::pow(uniform(random), 1.0F / (exponent + 1.0F));
    const float sine = std::sqrt(std::max(0.0F, 1.0F - cosine * cosine));
    const Eigen::Vector3f local(sine * std::cos(azimuth), sine * std::sin(azimuth), cosine);
    return Eigen::Quaternionf::FromTwoVectors(Eigen::Vector3f::UnitZ(), axis) * local;
  }

  static bool survives(Path& path, std::mt19937& random) {
    constexpr float kLittle = 0.2F;
    const float most = path.throughput.maxCoeff();
    if (most >= kLittle) return true;
    std::uniform_real_distribution<float> uniform(0.0F, kLittle);
    if (uniform(random) >= most) return false;
    path.throughput *= kLittle / most;
    return true;
  }

  const Mesh& mesh_;
  const Tracer& tracer_;
  const LightCoefficients& light_;
  float offset_;
};

/// Each of the two pictures follows `paths` paths a pixel. The same bits for any number of threads.
inline PathPictures path_render(const Mesh& mesh, const Tracer& tracer, const LightCoefficients& light,
                                const Camera& camera, const PictureSize& size, int paths) {
  const auto pixels = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
  const Picture black{size.width, size.height, std::vector<Eigen::Vector3f>(pixels, Eigen::Vector3f::Zero()),
                      std::vector<float>(pixels, 0.0F)};
  PathPictures pictures{black, black};
  const PathTracer from(mesh, tracer, light);
  tbb::parallel_for(0, size.height, [&](int row) {
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
  });
  for (Picture* picture : {&pictures.first, &pictures.second}) {
    for (Eigen::Vector3f& radiance : picture->radiance) radiance /= static_cast<float>(paths);
  }
  return pictures;
}

}  // namespace sh::prt
