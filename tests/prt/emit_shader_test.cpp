// Emitted vertex shaders, run by Mesa, against the relighting of the library.
#include <nlohmann/json.hpp>

#include "generated/cpp/transfer_prepare.hpp"
#include "numeric/glsl/egl_context.hpp"
#include "prt/basis.hpp"
#include "prt/emit/emit.hpp"
#include "prt/transfer/visibility.hpp"
#include "tests/prt/emitted_cases.hpp"
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

void set_textures(GLuint program, const nlohmann::json& json, const std::string& bytes) {
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
  const GLuint program = linked(files[0].bytes);
  glUseProgram(program);
  for (const auto& attribute : json["attributes"]) {
    const int components = attribute["components"];
    set_attribute(attribute["location"], components, bytes.data() + attribute["offset"].get<std::size_t>(),
                  count * static_cast<std::size_t>(components) * sizeof(float));
  }
  set_textures(program, json, bytes);
  set_light(program, one, json);
  const Eigen::Vector3f eye = kEye.cast<float>();
  glUniform3fv(glGetUniformLocation(program, "eye"), 1, eye.data());
  return captured_radiance(count);
}

class EmittedGlsl : public testing::TestWithParam<bool> {};

TEST_P(EmittedGlsl, GivesTheRadianceOfRelighting) {
  for (const EmittedCase& one : emitted_cases()) expect_near(run(one, GetParam()), expected(one), one.name);
}

INSTANTIATE_TEST_SUITE_P(Es, EmittedGlsl, testing::Bool());

}  // namespace
}  // namespace sh::prt::test
