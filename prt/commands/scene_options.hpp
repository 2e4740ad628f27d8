// A scene and the options that change it, for the commands that bake, plan and share a bake among processes.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "prt/commands/commands.hpp"

namespace sh::prt {

/// A scene, and options that replace entries of its `bake` and `plan`.
struct SceneOptions {
  std::string scene;
  std::optional<int> degree;
  std::optional<int> directions;
  std::optional<int> bounce_directions;
  std::string sampler;
  std::optional<std::uint32_t> seed;
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
