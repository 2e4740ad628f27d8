// Wisdom: the measured times of the recipes on the machines that were tuned. The committed files decide which recipe
// `shgen write` takes.
//
// A machine is a family of processors with a family of compilers, such as amd-gcc; its file has a line for each measurement:
// family, degree, recipe, nanoseconds per call, nanoseconds per lane. `shgen tune` writes it. Everything else only reads the
// files, so generated files do not depend on the current machine.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "codegen/families/family.hpp"

namespace sh::codegen {

/// The measured time of a recipe.
struct Timing {
  double call = 0;  ///< nanoseconds of one call in float, by itself, with the arguments in the first-level cache
  double lane = 0;  ///< nanoseconds for each result if every variable holds the lanes of a SIMD register
};

/// Two recipes count as equally fast if the ratio of their times is below this. The one that the family lists first
/// wins.
inline constexpr double kNoise = 1.10;

/// The content of a wisdom file.
class Wisdom {
 public:
  /// Reads the file; a missing file gives an empty Wisdom. Throws std::runtime_error, one line with the number of the
  /// wrong line, if a line is not a measurement.
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

/// The folder of the committed files.
std::filesystem::path wisdom_folder();
/// The committed wisdom, by the name of the machine.
const std::map<std::string, Wisdom>& committed_wisdom();
/// How many times as long as the fastest of them each recipe takes, on average over the machines (the geometric mean). Machines
/// that did not measure all of them do not count; without one that did the list is empty.
std::vector<double> mean_slowdowns(const std::map<std::string, Wisdom>& machines, const std::string& family, int degree,
                                   const std::vector<std::string>& recipes);

/// The name of this machine: the maker of its processor and the family of the compiler (the environment variable CXX,
/// otherwise c++), such as amd-gcc or intel-clang.
std::string machine_name();
/// Describes that compiler and the processor.
std::string describe_machine();

/// Measures recipes: prints them as C++, compiles this code with the machine's compiler and runs it. The times are in
/// the order of `recipes`, which take turns in several passes; the minimum counts. Takes a few seconds. Throws
/// std::runtime_error with the compiler's first message if the compiler fails.
std::vector<Timing> measure_times(const Family& family, const std::vector<Recipe>& recipes, int degree);

}  // namespace sh::codegen
