// What every reader of a file of splats offers.
#pragma once
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "prt/splats/splat_transform.hpp"
#include "prt/splats/splats.hpp"

namespace sh::prt {

struct PlyHeader;
struct SpzHeader;

/// The numbers of a splat, as messages name them.
enum class SplatNumber { kPosition, kRotation, kScale, kOpacity, kHarmonics };

/// Checks the structure of the file when it is made. Several threads may read blocks at once.
class SplatReader {
 public:
  virtual ~SplatReader() = default;

  [[nodiscard]] virtual const std::string& file() const = 0;
  [[nodiscard]] virtual std::size_t count() const = 0;
  [[nodiscard]] virtual int degree() const = 0;

  /// Replaces the block by splats first .. first + count - 1, which must exist. Numbers may be of any value
  /// (splat_flaws.hpp checks them). Throws std::runtime_error with one line if the file cannot be read.
  virtual void read(std::size_t first, std::size_t count, SplatBlock& block) const = 0;

  /// How the file calls a number: `index` counts within the splat's position, ..., coefficients (3, bands^2).
  [[nodiscard]] virtual std::string name_of(SplatNumber number, std::size_t index) const = 0;
  /// What `prt splats info` adds about the file.
  [[nodiscard]] virtual nlohmann::ordered_json details() const = 0;
  /// What the file holds beside splats and other formats do not, in words; empty if nothing.
  [[nodiscard]] virtual std::string extras() const { return {}; }
  /// From the splats to the scene that holds them (nodes of glTF).
  [[nodiscard]] virtual Similarity placement() const { return {}; }
  /// The header of a PLY file, else null.
  [[nodiscard]] virtual const PlyHeader* ply() const { return nullptr; }
  /// The header of an SPZ file, else null.
  [[nodiscard]] virtual const SpzHeader* spz() const { return nullptr; }
};

}  // namespace sh::prt
