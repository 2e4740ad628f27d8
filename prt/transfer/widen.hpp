// Numbers of transfer files to single precision, exactly; with the conversions of the processor where it has them.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

namespace sh::prt {

/// to (count) = IEEE binary16, by its bits; finite.
void widen_halves(const std::uint16_t* from, std::size_t count, float* to);

/// to (count) = signed 8 bits times scales, which start again at their end.
void widen_bytes(const std::int8_t* from, std::size_t count, std::span<const float> scales, float* to);

}  // namespace sh::prt
