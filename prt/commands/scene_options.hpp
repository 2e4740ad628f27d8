// A scene and the options that change it, for the commands that bake, plan and share a bake among processes.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "prt/commands/commands.hpp"

namespace sh::prt {

/// A scene, and options that replace its degree and its directions.
struct DirectionOptions {
  std::string scene;
  std::optional<int> degree;
  std::optional<int> directions;
  std::string sampler;  // empty: the scene's
  std::optional<std::uint32_t> seed;

  void add_to(CLI::App& command);
  void apply_to(BakeOptions& bake) const;
};

/// The same, and options that replace other entries of the scene's `bake` and `plan`.
struct SceneOptions : DirectionOptions {
  std::optional<int> bounce_directions;
  std::string kind;
  std::vector<std::uint32_t> compress;  // clusters, vectors; empty: the scene's
  bool compress_auto = false;
  bool fit_lobes = false;
  std::string plan;  // none, exact, lossy, or the file of a plan; empty: the scene's
  std::optional<double> error;
  std::string turns;
  std::vector<std::string> without;
  int threads = 0;

  void add_to(CLI::App& command);
  /// Throws std::invalid_argument beside the file of a plan, which holds all of them.
  void apply_to(Scene& loaded) const;
  /// The file of a plan, or empty.
  [[nodiscard]] std::string plan_file() const;
  /// The names of the given options.
  [[nodiscard]] std::vector<std::string> given() const;
};

/// The words of a command line that gives the options of a command, but for those left out and
/// `--log`; the first word is its name.
std::vector<std::string> words_without(const CLI::App& command, std::vector<std::string> left_out);

}  // namespace sh::prt
