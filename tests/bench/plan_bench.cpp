// What plans promise and what they cost: for error limits .1, .03 and .01, the stated error of `prt plan` against the
// error measured with 16 times the directions over eight turns of the light, the rays that the plan prints against those
// that its bake traces, and its bytes a vertex. Minutes a scene; `glossy` and `lobes` are the glossy scene in coarse,
// without and with bounces. Usage: plan_bench [--keep FOLDER] [--directions N] [--turns none|about_z|any]
// [demo|real|room|gltf|glossy|lobes]..., by default all scenes. The folder keeps the bakes with 16 times the directions
// for the next run; N and the turns of the light replace the scene's. Exit 0 if every measured error is at most the
// stated one, and every stated one at most 4 times it (with bounces 6 times).
#include <fmt/core.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "numeric/output/stopwatch.hpp"
#include "prt/scene/scene.hpp"
#include "prt/transfer/kept_bands.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "tests/prt/plan_promise.hpp"

namespace {

using namespace sh::prt;
using nlohmann::json;

constexpr int kMoreDirections = 16;
constexpr double kLoosest = 4.0;         // stated over measured
constexpr double kLoosestBounces = 6.0;  // the same with bounces

const char* const kGltf = "/usr/share/assimp/models/glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb";

Scene scene_of(const json& description) {
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "shforge_plan_bench.json";
  std::ofstream(file) << description;
  Scene scene = load_scene(file.string(), OnFlaw::kMend);
  std::filesystem::remove(file);
  return scene;
}

// The glossy scene in coarse, so that it takes a minute; kind is that of its transfer.
Scene glossy_scene(const TransferKind& kind) {
  json glossy = json::parse(std::ifstream(std::string(SHFORGE_SCENES) + "/glossy.json"));
  glossy["meshes"][0]["segments"] = 40;
  glossy["meshes"][1]["segments"] = 32;
  glossy["meshes"][2]["max_edge"] = 0.25;
  glossy["ground"]["max_edge"] = 0.4;
  glossy["bake"] = {{"transfer", kind.word}, {"degree", 4}, {"directions", 512}};
  return scene_of(glossy);
}

// The scene of a word; the demo's real scene has longer edges here, so that it takes minutes and not an hour.
Scene scene_called(const std::string& word) {
  const std::string folder = SHFORGE_SCENES;
  if (word == "room") return load_scene(folder + "/room.json", OnFlaw::kMend);
  if (word == "glossy") return glossy_scene(kGlossyShadowed);
  if (word == "lobes") return glossy_scene(kGlossyInterreflected);
  if (word == "real") {
    json real = json::parse(std::ifstream(folder + "/real.json"));
    real["meshes"][0]["max_edge"] = 0.08;
    return scene_of(real);
  }
  if (word == "gltf") return scene_of({{"meshes", {{{"file", kGltf}}}}, {"ground", json::object()}});
  return load_scene(word, OnFlaw::kMend);
}

// The bands that glossy transfer keeps.
std::string bands_text(const Transfer& transfer) {
  if (!transfer.kind->stores_visibility()) return "";
  const KeptBands kept = kept_by(transfer);
  std::string visibility = fmt::format(", visibility to {}", kept.visibility);
  if (!transfer.kind->stores_matrices()) return visibility;
  return fmt::format("{}, {} x {}", visibility, transfer.indirect_shape.rows(), transfer.indirect_shape.columns());
}

// Prints one line; true if the promise is kept.
bool keeps_promise(const Scene& scene, const Transfer& reference, double error) {
  const PlanOptions options{.mode = PlanMode::kLossy, .error = error, .turns = scene.plan.turns};
  const sh::output::Stopwatch planning;
  try {
    const BakeJob job = test::planned_as(scene, options);
    const double plan_seconds = planning.seconds();
    BakeReport report;
    const sh::output::Stopwatch baking;
    const Transfer planned = test::stored(bake(job, &report));
    const double bake_seconds = baking.seconds();
    const double stated = job.plan->record.error;
    const double measured = test::measured_error(scene, planned, reference, options.turns, *job.plan);
    const double loosest = scene.bake.kind->has_bounces() ? kLoosestBounces : kLoosest;
    const bool kept = measured <= stated && stated <= loosest * measured && stated <= error;
    fmt::print("  {:<6g}{:>10.2g}{:>10.2g}{:>8.2f}{:>10.2f}{:>10.2f}{:>8.1f}{:>8.1f}{:>8.1f}  {} {} {} {}{}{}\n", error,
               stated, measured, stated / measured, static_cast<double>(job.plan->planned.rays) * 1e-6,
               static_cast<double>(report.rays) * 1e-6, plan_seconds, bake_seconds,
               static_cast<double>(job.plan->planned.bytes) / static_cast<double>(scene.mesh.positions.size()),
               planned.kind->letters, planned.degree(), planned.directions,
               word_of(planned.shape.storage.element, kElementNames), bands_text(planned), kept ? "" : "  BROKEN");
    return kept;
  } catch (const std::invalid_argument& refusal) {
    fmt::print("  {:<6g}refused: {}\n", error, refusal.what());
    return false;
  }
}

struct Options {
  std::string keep;    // folder, or empty
  int directions = 0;  // or the scene's
  std::optional<LightTurns> turns;
  std::vector<std::string> words;
};

Options options_of(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--keep" && i + 1 < argc) {
      options.keep = argv[++i];
    } else if (word == "--directions" && i + 1 < argc) {
      options.directions = std::stoi(argv[++i]);
    } else if (word == "--turns" && i + 1 < argc) {
      options.turns = value_called<LightTurns>(argv[++i], kLightTurnsNames);
      if (!options.turns) {
        throw std::invalid_argument(fmt::format("--turns: expected none, about_z or any, got {}", argv[i]));
      }
    } else {
      options.words.push_back(word);
    }
  }
  if (options.words.empty()) options.words = {"demo", "real", "room", "gltf", "glossy", "lobes"};
  return options;
}

Transfer reference_of(const std::string& word, const Scene& scene, const std::string& keep) {
  const int directions = kMoreDirections * scene.bake.directions;
  const std::filesystem::path file = std::filesystem::path(keep) / fmt::format("{}_{}.transfer", word, directions);
  if (!keep.empty() && std::filesystem::exists(file)) return read_transfer(file.string());
  Transfer reference = test::full_bake(scene, directions);
  if (!keep.empty()) write_transfer(file.string(), reference);
  return reference;
}

bool measure(const std::string& word, const Options& options) {
  Scene scene = scene_called(word);
  if (options.directions > 0) scene.bake.directions = options.directions;
  if (options.turns) scene.plan.turns = *options.turns;
  const Transfer reference = reference_of(word, scene, options.keep);
  fmt::print("{}: {} vertices, {}, {} directions against {}\n", word, scene.mesh.positions.size(),
             scene.bake.kind->word, scene.bake.directions, reference.directions);
  fmt::print("  {:<6}{:>10}{:>10}{:>8}{:>10}{:>10}{:>8}{:>8}{:>8}\n", "limit", "stated", "measured", "ratio",
             "M planned", "M traced", "plan s", "bake s", "bytes");
  bool kept = true;
  for (const double error : {0.1, 0.03, 0.01}) kept = keeps_promise(scene, reference, error) && kept;
  std::fflush(stdout);
  return kept;
}

}  // namespace

int main(int argc, char** argv) try {
  const Options options = options_of(argc, argv);
  bool kept = true;
  for (const std::string& word : options.words) kept = measure(word, options) && kept;
  return kept ? 0 : 1;
} catch (const std::exception& error) {
  fmt::print(stderr, "plan_bench: {}\n", error.what());
  return 2;
}
