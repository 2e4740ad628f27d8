// The signs by which coefficients of Gaussian splats differ from this project's.
#pragma once
#include <string>
#include <vector>

namespace sh::prt {

/// (bands^2) factors, 1 or -1: theirs = factor times ours and the other way round. All formats of splats have the
/// convention of the preset `gaussian-splatting` (numeric/identify/presets.cpp) and its order, l(l+1)+m.
std::vector<float> splat_signs(int degree);

/// That convention in words.
std::string splat_convention();

}  // namespace sh::prt
