// What a command line says in place of a scene's `bake`: prt/commands/commands.hpp.
#include "prt/commands/commands.hpp"
#include "prt/transfer/transfer_names.hpp"

namespace sh::prt {

void BakeOverrides::add_to(CLI::App& command) {
  command.add_option("--degree", degree, "0 to 10, instead of the scene's");
  command.add_option("--directions", directions, "rays a vertex over the whole sphere, instead of the scene's");
  command.add_option("--sampler", sampler, "how the directions are chosen, instead of the scene's")
      ->check(CLI::IsMember(std::vector<std::string>(kSamplerNames.begin(), kSamplerNames.end())));
  command.add_option("--seed", seed, "of all samplers but fibonacci, instead of the scene's")
      ->check(CLI::Range(0, kMaxSeed));
  command.add_option("--kind", kind, "unshadowed, shadowed or interreflected, instead of the scene's")
      ->check(CLI::IsMember({"unshadowed", "shadowed", "interreflected"}));
}

void BakeOverrides::apply_to(BakeOptions& bake) const {
  bake.degree = degree.value_or(bake.degree);
  bake.directions = directions.value_or(bake.directions);
  bake.sampler = sampler_called(sampler).value_or(bake.sampler);
  bake.seed = seed.value_or(bake.seed);
  if (!kind.empty()) {
    bake.kind = kind_called(kind);
  }
  require_degree(bake.degree);
}

}  // namespace sh::prt
