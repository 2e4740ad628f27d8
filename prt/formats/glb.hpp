// GLB files: a glTF document and one buffer [Khronos, glTF 2.0, section 4].
#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "prt/binary/glb_container.hpp"

namespace sh::prt::formats {

/// A glTF document in the making, and its buffer.
class Glb {
 public:
  Glb();
  nlohmann::ordered_json json;

  /// Adds bytes as a buffer view and returns its number. `target` is 34962 for vertices, 34963 for indices, 0 for others.
  std::size_t add_view(std::string_view bytes, int target = 0);
  /// Adds an accessor of the float type SCALAR .. VEC4 over values (count, width), and returns its number.
  std::size_t add_floats(const std::vector<float>& values, int width);
  /// The bytes of the file. Throws std::invalid_argument from 4 GB on.
  [[nodiscard]] std::string bytes() const;

 private:
  std::string buffer_;
};

/// The JSON text of a GLB file; nothing for another file. Throws std::runtime_error for a damaged one.
std::optional<std::string_view> json_of_glb(std::string_view bytes);

}  // namespace sh::prt::formats
