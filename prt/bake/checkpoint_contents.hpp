// The contents of a checkpoint: its key, which names everything that the results of rays depend on, and the results of
// a chunk of vertices, encoded as bytes and decoded.
//   transfer vectors: (vertices, bands^2) binary32; Sight of each vertex: (vertices) bytes; with bounces, for each
//   vertex: 1 where its row of form factors is kept, else 0 (4 bytes); its length (4); its entries.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "prt/bake/chunks.hpp"
#include "prt/bake/fill_closed.hpp"
#include "prt/bake/form_factors.hpp"
#include "prt/scene/scene.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {

/// References to the results of the rays.
struct ShadowResult {
  Transfer& transfer;        // its first vertices x bands^2 coefficients
  std::vector<Sight> sight;  // (vertices)
  FormFactors* factors;      // null if hits are not needed
};

std::string encode_chunk(const ShadowResult& result, const VertexRange& range);

/// Returns false, and changes no finished result, if the data do not have the shape of the chunk.
bool decode_chunk(std::string_view data, const VertexRange& range, ShadowResult& result);

/// A JSON object: counts and checksum of the mesh and of `open` (see Plan), kind, degree, directions, sampler, seed,
/// instruction set. Albedo, tolerance and solver are not in it: only the bounces use them, and rays do not depend on
/// them.
std::string bake_key(const Scene& scene, const std::string& instruction_set, const std::vector<std::uint8_t>& open);

}  // namespace sh::prt
