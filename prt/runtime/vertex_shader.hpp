// Vertex shaders that relight: the text of prt/shaders with the generated functions pasted in, complete as it is.
#pragma once
#include <string>

#include "prt/transfer/transfer.hpp"

namespace sh::prt {

enum class ShaderLanguage { kGlsl450, kEs300 };

/// Unshadowed takes normals, the others the transfer file's rows (those of an unshadowed file too, as shadowed). Throws
/// std::invalid_argument unless 0 <= degree <= kMaxDegree.
std::string vertex_shader(const TransferKind& kind, int degree, bool white, ShaderLanguage language);

}  // namespace sh::prt
