// Relights several rigidly moving objects under one light. Each object takes the light turned by the inverse of its own
// rotation. Around an object whose space has been baked, its volume says what it leaves of this light
// (prt/runtime/neighborhood.hpp). The bounding spheres of the other objects cover caps of it (prt/light/proxy_shadow.hpp).
// Both are seen from the center of the object or, if the object asks for it, from each of its vertices. Glossy objects
// multiply this light by their visibility and reflect it by equation 12 (prt/runtime/glossy.hpp).
//
// An object may also take its light from the scene [SloanKautzSnyder02, section 6.2]: what the lit surfaces of the others and
// the sky between them send to its center, sampled for every frame (prt/runtime/sampled_light.hpp).
//
// Approximations: the light is equally far away from all objects. An object without a volume blocks light like its
// sphere. No light goes from one object to another, but to those that take it from the scene, once. With one light for the whole object, a shadow falls evenly on all of
// it. A point inside the sphere of another object, for instance where objects touch, has half of its directions covered;
// overlaps() reports it.
#pragma once
#include <Eigen/Core>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "prt/runtime/glossy.hpp"
#include "prt/runtime/neighborhood.hpp"
#include "prt/runtime/shading.hpp"
#include "prt/scene/stage.hpp"

namespace sh::prt {

/// Messages for users about objects that gather light once, at a center that lies inside the sphere of another object.
std::vector<std::string> overlaps(const Stage& stage, const std::vector<Pose>& poses);

std::vector<Pose> poses_at(const Stage& stage, double time);

/// All objects as one mesh in world axes. A single object whose pose is the identity keeps every bit of its mesh.
Mesh merged_mesh(const Stage& stage, const std::vector<Pose>& poses);

class LitStage;

/// Relights a stage at any time. The stage must outlive it.
class StageLighting {
 public:
  /// `projected` gives the lights' coefficients of a degree; it is called once for each that the objects have. Throws
  /// std::invalid_argument where the shading does not fit an object; a degree need only fit one of them. `lights` are the
  /// same, for objects that take their light from the scene.
  StageLighting(const Stage& stage, const std::function<LightCoefficients(int)>& projected, Shading shading,
                std::vector<Light> lights = {});

  /// The light of the objects of this degree, before it turns.
  [[nodiscard]] const LightCoefficients& light(int degree) const { return lights_.at(degree); }
  /// The stage with its objects in these poses, under the light turned.
  [[nodiscard]] LitStage at(std::vector<Pose> poses, const Eigen::Matrix3d& light_turn) const;
  /// LitStage::radiance of it.
  [[nodiscard]] std::vector<Eigen::Vector3f> radiance(const std::vector<Pose>& poses, const Eigen::Matrix3d& light_turn,
                                                      const Eigen::Vector3d& eye = Eigen::Vector3d::Zero()) const;

 private:
  friend class LitStage;
  const Stage& stage_;
  Shading shading_;
  std::vector<Light> lights_of_scene_;
  std::map<int, LightCoefficients> lights_;  // by the degree of the transfer
};

/// A stage at one time. The StageLighting must outlive it.
class LitStage {
 public:
  /// Exit radiance of the vertices of merged_mesh, of glossy objects towards a point `eye` of the world. The same bits for
  /// any number of threads.
  [[nodiscard]] std::vector<Eigen::Vector3f> radiance(const Eigen::Vector3d& eye) const;
  /// The same of one object; media have none.
  [[nodiscard]] std::vector<Eigen::Vector3f> radiance(std::size_t index, const Eigen::Vector3d& eye) const;
  /// The radiance that reaches a glossy object, in its axes.
  [[nodiscard]] TransferredRadiance reaching(std::size_t index) const;
  /// The light of an object that takes one light, as media do, in its axes.
  [[nodiscard]] LightCoefficients light(std::size_t index) const {
    return object(index).from_scene ? light_from_scene(index) : distant_light(index);
  }

 private:
  friend class StageLighting;
  LitStage(const StageLighting& lighting, std::vector<Pose> poses, const Eigen::Matrix3d& light_turn);

  [[nodiscard]] const StageObject& object(std::size_t index) const { return lighting_.stage_.objects[index]; }
  /// What shines and what stands in its way, in the axes of the object: at its center, or at a point of the world.
  [[nodiscard]] LightCoefficients distant_light(std::size_t index) const;
  [[nodiscard]] LightCoefficients distant_light(std::size_t index, const Eigen::Vector3d& point) const;
  /// What the lit surfaces of the others and the sky send to its center, in its axes.
  [[nodiscard]] LightCoefficients light_from_scene(std::size_t index) const;
  [[nodiscard]] std::vector<Eigen::Vector3f> lit_from_afar(std::size_t index, const Eigen::Vector3d& eye) const;
  [[nodiscard]] TransferredRadiance reaching_from_afar(std::size_t index) const;
  [[nodiscard]] std::vector<Eigen::Vector3f> sent(std::size_t index, const TransferredRadiance& reaching,
                                                  const Eigen::Vector3d& eye) const;

  const StageLighting& lighting_;
  std::vector<Pose> poses_;
  Eigen::Matrix3d light_turn_;
  std::vector<LightCoefficients> lights_;  // of the objects, in their axes, with nothing in the way
  std::map<int, Neighborhoods> around_;    // by the degree of the transfer; empty where no object has a volume
};

}  // namespace sh::prt
