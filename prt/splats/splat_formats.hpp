// The table of formats of Gaussian splats.
#pragma once
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "prt/splats/splat_reader.hpp"
#include "prt/splats/splat_writer.hpp"

namespace sh::prt {

struct SplatFormat {
  std::string_view name;
  std::string_view ending;  // of its files
  std::string_view axes;    // that its files usually have (splat_axes.hpp)
  bool needs_box;           // its header states the box of all positions, or depends on it
  std::unique_ptr<SplatReader> (*read)(const std::string& file);
  std::unique_ptr<SplatWriter> (*write)(const SplatOutput& output);
};

std::span<const SplatFormat> splat_formats();

/// By the first bytes of the file. Throws std::runtime_error with one line if it is of none of them.
const SplatFormat& splat_format_of(const std::string& file);

/// By the ending of a name. Throws std::invalid_argument with one line if it is none of theirs.
const SplatFormat& splat_format_named(const std::string& file);

}  // namespace sh::prt
