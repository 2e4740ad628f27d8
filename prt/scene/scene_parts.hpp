// The parts of a scene file, one function for each part (prt/FILES.md lists the keys), and the scenes made in code.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "prt/light/window.hpp"
#include "prt/mesh/import_mesh.hpp"
#include "prt/mesh/mend.hpp"
#include "prt/mesh/mesh.hpp"
#include "prt/mesh/soup.hpp"
#include "prt/scene/json_reader.hpp"
#include "prt/scene/scene.hpp"

namespace sh::prt {

/// The path of `file`, which is relative to `folder`, the folder of the scene.
std::string beside(const std::string& folder, const std::string& file);

/// A rotation, right-handed about a unit axis.
struct Turn {
  Eigen::Vector3f axis = Eigen::Vector3f::UnitZ();
  float degrees = 0.0F;
};

constexpr double kMostTurn = 36000.0;  // degrees: a hundred turns

/// Reads {"axis": [x, y, z], "degrees": d}, d from -kMostTurn to kMostTurn; the default axis is z.
Turn read_turn(const JsonReader& reader);

/// A square of flat ground under the meshes, in their frame.
struct Ground {
  float height;
  float size;      // edge length
  float max_edge;  // under and near the meshes; edges may grow to a quarter of their distance from them
  Eigen::Vector3f albedo = Eigen::Vector3f::Constant(0.5F);
};

/// The defaults, which depend on the meshes: the ground is below them by 1/10000 of their extent (so that it coincides
/// with no face), four times as wide, and has edges of 1/50 of their extent.
Ground default_ground(const Mesh& mesh);
void add_ground(Mesh& mesh, const Ground& ground);

/// One mesh of a scene in the world, before it is welded and split.
struct MeshPart {
  Soup soup;
  std::size_t file_vertices = 0;
  float crease_degrees = 0.0F;
  double max_edge = 0.0;              // 0: faces are not split
  int texels = 0;                     // along a side of the atlas of the mesh; 0: there is none
  std::string name;                   // in messages
  std::string normal_map_entry = {};  // the first entry that asks for a normal map; empty: none
};

/// An entry of `meshes` and those of its `materials`: where a material may stand.
std::vector<JsonReader> material_readers(const JsonReader& mesh);

/// The shapes with their materials that entries of `meshes` name. One that several entries place is read once.
class Shapes {
 public:
  explicit Shapes(const JsonReader& meshes);
  /// That of an entry, each of which takes its shape once.
  ImportedMesh take(const JsonReader& reader, const std::string& folder, OnFlaw on_flaw);

 private:
  struct Shape {
    std::size_t entries = 0;  // that will take it
    std::optional<ImportedMesh> read;
  };
  // The entry without what only places and splits its shape.
  static std::string key(const JsonReader& reader);
  std::map<std::string, Shape> shapes_;
};

/// Reads one entry of `meshes` and checks it. Relative paths start in `folder`.
MeshPart read_mesh(const JsonReader& reader, const std::string& folder, OnFlaw on_flaw, Shapes& shapes);
/// Reads the key `medium`. Its density is read or made.
Medium read_medium(const JsonReader& reader, const std::string& folder);
Ground read_ground(const JsonReader& reader, const Mesh& mesh);
/// Reads one entry of `lights`; its files are not loaded yet.
LightSpec read_light(const JsonReader& reader, const std::string& folder);
/// Reads the key `lights`; without it, the CIE overcast sky is the only light.
std::vector<LightSpec> read_lights(const JsonReader& reader, const std::string& folder);
/// Reads "auto", the name of a kind, or {"type", "width" | "lambda" | "strength", "power", "keep"}; without a number,
/// the least window.
WindowChoice read_window(const JsonReader& reader);
Camera read_camera(const JsonReader& reader, const Camera& otherwise);
BakeOptions read_bake_options(const JsonReader& reader);
/// The presence of the key `plan` selects a lossy plan.
PlanOptions read_plan_options(const JsonReader& reader);

/// Rounds a part to single precision in the frame, welds and splits it, adds backs to two-sided faces and texels. Messages
/// about flaws and errors begin with its name.
Mesh finish_mesh(MeshPart part, const Frame& frame, OnFlaw on_flaw);

/// An arch, stairs, and columns with a sphere, a torus and a cone, under the CIE overcast sky and on a ground that
/// receives their shadows. It has smooth and flat shading and several albedos; every vertex sees a part of the sky.
Scene make_embedded_scene();

/// A thin disc of radius 1 that faces up, 0.6 above a ground z = 0, under the CIE overcast sky and a broad light from
/// one side. The disc is a regular polygon of the same area; it has enough corners to keep the difference below 1e-5.
Scene make_disc_scene();

}  // namespace sh::prt
