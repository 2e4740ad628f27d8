// Shaders run by Mesa: vertex shaders with an output captured, `radiance` if no other, or programs that draw pixels.
#pragma once
#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <array>
#include <cstring>
#include <string>
#include <vector>

namespace sh::prt::test {

/// The program of two shaders, with an output of the vertices captured unless it is null.
inline GLuint linked(const std::string& vertices, const std::string& pixels, const char* output) {
  const GLuint program = glCreateProgram();
  const GLuint shader = glCreateShader(GL_VERTEX_SHADER);
  const GLuint fragment = glCreateShader(GL_FRAGMENT_SHADER);
  for (const auto& [stage, text] : {std::pair{shader, vertices}, {fragment, pixels}}) {
    const char* pointer = text.c_str();
    glShaderSource(stage, 1, &pointer, nullptr);
    glCompileShader(stage);
    glAttachShader(program, stage);
  }
  if (output != nullptr) glTransformFeedbackVaryings(program, 1, &output, GL_INTERLEAVED_ATTRIBS);
  glLinkProgram(program);
  GLint good = GL_FALSE;
  glGetProgramiv(program, GL_LINK_STATUS, &good);
  std::array<char, 512> log{};
  glGetShaderInfoLog(shader, log.size(), nullptr, log.data());
  std::array<char, 512> more{};
  glGetShaderInfoLog(fragment, more.size(), nullptr, more.data());
  EXPECT_EQ(good, GL_TRUE) << log.data() << more.data();
  return program;
}

inline GLuint linked(const std::string& source, const char* output = "radiance") {
  const bool is_es = source.rfind("#version 300 es", 0) == 0;
  return linked(source, std::string(is_es ? "#version 300 es\n" : "#version 450 core\n") + "void main() {}\n", output);
}

/// values (vertices, components) in memory.
inline void set_attribute(GLuint location, GLint components, const void* values, std::size_t bytes) {
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes), values, GL_STATIC_DRAW);
  glVertexAttribPointer(location, components, GL_FLOAT, GL_FALSE, 0, nullptr);
  glEnableVertexAttribArray(location);
}

inline void set_attribute(GLuint location, const std::vector<Eigen::Vector3f>& values) {
  set_attribute(location, 3, values.data(), values.size() * sizeof values[0]);
}

/// One channel, or `channels`, read without a filter, bound to a texture unit.
inline void set_texture(GLuint unit, GLint format, GLsizei width, GLsizei height, GLenum type, const void* numbers,
                        GLenum channels = GL_RED) {
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, channels, type, numbers);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

/// There is no window. The context needs a complete framebuffer although nothing is drawn.
inline void bind_framebuffer() {
  GLuint framebuffer = 0;
  GLuint target = 0;
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glGenRenderbuffers(1, &target);
  glBindRenderbuffer(GL_RENDERBUFFER, target);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 1, 1);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, target);
}

/// Draws points, all of them in each instance, and returns a new buffer of the output of each, bound to
/// GL_TRANSFORM_FEEDBACK_BUFFER.
inline GLuint captured(GLsizei points, GLsizei instances, GLsizeiptr bytes) {
  bind_framebuffer();
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
  glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, bytes, nullptr, GL_STREAM_READ);
  glEnable(GL_RASTERIZER_DISCARD);
  glBeginTransformFeedback(GL_POINTS);
  glDrawArraysInstanced(GL_POINTS, 0, points, instances);
  glEndTransformFeedback();
  return buffer;
}

/// Draws the vertices as points and returns the output of each.
inline std::vector<Eigen::Vector3f> captured_radiance(std::size_t count) {
  const auto bytes = static_cast<GLsizeiptr>(count * sizeof(Eigen::Vector3f));
  captured(static_cast<GLsizei>(count), 1, bytes);
  std::vector<Eigen::Vector3f> radiance(count, Eigen::Vector3f::Constant(-1e9F));
  const void* mapped = glMapBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, 0, bytes, GL_MAP_READ_BIT);
  EXPECT_NE(mapped, nullptr);
  if (mapped != nullptr) std::memcpy(radiance.front().data(), mapped, bytes);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  return radiance;
}

}  // namespace sh::prt::test
