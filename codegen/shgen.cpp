// shgen: writes, checks and shows the generated kernels.
//
//   shgen write [--out DIR]                          write generated/ (unchanged files are left alone)
//   shgen check [--dir DIR]                          compare generated/ with what would be written
//   shgen list [FAMILY...]                           kernels and recipes: operations, measured error, time, files
//   shgen tune [FAMILY...] [--degree N] [--out FILE] [--check]  measure the recipes, so that `write` takes the fastest
//   shgen emit FAMILY --degree N --lang cpp|glsl|glsl-es|hlsl|c99 [--scalar float|double]
//                     [--prefer speed|accuracy|size | --recipe NAME]  print one kernel's file
//                     [--left S] [--right S] [--keep-bands L,...] [--keep-orders=M,...] [--outputs S|I,...]
//                                                   without what these say is zero or not wanted (codegen/mask.hpp)
//   shgen dump STAGE KERNEL                          print the SSA of a kernel after a stage: dump share basis_l4
//   shgen prove [NAME...] [--degree L] [--json FILE] prove every identity of symbolic/, or those named
//   shgen errata [ID|SOURCE...] [--verdict V] [--json FILE]  formulas of the sources, each decided exactly
//   shgen tex|markdown FAMILY --degree N [--convention C]  formulas of symbolic/, typeset
//
// Exit: 0 done, 1 `check` found a difference, `prove` a false identity or `errata` a false verdict, 2 bad input.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>

#include "codegen/catalogue.hpp"
#include "codegen/errata_command.hpp"
#include "codegen/in_convention.hpp"
#include "codegen/masked_kernel.hpp"
#include "codegen/output_tree.hpp"
#include "codegen/print/dump.hpp"
#include "codegen/prove_command.hpp"
#include "codegen/tune_command.hpp"
#include "codegen/typeset_command.hpp"

namespace sh::codegen {
namespace {

constexpr int kDone = 0;
constexpr int kDifferent = 1;
constexpr int kBadInput = 2;

// ./generated when it exists (run from a checkout), otherwise the folder this tool was built from.
std::string default_folder() {
  return std::filesystem::is_regular_file("generated/MANIFEST") ? "generated" : SHFORGE_GENERATED_DIR;
}

void report_progress(const std::string& kernel) { std::cerr << "shgen: " << kernel << '\n'; }

void ignore_progress(const std::string& /*kernel*/) {}

int write(const std::string& folder) {
  make_folder(folder);
  const std::vector<std::string> written = write_tree(folder, render_all(report_progress));
  for (const std::string& name : written) std::cout << name << '\n';
  std::cerr << "shgen: " << written.size() << " files written under " << folder << '\n';
  return kDone;
}

int check(const std::string& folder) {
  require_existing(folder);
  const std::vector<std::string> differences = compare_tree(folder, render_all(ignore_progress));
  for (const std::string& line : differences) std::cout << line << '\n';
  if (!differences.empty()) return kDifferent;
  std::cerr << "shgen: " << folder << " is what the generator writes\n";
  return kDone;
}

// The manifest of a folder: every line, or those of some families.
int list(const std::string& folder, const std::vector<std::string>& only) {
  std::vector<std::string> prefixes;
  for (const std::string& name : only) prefixes.push_back(find_family(name).name + "_l");
  std::ifstream manifest(folder + "/MANIFEST");
  if (!manifest) throw std::runtime_error(folder + "/MANIFEST: cannot be read; `shgen write` writes it");
  std::string line;
  while (std::getline(manifest, line)) {
    const bool chosen = std::any_of(prefixes.begin(), prefixes.end(),
                                    [&](const std::string& prefix) { return line.rfind(prefix, 0) == 0; });
    if (prefixes.empty() || line[0] == '#' || chosen) std::cout << line << '\n';
  }
  return kDone;
}

int emit(const std::string& family, int degree, const std::string& language, const std::string& scalar,
         const std::string& prefer, const MaskOptions& mask, const ConventionOptions& convention) {
  const Language& target = find_language(language);
  const Family& chosen = find_family(family);
  const Prefer preference = find_preference(prefer);
  FinishedKernel finished =
      mask.empty() ? preferred_kernel(chosen, degree, preference) : masked_kernel(chosen, degree, preference, mask);
  if (!convention.empty()) finished = in_convention(finished, chosen.reference(degree, kReferencePoints), convention);
  std::cout << target.print_kernel(finished, find_scalar(scalar));
  return kDone;
}

void add_mask_options(CLI::App& command, MaskOptions& mask) {
  command.add_option("--left", mask.left, "Symmetries of the first coefficient array, e.g. zonal or mirror-x,mirror-y");
  command.add_option("--right", mask.right, "Symmetries of the second coefficient array");
  command.add_option("--keep-bands", mask.keep_bands, "Degrees l that are not zero, e.g. 0,1,2,4")->delimiter(',');
  command.add_option("--keep-orders", mask.keep_orders, "Orders m that are not zero, e.g. --keep-orders=-2,0,2")
      ->delimiter(',');
  command.add_option("--outputs", mask.outputs, "Wanted results: a symmetry or a list of entries, e.g. 0,2,6");
}

int emit_recipe(const std::string& family_name, int degree, const std::string& language, const std::string& scalar,
                const std::string& recipe) {
  const Family& family = find_family(family_name);
  FinishedKernel finished = finish_kernel(family, find_recipe(family, degree, recipe), degree);
  finished.kernel.arguments += " --recipe " + recipe;
  std::cout << find_language(language).print_kernel(finished, find_scalar(scalar));
  return kDone;
}

// "basis_l4" -> the stages of family basis at degree 4.
std::vector<Stage> stages_of(const std::string& kernel) {
  const std::size_t split = kernel.rfind("_l");
  const std::string digits = split == std::string::npos ? "" : kernel.substr(split + 2);
  if (digits.empty() || digits.size() > 3 || digits.find_first_not_of("0123456789") != std::string::npos) {
    throw std::invalid_argument("unknown kernel '" + kernel + "'; it should be FAMILY_lDEGREE such as basis_l4");
  }
  const Family& family = find_family(kernel.substr(0, split));
  const int degree = std::stoi(digits);
  return kernel_stages(family, fastest_recipe(family, degree), degree);
}

int dump(const std::string& stage, const std::string& kernel) {
  std::string known;
  for (const Stage& s : stages_of(kernel)) {
    if (s.name == stage) {
      std::cout << print::dump(s.kernel);
      return kDone;
    }
    known += (known.empty() ? "" : ", ") + s.name;
  }
  throw std::invalid_argument("unknown stage '" + stage + "'; it should be one of: " + known);
}

int run(int argc, char** argv) {
  CLI::App app{"Writes, checks and shows the generated spherical-harmonics kernels."};
  app.require_subcommand(0, 1);
  std::string folder;
  std::string family;
  std::string language;
  std::string scalar = "float";
  std::string prefer = "speed";
  std::string stage;
  std::string kernel;
  int degree = 0;
  auto* write_command = app.add_subcommand("write", "Write the generated files that differ");
  write_command->add_option("--out", folder, "Folder to write to (default: ./generated or the source tree's)");
  auto* check_command = app.add_subcommand("check", "Compare the generated files with what would be written");
  check_command->add_option("--dir", folder, "Folder to compare (default: ./generated or the source tree's)");
  std::vector<std::string> chosen;
  auto* list_command = app.add_subcommand("list", "List every kernel and recipe with cost, error, time and files");
  list_command->add_option("family", chosen, "Families (default: all)");
  TuneOptions tune_options;
  auto* tune_command = app.add_subcommand("tune", "Measure the recipes on this machine, for `shgen write` to choose");
  tune_command->add_option("family", tune_options.families, "Families (default: all)");
  const auto* tune_degree = tune_command->add_option("--degree", degree, "This degree only");
  tune_command->add_option("--out", tune_options.file, "Wisdom file to update (default: the source tree's)");
  tune_command->add_flag("--check", tune_options.check, "Only compare the recipes with the choice; write nothing");
  auto* emit_command = app.add_subcommand("emit", "Print the file of one kernel");
  emit_command->add_option("family", family, "Family, e.g. basis")->required();
  emit_command->add_option("--degree", degree, "Largest degree l")->required();
  emit_command->add_option("--lang", language, "Language: cpp, glsl, glsl-es, hlsl or c99")->required();
  emit_command->add_option("--scalar", scalar, "Scalar type: float or double (C++ is templated on it)");
  emit_command->add_option("--prefer", prefer, "What the recipe is chosen for: speed, accuracy or size");
  ConventionOptions convention;
  emit_command->add_option("--convention", convention.convention, "Convention of arrays, e.g. directxmath, unity");
  emit_command->add_option("--axes", convention.axes, "The convention's coordinates from the caller's, e.g. x,z,-y");
  MaskOptions mask;
  add_mask_options(*emit_command, mask);
  std::string recipe;
  emit_command->add_option("--recipe", recipe, "This recipe of the family, whatever it is good for")
      ->excludes("--prefer", "--convention", "--axes", "--left", "--right", "--keep-bands", "--keep-orders",
                 "--outputs");
  auto* dump_command = app.add_subcommand("dump", "Print the SSA of a kernel after a stage");
  dump_command->add_option("stage", stage, "recipe, share, factor, prune or schedule")->required();
  dump_command->add_option("kernel", kernel, "Kernel, e.g. basis_l4")->required();
  ProveOptions prove_options;
  auto* prove_command = app.add_subcommand("prove", "Prove every identity that the kernels rest on");
  prove_command->add_option("name", prove_options.only, "Proofs to run (default: all)");
  const auto* prove_degree =
      prove_command->add_option("--degree", degree, "Prove to this degree where the range allows");
  prove_command->add_option("--json", prove_options.json, "File to write the results to");
  ErrataOptions errata_options;
  auto* errata_command = app.add_subcommand("errata", "Decide the formulas of the sources");
  errata_command->add_option("name", errata_options.only, "Entries (B-08) or sources (B) (default: all)");
  errata_command->add_option("--verdict", errata_options.verdict, "Only entries of this verdict, e.g. wrong");
  errata_command->add_option("--json", errata_options.json, "File to write the results to");
  TypesetOptions typeset_options;
  const auto add_typeset_command = [&](const char* name, const char* what) {
    auto* command = app.add_subcommand(name, what);
    command->add_option("family", typeset_options.family, "Family, e.g. basis, rotation, gaunt, cap")->required();
    command->add_option("--degree", typeset_options.degree, "Largest degree l")->required();
    command->add_option("--convention", typeset_options.convention, "Convention, e.g. shforge, directxmath, unity");
    return command;
  };
  const auto* tex_command = add_typeset_command("tex", "Print formulas as a LaTeX document");
  const auto* markdown_command = add_typeset_command("markdown", "Print formulas as Markdown with TeX mathematics");
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& request) {  // --help
    return app.exit(request);
  } catch (const CLI::ParseError& error) {
    throw std::invalid_argument(error.what());
  }
  if (app.get_subcommands().empty()) {
    throw std::invalid_argument(
        "no command; it should be one of: write, check, list, tune, emit, dump, prove, errata, tex, markdown");
  }
  if (prove_command->parsed()) {
    if (prove_degree->count() > 0) prove_options.degree = degree;
    return prove(prove_options, std::cout, std::cerr) ? kDone : kDifferent;
  }
  if (errata_command->parsed()) {
    return errata(symbolic::errata::all_sources(), errata_options, std::cout, std::cerr) ? kDone : kDifferent;
  }
  if (tex_command->parsed() || markdown_command->parsed()) {
    std::cout << (tex_command->parsed() ? typeset_tex(typeset_options) : typeset_markdown(typeset_options));
    return kDone;
  }
  if (folder.empty()) folder = default_folder();
  if (write_command->parsed()) return write(folder);
  if (check_command->parsed()) return check(folder);
  if (list_command->parsed()) return list(folder, chosen);
  if (tune_command->parsed()) {
    if (tune_degree->count() > 0) tune_options.degree = degree;
    return tune(tune_options, std::cout, std::cerr) ? kDone : kDifferent;
  }
  if (!recipe.empty()) return emit_recipe(family, degree, language, scalar, recipe);
  if (emit_command->parsed()) return emit(family, degree, language, scalar, prefer, mask, convention);
  return dump(stage, kernel);
}

}  // namespace
}  // namespace sh::codegen

int main(int argc, char** argv) {
  try {
    const int result = sh::codegen::run(argc, argv);
    if (!std::cout.flush()) throw std::runtime_error("standard output: cannot be written; the disk should have space");
    return result;
  } catch (const std::exception& error) {
    std::cerr << "shgen: " << error.what() << '\n';
    return sh::codegen::kBadInput;
  }
}
