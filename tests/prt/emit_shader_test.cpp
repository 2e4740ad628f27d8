// Emitted vertex shaders, run by Mesa, against the relighting of the library.
#include <nlohmann/json.hpp>

#include "generated/cpp/transfer_prepare.hpp"
#include "numeric/glsl/egl_context.hpp"
#include "prt/basis.hpp"
#include "prt/emit/emit.hpp"
#include "prt/transfer/visibility.hpp"
#include "tests/prt/coated_cases.hpp"
#include "tests/prt/vertex_shader_run.hpp"

namespace sh::prt::test {
namespace {

// The light as the shader takes it: the coefficients that relight.json lists, times its factors.
void set_light(GLuint program, const EmittedCase& one, const nlohmann::json& json) {
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
GLuint set_textures(GLuint program, const nlohmann::json& json, const std::string& bytes) {
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
void light_clusters(const EmittedCase& one, const std::string& source, const nlohmann::json& json,
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

std::vector<Eigen::Vector3f> run(const EmittedCase& one, bool es) {
  const numeric::EglContext context(es ? numeric::GlslLanguage::kEs300 : numeric::GlslLanguage::kCore450);
  const std::vector<EmittedFile> files = emit_glsl(one.transfer, {one.name, one.light}, es).files;
  const std::string& bytes = files[1].bytes;
  const auto json = nlohmann::json::parse(files[2].bytes);
  const std::size_t count = json["vertices"];
  GLuint vertices = 0;
  glGenVertexArrays(1, &vertices);
  glBindVertexArray(vertices);
  const auto lit = json.value("lit", nlohmann::json::array());
  const auto first_lit = static_cast<GLuint>(json.value("textures", nlohmann::json::array()).size());
  for (std::size_t i = 0; i < lit.size(); ++i) {
    const auto shader =
        std::find_if(files.begin(), files.end(), [&](const auto& file) { return file.name == lit[i]["shader"]; });
    light_clusters(one, shader->bytes, json, lit[i], bytes, first_lit + static_cast<GLuint>(i));
  }
  const GLuint program = linked(files[0].bytes);
  glUseProgram(program);
  for (const auto& attribute : json["attributes"]) {
    const int components = attribute["components"];
    set_attribute(attribute["location"], components, bytes.data() + attribute["offset"].get<std::size_t>(),
                  count * static_cast<std::size_t>(components) * sizeof(float));
  }
  GLuint unit = set_textures(program, json, bytes);
  for (const auto& texture : lit) {
    const std::string name = texture["texture"];
    glUniform1i(glGetUniformLocation(program, name.c_str()), static_cast<GLint>(unit++));
  }
  set_light(program, one, json);
  const Eigen::Vector3f eye = kEye.cast<float>();
  glUniform3fv(glGetUniformLocation(program, "eye"), 1, eye.data());
  return captured_radiance(count);
}

class EmittedGlsl : public testing::TestWithParam<bool> {};

void expect_radiance_of_relighting(const std::vector<EmittedCase>& all, bool es) {
  for (const EmittedCase& one : all) expect_near(run(one, es), expected(one), one.name);
}

TEST_P(EmittedGlsl, GivesTheRadianceOfRelighting) { expect_radiance_of_relighting(emitted_cases(), GetParam()); }

TEST_P(EmittedGlsl, GivesTheRadianceOfRowsInClusters) { expect_radiance_of_relighting(clustered_cases(), GetParam()); }

TEST_P(EmittedGlsl, GivesTheRadianceOfBrdfs) { expect_radiance_of_relighting(coated_cases(), GetParam()); }

INSTANTIATE_TEST_SUITE_P(Es, EmittedGlsl, testing::Bool());

}  // namespace
}  // namespace sh::prt::test
