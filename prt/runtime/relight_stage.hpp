// Several rigidly moving objects under one light. Each meets the light turned by the inverse of its own rotation
// (rotating the light is rotating the object) and without the caps that the bounding spheres of the others cover as
// seen from its centre or, where it asks for that, from each of its vertices (prt/light/proxy_shadow.hpp).
//
// Approximations: the light is as far away for one object as for the other; an object blocks as its sphere would,
// and no light goes from one object to another; with one light for the whole object, a shadow falls on all of it alike.
// Inside another's sphere, as where objects touch, half of the sphere of directions is covered, and overlaps() says so.
#pragma once
#include <Eigen/Core>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "prt/runtime/shading.hpp"
#include "prt/scene/stage.hpp"

namespace sh::prt {

/// The light, given in world axes and turned by `light_turn`, as object `index` meets it at its proxy's centre: in the
/// object's own axes. An object alone with the identity as rotation meets every bit of it.
LightCoefficients light_at_object(const Stage& stage, const std::vector<Pose>& poses, std::size_t index,
                                  const LightCoefficients& light, const Eigen::Matrix3d& light_turn);

/// Lines for people about objects whose centres, where light is gathered once, lie inside the sphere of another.
std::vector<std::string> overlaps(const Stage& stage, const std::vector<Pose>& poses);

std::vector<Pose> poses_at(const Stage& stage, double time);

/// All objects as one mesh in world axes; a single one with the identity as pose is its own mesh, bit by bit.
Mesh merged_mesh(const Stage& stage, const std::vector<Pose>& poses);

/// Relights a stage at any time. The stage must outlive it.
class StageLighting {
 public:
  /// `projected` gives the lights' coefficients of a degree; it is called once for each that the objects have. Throws
  /// std::invalid_argument where the shading does not fit an object; a degree need only fit one of them.
  StageLighting(const Stage& stage, const std::function<LightCoefficients(int)>& projected, Shading shading);

  /// Exit radiance of the vertices of merged_mesh. The same bits for any number of threads.
  [[nodiscard]] std::vector<Eigen::Vector3f> radiance(const std::vector<Pose>& poses,
                                                      const Eigen::Matrix3d& light_turn) const;

 private:
  const Stage& stage_;
  Shading shading_;
  std::map<int, LightCoefficients> lights_;  // by the degree of the transfer
};

}  // namespace sh::prt
