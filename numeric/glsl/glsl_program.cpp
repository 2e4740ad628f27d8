// See glsl_program.hpp.
#include "numeric/glsl/glsl_program.hpp"

#include <sstream>
#include <stdexcept>

namespace sh::numeric {
namespace {

std::string first_line(const std::string& log) { return log.substr(0, log.find('\n')); }

std::string shader_log(GLuint shader) {
  GLint length = 0;
  glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(length) + 1, '\0');
  glGetShaderInfoLog(shader, length + 1, &length, log.data());
  log.resize(length);
  return log;
}

std::string program_log(GLuint program) {
  GLint length = 0;
  glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(length) + 1, '\0');
  glGetProgramInfoLog(program, length + 1, &length, log.data());
  log.resize(length);
  return log;
}

// The stage compiled and attached, or the compiler's message.
std::string attach(GLuint program, const GlslStage& stage) {
  const GLuint shader = glCreateShader(stage.type);
  const char* text = stage.source.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint compiled = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  std::string problem = compiled == GL_TRUE ? "" : first_line(shader_log(shader));
  if (compiled == GL_TRUE) glAttachShader(program, shader);
  glDeleteShader(shader);  // lives on while attached
  return compiled == GL_TRUE || !problem.empty() ? problem : "the compiler gave no reason";
}

}  // namespace

GlslProgram::GlslProgram(const std::string& label, const std::vector<GlslStage>& stages) : id_(glCreateProgram()) {
  std::string problem;
  for (const auto& stage : stages) {
    if (problem.empty()) problem = attach(id_, stage);
  }
  if (problem.empty()) {
    glLinkProgram(id_);
    GLint linked = GL_FALSE;
    glGetProgramiv(id_, GL_LINK_STATUS, &linked);
    if (linked != GL_TRUE) problem = "link: " + first_line(program_log(id_));
  }
  if (problem.empty()) return;
  glDeleteProgram(id_);
  throw std::runtime_error(label + ": does not compile as GLSL: " + problem);
}

void require_no_gl_error(const std::string& label) {
  const GLenum error = glGetError();
  if (error == GL_NO_ERROR) return;
  std::ostringstream line;
  line << label << ": GL error 0x" << std::hex << error << " while running";
  throw std::runtime_error(line.str());
}

}  // namespace sh::numeric
