// glTF: a mesh with its transfer as vertex attributes, in the extension SHFORGE_transfer (FORMATS.md describes it).
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "numeric/identify/coefficient_map.hpp"
#include "prt/binary/bytes.hpp"
#include "prt/formats/glb.hpp"
#include "prt/formats/writers.hpp"

namespace sh::prt::formats {
namespace {

using Json = nlohmann::ordered_json;
constexpr const char* kExtension = "SHFORGE_transfer";

// y up: the axes and functions of three.js, so that rows meet the coefficients of its light probes.
const numeric::identify::Preset& convention() { return numeric::identify::find_preset("threejs"); }

std::vector<float> in_axes(const std::vector<Eigen::Vector3f>& vectors) {
  const numeric::identify::Axes& axes = convention().world;
  std::vector<float> out;
  out.reserve(3 * vectors.size());
  for (const Eigen::Vector3f& v : vectors) {
    for (std::size_t row = 0; row < 3; ++row) out.push_back(static_cast<float>(axes.sign[row]) * v[axes.axis[row]]);
  }
  return out;
}

std::vector<float> as_they_are(const std::vector<Eigen::Vector3f>& vectors) {
  std::vector<float> out;
  out.reserve(3 * vectors.size());
  for (const Eigen::Vector3f& v : vectors) out.insert(out.end(), v.data(), v.data() + 3);
  return out;
}

// Where vertices are: their frame is the node's.
Json node_of(const Frame& frame) {
  Json node = {{"mesh", 0}};
  if (frame.is_world()) return node;
  const numeric::identify::Axes& axes = convention().world;
  for (std::size_t row = 0; row < 3; ++row) {
    node["translation"].push_back(axes.sign[row] * frame.origin[axes.axis[row]]);
  }
  node["scale"] = {frame.unit, frame.unit, frame.unit};
  return node;
}

std::size_t add_positions(Glb& glb, const Mesh& mesh) {
  const std::vector<float> positions = in_axes(mesh.positions);
  const std::size_t accessor = glb.add_floats(positions, 3);
  Json& json = glb.json["accessors"][accessor];
  for (std::size_t k = 0; k < 3; ++k) {
    float least = positions[k];
    float most = least;
    for (std::size_t i = k; i < positions.size(); i += 3) {
      least = std::min(least, positions[i]);
      most = std::max(most, positions[i]);
    }
    json["min"].push_back(least);
    json["max"].push_back(most);
  }
  return accessor;
}

std::size_t add_faces(Glb& glb, const Mesh& mesh) {
  std::string bytes;
  for (const Face& face : mesh.faces) append(bytes, face.data(), 3);
  const std::size_t view = glb.add_view(bytes, kIndices);
  glb.json["accessors"].push_back(
      {{"bufferView", view}, {"componentType", kUnsignedInt}, {"count", 3 * mesh.faces.size()}, {"type", "SCALAR"}});
  return glb.json["accessors"].size() - 1;
}

// The numbers of all vertices in groups of four, (groups)(vertices, 4); zeros fill the last group.
std::vector<std::vector<float>> grouped(const Transfer& transfer) {
  const std::size_t vertices = transfer.mesh.positions.size();
  const std::size_t columns = transfer.shape.columns();
  const std::size_t length = transfer.shape.length();
  const numeric::identify::CoefficientMap map(convention(), transfer.shape.function_degree());
  std::vector<std::vector<float>> groups((length + 3) / 4, std::vector<float>(4 * vertices));
  std::vector<float> room;
  std::vector<float> turned(length);
  for (std::size_t v = 0; v < vertices; ++v) {
    const float* row = transfer.row(v, room);
    for (std::size_t i = 0; i < length; i += columns) map.to(row + i, turned.data() + i);
    for (std::size_t i = 0; i < length; ++i) groups[i / 4][4 * v + i % 4] = turned[i];
  }
  return groups;
}

Json description(const Transfer& transfer) {
  const TransferShape& shape = transfer.shape;
  return {
      {"kind", transfer.kind->letters},
      {"degree", shape.degree},
      {"resultDegree", shape.result_degree},
      {"channels", shape.channels},
      {"rows", shape.rows()},
      {"columns", shape.columns()},
      {"meets", word_of(shape.meets, kMeetsNames)},
      {"holdsCosine", shape.holds_cosine},
      {"holdsAlbedo", shape.holds_albedo},
      {"convention",
       "real orthonormal spherical harmonics of the y-up axes of glTF, polar axis z, no Condon-Shortley phase, index "
       "l(l+1)+m"}};
}

void add_material(Glb& glb, const Transfer& transfer, Json& attributes) {
  const Mesh& mesh = transfer.mesh;
  attributes["COLOR_0"] = glb.add_floats(as_they_are(mesh.albedo), 3);
  if (!mesh.specular.empty() && transfer.kind->is_glossy()) {
    attributes["_SPECULAR"] = glb.add_floats(as_they_are(mesh.specular), 3);
    attributes["_EXPONENT"] = glb.add_floats(mesh.exponent, 1);
  }
  if (!transfer.emitted.empty()) attributes["_EMITTED"] = glb.add_floats(as_they_are(transfer.emitted), 3);
}

}  // namespace

std::string write_glb(const Transfer& transfer) {
  if (transfer.kind->stores_matrices()) {
    throw std::runtime_error(
        fmt::format("vertex attributes hold no matrices of light between surfaces (kind {}); expected "
                    "another kind, or the format npz",
                    transfer.kind->letters));
  }
  Glb glb;
  Json attributes;
  attributes["POSITION"] = add_positions(glb, transfer.mesh);
  attributes["NORMAL"] = glb.add_floats(in_axes(transfer.mesh.normals), 3);
  add_material(glb, transfer, attributes);
  if (transfer.shape.length() > 0) {
    const auto groups = grouped(transfer);
    for (std::size_t i = 0; i < groups.size(); ++i) {
      attributes[fmt::format("_SH_TRANSFER_{}", i)] = glb.add_floats(groups[i], 4);
    }
  }
  glb.json["extensionsUsed"] = {kExtension};
  const Json primitive = {{"attributes", attributes}, {"indices", add_faces(glb, transfer.mesh)}};
  glb.json["meshes"] = {{{"primitives", {primitive}}, {"extensions", {{kExtension, description(transfer)}}}}};
  glb.json["nodes"] = {node_of(transfer.mesh.frame)};
  glb.json["scene"] = 0;
  glb.json["scenes"] = {{{"nodes", {0}}}};
  return glb.bytes();
}

}  // namespace sh::prt::formats
