// The vertex shaders, run by Mesa with their outputs captured, against the relighting in C++.
#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cstring>

#include "numeric/glsl/egl_context.hpp"
#include "prt/runtime/relight.hpp"
#include "prt/runtime/vertex_shader.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/rooms.hpp"

namespace sh::prt::test {
namespace {

GLuint linked(const std::string& source) {
  const GLuint program = glCreateProgram();
  const GLuint shader = glCreateShader(GL_VERTEX_SHADER);
  const bool is_es = source.rfind("#version 300 es", 0) == 0;
  const GLuint fragment = glCreateShader(GL_FRAGMENT_SHADER);
  const std::string nothing = std::string(is_es ? "#version 300 es\n" : "#version 450 core\n") + "void main() {}\n";
  for (const auto& [stage, text] : {std::pair{shader, source}, {fragment, nothing}}) {
    const char* pointer = text.c_str();
    glShaderSource(stage, 1, &pointer, nullptr);
    glCompileShader(stage);
    glAttachShader(program, stage);
  }
  const char* output = "radiance";
  glTransformFeedbackVaryings(program, 1, &output, GL_INTERLEAVED_ATTRIBS);
  glLinkProgram(program);
  GLint good = GL_FALSE;
  glGetProgramiv(program, GL_LINK_STATUS, &good);
  char log[512] = "";
  glGetShaderInfoLog(shader, sizeof log, nullptr, static_cast<char*>(log));
  EXPECT_EQ(good, GL_TRUE) << static_cast<const char*>(log);
  return program;
}

void set_attribute(GLuint location, const std::vector<Eigen::Vector3f>& values) {
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(values.size() * sizeof values[0]), values.data(),
               GL_STATIC_DRAW);
  glVertexAttribPointer(location, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
  glEnableVertexAttribArray(location);
}

void set_transfer(std::vector<float> numbers) {
  constexpr GLsizei kWidth = 2048;
  const auto rows = static_cast<GLsizei>((numbers.size() + kWidth - 1) / kWidth);
  numbers.resize(static_cast<std::size_t>(rows) * kWidth);
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, kWidth, rows, 0, GL_RED, GL_FLOAT, numbers.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

/// There is no window. The context needs a complete framebuffer although nothing is drawn.
void bind_framebuffer() {
  GLuint framebuffer = 0;
  GLuint target = 0;
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glGenRenderbuffers(1, &target);
  glBindRenderbuffer(GL_RENDERBUFFER, target);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 1, 1);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, target);
}

void set_light(GLuint program, const LightCoefficients& light, bool white) {
  std::vector<float> values;
  for (std::size_t i = 0; i < light.bands_squared(); ++i) {
    for (std::size_t c = 0; c < (white ? 1U : 3U); ++c) values.push_back(static_cast<float>(light.at(c, i)));
  }
  const auto count = static_cast<GLsizei>(light.bands_squared());
  const GLint place = glGetUniformLocation(program, "light");
  white ? glUniform1fv(place, count, values.data()) : glUniform3fv(place, count, values.data());
}

/// The output of the shader for every vertex. A shader that takes normals turns the light by `turn` into the object's
/// axes.
std::vector<Eigen::Vector3f> run(const Transfer& transfer, const LightCoefficients& light, bool white,
                                 const Eigen::Matrix3d& turn, ShaderLanguage language) {
  const numeric::EglContext context(language == ShaderLanguage::kGlsl450 ? numeric::GlslLanguage::kCore450
                                                                         : numeric::GlslLanguage::kEs300);
  const std::size_t count = transfer.mesh.positions.size();
  GLuint vertices = 0;
  glGenVertexArrays(1, &vertices);
  glBindVertexArray(vertices);
  const GLuint program = linked(vertex_shader(*transfer.kind, light.degree, white, language));
  glUseProgram(program);
  set_attribute(0, transfer.mesh.positions);
  set_attribute(1, transfer.mesh.albedo);
  set_attribute(2, transfer.mesh.normals);
  if (!transfer.emitted.empty()) set_attribute(3, transfer.emitted);
  set_transfer(transfer.coefficients);
  set_light(program, light, white);
  const Eigen::Matrix<float, 3, 3, Eigen::RowMajor> rows = turn.cast<float>();
  glUniform1fv(glGetUniformLocation(program, "rotation"), 9, rows.data());
  bind_framebuffer();
  GLuint captured = 0;
  glGenBuffers(1, &captured);
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, captured);
  const auto bytes = static_cast<GLsizeiptr>(count * sizeof(Eigen::Vector3f));
  glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, bytes, nullptr, GL_STREAM_READ);
  glEnable(GL_RASTERIZER_DISCARD);
  glBeginTransformFeedback(GL_POINTS);
  glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(count));
  glEndTransformFeedback();
  std::vector<Eigen::Vector3f> radiance(count, Eigen::Vector3f::Constant(-1e9F));
  const void* mapped = glMapBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, 0, bytes, GL_MAP_READ_BIT);
  EXPECT_NE(mapped, nullptr);
  if (mapped != nullptr) std::memcpy(radiance.front().data(), mapped, bytes);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  return radiance;
}

Transfer baked_torus(const TransferKind* kind, int degree) {
  return baked(primitive_mesh("torus", 12), kind, 64, degree);
}

void expect_close(const std::vector<Eigen::Vector3f>& got, const std::vector<Eigen::Vector3f>& expected) {
  ASSERT_EQ(got.size(), expected.size());
  for (std::size_t v = 0; v < got.size(); ++v) EXPECT_LT((got[v] - expected[v]).norm(), 2e-6F) << v;
}

// The shader gives what relight() gives, under colored and under white light.
void expect_as_relight(const Transfer& transfer, const LightCoefficients& light, const Eigen::Matrix3d& turn,
                       ShaderLanguage language) {
  expect_close(run(transfer, light, false, turn, language), relight(transfer, turned(light, turn)));
  expect_close(run(transfer, white(light), true, turn, language), relight(transfer, turned(white(light), turn)));
}

class VertexShader : public testing::TestWithParam<ShaderLanguage> {};

TEST_P(VertexShader, OfRowsGivesWhatRelightGives) {
  for (const TransferKind* kind : {&kShadowed, &kInterreflected}) {
    for (const int degree : {1, 4}) {
      const Transfer transfer = baked_torus(kind, degree);
      expect_as_relight(transfer, random_light(degree, 1), Eigen::Matrix3d::Identity(), GetParam());
    }
  }
}

TEST_P(VertexShader, OfNormalsTurnsTheLightAndGivesWhatUnshadowedTransferGives) {
  const Eigen::Matrix3d turn = rotation_about({1.0, -2.0, 0.5}, 130.0);
  for (const int degree : {2, 4}) {
    const Transfer transfer = baked_torus(&kUnshadowed, degree);
    expect_as_relight(transfer, random_light(degree, 2), turn, GetParam());
  }
}

TEST_P(VertexShader, AddsTheLightOfTheSurfacesThemselves) {
  for (const TransferKind* kind : {&kUnshadowed, &kShadowed, &kInterreflected}) {
    Transfer transfer = baked_torus(kind, 2);
    transfer.emitted.assign(transfer.mesh.positions.size(), {0.5F, 1.0F, 2.0F});
    transfer.emitted.front().setZero();
    expect_as_relight(transfer, random_light(2, 3), Eigen::Matrix3d::Identity(), GetParam());
  }
}

INSTANTIATE_TEST_SUITE_P(Languages, VertexShader, testing::Values(ShaderLanguage::kGlsl450, ShaderLanguage::kEs300));

}  // namespace
}  // namespace sh::prt::test
