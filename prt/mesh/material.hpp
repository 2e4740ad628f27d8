// The materials of surfaces besides their diffuse color, and a scene's changes to the materials of a mesh file. Emitted
// light is radiance, W m^-2 sr^-1, linear RGB. Reflectances are linear RGB in 0..1 (albedo, mirror); their sum is at
// most 1.
#pragma once
#include <Eigen/Core>
#include <map>
#include <optional>
#include <string>

namespace sh::prt {

/// The finish of a face. The front of a surface always emits `emission`, reflects the part `mirror` like a mirror and
/// reflects the part albedo diffusely.
struct Finish {
  Eigen::Vector3f emission = Eigen::Vector3f::Zero();
  Eigen::Vector3f mirror = Eigen::Vector3f::Zero();
  bool is_two_sided = false;  // both sides are fronts
  bool operator==(const Finish&) const = default;
};

/// The reflection of a surface; a scene sets both parts together.
struct Reflection {
  Eigen::Vector3f albedo = Eigen::Vector3f::Zero();
  Eigen::Vector3f mirror = Eigen::Vector3f::Zero();
};

/// A scene's changes to a material. Each value that is set replaces the one of the file, including its vertex colors.
struct MaterialChange {
  std::optional<Reflection> reflection;
  std::optional<Eigen::Vector3f> emission;
  std::optional<bool> is_two_sided;
};

/// Changes to a whole file and to its materials by name; the changes by name have priority.
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
