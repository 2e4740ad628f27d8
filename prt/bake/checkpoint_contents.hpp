// The contents of a checkpoint: its key, which names all that decides the results of rays, and those results of a chunk
// of vertices, as bytes and back.
//   transfer vectors: (vertices, bands^2) binary32; the fate of the rays: (vertices) bytes; with bounces, for each
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

/// Where the results of the rays lie.
struct ShadowResult {
  Transfer& transfer;        // its first vertices x bands^2 coefficients
  std::vector<Sight> sight;  // (vertices)
  FormFactors* factors;      // null where hits are not wanted
};

std::string encode_chunk(const ShadowResult& result, const VertexRange& range);

/// False, with nothing that matters changed, where the data are not of that chunk's shape.
bool decode_chunk(std::string_view data, const VertexRange& range, ShadowResult& result);

/// A JSON object: counts and checksum of the mesh and of `open` (see Plan), kind, degree, directions, sampler, seed,
/// instruction set. Albedo, tolerance and solver, which only the bounces use, are not in it: rays do not depend on
/// them.
std::string bake_key(const Scene& scene, const std::string& instruction_set, const std::vector<std::uint8_t>& open);

}  // namespace sh::prt
