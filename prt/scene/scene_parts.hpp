// The parts of a scene file, each read by one function. prt/README.md lists the keys.
#pragma once
#include <string>
#include <vector>

#include "prt/light/deringing.hpp"
#include "prt/mesh/material.hpp"
#include "prt/mesh/mend.hpp"
#include "prt/mesh/mesh.hpp"
#include "prt/mesh/soup.hpp"
#include "prt/scene/json_reader.hpp"
#include "prt/scene/scene.hpp"

namespace sh::prt {

/// A file that a scene names, found beside the folder of the scene.
std::string beside(const std::string& folder, const std::string& file);

/// A rotation, right-handed about a unit axis.
struct Turn {
  Eigen::Vector3f axis = Eigen::Vector3f::UnitZ();
  float degrees = 0.0F;
};

/// {"axis": [x, y, z], "degrees": d}; the axis is z unless given.
Turn read_turn(const JsonReader& reader);

/// A square of flat ground under the meshes.
struct Ground {
  float height;
  float size;      // edge length
  float max_edge;  // under and near the meshes; edges may grow to a quarter of their distance from them
  Eigen::Vector3f albedo = Eigen::Vector3f::Constant(0.5F);
};

/// What is left out is derived from the meshes: just below them (by 1/10000 of their extent, so that no face of theirs
/// coincides with it), four times as wide, edges of 1/50 of their extent.
Ground default_ground(const Mesh& mesh);
void add_ground(Mesh& mesh, const Ground& ground);

/// One entry of `meshes`, in world axes, checked, welded and split. Relative files are found beside `folder`.
Mesh read_mesh(const JsonReader& reader, const std::string& folder, OnFlaw on_flaw);
/// The keys albedo, mirror, emission, sides and materials of such an entry.
MaterialChanges read_materials(const JsonReader& mesh);
/// Refuses `materials` that the mesh does not have.
void check_material_names(const JsonReader& mesh, const std::vector<std::string>& known);
Ground read_ground(const JsonReader& reader, const Mesh& mesh);
/// One entry of `lights`; what it names is not loaded yet.
LightSpec read_light(const JsonReader& reader, const std::string& folder);
/// Its part for pictures.
void read_environment(const JsonReader& reader, const std::string& folder, LightSpec& light);
/// "auto", a kind's name, or {"type", "width" | "lambda" | "strength", "power", "keep"}; without its number, the least.
WindowChoice read_window(const JsonReader& reader);
Camera read_camera(const JsonReader& reader, const Camera& otherwise);
BakeOptions read_bake_options(const JsonReader& reader);
/// The scene asks for a lossy plan by having the key.
PlanOptions read_plan_options(const JsonReader& reader);

/// Welds and splits a soup that is in its final place, and gives two-sided faces their backs. `name` begins what is
/// said about flaws and errors.
Mesh finish_mesh(Soup soup, std::size_t file_vertices, float crease_degrees, float max_edge, const std::string& name,
                 OnFlaw on_flaw);

}  // namespace sh::prt
