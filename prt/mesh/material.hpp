// What surfaces are made of besides their diffuse colour, and what a scene says about it instead of a mesh file.
// Light is radiance, W m^-2 sr^-1, linear RGB; reflectances are linear RGB in 0..1, albedo and mirror at most 1
// together.
#pragma once
#include <Eigen/Core>
#include <map>
#include <optional>
#include <string>

namespace sh::prt {

/// Of a face. A surface sends out `emission` on its front whatever falls on it, reflects the part `mirror` like a
/// mirror and the part albedo diffusely.
struct Finish {
  Eigen::Vector3f emission = Eigen::Vector3f::Zero();
  Eigen::Vector3f mirror = Eigen::Vector3f::Zero();
  bool is_two_sided = false;  // both sides are fronts
  bool operator==(const Finish&) const = default;
};

/// How a surface reflects; who says one says both.
struct Reflection {
  Eigen::Vector3f albedo = Eigen::Vector3f::Zero();
  Eigen::Vector3f mirror = Eigen::Vector3f::Zero();
};

/// What is said replaces what the file says, its vertex colours too.
struct MaterialChange {
  std::optional<Reflection> reflection;
  std::optional<Eigen::Vector3f> emission;
  std::optional<bool> is_two_sided;
};

/// Of a whole file, and of its materials by name, which goes before.
struct MaterialChanges {
  MaterialChange all;
  std::map<std::string, MaterialChange> by_name;

  [[nodiscard]] MaterialChange of(const std::string& name) const {
    MaterialChange change = all;
    if (const auto named = by_name.find(name); named != by_name.end()) {
      const MaterialChange& own = named->second;
      change.reflection = own.reflection ? own.reflection : change.reflection;
      change.emission = own.emission ? own.emission : change.emission;
      change.is_two_sided = own.is_two_sided ? own.is_two_sided : change.is_two_sided;
    }
    return change;
  }
};

}  // namespace sh::prt
