// The vertex shaders, run by Mesa with their outputs captured, against the relighting in C++.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "numeric/glsl/egl_context.hpp"
#include "prt/runtime/relight.hpp"
#include "prt/runtime/vertex_shader.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/rooms.hpp"
#include "tests/prt/vertex_shader_run.hpp"

namespace sh::prt::test {
namespace {

void set_transfer(std::vector<float> numbers) {
  constexpr GLsizei kWidth = 2048;
  const auto rows = static_cast<GLsizei>((numbers.size() + kWidth - 1) / kWidth);
  numbers.resize(static_cast<std::size_t>(rows) * kWidth);
  set_texture(0, GL_R32F, kWidth, rows, GL_FLOAT, numbers.data());
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
  return captured_radiance(count);
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
