// What the rays of a chunk of vertices found, as bytes for a checkpoint, and back.
//   transfer vectors: (vertices, bands^2) binary32; what became of the rays: (vertices) bytes; with bounces, for each
//   vertex: 1 where its row of form factors is kept, else 0 (4 bytes); its length (4); its entries.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "prt/bake/chunks.hpp"
#include "prt/bake/fill_closed.hpp"
#include "prt/bake/form_factors.hpp"
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

}  // namespace sh::prt
