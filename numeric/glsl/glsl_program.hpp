// Compiles and links GLSL; a failure becomes one line that names the source.
#pragma once

#include <epoxy/gl.h>

#include <string>
#include <vector>

namespace sh::numeric {

struct GlslStage {
  GLenum type;  // GL_COMPUTE_SHADER, GL_VERTEX_SHADER, GL_FRAGMENT_SHADER
  std::string source;
};

// A linked program, deleted with the object. Needs a current context.
class GlslProgram {
 public:
  // Throws std::runtime_error: "LABEL: does not compile as GLSL: MESSAGE".
  GlslProgram(const std::string& label, const std::vector<GlslStage>& stages);
  ~GlslProgram() { glDeleteProgram(id_); }
  GlslProgram(const GlslProgram&) = delete;
  GlslProgram& operator=(const GlslProgram&) = delete;

  [[nodiscard]] GLuint id() const { return id_; }

 private:
  GLuint id_;
};

// Throws std::runtime_error "LABEL: GL error 0x... while running" if GL has recorded an error.
void require_no_gl_error(const std::string& label);

}  // namespace sh::numeric
