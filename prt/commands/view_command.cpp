// `prt view FILE... -o view.html`: one page that shows baked transfer, and stages of it, under live light, in any browser,
// without a network.
// `prt view FILE... --serve`: the same page from a server on this machine, for files that are too large for one page.
// `prt view FILE -o relight.js`: the module by which other pages relight such files.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>

#include "numeric/output/atomic_file.hpp"
#include "prt/commands/commands.hpp"
#include "prt/runtime/relight_stage.hpp"
#include "prt/say.hpp"
#include "prt/scene/coefficients_json.hpp"
#include "prt/scene/stage.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "prt/view/page.hpp"
#include "prt/view/serve.hpp"

namespace sh::prt {
namespace {

struct ViewCommand {
  std::vector<std::string> files;
  std::string transfers;
  std::string output;
  bool serve = false;
  int port = 0;
  LightOptions light;
  int threads = 0;
};

/// The page's files and subjects, and what the first stage among them says about light and camera.
struct Chosen {
  Viewed viewed;
  std::vector<LightSpec> lights;
  std::optional<Camera> camera;
  std::vector<std::string> inputs;            // all files that are read
  std::map<std::string, std::size_t> places;  // of transfer files, by path
};

std::string bytes_of(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::string name_of(const std::string& file) { return std::filesystem::path(file).filename().string(); }

ViewedFile viewed(const std::string& file, std::shared_ptr<const Transfer> transfer) {
  if (!transfer->grid && (transfer->mesh.positions.empty() || transfer->mesh.faces.empty())) {
    throw std::runtime_error(fmt::format("{}: a transfer without faces: nothing to view", file));
  }
  return {name_of(file), bytes_of(file), std::move(transfer)};
}

/// The transfer is read first: it checks the bytes.
ViewedFile viewed(const std::string& file) {
  const TransferKind* kind = kind_of_file(file);
  const bool is_medium = kind != nullptr && kind->in_medium;
  return viewed(file,
                std::make_shared<const Transfer>(read_transfer(file, is_medium ? medium_kinds() : surface_kinds())));
}

/// The place of a file among those of the page, which has each once.
template <class Read>
std::size_t place_of(const std::string& file, const Read& read, Chosen& chosen) {
  const auto [place, is_new] = chosen.places.emplace(file, chosen.viewed.files.size());
  if (is_new) chosen.viewed.files.push_back(read());
  return place->second;
}

/// Messages about objects inside of others, at the times of all keys.
void report_overlaps(const Stage& stage, OnFlaw flaws) {
  std::set<std::string> lines;
  for (const StageObject& object : stage.objects) {
    for (const Motion::Key& key : object.motion.keys) {
      for (const std::string& line : overlaps(stage, poses_at(stage, key.time))) {
        if (lines.insert(line).second) report_flaw(flaws, line);
      }
    }
  }
}

void add_stage(const std::string& file, const ViewCommand& options, Chosen& chosen) {
  Stage stage = load_stage(file, options.transfers);
  ViewedSubject subject{name_of(file), stage.name, {}, stage.objects, {}};
  const auto has_volume = [](const StageObject& object) { return object.volume != nullptr; };
  if (std::count_if(stage.objects.begin(), stage.objects.end(), has_volume) > 1) {
    throw std::runtime_error(fmt::format(
        "{}: a page shadows objects by one volume and by spheres; expected one object with `volume`", file));
  }
  for (const StageObject& object : stage.objects) {
    if (object.from_scene) {
      throw std::runtime_error(fmt::format(
          "{}: {}: a page does not sample light from the scene; expected objects without `light_from` scene", file,
          object.name));
    }
    if (object.per_vertex && object.transfer->kind->is_glossy()) {
      throw std::runtime_error(
          fmt::format("{}: {}: a page gathers the light of glossy objects at their centers; expected `light_at` center",
                      file, object.name));
    }
    if (object.transfer->kind->in_medium) {
      throw std::runtime_error(
          fmt::format("{}: {}: a page shows a medium alone, not on a stage; expected surfaces", file, object.name));
    }
    if (object.volume && object.volume->kind->stores_matrices()) {
      throw std::runtime_error(fmt::format(
          "{}: {}: a page does not show what an object reflects onto others; expected `volume` without `--reflected`",
          file, object.name));
    }
    subject.files.push_back(place_of(
        object.file, [&] { return viewed(object.file, object.transfer); }, chosen));
    std::optional<std::size_t>& volume = subject.volumes.emplace_back();
    if (!object.volume) continue;
    volume = place_of(
        object.volume_file, [&] { return viewed(object.volume_file, object.volume); }, chosen);
  }
  report_overlaps(stage, on_flaw(options.light.strict));
  chosen.viewed.subjects.push_back(std::move(subject));
  if (chosen.lights.empty()) chosen.lights = stage.lights;
  if (!chosen.camera) chosen.camera = stage.camera;
  chosen.inputs.insert(chosen.inputs.end(), stage.files.begin(), stage.files.end());
}

Chosen all_chosen(const ViewCommand& options) {
  Chosen chosen;
  for (const std::string& file : options.files) {
    chosen.inputs.push_back(file);
    if (file.ends_with(".json")) {
      add_stage(file, options, chosen);
    } else {
      const std::size_t place = place_of(
          file, [&] { return viewed(file); }, chosen);
      chosen.viewed.subjects.push_back({name_of(file), chosen.viewed.files[place].transfer->scene, {place}, {}, {}});
    }
  }
  return chosen;
}

std::string name_of_light(const ViewCommand& options, const Chosen& chosen) {
  const LightOptions& light = options.light;
  const auto stem = [](const std::string& file) { return std::filesystem::path(file).stem().string(); };
  if (!light.light.empty()) return stem(light.light);
  if (!light.scene.empty()) return "lights of " + stem(light.scene);
  return chosen.lights.empty() ? "overcast" : "lights of the stage";
}

std::string page_of(const ViewCommand& options, const Chosen& chosen, FilesOfPage where) {
  int degree = 0;
  for (const ViewedFile& file : chosen.viewed.files) degree = std::max(degree, file.transfer->degree());
  const ChosenLight light = choose_light(options.light, chosen.lights);
  if (!options.output.empty()) output::require_no_input(options.output, light.files);
  return viewer_page(chosen.viewed,
                     {name_of_light(options, chosen), project_windowed(light.lights, degree, options.light.window)},
                     light.camera ? light.camera : chosen.camera, where);
}

std::string module_of(const ViewCommand& options) {
  if (options.files.size() > 1 || options.files.front().ends_with(".json")) {
    throw std::runtime_error(fmt::format("{}: a module relights files like one: expected one transfer file, got {}",
                                         options.output, fmt::join(options.files, ", ")));
  }
  const std::string& file = options.files.front();
  return viewer_module(*viewed(file, std::make_shared<const Transfer>(read_transfer(file))).transfer);
}

void write(const ViewCommand& options) {
  require_output(options.output, {".html", ".js"});
  output::require_no_input(options.output, options.files);
  const Stopwatch stopwatch;
  std::string text;
  if (options.output.ends_with(".js")) {
    text = module_of(options);
  } else {
    const Chosen chosen = all_chosen(options);
    output::require_no_input(options.output, chosen.inputs);
    text = page_of(options, chosen, FilesOfPage::kInside);
  }
  output::write_file(options.output, text);
  report_time(stopwatch, fmt::format("wrote {}, {} bytes,", options.output, text.size()));
}

/// A file of the system's folder for such, which goes away with it.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& bytes)
      : name_((std::filesystem::temp_directory_path() / "prt-picture-XXXXXX").string()) {
    const int descriptor = mkstemp(name_.data());
    if (descriptor >= 0) close(descriptor);
    if (!std::ofstream(name_, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()))) {
      throw std::runtime_error("the server has no room for the picture in its folder of temporary files");
    }
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() { std::remove(name_.c_str()); }
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  std::string name_;
};

/// The light of a lat-long picture that a page sends. Messages are without a file's name: the page knows it.
std::string projected(const std::string& bytes, int degree) {
  const TemporaryFile file(bytes);
  try {
    const std::vector<Light> lights = load_lights(named_lights(file.name(), "lat_long"), OnFlaw::kMend);
    return coefficients_json(project_windowed(lights, degree, {})).dump();
  } catch (const std::runtime_error& flaw) {
    const std::string line = flaw.what();
    throw std::runtime_error(line.starts_with(file.name()) ? line.substr(file.name().size() + 2) : line);
  }
}

void serve(const ViewCommand& options) {
  const Chosen chosen = all_chosen(options);
  serve_page(page_of(options, chosen, FilesOfPage::kServed), chosen.viewed.files, options.port, projected,
             [](const std::string& address) {
               say(fmt::format("open {} in a browser of this machine; Ctrl-C ends", address));
             });
}

void run_view_command(const ViewCommand& options) {
  if (options.serve == !options.output.empty()) {
    throw std::runtime_error("expected either -o FILE.html, -o FILE.js or --serve");
  }
  options.serve ? serve(options) : write(options);
}

}  // namespace

void add_view_command(CLI::App& tool) {
  auto options = std::make_shared<ViewCommand>();
  CLI::App& command = *tool.add_subcommand("view", "write a page that shows transfer files under live light");
  command.add_option("FILE", options->files, "transfer files from `prt bake`, or stages (.json)")->required();
  command.add_option("--transfers", options->transfers, "folder of the stages' transfer files; default: their own");
  command.add_option("-o,--output", options->output,
                     "HTML file to write; or a .js file: the module by which other pages relight such files");
  command.add_flag("--serve", options->serve,
                   "serve the page to browsers of this machine instead, for files that are too large for one page");
  command.add_option("--port", options->port, "port of --serve on 127.0.0.1; 0: any that is free")
      ->check(CLI::Range(0, 65535));
  options->light.add_to(command);
  run_with_threads(command, options, run_view_command);
}

}  // namespace sh::prt
