// Godot: the nine colors of a light probe, as LightmapGI bakes them (lm_compute.glsl, MODE_LIGHT_PROBES) and shaders read
// them; as JSON and as a shader with its values.
#include <fmt/format.h>

#include "prt/formats/json_numbers.hpp"
#include "prt/formats/writers.hpp"

namespace sh::prt::formats {

std::string write_godot(const EngineLight& light) {
  const nlohmann::ordered_json json = {{"probe_sh", light.coefficients}};
  return json.dump(2) + "\n";
}

std::string write_godot_code(const EngineLight& light) {
  std::string text =
      "// Paste into a .gdshader of a mesh, in place of the ambient light of the scene. The function is that of\n"
      "// Godot's own light probes: irradiance over pi at a normal of the world.\n"
      "shader_type spatial;\nrender_mode ambient_light_disabled;\n\n"
      "uniform vec3 albedo : source_color = vec3(0.5);\n"
      "const vec3 probe_sh[9] = {\n";
  for (const auto& triple : light.coefficients) {
    text += fmt::format("\tvec3({:#.9g}, {:#.9g}, {:#.9g}),\n", triple[0], triple[1], triple[2]);
  }
  text.erase(text.size() - 2, 1);
  text +=
      "};\n\n"
      "vec3 ambient_of_probe(vec3 n) {\n"
      "\treturn 0.886227 * probe_sh[0]\n"
      "\t\t+ 1.023327 * (probe_sh[1] * n.y + probe_sh[2] * n.z + probe_sh[3] * n.x)\n"
      "\t\t+ 0.858086 * (probe_sh[4] * n.x * n.y + probe_sh[5] * n.y * n.z + probe_sh[7] * n.x * n.z)\n"
      "\t\t+ 0.247708 * probe_sh[6] * (3.0 * n.z * n.z - 1.0)\n"
      "\t\t+ 0.429043 * probe_sh[8] * (n.x * n.x - n.y * n.y);\n"
      "}\n\n"
      "void fragment() {\n"
      "\tALBEDO = albedo;\n"
      "\tEMISSION = albedo * max(ambient_of_probe(mat3(INV_VIEW_MATRIX) * NORMAL), vec3(0.0));\n"
      "}\n";
  return text;
}

std::optional<Triples> read_godot(const Document& document) {
  if (!document.json || !document.json->contains("probe_sh")) return {};
  Triples triples;
  for (int i = 0; i < 9; ++i) {
    const auto rgb = numbers_at(*document.json, fmt::format("/probe_sh/{}", i), 3);
    triples.push_back({rgb[0], rgb[1], rgb[2]});
  }
  return triples;
}

}  // namespace sh::prt::formats
