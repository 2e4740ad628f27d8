// Printer: kernels with SIMD inside one call, for one product or one rotation; part of generated/batch/.
//
// Their code is fixed text; what is derived are the tables that it reads, correctly rounded.
#pragma once

#include <map>
#include <string>

namespace sh::codegen::print {

/// Degrees whose products have tables of orbits.
inline constexpr int kFirstOrbitDegree = 3;
inline constexpr int kLastOrbitDegree = 6;
/// The last degree that is rotated in lanes.
inline constexpr int kLastTurnDegree = 6;

/// Relative path -> text of their files under generated/batch/.
std::map<std::string, std::string> one_files();
/// Those of them that are tables.
std::map<std::string, std::string> one_table_files();

/// Fixed texts: what the kernels share, the kernels.
extern const char* const kOneVectors;
extern const char* const kOneOrbits;
extern const char* const kOneProduct;
extern const char* const kOneRotateLanes;
extern const char* const kOneRotate;
/// Parts of batch.hpp, call.hpp and batch.cpp.
extern const char* const kOneHeader;
extern const char* const kOneTypes;
extern const char* const kOneDeclarations;
extern const char* const kOneChoice;

}  // namespace sh::codegen::print
