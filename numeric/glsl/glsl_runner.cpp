// Writes the shader around the function, runs it and reads the result back: see glsl_runner.hpp.
#include "numeric/glsl/glsl_runner.hpp"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace sh::numeric {
namespace {

constexpr int kTextureWidth = 2048;  // the least that ES 3.0 guarantees

// The first line of the log of a shader or a program.
template <class GetLength, class GetLog>
std::string log_of(GLuint id, GetLength get_length, GetLog get_log) {
  GLint length = 0;
  get_length(id, GL_INFO_LOG_LENGTH, &length);
  std::string log(length + 1, '\0');
  get_log(id, length + 1, &length, log.data());
  log.resize(length);
  return log.substr(0, log.find('\n'));
}

// A linked program, deleted with the object. Needs a current context.
class GlslProgram {
 public:
  // Throws std::runtime_error: "LABEL: does not compile as GLSL: MESSAGE".
  GlslProgram(const std::string& label, const std::string& vertex, const std::string& fragment)
      : id_(glCreateProgram()) {
    std::string problem = attach(GL_VERTEX_SHADER, vertex);
    if (problem.empty()) problem = attach(GL_FRAGMENT_SHADER, fragment);
    GLint linked = GL_FALSE;
    if (problem.empty()) {
      glLinkProgram(id_);
      glGetProgramiv(id_, GL_LINK_STATUS, &linked);
      if (linked != GL_TRUE) problem = "link: " + log_of(id_, glGetProgramiv, glGetProgramInfoLog);
    }
    if (problem.empty()) return;
    glDeleteProgram(id_);
    throw std::runtime_error(label + ": does not compile as GLSL: " + problem);
  }
  ~GlslProgram() { glDeleteProgram(id_); }
  GlslProgram(const GlslProgram&) = delete;
  GlslProgram& operator=(const GlslProgram&) = delete;

  [[nodiscard]] GLuint id() const { return id_; }

 private:
  // Compiles and attaches a stage; returns the message of the compiler if it fails.
  [[nodiscard]] std::string attach(GLenum type, const std::string& source) const {
    const GLuint shader = glCreateShader(type);
    const char* text = source.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    std::string problem;
    if (compiled == GL_TRUE) {
      glAttachShader(id_, shader);
    } else {
      problem = log_of(shader, glGetShaderiv, glGetShaderInfoLog);
      if (problem.empty()) problem = "the compiler gave no reason";
    }
    glDeleteShader(shader);  // lives on while attached
    return problem;
  }

  GLuint id_;
};

// The body of "void call(int item)": reads the inputs of the item, calls the function and stores four outputs in each
// texel. All indices are constant: drivers compile loops, and arrays that are indexed by variables, many times slower.
std::string wrapper(const GlslFunction& function) {
  std::string before;
  std::string arguments;
  std::vector<std::string> outputs;
  const Signature& signature = function.signature;
  int input = 0;
  if (signature.returns_value) outputs.push_back("returned");
  for (std::size_t i = 0; i < signature.parameters.size(); ++i) {
    const auto& p = signature.parameters[i];
    const auto element = [&](int k) { return p.count == 0 ? fmt::format("p{}", i) : fmt::format("p{}[{}]", i, k); };
    before += fmt::format("    float {};\n", element(p.count));
    arguments += fmt::format("{}p{}", i == 0 ? "" : ", ", i);
    for (int k = 0; k < p.values(); ++k) {
      if (p.is_written()) outputs.push_back(element(k));
      if (!p.is_read()) continue;
      before += fmt::format("    {} = read_input(item * {} + {});\n", element(k), signature.input_count(), input++);
    }
  }
  outputs.resize((outputs.size() + 3) / 4 * 4, "0.0");
  std::string after;
  for (std::size_t i = 0; i < outputs.size(); i += 4) {
    after += fmt::format("    if (part == {}) texel = vec4({}, {}, {}, {});\n", i / 4, outputs[i], outputs[i + 1],
                         outputs[i + 2], outputs[i + 3]);
  }
  return fmt::format("void call(int item) {{\n{}    {}{}({});\n{}}}\n", before,
                     signature.returns_value ? "float returned = " : "", function.name, arguments, after);
}

int texels_per_item(const GlslFunction& function) { return (function.signature.output_count() + 3) / 4; }

const char* version_line(GlslLanguage language) {
  return language == GlslLanguage::kCore450 ? "#version 450 core\n" : "#version 300 es\n";
}

// One triangle that covers the target.
std::string vertex_source(GlslLanguage language) {
  return std::string(version_line(language)) +
         "void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); "
         "}\n";
}

// With `discard`, llvmpipe compiles a shader once; without it, again for tiles that a triangle covers.
std::string fragment_source(GlslLanguage language, const std::string& source, const GlslFunction& function,
                            Grouping grouping) {
  constexpr const char* kText = R"({version}#line 1
{source}precision highp float;
precision highp int;
precision highp sampler2D;
uniform sampler2D inputs;
uniform int items;
{invariant}out vec4 texel;
int part;
float read_input(int i) {{ return texelFetch(inputs, ivec2(i % {width}, i / {width}), 0).r; }}
{wrapper}void main() {{
    int place = int(gl_FragCoord.y) * {width} + int(gl_FragCoord.x);
    int item = place / {texels};
    part = place - item * {texels};
    texel = vec4(0.0);
    if (item >= items) discard;
    call(item);
}}
)";
  return fmt::format(kText, fmt::arg("version", version_line(language)), fmt::arg("source", source),
                     fmt::arg("invariant", grouping == Grouping::kInvariant ? "invariant " : ""),
                     fmt::arg("width", kTextureWidth), fmt::arg("wrapper", wrapper(function)),
                     fmt::arg("texels", texels_per_item(function)));
}

int rows_for(std::size_t texels) { return static_cast<int>((texels + kTextureWidth - 1) / kTextureWidth); }

// A texture, deleted with the object.
class Texture {
 public:
  Texture(GLint internal_format, GLenum format, int rows, const float* data) {
    glGenTextures(1, &id_);
    glBindTexture(GL_TEXTURE_2D, id_);
    glTexImage2D(GL_TEXTURE_2D, 0, internal_format, kTextureWidth, rows, 0, format, GL_FLOAT, data);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  }
  ~Texture() { glDeleteTextures(1, &id_); }
  Texture(const Texture&) = delete;
  Texture& operator=(const Texture&) = delete;

  [[nodiscard]] GLuint id() const { return id_; }

 private:
  GLuint id_ = 0;
};

// Draws the texels of the target; returns them as RGBA, row by row.
std::vector<float> draw(const std::string& label, const GlslProgram& program, const Texture& input,
                        const Texture& target, int rows, int items) {
  GLuint framebuffer = 0;
  GLuint no_vertices = 0;
  glGenVertexArrays(1, &no_vertices);
  glBindVertexArray(no_vertices);
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target.id(), 0);
  const bool complete = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  std::vector<float> texels(complete ? std::size_t{4} * rows * kTextureWidth : 0);
  if (complete) {
    glViewport(0, 0, kTextureWidth, rows);
    glUseProgram(program.id());
    glBindTexture(GL_TEXTURE_2D, input.id());
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
  if (const GLenum error = glGetError(); error != GL_NO_ERROR) {
    throw std::runtime_error(fmt::format("{}: GL error {:#x} while running", label, error));
  }
  return texels;
}

}  // namespace

std::vector<float> GlslRunner::run(const std::string& label, const std::string& source, const GlslFunction& function,
                                   const std::vector<float>& inputs, Grouping grouping) {
  const std::size_t width = function.signature.input_count();
  if (width == 0 || inputs.empty() || inputs.size() % width != 0) {
    throw std::invalid_argument(
        fmt::format("{}: expected a positive multiple of {} inputs, got {}", label, width, inputs.size()));
  }
  context_.make_current();
  const GlslProgram program(label, vertex_source(language_), fragment_source(language_, source, function, grouping));
  const std::size_t items = inputs.size() / width;
  const int input_rows = rows_for(inputs.size());
  std::vector<float> padded = inputs;
  padded.resize(std::size_t{kTextureWidth} * input_rows);
  const std::size_t per_item = texels_per_item(function);
  const int rows = rows_for(items * per_item);
  const Texture input(GL_R32F, GL_RED, input_rows, padded.data());
  const Texture target(GL_RGBA32F, GL_RGBA, rows, nullptr);
  const std::vector<float> texels = draw(label, program, input, target, rows, static_cast<int>(items));
  // Each item fills whole texels: leave out the rest of the last one.
  std::vector<float> outputs;
  for (std::size_t i = 0; i < items; ++i) {
    const auto first = texels.begin() + static_cast<std::ptrdiff_t>(4 * per_item * i);
    outputs.insert(outputs.end(), first, first + function.signature.output_count());
  }
  return outputs;
}

}  // namespace sh::numeric
