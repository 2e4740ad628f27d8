// Vertex shaders that relight: the text of prt/shaders with the generated functions pasted in. The result is complete.
#pragma once
#include <string>

#include "prt/transfer/transfer.hpp"

namespace sh::prt {

enum class ShaderLanguage { kGlsl450, kEs300 };

/// The shader of unshadowed transfer reads normals. The other shaders read the rows of the transfer file; the shadowed
/// one also reads the rows of an unshadowed file. Throws std::invalid_argument unless 0 <= degree <= kMaxDegree.
std::string vertex_shader(const TransferKind& kind, int degree, bool white, ShaderLanguage language);

}  // namespace sh::prt
