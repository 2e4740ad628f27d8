// Writes the shader around the function, runs it and reads the result back: see glsl_runner.hpp.
#include "numeric/glsl/glsl_runner.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "numeric/glsl/glsl_program.hpp"

namespace sh::numeric {
namespace {

constexpr int kTextureWidth = 2048;  // the least that ES 3.0 guarantees

// name[i]
std::string indexed(const std::string& name, int i) {
  std::string text = name;
  text += '[';
  text += std::to_string(i);
  text += ']';
  return text;
}

// The body of "void call(int item)": reads the item's inputs by read_input, calls the function and hands every output,
// a name with a constant index, to `store`. Constant indices throughout: drivers compile arrays that are indexed by
// variables, and loops, many times slower.
template <class Store>
std::string wrapper(const GlslFunction& function, Store&& store) {
  std::ostringstream before;
  std::ostringstream arguments;
  std::ostringstream after;
  const Signature& signature = function.signature;
  int input = 0;
  int output = 0;
  if (signature.returns_value) after << store(output++, "returned");
  for (std::size_t i = 0; i < signature.parameters.size(); ++i) {
    const auto& p = signature.parameters[i];
    const std::string name = std::string("p").append(std::to_string(i));
    before << "    float " << (p.count == 0 ? name : indexed(name, p.count)) << ";\n";
    arguments << (i == 0 ? "" : ", ") << name;
    for (int k = 0; k < p.values(); ++k) {
      const std::string element = p.count == 0 ? name : indexed(name, k);
      if (p.is_written()) after << store(output++, element);
      if (!p.is_read()) continue;
      before << "    " << element << " = read_input(item * " << signature.input_count() << " + " << input++ << ");\n";
    }
  }
  return "void call(int item) {\n" + before.str() + "    " + (signature.returns_value ? "float returned = " : "") +
         function.name + "(" + arguments.str() + ");\n" + after.str() + "}\n";
}

int texels_per_item(const GlslFunction& function) { return (function.signature.output_count() + 3) / 4; }

std::string version_line(GlslLanguage language) {
  return language == GlslLanguage::kCore450 ? "#version 450 core\n" : "#version 300 es\n";
}

// One triangle that covers the target.
std::string vertex_source(GlslLanguage language) {
  return version_line(language) +
         "void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); "
         "}\n";
}

std::string fragment_source(GlslLanguage language, const std::string& source, const GlslFunction& function,
                            Grouping grouping) {
  std::ostringstream text;
  text << version_line(language) << "#line 1\n"
       << source << "precision highp float;\nprecision highp int;\nprecision highp sampler2D;\n"
       << "uniform sampler2D inputs;\nuniform int items;\n"
       << (grouping == Grouping::kInvariant ? "invariant " : "") << "out vec4 texel;\nint part;\n"
       << "float read_input(int i) { return texelFetch(inputs, ivec2(i % " << kTextureWidth << ", i / " << kTextureWidth
       << "), 0).r; }\n"
       << wrapper(function,
                  [](int i, const std::string& value) {
                    return "    if (part == " + std::to_string(i / 4) + ") texel[" + std::to_string(i % 4) +
                           "] = " + value + ";\n";
                  })
       << "void main() {\n"
       << "    int place = int(gl_FragCoord.y) * " << kTextureWidth << " + int(gl_FragCoord.x);\n"
       << "    int item = place / " << texels_per_item(function) << ";\n"
       << "    part = place - item * " << texels_per_item(function) << ";\n"
       << "    texel = vec4(0.0);\n"
       << "    if (item < items) call(item);\n"
       << "}\n";
  return text.str();
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
  GLuint no_vertices = 0;
  glGenVertexArrays(1, &no_vertices);
  glBindVertexArray(no_vertices);
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
  glDeleteVertexArrays(1, &no_vertices);
  if (!complete) throw std::runtime_error(label + ": this GL cannot render to float textures (EXT_color_buffer_float)");
  return texels;
}

std::vector<float> run_items(GlslLanguage language, const std::string& label, const std::string& source,
                             const GlslFunction& function, const std::vector<float>& inputs, int items,
                             Grouping grouping) {
  const GlslProgram program(label, {{GL_VERTEX_SHADER, vertex_source(language)},
                                    {GL_FRAGMENT_SHADER, fragment_source(language, source, function, grouping)}});
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
                                   const std::vector<float>& inputs, Grouping grouping) {
  const auto width = static_cast<std::size_t>(function.signature.input_count());
  if (width == 0 || inputs.empty() || inputs.size() % width != 0) {
    throw std::invalid_argument(label + ": " + std::to_string(inputs.size()) + " inputs given, must be a multiple of " +
                                std::to_string(width) + " and not none");
  }
  context_.make_current();
  const auto items = static_cast<int>(inputs.size() / width);
  return run_items(language_, label, source, function, inputs, items, grouping);
}

}  // namespace sh::numeric
