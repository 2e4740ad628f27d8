// The transfer function of sRGB [IEC 61966-2-1]; primaries are those of Rec. 709, so that channels stay apart.
#pragma once
#include <cmath>

namespace sh::prt {

/// [0, 1] encoded -> [0, 1] linear.
inline double srgb_decode(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

}  // namespace sh::prt
