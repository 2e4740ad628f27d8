// From one file of splats to another, block by block on all threads.
#pragma once
#include <Eigen/Geometry>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "prt/splats/splat_flaws.hpp"
#include "prt/splats/splat_formats.hpp"
#include "prt/splats/splat_transform.hpp"

namespace sh::prt {

/// Splats of one block. The same for any number of threads, so that the bytes are.
inline constexpr std::size_t kSplatsPerBlock = 512;

struct SplatEdit {
  std::optional<Eigen::AlignedBox3d> crop;  // first, in the axes and units of the input's scene
  Similarity similarity;                    // then, in the same axes
  std::optional<int> degree;
  FlawChoice flaws;
  std::string axes_in;   // empty: those of the format
  std::string axes_out;  // empty: those of the format
  SpzOptions spz;
};

struct SplatResult {
  std::size_t count = 0;  // of splats written
  int degree = 0;
  std::size_t dropped = 0;  // invalid ones
  std::size_t cropped = 0;
  std::size_t mended = 0;  // zero quaternions that count as the identity
  std::string losses;      // what the format could not hold of the splats, in words; empty if nothing
  std::string left_out;    // what the input has beside splats and the output has not, in words
  bool is_copy = false;    // of the input's bytes
};

/// Writes all or nothing. An input that is asked for no change, in its own format, is checked and copied byte by byte.
/// Throws std::runtime_error or std::invalid_argument with one line, output::Interrupted after a signal.
SplatResult convert_splats(const std::string& input, const std::string& output, const SplatEdit& edit);

/// Calls each(block) for all blocks in their order. The blocks are checked as for a conversion.
void for_splats(const SplatReader& reader, const FlawChoice& flaws, FlawCounts& counts,
                const std::function<void(const SplatBlock&)>& each);

}  // namespace sh::prt
