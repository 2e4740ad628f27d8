// Surfaceless EGL: EGL_MESA_platform_surfaceless, EGL_KHR_no_config_context, EGL_KHR_surfaceless_context.
#include "numeric/glsl/egl_context.hpp"

#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <fmt/core.h>

#include <array>
#include <cstdlib>
#include <stdexcept>

namespace sh::numeric {
namespace {

[[noreturn]] void fail(const std::string& what) {
  throw std::runtime_error(fmt::format(
      "EGL: {} failed (error {:#x}); the GLSL kernels need libegl1 and Mesa's llvmpipe (Debian: libegl-mesa0, "
      "libgl1-mesa-dri)",
      what, eglGetError()));
}

EGLDisplay surfaceless_display() {
  constexpr int kKeepWhatTheUserSet = 0;
  setenv("LIBGL_ALWAYS_SOFTWARE", "1", kKeepWhatTheUserSet);
  setenv("GALLIUM_DRIVER", "llvmpipe", kKeepWhatTheUserSet);
  setenv("GALLIVM_PERF", "nopt", kKeepWhatTheUserSet);  // unoptimised: to compile takes longer than to run
  if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) fail("EGL_MESA_platform_surfaceless");
  EGLDisplay display = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display == EGL_NO_DISPLAY) fail("eglGetPlatformDisplay");
  if (eglInitialize(display, nullptr, nullptr) == EGL_FALSE) fail("eglInitialize");
  return display;
}

}  // namespace

std::string to_string(GlslLanguage language) { return language == GlslLanguage::kCore450 ? "glsl 450" : "glsl es 300"; }

struct EglContext::Handles {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
};

EglContext::EglContext(GlslLanguage language) : handles_(std::make_unique<Handles>()) {
  handles_->display = surfaceless_display();
  const bool core = language == GlslLanguage::kCore450;
  if (eglBindAPI(core ? EGL_OPENGL_API : EGL_OPENGL_ES_API) == EGL_FALSE) fail("eglBindAPI");
  const std::array<EGLint, 7> core_attributes = {
      EGL_CONTEXT_MAJOR_VERSION,           4,       EGL_CONTEXT_MINOR_VERSION, 5, EGL_CONTEXT_OPENGL_PROFILE_MASK,
      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
  const std::array<EGLint, 5> es_attributes = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 0, EGL_NONE};
  handles_->context = eglCreateContext(handles_->display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT,
                                       core ? core_attributes.data() : es_attributes.data());
  if (handles_->context == EGL_NO_CONTEXT) fail("eglCreateContext for " + to_string(language));
  make_current();
}

// The display belongs to the process and is shared by every context in it, so it is not terminated.
EglContext::~EglContext() {
  eglMakeCurrent(handles_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(handles_->display, handles_->context);
}

void EglContext::make_current() const {
  if (eglMakeCurrent(handles_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, handles_->context) == EGL_FALSE) {
    fail("eglMakeCurrent");
  }
}

std::string EglContext::renderer() const {
  make_current();
  const auto* const name = glGetString(GL_RENDERER);
  return name == nullptr ? "" : reinterpret_cast<const char*>(name);
}

}  // namespace sh::numeric
