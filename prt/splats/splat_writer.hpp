// What every writer of a file of splats offers, and what it has to know before the first splat.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "prt/splats/splats.hpp"

namespace sh::prt {

class SplatReader;

/// How SPZ is to store numbers.
struct SpzOptions {
  std::optional<int> version;      // 2, 3 or 4; otherwise that of the input, or 3
  std::optional<int> first_bits;   // of coefficients of degree 1, 1 to 8; otherwise 5
  std::optional<int> higher_bits;  // of degree 2 and above, 1 to 8; otherwise 4
  [[nodiscard]] bool any() const { return version || first_bits || higher_bits; }
};

struct SplatOutput {
  std::string file;
  int degree = 0;
  SplatSummary summary;                // of all splats that will be written; its box only where the format needs it
  SplatParts changed;                  // a PLY file made from a PLY file keeps what is not changed
  const SplatReader* input = nullptr;  // null: splats made in memory
  SpzOptions spz;
};

/// The bytes of a block: one piece for each part of the file that grows.
using SplatPieces = std::vector<std::string>;

/// Writes a file completely or not at all (AtomicFile). Several threads may encode; append() is called for one block
/// after the other, in their order, and finish() last.
class SplatWriter {
 public:
  virtual ~SplatWriter() = default;
  [[nodiscard]] virtual SplatPieces encode(const SplatBlock& block) const = 0;
  virtual void append(const SplatPieces& pieces) = 0;
  virtual void finish() = 0;
  /// What the format could not hold, in words for a warning; empty if nothing.
  [[nodiscard]] virtual std::string losses() const { return {}; }
};

}  // namespace sh::prt
