// `prt shader --kind DS --degree 4 > relight.vert`: prints a complete vertex shader that relights.
#include <memory>
#include <stdexcept>

#include "prt/commands/commands.hpp"
#include "prt/runtime/vertex_shader.hpp"

namespace sh::prt {
namespace {

struct Options {
  std::string kind = "DS";
  int degree = 4;
  bool white = false;
  std::string language = "450";
};

void run(const Options& options) {
  print_out(vertex_shader(*kind_with_letters(options.kind), options.degree, options.white,
                          options.language == "450" ? ShaderLanguage::kGlsl450 : ShaderLanguage::kEs300));
}

}  // namespace

void add_shader_command(CLI::App& tool) {
  auto options = std::make_shared<Options>();
  CLI::App* command = tool.add_subcommand("shader", "print a complete vertex shader that relights");
  const auto letters = kind_letters();
  command
      ->add_option("--kind", options->kind,
                   "kind of transfer: DU reads normals, DS rows of one channel, DI rows of three")
      ->check(CLI::IsMember(std::vector<std::string>{letters.begin(), letters.end()}))
      ->capture_default_str();
  command->add_option("--degree", options->degree, "SH degree, 0 to 10")->capture_default_str();
  command->add_flag("--white", options->white, "use a light with one channel for all colors");
  command
      ->add_option("--language", options->language, "shader language: GLSL 450 (OpenGL 4.5) or GLSL ES 300 (WebGL 2)")
      ->check(CLI::IsMember({"450", "es300"}))
      ->capture_default_str();
  command->callback([options] { run(*options); });
}

}  // namespace sh::prt
