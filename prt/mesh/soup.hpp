// Triangles from a file or a generator before they are welded into a Mesh, the checks that they must pass, and the
// materials of surfaces besides their diffuse color. Emitted light is radiance, W m^-2 sr^-1, linear RGB. Reflectances
// are linear RGB in 0..1 (albedo, mirror, specular); their sum is at most 1.
#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "prt/mesh/mesh.hpp"

namespace sh::prt {

/// A lobe about the mirrored direction of view: the part `specular` of the light, cos^exponent of the angle between
/// them [Phong75]; or a BRDF that takes the place of this lobe and of the diffuse reflection.
struct Gloss {
  Eigen::Vector3f specular = Eigen::Vector3f::Zero();
  float exponent = 0.0F;
  std::shared_ptr<const Reflectance> brdf;
  bool operator==(const Gloss&) const = default;
};

/// Pictures at texture coordinates that vary a material; null where it does not vary.
struct VariedMaterial {
  std::shared_ptr<const Image> albedo;          // linear RGB, a factor of the albedo
  std::shared_ptr<const EncodedPicture> shown;  // the same as the file has it, for pictures of the surface
  std::shared_ptr<const Image> emission;        // linear RGB, a factor of the emission
  std::shared_ptr<const Image> facets;  // green times `roughness`, blue times `metallic` (material/microfacet.hpp)
  float roughness = 1.0F;
  float metallic = 1.0F;
  [[nodiscard]] bool any() const { return albedo != nullptr || emission != nullptr || facets != nullptr; }
  bool operator==(const VariedMaterial&) const = default;
};

/// The finish of a face. The front of a surface always emits `emission`, reflects the part `mirror` like a mirror, the
/// part gloss.specular about the mirrored direction, and the part albedo diffusely.
struct Finish {
  Eigen::Vector3f emission = Eigen::Vector3f::Zero();
  Eigen::Vector3f mirror = Eigen::Vector3f::Zero();
  Gloss gloss;
  std::shared_ptr<const NormalMap> normal_map;
  VariedMaterial varied;
  std::optional<Translucence> translucence;  // of the body behind it
  bool is_two_sided = false;                 // both sides are fronts
  /// Whether it needs texture coordinates.
  [[nodiscard]] bool has_pictures() const { return normal_map != nullptr || varied.any(); }
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
  std::optional<Gloss> gloss;
  std::shared_ptr<const NormalMap> normal_map;
  std::optional<Eigen::Vector3f> emission;
  std::optional<Translucence> translucence;
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
      change.gloss = own.gloss ? own.gloss : change.gloss;
      change.normal_map = own.normal_map ? own.normal_map : change.normal_map;
      change.emission = own.emission ? own.emission : change.emission;
      change.translucence = own.translucence ? own.translucence : change.translucence;
      change.is_two_sided = own.is_two_sided ? own.is_two_sided : change.is_two_sided;
    }
    return change;
  }
};

/// Vertices may repeat. Positions are double, so that a place far from the origin does not cost the digits of the
/// shape. `normals` and `albedo` are as long as `positions`; `normals` may be empty, then they are computed. `texture`
/// may be empty, too; only surfaces with pictures use it. So may `chart`, which only atlases use.
struct Soup {
  std::vector<Eigen::Vector3d> positions;
  std::vector<Eigen::Vector3f> normals;
  std::vector<Eigen::Vector3f> albedo;   // linear RGB
  std::vector<Eigen::Vector2f> texture;  // coordinates
  std::vector<Eigen::Vector2f> chart;    // coordinates in an atlas
  std::vector<Face> faces;               // counterclockwise as seen from outside
  std::vector<std::uint32_t> source;     // vertex of the file each vertex came from; empty: itself
  std::vector<std::uint32_t> finish;     // (faces) into `finishes`; empty: every face has the first
  std::vector<Finish> finishes{Finish{}};
  std::vector<std::uint32_t> node;  // (faces) into `nodes`; empty: every face has the first, if there is one
  std::vector<MeshNode> nodes;      // without their faces
  double rounding = 0.0;  // largest error of a coordinate that single precision in the file brought, in its unit

  [[nodiscard]] std::uint32_t finish_of(std::size_t face) const { return finish.empty() ? 0 : finish[face]; }
  [[nodiscard]] std::uint32_t node_of(std::size_t face) const { return node.empty() ? 0 : node[face]; }
};

/// Maps points and nodes by `map`, and normals by its inverse transpose. A map that mirrors also turns the faces around.
void transform(Soup& soup, const Eigen::Affine3d& map);

/// Throws std::runtime_error, one line that begins with `name`, if there are no vertices or no faces, if a face names a
/// missing vertex, if a coordinate is NaN or infinite, or if a surface with pictures has no texture coordinates.
void check(const Soup& soup, const std::string& name);

/// Drops faces without area (to rounding); returns how many.
std::size_t drop_faces_without_area(Soup& soup);

/// Turns all faces and normals around, so that the inside becomes the outside.
void turn_inside_out(Soup& soup);

/// Turns each face around if the sum of its corner normals points to its back; returns how many. Precondition: the soup
/// has normals and passed check().
std::size_t turn_faces_to_normals(Soup& soup);

/// Computes normals that are missing, zero or not finite from the faces. A soup without any normals gets one vertex per
/// face corner. The normal of a corner is the mean, weighted by angle, of the faces around its position that meet its
/// own face at no more than `crease_degrees`. Returns how many given normals were unusable.
std::size_t complete_normals(Soup& soup, float crease_degrees);

}  // namespace sh::prt
