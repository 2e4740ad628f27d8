#include "prt/runtime/vertex_shader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "prt/light/light_coefficients.hpp"

namespace sh::prt {
namespace {

using namespace std::string_view_literals;
constexpr std::pair<std::string_view, std::string_view> kTexts[] = {
#include "shader_texts.inc"
};

std::string_view text_of(const std::string& file) {
  return std::find_if(std::begin(kTexts), std::end(kTexts), [&](const auto& text) { return text.first == file; })
      ->second;
}

}  // namespace

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
    const std::string relight = fmt::format("{}_l{}", family, degree);
    out += fmt::format("#define CHANNELS {}\n#define KEPT_COUNT COUNT\n#define KEPT(k) (k)\n#define RELIGHT {}\n{}",
                       shape.channels, relight, shape.holds_albedo ? "" : "#define RECOLORABLE\n");
    return out.append(text_of(relight + ".glsl")).append(text_of("row_sums.glsl")).append(text_of("relight_rows.vert"));
  }
  const std::string rotate = fmt::format("rotate_l{}", degree);
  const std::string irradiance = fmt::format("irradiance_evaluate_l{}", degree);
  out += fmt::format("#define ROTATE {}\n#define IRRADIANCE {}\n", rotate, irradiance);
  return out.append(text_of(rotate + ".glsl"))
      .append(text_of(irradiance + ".glsl"))
      .append(text_of("relight_normals.vert"));
}

}  // namespace sh::prt
