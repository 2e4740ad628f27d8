// Writes the shader around the function, runs it and reads the result back: see glsl_runner.hpp.
#include "numeric/glsl_runner.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "numeric/glsl_program.hpp"

namespace sh::numeric {
namespace {

constexpr int kGroupSize = 64;
constexpr int kTextureWidth = 2048;  // the least that ES 3.0 guarantees

// name[i]
std::string indexed(const std::string& name, int i) {
  std::string text = name;
  text += '[';
  text += std::to_string(i);
  text += ']';
  return text;
}

// "void call(int item)": reads the item's inputs by read_input, calls the function, leaves its outputs in result[].
std::string wrapper(const GlslFunction& function) {
  std::ostringstream before;
  std::ostringstream arguments;
  std::ostringstream after;
  const Signature& signature = function.signature;
  int input = 0;
  int output = signature.returns_value ? 1 : 0;
  for (std::size_t i = 0; i < signature.parameters.size(); ++i) {
    const auto& p = signature.parameters[i];
    const std::string name = std::string("p").append(std::to_string(i));
    before << "    float " << (p.count == 0 ? name : indexed(name, p.count)) << ";\n";
    arguments << (i == 0 ? "" : ", ") << name;
    for (int k = 0; k < p.values(); ++k) {
      const std::string element = p.count == 0 ? name : indexed(name, k);
      if (p.is_written()) after << "    result[" << output++ << "] = " << element << ";\n";
      if (!p.is_read()) continue;
      before << "    " << element << " = read_input(item * " << signature.input_count() << " + " << input++ << ");\n";
    }
  }
  std::ostringstream text;
  text << "float result[" << signature.output_count() << "];\n"
       << "void call(int item) {\n"
       << before.str() << "    " << (signature.returns_value ? "result[0] = " : "") << function.name << "("
       << arguments.str() << ");\n"
       << after.str() << "}\n";
  return text.str();
}

std::string compute_source(const std::string& source, const GlslFunction& function) {
  const int outputs = function.signature.output_count();
  std::ostringstream text;
  text << "#version 450 core\n#line 1\n"
       << source << "layout(local_size_x = " << kGroupSize << ") in;\n"
       << "layout(std430, binding = 0) readonly buffer Inputs { float inputs[]; };\n"
       << "layout(std430, binding = 1) writeonly buffer Outputs { float outputs[]; };\n"
       << "uniform int items;\n"
       << "float read_input(int i) { return inputs[i]; }\n"
       << wrapper(function) << "void main() {\n"
       << "    int item = int(gl_GlobalInvocationID.x);\n"
       << "    if (item >= items) return;\n"
       << "    call(item);\n"
       << "    for (int i = 0; i < " << outputs << "; ++i) outputs[item * " << outputs << " + i] = result[i];\n"
       << "}\n";
  return text.str();
}

int texels_per_item(const GlslFunction& function) { return (function.signature.output_count() + 3) / 4; }

// One triangle that covers the target.
constexpr const char* kCoveringTriangle =
    "#version 300 es\n"
    "void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); }\n";

std::string fragment_source(const std::string& source, const GlslFunction& function) {
  const int outputs = function.signature.output_count();
  std::ostringstream text;
  text << "#version 300 es\n#line 1\n"
       << source << "precision highp float;\nprecision highp int;\nprecision highp sampler2D;\n"
       << "uniform sampler2D inputs;\nuniform int items;\nout vec4 texel;\n"
       << "float read_input(int i) { return texelFetch(inputs, ivec2(i % " << kTextureWidth << ", i / " << kTextureWidth
       << "), 0).r; }\n"
       << wrapper(function) << "void main() {\n"
       << "    int place = int(gl_FragCoord.y) * " << kTextureWidth << " + int(gl_FragCoord.x);\n"
       << "    int item = place / " << texels_per_item(function) << ";\n"
       << "    int first = 4 * (place - item * " << texels_per_item(function) << ");\n"
       << "    texel = vec4(0.0);\n"
       << "    if (item >= items) return;\n"
       << "    call(item);\n"
       << "    for (int i = 0; i < 4; ++i) if (first + i < " << outputs << ") texel[i] = result[first + i];\n"
       << "}\n";
  return text.str();
}

GLsizeiptr bytes(std::size_t floats) { return static_cast<GLsizeiptr>(floats * sizeof(float)); }

std::vector<float> run_compute(const std::string& label, const std::string& source, const GlslFunction& function,
                               const std::vector<float>& inputs, int items) {
  const GlslProgram program(label, {{GL_COMPUTE_SHADER, compute_source(source, function)}});
  std::vector<float> outputs(static_cast<std::size_t>(items) * static_cast<std::size_t>(function.signature.output_count()));
  GLuint buffers[2] = {0, 0};
  glGenBuffers(2, buffers);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, buffers[0]);
  glBufferData(GL_SHADER_STORAGE_BUFFER, bytes(inputs.size()), inputs.data(), GL_STATIC_DRAW);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, buffers[1]);
  glBufferData(GL_SHADER_STORAGE_BUFFER, bytes(outputs.size()), nullptr, GL_DYNAMIC_READ);
  glUseProgram(program.id());
  glUniform1i(glGetUniformLocation(program.id(), "items"), items);
  glDispatchCompute((static_cast<GLuint>(items) + kGroupSize - 1) / kGroupSize, 1, 1);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, bytes(outputs.size()), outputs.data());
  glUseProgram(0);
  glDeleteBuffers(2, buffers);
  require_no_gl_error(label);
  return outputs;
}

int rows_for(std::size_t texels) {
  return static_cast<int>((texels + kTextureWidth - 1) / static_cast<std::size_t>(kTextureWidth));
}

GLuint make_texture(GLint internal_format, GLenum format, int rows, const float* data) {
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, internal_format, kTextureWidth, rows, 0, format, GL_FLOAT, data);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  return texture;
}

// Draws the target's texels; returns them as RGBA, row by row.
std::vector<float> draw(const std::string& label, const GlslProgram& program, GLuint input, GLuint target, int rows,
                        int items) {
  GLuint framebuffer = 0;
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target, 0);
  const bool complete = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  std::vector<float> texels(complete ? 4 * static_cast<std::size_t>(rows) * kTextureWidth : 0);
  if (complete) {
    glViewport(0, 0, kTextureWidth, rows);
    glUseProgram(program.id());
    glBindTexture(GL_TEXTURE_2D, input);
    glUniform1i(glGetUniformLocation(program.id(), "inputs"), 0);
    glUniform1i(glGetUniformLocation(program.id(), "items"), items);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glReadPixels(0, 0, kTextureWidth, rows, GL_RGBA, GL_FLOAT, texels.data());
    glUseProgram(0);
  }
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glDeleteFramebuffers(1, &framebuffer);
  if (!complete) {
    throw std::runtime_error(label + ": this GL ES cannot render to float textures (EXT_color_buffer_float)");
  }
  return texels;
}

std::vector<float> run_fragment(const std::string& label, const std::string& source, const GlslFunction& function,
                                const std::vector<float>& inputs, int items) {
  const GlslProgram program(
      label, {{GL_VERTEX_SHADER, kCoveringTriangle}, {GL_FRAGMENT_SHADER, fragment_source(source, function)}});
  const int input_rows = rows_for(inputs.size());
  std::vector<float> padded(inputs);
  padded.resize(static_cast<std::size_t>(input_rows) * kTextureWidth);
  const auto per_item = static_cast<std::size_t>(texels_per_item(function));
  const int rows = rows_for(static_cast<std::size_t>(items) * per_item);
  const GLuint textures[2] = {make_texture(GL_R32F, GL_RED, input_rows, padded.data()),
                              make_texture(GL_RGBA32F, GL_RGBA, rows, nullptr)};
  std::vector<float> texels;
  try {
    texels = draw(label, program, textures[0], textures[1], rows, items);
  } catch (...) {
    glDeleteTextures(2, textures);
    throw;
  }
  glDeleteTextures(2, textures);
  require_no_gl_error(label);
  // Drop the padding of each item to whole texels.
  const auto wanted = static_cast<std::size_t>(function.signature.output_count());
  std::vector<float> outputs;
  outputs.reserve(static_cast<std::size_t>(items) * wanted);
  for (std::size_t i = 0; i < static_cast<std::size_t>(items); ++i) {
    const auto first = texels.begin() + static_cast<std::ptrdiff_t>(4 * per_item * i);
    outputs.insert(outputs.end(), first, first + static_cast<std::ptrdiff_t>(wanted));
  }
  return outputs;
}

}  // namespace

GlslRunner::GlslRunner(GlslLanguage language) : language_(language), context_(language) {}

std::vector<float> GlslRunner::run(const std::string& label, const std::string& source, const GlslFunction& function,
                                   const std::vector<float>& inputs) {
  const auto width = static_cast<std::size_t>(function.signature.input_count());
  if (width == 0 || inputs.empty() || inputs.size() % width != 0) {
    throw std::invalid_argument(label + ": " + std::to_string(inputs.size()) + " inputs given, must be a multiple of " +
                                std::to_string(width) + " and not none");
  }
  context_.make_current();
  const auto items = static_cast<int>(inputs.size() / width);
  return language_ == GlslLanguage::kCore450 ? run_compute(label, source, function, inputs, items)
                                             : run_fragment(label, source, function, inputs, items);
}

}  // namespace sh::numeric
