// The transfer function of sRGB [IEC 61966-2-1] and its inverse. sRGB has the primaries of Rec. 709, so that no channel
// depends on another.
#pragma once
#include <cmath>

namespace sh::output {

/// [0, 1] encoded -> [0, 1] linear.
template <class Real>
Real srgb_decode(Real encoded) {
  return encoded <= Real(0.04045) ? encoded / Real(12.92) : std::pow((encoded + Real(0.055)) / Real(1.055), Real(2.4));
}

/// [0, 1] linear -> [0, 1] encoded.
template <class Real>
Real srgb_encode(Real linear) {
  return linear <= Real(0.0031308) ? Real(12.92) * linear
                                   : Real(1.055) * std::pow(linear, Real(1) / Real(2.4)) - Real(0.055);
}

}  // namespace sh::output
