// An OpenGL or OpenGL ES context without a window or display: surfaceless EGL on the software rasterizer of Mesa,
// llvmpipe.
//
// It needs no GPU and no display server, and gives the same results wherever Mesa runs. The constructor sets
// LIBGL_ALWAYS_SOFTWARE, GALLIUM_DRIVER and GALLIVM_PERF in the environment of the process, unless they are set already.
#pragma once

#include <memory>
#include <string>

namespace sh::numeric {

enum class GlslLanguage {
  kCore450,  ///< OpenGL 4.5 core, GLSL 4.50
  kEs300,    ///< OpenGL ES 3.0, GLSL ES 3.00 (that of WebGL 2)
};

/// "glsl 450" or "glsl es 300".
std::string to_string(GlslLanguage language);

class EglContext {
 public:
  /// Makes the context current on this thread. Throws std::runtime_error, one line, if EGL or the version is missing.
  explicit EglContext(GlslLanguage language);
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  void make_current() const;
  /// The name that the renderer gives itself, such as "llvmpipe (LLVM 15.0.6, 256 bits)".
  [[nodiscard]] std::string renderer() const;

 private:
  struct Handles;
  std::unique_ptr<Handles> handles_;
};

}  // namespace sh::numeric
