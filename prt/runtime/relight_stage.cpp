#include "prt/runtime/relight_stage.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "prt/chunks.hpp"
#include "prt/light/proxy_shadow.hpp"
#include "prt/mesh/weld.hpp"
#include "prt/runtime/neighborhood.hpp"
#include "prt/runtime/relight.hpp"
#include "prt/runtime/sampled_light.hpp"

namespace sh::prt {
namespace {

Eigen::Vector3d placed(const Pose& pose, const Eigen::Vector3d& p) { return pose.rotation * p + pose.position; }

/// The caps that the other objects cover as seen from a point, in the axes of object `index`; empty if they block
/// nothing.
std::vector<Cap> caps_seen_from(const Stage& stage, const std::vector<Pose>& poses, std::size_t index,
                                const Eigen::Vector3d& point) {
  std::vector<Cap> caps;
  for (std::size_t k = 0; k < stage.objects.size(); ++k) {
    const Sphere& proxy = stage.objects[k].proxy;
    if (k != index && proxy.radius > 0.0 && !stage.objects[k].volume) {
      Cap cap = sphere_seen_from(point, placed(poses[k], proxy.center), proxy.radius);
      cap.direction = (poses[index].rotation.transpose() * cap.direction).normalized();
      caps.push_back(cap);
    }
  }
  return caps;
}

/// The light in the axes of an object.
LightCoefficients turned_into(const Pose& pose, const LightCoefficients& light, const Eigen::Matrix3d& light_turn) {
  return turned(light, pose.rotation.transpose() * light_turn);
}

/// The light at a point, in the axes of object `index`, which `light` has without the other objects.
LightCoefficients light_at(const Stage& stage, const std::vector<Pose>& poses, std::size_t index,
                           const LightCoefficients& light, const Neighborhoods* around, const Eigen::Vector3d& point) {
  const std::optional<LightCoefficients> behind = around == nullptr ? std::nullopt : around->at(index, point);
  return shadowed_by_caps(behind ? *behind : light, caps_seen_from(stage, poses, index, point));
}

/// The light at the proxy's center of object `index`, in the axes of the object. A single object whose rotation is the
/// identity gets the same bits back.
LightCoefficients light_at_object(const Stage& stage, const std::vector<Pose>& poses, std::size_t index,
                                  const LightCoefficients& light, const Neighborhoods* around) {
  const Eigen::Vector3d center = placed(poses[index], stage.objects[index].proxy.center);
  return light_at(stage, poses, index, light, around, center);
}

/// Relights each vertex under the light that reaches it.
std::vector<Eigen::Vector3f> radiance_per_vertex(const Stage& stage, const std::vector<Pose>& poses, std::size_t index,
                                                 const LightCoefficients& light, const Neighborhoods* around,
                                                 const Shading& shading) {
  const Transfer& transfer = *stage.objects[index].transfer;
  std::vector<Eigen::Vector3f> radiance(transfer.mesh.positions.size());
  in_parallel(std::size_t{0}, radiance.size(), [&](std::size_t v) {
    const Eigen::Vector3d point = placed(poses[index], transfer.mesh.point(v));
    radiance[v] = shading.shade_vertex(transfer, v, light_at(stage, poses, index, light, around, point));
  });
  return radiance;
}

/// Appends a part with its normals turned, and its placed vertices to `points`.
void append_placed(Mesh& mesh, std::vector<Eigen::Vector3d>& points, const Mesh& part, const Pose& pose) {
  Mesh moved = part;
  const auto turn = [&](std::vector<Eigen::Vector3f>& vectors) {
    for (Eigen::Vector3f& v : vectors) v = (pose.rotation * v.cast<double>()).cast<float>();
  };
  for (std::size_t v = 0; v < part.positions.size(); ++v) points.push_back(placed(pose, part.point(v)));
  turn(moved.normals);
  turn(moved.geometric_normals);
  append(mesh, moved);
}

}  // namespace

std::vector<std::string> overlaps(const Stage& stage, const std::vector<Pose>& poses) {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < stage.objects.size(); ++i) {
    const Eigen::Vector3d center = placed(poses[i], stage.objects[i].proxy.center);
    for (std::size_t k = 0; k < stage.objects.size(); ++k) {
      const Sphere& proxy = stage.objects[k].proxy;
      if (k != i && !stage.objects[k].volume && !stage.objects[i].per_vertex &&
          (placed(poses[k], proxy.center) - center).norm() < proxy.radius) {
        lines.push_back(
            fmt::format("{}: the center of object {} ({}) is inside the proxy of object {} ({}), which "
                        "takes half of its light",
                        stage.name, i, stage.objects[i].name, k, stage.objects[k].name));
      }
    }
  }
  return lines;
}

std::vector<Pose> poses_at(const Stage& stage, double time) {
  std::vector<Pose> poses;
  for (const StageObject& object : stage.objects) poses.push_back(object.motion.at(time));
  return poses;
}

Mesh merged_mesh(const Stage& stage, const std::vector<Pose>& poses) {
  if (poses.size() == 1 && poses.front() == Pose()) return stage.objects.front().transfer->mesh;
  Mesh mesh;
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < poses.size(); ++i) append_placed(mesh, points, stage.objects[i].transfer->mesh, poses[i]);
  place(mesh, points, stage.name);
  return mesh;
}

StageLighting::StageLighting(const Stage& stage, const std::function<LightCoefficients(int)>& projected,
                             Shading shading, std::vector<Light> lights)
    : stage_(stage), shading_(std::move(shading)), lights_of_scene_(std::move(lights)) {
  const auto highest = std::max_element(
      stage.objects.begin(), stage.objects.end(),
      [](const StageObject& a, const StageObject& b) { return a.transfer->degree() < b.transfer->degree(); });
  for (const StageObject& object : stage.objects) {
    shading_.require_fit(*object.transfer, highest->transfer->degree());
    const int degree = object.transfer->degree();
    if (lights_.count(degree) == 0) lights_.emplace(degree, shading_.chosen(projected(shading_.degree_for(degree))));
  }
}

std::vector<Eigen::Vector3f> StageLighting::radiance(const std::vector<Pose>& poses,
                                                     const Eigen::Matrix3d& light_turn) const {
  std::vector<Eigen::Vector3f> all;
  std::map<int, Neighborhoods> around;  // by the degree of the transfer
  if (std::any_of(stage_.objects.begin(), stage_.objects.end(), [](const auto& object) { return object.volume; })) {
    for (const auto& [degree, light] : lights_) around.try_emplace(degree, stage_, poses, turned(light, light_turn));
  }
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const StageObject& object = stage_.objects[i];
    const int degree = object.transfer->degree();
    const LightCoefficients light = turned_into(poses[i], lights_.at(degree), light_turn);
    const Neighborhoods* volumes = around.empty() ? nullptr : &around.at(degree);
    const std::vector<Eigen::Vector3f> part =
        object.per_vertex ? radiance_per_vertex(stage_, poses, i, light, volumes, shading_)
                          : shading_.shade(*object.transfer, light_at_object(stage_, poses, i, light, volumes));
    all.insert(all.end(), part.begin(), part.end());
  }
  const std::vector<Eigen::Vector3f> seen = all;
  std::size_t first = 0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const StageObject& object = stage_.objects[i];
    if (object.from_scene) {
      const LightCoefficients light =
          turned_into(poses[i], light_from_scene(poses, light_turn, seen, i), Eigen::Matrix3d::Identity());
      const std::vector<Eigen::Vector3f> part = shading_.shade(*object.transfer, light);
      std::copy(part.begin(), part.end(), all.begin() + static_cast<std::ptrdiff_t>(first));
    }
    first += object.transfer->mesh.positions.size();
  }
  return all;
}

LightCoefficients StageLighting::light_from_scene(const std::vector<Pose>& poses, const Eigen::Matrix3d& light_turn,
                                                  const std::vector<Eigen::Vector3f>& radiance,
                                                  std::size_t index) const {
  Mesh others;
  std::vector<Eigen::Vector3d> points;
  std::vector<Eigen::Vector3f> sent;
  auto next = radiance.begin();
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const Mesh& mesh = stage_.objects[k].transfer->mesh;
    const auto end = next + static_cast<std::ptrdiff_t>(mesh.positions.size());
    if (k != index) {
      append_placed(others, points, mesh, poses[k]);
      sent.insert(sent.end(), next, end);
    }
    next = end;
  }
  const std::vector<Light> lights = turned(lights_of_scene_, light_turn);
  const int degree = shading_.degree_for(stage_.objects[index].transfer->degree());
  if (others.faces.empty()) return shading_.chosen(project(lights, degree));
  place(others, points, stage_.name);
  const Tracer tracer(others);
  const LightSampler sampler(others, tracer, diffuse_surface(others, std::move(sent)), lights, CubeSize());
  return shading_.chosen(sampler.at(placed(poses[index], stage_.objects[index].proxy.center), degree).light);
}

}  // namespace sh::prt
