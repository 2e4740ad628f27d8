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

LitStage StageLighting::at(std::vector<Pose> poses, const Eigen::Matrix3d& light_turn) const {
  return {*this, std::move(poses), light_turn};
}

std::vector<Eigen::Vector3f> StageLighting::radiance(const std::vector<Pose>& poses, const Eigen::Matrix3d& light_turn,
                                                     const Eigen::Vector3d& eye) const {
  return at(poses, light_turn).radiance(eye);
}

LitStage::LitStage(const StageLighting& lighting, std::vector<Pose> poses, const Eigen::Matrix3d& light_turn)
    : lighting_(lighting), poses_(std::move(poses)), light_turn_(light_turn) {
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    lights_.push_back(
        turned(lighting.light(object(i).transfer->degree()), poses_[i].rotation.transpose() * light_turn));
  }
  const std::vector<StageObject>& objects = lighting.stage_.objects;
  if (std::none_of(objects.begin(), objects.end(), [](const auto& one) { return one.volume; })) return;
  for (const auto& [degree, light] : lighting.lights_) {
    around_.try_emplace(degree, lighting.stage_, poses_, turned(light, light_turn));
  }
}

LightCoefficients LitStage::distant_light(std::size_t index, const Eigen::Vector3d& point) const {
  const std::optional<LightCoefficients> behind =
      around_.empty() ? std::nullopt : around_.at(object(index).transfer->degree()).at(index, point);
  return shadowed_by_caps(behind ? *behind : lights_[index], caps_seen_from(lighting_.stage_, poses_, index, point));
}

// A single object whose rotation is the identity gets the same bits back.
LightCoefficients LitStage::distant_light(std::size_t index) const {
  return distant_light(index, placed(poses_[index], object(index).proxy.center));
}

TransferredRadiance LitStage::reaching_from_afar(std::size_t index) const {
  const Transfer& transfer = *object(index).transfer;
  if (!object(index).per_vertex) return {transfer, distant_light(index)};
  return TransferredRadiance::at_vertices(
      transfer, [&](std::size_t v) { return distant_light(index, placed(poses_[index], transfer.mesh.point(v))); });
}

TransferredRadiance LitStage::reaching(std::size_t index) const {
  if (!object(index).from_scene) return reaching_from_afar(index);
  return {*object(index).transfer, light_from_scene(index)};
}

std::vector<Eigen::Vector3f> LitStage::sent(std::size_t index, const TransferredRadiance& reaching,
                                            const Eigen::Vector3d& eye) const {
  const Transfer& transfer = *object(index).transfer;
  return exit_radiance(transfer, reaching, poses_[index].rotation.transpose() * (eye - poses_[index].position),
                       lighting_.shading_.albedo(transfer.mesh));
}

std::vector<Eigen::Vector3f> LitStage::lit_from_afar(std::size_t index, const Eigen::Vector3d& eye) const {
  const Transfer& transfer = *object(index).transfer;
  if (transfer.kind->in_medium) return {};
  if (transfer.kind->is_glossy()) return sent(index, reaching_from_afar(index), eye);
  if (!object(index).per_vertex) return lighting_.shading_.shade(transfer, distant_light(index));
  std::vector<Eigen::Vector3f> radiance(transfer.mesh.positions.size());
  in_parallel(std::size_t{0}, radiance.size(), [&](std::size_t v) {
    const Eigen::Vector3d point = placed(poses_[index], transfer.mesh.point(v));
    radiance[v] = lighting_.shading_.shade_vertex(transfer, v, distant_light(index, point));
  });
  return radiance;
}

std::vector<Eigen::Vector3f> LitStage::radiance(std::size_t index, const Eigen::Vector3d& eye) const {
  const Transfer& transfer = *object(index).transfer;
  if (!object(index).from_scene || transfer.kind->in_medium) return lit_from_afar(index, eye);
  return transfer.kind->is_glossy() ? sent(index, reaching(index), eye)
                                    : lighting_.shading_.shade(transfer, light_from_scene(index));
}

std::vector<Eigen::Vector3f> LitStage::radiance(const Eigen::Vector3d& eye) const {
  std::vector<Eigen::Vector3f> all;
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    const std::vector<Eigen::Vector3f> part = radiance(i, eye);
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

// Glossy others send what they send to the center.
LightCoefficients LitStage::light_from_scene(std::size_t index) const {
  const Eigen::Vector3d center = placed(poses_[index], object(index).proxy.center);
  Mesh others;
  std::vector<Eigen::Vector3d> points;
  std::vector<Eigen::Vector3f> sent;
  for (std::size_t k = 0; k < poses_.size(); ++k) {
    if (k == index) continue;
    append_placed(others, points, object(k).transfer->mesh, poses_[k]);
    const std::vector<Eigen::Vector3f> part = lit_from_afar(k, center);
    sent.insert(sent.end(), part.begin(), part.end());
  }
  const std::vector<Light> lights = turned(lighting_.lights_of_scene_, light_turn_);
  const Shading& shading = lighting_.shading_;
  const int degree = shading.degree_for(object(index).transfer->degree());
  const Eigen::Matrix3d into = poses_[index].rotation.transpose();
  if (others.faces.empty()) return turned(shading.chosen(project(lights, degree)), into);
  place(others, points, lighting_.stage_.name);
  const Tracer tracer(others);
  const LightSampler sampler(others, tracer, diffuse_surface(others, std::move(sent)), lights, CubeSize());
  return turned(shading.chosen(sampler.at(center, degree).light), into);
}

}  // namespace sh::prt
