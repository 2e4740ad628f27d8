#include "prt/runtime/vertex_shader.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "prt/light/light_coefficients.hpp"
#include "prt/runtime/shader_texts.hpp"

namespace sh::prt {
std::string vertex_shader(const TransferKind& kind, int degree, bool white, ShaderLanguage language) {
  require_degree(degree);
  if (kind.is_glossy()) {
    throw std::invalid_argument(fmt::format("transfer of kind {}: expected a diffuse kind", kind.letters));
  }
  const TransferShape shape = kind.shape(degree);
  std::string out = language == ShaderLanguage::kGlsl450 ? "#version 450 core\n" : "#version 300 es\n";
  out += fmt::format("// `prt shader`: transfer {}, degree {}, {} light.\n",
                     !kind.traces_rays()   ? "unshadowed, from normals"
                     : !kind.has_bounces() ? "of one channel"
                                           : "with bounces",
                     degree, white ? "white" : "RGB");
  out += fmt::format("#define COUNT {}\n{}", shape.count(), white ? "#define WHITE\n" : "");
  if (kind.traces_rays()) {
    const char* family = shape.channels == 3 ? "relight_colored" : white ? "relight" : "relight_rgb";
    const std::string relight = kernel_name(family, degree);
    out += fmt::format("#define CHANNELS {}\n#define KEPT_COUNT COUNT\n#define KEPT(k) (k)\n#define RELIGHT {}\n{}",
                       shape.channels, relight, shape.holds_albedo ? "" : "#define RECOLORABLE\n");
    return out.append(shader_text(relight + ".glsl"))
        .append(shader_text("numbers.glsl"))
        .append(shader_text("row_sums.glsl"))
        .append(shader_text("relight_rows.vert"));
  }
  const std::string rotate = kernel_name("rotate", degree);
  const std::string irradiance = kernel_name("irradiance_evaluate", degree);
  out += fmt::format("#define ROTATE {}\n#define IRRADIANCE {}\n", rotate, irradiance);
  return out.append(shader_text(rotate + ".glsl"))
      .append(shader_text(irradiance + ".glsl"))
      .append(shader_text("relight_normals.vert"));
}

}  // namespace sh::prt
