// What a bake produces: a mesh and one vector of SH coefficients per vertex.
// Transfer vectors hold the cosine and 1/pi but not the albedo, so that a baked mesh can be recoloured:
//   exit radiance (RGB) = albedo * sum_i T_i L_i,   L (3, bands^2) the SH coefficients of the incident radiance.
// A vertex under constant unit radiance and an open sky thus has sum_i T_i L_i = 1.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "prt/mesh.hpp"

namespace sh::prt {

inline constexpr int kMaxDegree = 10;

/// Unshadowed (DU): every vertex sees its whole hemisphere. Shadowed (DS): rays decide.
enum class TransferKind : std::uint32_t { kUnshadowed = 0, kShadowed = 1 };

/// Transfer vectors of every vertex of `mesh`.
struct Transfer {
  std::string scene;  // the scene's name, for people
  Mesh mesh;
  int degree = 0;  // 0..kMaxDegree
  TransferKind kind = TransferKind::kUnshadowed;
  std::uint32_t directions = 0;     // over the whole sphere; 0 where no ray was traced
  std::string instruction_set;      // bits are reproducible on this instruction set
  std::vector<float> coefficients;  // (vertices, bands^2), row-major, i = l(l+1)+m
  [[nodiscard]] std::size_t bands_squared() const {
    const auto bands = static_cast<std::size_t>(degree) + 1;
    return bands * bands;
  }
};

}  // namespace sh::prt
