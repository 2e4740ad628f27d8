// `prt view FILE... -o view.html`: one page that shows baked transfer under live light, in any browser, without a network.
// `prt view FILE... --serve`: the same page from a server on this machine, for files that are too large for one page.
// `prt view FILE -o relight.js`: the module by which other pages relight such files.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "numeric/output/atomic_file.hpp"
#include "prt/commands/commands.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "prt/view/page.hpp"
#include "prt/view/serve.hpp"

namespace sh::prt {
namespace {

struct ViewCommand {
  std::vector<std::string> files;
  std::string output;
  bool serve = false;
  int port = 0;
  LightOptions light;
  int threads = 0;
};

std::string bytes_of(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// The transfer is read first: it checks the bytes.
ViewedFile viewed(const std::string& file) {
  Transfer transfer = read_transfer(file);
  if (transfer.mesh.positions.empty() || transfer.mesh.faces.empty()) {
    throw std::runtime_error(fmt::format("{}: a transfer without faces: nothing to view", file));
  }
  return {std::filesystem::path(file).filename().string(), bytes_of(file), std::move(transfer)};
}

std::string name_of(const LightOptions& light) {
  if (!light.light.empty()) return std::filesystem::path(light.light).stem().string();
  return light.scene.empty() ? "overcast" : "lights of " + std::filesystem::path(light.scene).stem().string();
}

std::vector<ViewedFile> all_viewed(const ViewCommand& options) {
  std::vector<ViewedFile> files;
  for (const std::string& file : options.files) files.push_back(viewed(file));
  return files;
}

std::string page_of(const ViewCommand& options, const std::vector<ViewedFile>& files, FilesOfPage where) {
  const auto lower = [](const ViewedFile& a, const ViewedFile& b) { return a.transfer.degree() < b.transfer.degree(); };
  const int degree = std::max_element(files.begin(), files.end(), lower)->transfer.degree();
  const ChosenLight chosen = choose_light(options.light);
  if (!options.output.empty()) output::require_no_input(options.output, chosen.files);
  return viewer_page(files, {name_of(options.light), project_windowed(chosen.lights, degree, options.light.window)},
                     chosen.camera, where);
}

std::string module_of(const ViewCommand& options) {
  if (options.files.size() > 1) {
    throw std::runtime_error(fmt::format("{}: a module relights files like one: expected one FILE, got {}",
                                         options.output, options.files.size()));
  }
  return viewer_module(viewed(options.files.front()).transfer);
}

void write(const ViewCommand& options) {
  require_output(options.output, {".html", ".js"});
  output::require_no_input(options.output, options.files);
  const Stopwatch stopwatch;
  const std::string text = options.output.ends_with(".js")
                               ? module_of(options)
                               : page_of(options, all_viewed(options), FilesOfPage::kInside);
  output::write_file(options.output, text);
  report_time(stopwatch, fmt::format("wrote {}, {} bytes,", options.output, text.size()));
}

void serve(const ViewCommand& options) {
  const std::vector<ViewedFile> files = all_viewed(options);
  serve_page(page_of(options, files, FilesOfPage::kServed), files, options.port, [](const std::string& address) {
    fmt::print(stderr, "prt: open {} in a browser of this machine; Ctrl-C ends\n", address);
  });
}

void run(const ViewCommand& options) {
  if (options.serve == !options.output.empty()) {
    throw std::runtime_error("expected either -o FILE.html, -o FILE.js or --serve");
  }
  options.serve ? serve(options) : write(options);
}

}  // namespace

void add_view_command(CLI::App& tool) {
  auto options = std::make_shared<ViewCommand>();
  CLI::App& command = *tool.add_subcommand("view", "write a page that shows transfer files under live light");
  command.add_option("FILE", options->files, "transfer files from `prt bake`")->required();
  command.add_option("-o,--output", options->output,
                     "HTML file to write; or a .js file: the module by which other pages relight such files");
  command.add_flag("--serve", options->serve,
                   "serve the page to browsers of this machine instead, for files that are too large for one page");
  command.add_option("--port", options->port, "port of --serve on 127.0.0.1; 0: any that is free")
      ->check(CLI::Range(0, 65535));
  options->light.add_to(command);
  run_with_threads(command, options, run);
}

}  // namespace sh::prt
