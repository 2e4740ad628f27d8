// Wisdom: how long each recipe took on the machine it was tuned on; the committed file decides which recipe is written.
//
// A text file, one line a measurement: family, degree, recipe, nanoseconds a call, nanoseconds a lane. `shgen tune`
// writes it, everything else only reads it, so that generated files do not depend on the machine at hand.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <tuple>

namespace sh::codegen {

struct Timing {
  double call = 0;  ///< nanoseconds of one call in float, arguments in the first-level cache
  double lane = 0;  ///< nanoseconds for each result when every variable holds the lanes of a SIMD register
};

/// Recipes closer than this ratio count as equally fast; the one that its family lists first wins.
inline constexpr double kNoise = 1.10;

class Wisdom {
 public:
  /// Throws std::runtime_error, one line with the line's number, when a line is not a measurement. A file that does
  /// not exist is no wisdom.
  static Wisdom read(const std::filesystem::path& file);

  void set(const std::string& family, int degree, const std::string& recipe, Timing timing);
  void set_machine(std::string machine) { machine_ = std::move(machine); }
  [[nodiscard]] std::optional<Timing> find(const std::string& family, int degree, const std::string& recipe) const;
  /// The content of the file.
  [[nodiscard]] std::string to_string() const;

 private:
  std::string machine_;
  std::map<std::tuple<std::string, int, std::string>, Timing> timings_;
};

/// The committed file, and its content.
std::filesystem::path wisdom_file();
const Wisdom& committed_wisdom();

}  // namespace sh::codegen
