// Runs a GLSL function over many inputs on a CPU and returns its outputs as floats, to compare them bit by bit.
//
// Input: the text of one or more functions without a #version line, the signature of the one to call, and n packed
// items of its inputs. Output: n packed items of its outputs, both in the flat order of signature.hpp. A fragment
// shader reads a float texture and writes another, four values a texel: GLSL ES 3.00 has nothing else, and drivers
// compile that faster than storage buffers. Takes any function whose parameters are float or float[n], in, out or
// inout, such as basis_l4(float, float, float, out float[25]).
#pragma once

#include <string>
#include <vector>

#include "numeric/glsl/egl_context.hpp"
#include "numeric/kernels/signature.hpp"

namespace sh::numeric {

struct GlslFunction {
  std::string name;
  Signature signature;
};

/// Whether the compiler may regroup operations, such as k1 (k2 v) as (k1 k2) v. GLSL allows it unless the result is
/// declared invariant (OpenGL Shading Language 4.50, section 4.8.1).
enum class Grouping { kFree, kInvariant };

class GlslRunner {
 public:
  /// Throws std::runtime_error, one line, if EGL or the version of GL is missing.
  explicit GlslRunner(GlslLanguage language) : language_(language), context_(language) {}

  /// inputs (n, input_count()) row-major -> (n, output_count()) of the signature. `label` names the source in errors,
  /// usually by its file. Throws std::runtime_error, one line, if the source does not compile (the first message of the
  /// compiler) or GL reports an error, std::invalid_argument if `inputs` is not a whole number of items.
  std::vector<float> run(const std::string& label, const std::string& source, const GlslFunction& function,
                         const std::vector<float>& inputs, Grouping grouping = Grouping::kFree);

  [[nodiscard]] std::string renderer() const { return context_.renderer(); }

 private:
  GlslLanguage language_;
  EglContext context_;
};

}  // namespace sh::numeric
