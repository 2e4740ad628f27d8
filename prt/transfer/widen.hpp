// Numbers of transfer files to single precision, exactly; with the conversions of the processor where it has them.
#pragma once
#include <cstddef>
#include <cstdint>

namespace sh::prt {

/// to (count) = IEEE binary16, by its bits; finite.
void widen_halves(const std::uint16_t* from, std::size_t count, float* to);

/// to (rows, columns) = signed 8 bits times the scale of the column, (columns).
void widen_bytes(const std::int8_t* from, std::size_t rows, std::size_t columns, const float* scale, float* to);

}  // namespace sh::prt
