// Printer: the exact tables, correctly rounded, that kernels with SIMD inside one call read; part of generated/batch/.
#pragma once

#include <map>
#include <string>

namespace sh::codegen::print {

/// Degrees whose products have tables of orbits.
inline constexpr int kFirstOrbitDegree = 3;
inline constexpr int kLastOrbitDegree = 6;
/// The last degree that is rotated in lanes.
inline constexpr int kLastTurnDegree = 6;

/// Relative path -> text: orbits of products, triples of the Gaunt tensor, turns of bands.
std::map<std::string, std::string> lane_tables();

}  // namespace sh::codegen::print
