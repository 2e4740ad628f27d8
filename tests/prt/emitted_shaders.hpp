// The data of emitted shaders in an OpenGL context: light, textures, attributes, and the light on clusters.
#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "prt/emit/emit.hpp"
#include "prt/transfer/visibility.hpp"
#include "tests/prt/emitted_cases.hpp"
#include "tests/prt/vertex_shader_run.hpp"

namespace sh::prt::test {

// The light as the shader takes it: the coefficients that relight.json lists, times its factors.
inline void set_light(GLuint program, const EmittedCase& one, const nlohmann::json& json) {
  const LightCoefficients light = light_of(one);
  std::vector<std::size_t> places(light.bands_squared());
  for (std::size_t i = 0; i < places.size(); ++i) places[i] = i;
  if (json.contains("light")) places = json["light"].get<std::vector<std::size_t>>();
  std::vector<float> values;
  for (std::size_t k = 0; k < places.size(); ++k) {
    for (std::size_t c = 0; c < 3; ++c) {
      values.push_back(static_cast<float>(light.at(c, places[k])));
      if (!json.contains("light_factors")) continue;
      const auto factors = json["light_factors"].get<std::vector<float>>();
      values.back() *= factors[factors.size() == places.size() ? k : c * places.size() + k];
    }
  }
  glUniform3fv(glGetUniformLocation(program, "light"), static_cast<GLsizei>(places.size()), values.data());
  std::vector<float> all(light.values.begin(), light.values.end());
  if (const GLint place = glGetUniformLocation(program, "samples"); place >= 0) {
    std::vector<float> samples = prepared_light(light.degree, all.data());
    samples.resize((samples.size() + 3) / 4 * 4);
    glUniform4fv(place, static_cast<GLsizei>(samples.size() / 4), samples.data());
  }
}

// Returns the number of the next free unit.
inline GLuint set_textures(GLuint program, const nlohmann::json& json, const std::string& bytes) {
  GLuint unit = 0;
  for (const auto& texture : json.value("textures", nlohmann::json::array())) {
    const std::string format = texture["format"];
    const bool half = format == "R16F";
    const bool byte = format == "R8_SNORM";
    set_texture(unit,
                half   ? GL_R16F
                : byte ? GL_R8_SNORM
                       : GL_R32F,
                texture["width"], texture["height"],
                half   ? GL_HALF_FLOAT
                : byte ? GL_BYTE
                       : GL_FLOAT,
                bytes.data() + texture["offset"].get<std::size_t>());
    const std::string name = texture["name"];
    glUniform1i(glGetUniformLocation(program, name.c_str()), static_cast<GLint>(unit++));
  }
  return unit;
}

// The texture that a shader of clusters writes, in a unit.
inline void light_clusters(const EmittedCase& one, const std::string& source, const nlohmann::json& json,
                           const nlohmann::json& lit, const std::string& bytes, GLuint unit) {
  const GLuint program = linked(source, "lit");
  glUseProgram(program);
  set_textures(program, json, bytes);
  set_light(program, one, json);
  const GLsizei width = lit["width"];
  const GLsizei height = lit["height"];
  const GLuint buffer = captured(lit["rows"], lit["parts"], GLsizeiptr{16} * width * height);
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, buffer);
  set_texture(unit, GL_RGBA32F, width, height, GL_FLOAT, nullptr, GL_RGBA);
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
}

/// An emitted run time, ready in the current context: attributes, textures, clusters under the light.
struct EmittedShaders {
  std::vector<EmittedFile> files;
  nlohmann::json json;
  std::string bytes;

  EmittedShaders(const EmittedCase& one, bool es, bool per_pixel)
      : files(emit_glsl(one.transfer, {one.name, one.light, per_pixel}, es).files),
        json(nlohmann::json::parse(files[2].bytes)),
        bytes(files[1].bytes) {
    GLuint vertices = 0;
    glGenVertexArrays(1, &vertices);
    glBindVertexArray(vertices);
    const auto lit = json.value("lit", nlohmann::json::array());
    const auto first_lit = static_cast<GLuint>(json.value("textures", nlohmann::json::array()).size());
    for (std::size_t i = 0; i < lit.size(); ++i) {
      light_clusters(one, file(lit[i]["shader"]), json, lit[i], bytes, first_lit + static_cast<GLuint>(i));
    }
  }
  [[nodiscard]] const std::string& file(const std::string& name) const {
    return std::find_if(files.begin(), files.end(), [&](const auto& one) { return one.name == name; })->bytes;
  }
  /// Makes the program current, with all that it reads.
  void use(GLuint program, const EmittedCase& one) const {
    glUseProgram(program);
    const std::size_t count = json["vertices"];
    for (const auto& attribute : json["attributes"]) {
      const int components = attribute["components"];
      set_attribute(attribute["location"], components, bytes.data() + attribute["offset"].get<std::size_t>(),
                    count * static_cast<std::size_t>(components) * sizeof(float));
    }
    GLuint unit = set_textures(program, json, bytes);
    for (const auto& texture : json.value("lit", nlohmann::json::array())) {
      const std::string name = texture["texture"];
      glUniform1i(glGetUniformLocation(program, name.c_str()), static_cast<GLint>(unit++));
    }
    set_light(program, one, json);
    const Eigen::Vector3f eye = kEye.cast<float>();
    glUniform3fv(glGetUniformLocation(program, "eye"), 1, eye.data());
  }
};

}  // namespace sh::prt::test
