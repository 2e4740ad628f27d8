// Pictures as files have them: the bytes of PNG or JPEG, which a transfer file keeps as they are.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace sh::prt {

struct EncodedPicture {
  std::string name;  // for people
  std::string bytes;
  bool operator==(const EncodedPicture&) const = default;
};

/// The pictures of a mesh, one after another, as in files.
struct Pictures {
  struct Head {
    std::string name;
    std::size_t bytes = 0;
  };
  std::vector<Head> heads;
  std::vector<std::int8_t> bytes;

  /// The number of an equal one, which is added if there is none. Throws std::runtime_error for more than 65535.
  std::size_t number_of(const EncodedPicture& picture);
  [[nodiscard]] EncodedPicture at(std::size_t number) const;
  /// The bytes that the heads count.
  [[nodiscard]] std::size_t byte_count() const { return first_byte(heads.size()); }

 private:
  [[nodiscard]] std::size_t first_byte(std::size_t number) const;
};

}  // namespace sh::prt
