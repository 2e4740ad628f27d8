// `prt plan SCENE`: prints the work that a bake can leave out, its savings and its error.
#include <memory>
#include <nlohmann/json.hpp>

#include "prt/bake/bake.hpp"
#include "prt/commands/commands.hpp"

namespace sh::prt {
namespace {

struct Options {
  std::string scene;
  BakeOverrides bake;
  PlanArguments plan;
  bool json = false;
  int threads = 0;
};

void run(const Options& options) {
  const Stopwatch stopwatch;
  Scene scene = load_scene(options.scene, OnFlaw::kMend);
  options.bake.apply_to(scene.bake);
  scene.plan = options.plan.applied_to(scene.plan);
  if (options.plan.mode.empty()) scene.plan.mode = PlanMode::kLossy;
  BakeSettings settings;
  settings.threads = options.threads;
  const BakeJob job = planned({std::move(scene), settings});
  print_out(options.json ? plan_json(*job.plan, job.scene).dump(2) + "\n" : plan_text(*job.plan, job.scene));
  report_time(stopwatch, "planned");
}

}  // namespace

void PlanArguments::add_to(CLI::App& command) {
  command.add_option("--plan", mode, "none: leave nothing out; exact: change no number; lossy: stay within the error")
      ->check(CLI::IsMember({"none", "exact", "lossy"}));
  command.add_option("--error", error, "error limit of a lossy plan, instead of the scene's");
  command
      .add_option("--light-turns", turns, "later rotations of the lights that the plan allows, instead of the scene's")
      ->check(CLI::IsMember({"none", "about_z", "any"}));
  command.add_option("--without", without, "decisions to skip")->delimiter(',');
}

PlanOptions PlanArguments::applied_to(PlanOptions options) const {
  if (!mode.empty()) {
    options.mode = mode == "none" ? PlanMode::kNone : mode == "exact" ? PlanMode::kExact : PlanMode::kLossy;
  } else if (error) {
    options.mode = PlanMode::kLossy;
  }
  options.error = error.value_or(options.error);
  options.turns = turns.empty() ? options.turns : *turns_called(turns);
  options.without.insert(options.without.end(), without.begin(), without.end());
  return options;
}

void add_plan_command(CLI::App& tool) {
  auto options = std::make_shared<Options>();
  CLI::App* command = tool.add_subcommand("plan", "list the work that a bake can leave out, and the error");
  command->add_option("SCENE", options->scene, "a scene's JSON file, or `demo`, the embedded scene")->required();
  options->bake.add_to(*command);
  options->plan.add_to(*command);
  command->add_flag("--json", options->json, "print JSON for programs");
  command->add_option("--threads", options->threads, "number of threads; 0: every core")->capture_default_str();
  command->callback([options] { with_threads(options->threads, [&] { run(*options); }); });
}

}  // namespace sh::prt
