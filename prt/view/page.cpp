#include "prt/view/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "prt/binary/gzip.hpp"
#include "prt/light/light_shapes.hpp"
#include "prt/light/window.hpp"
#include "prt/runtime/file_shaders.hpp"
#include "prt/runtime/shader_texts.hpp"
#include "prt/transfer/transfer_file.hpp"

namespace sh::prt {
namespace {

using Json = nlohmann::ordered_json;
using namespace std::string_view_literals;

constexpr std::pair<std::string_view, std::string_view> kTexts[] = {
#include "view_texts.inc"
};

/// In the order in which they need each other.
constexpr std::string_view kModule[] = {"checksum.js", "transfer_file.js", "kernels.js", "relight.js"};
constexpr std::string_view kPage[] = {
    "vectors.js",       "stage.js",         "neighborhood.js", "camera.js",     "pixels.js",  "light.js",
    "light_picture.js", "radiance_file.js", "exr_file.js",     "light_file.js", "state.js",   "embedded.js",
    "lighting.js",      "pick.js",          "atlas.js",        "surfaces.js",   "picture.js", "subject.js",
    "ball.js",          "medium.js",        "input.js",        "panel.js",      "overlay.js", "main.js"};
constexpr std::string_view kShaders[] = {"tone.glsl",           "light.glsl",    "picture.vert",  "picture.frag",
                                         "picture_pixels.frag", "surfaces.vert", "surfaces.frag", "medium.vert",
                                         "medium.frag",         "ball.vert",     "ball.frag"};

std::string_view text_of(std::string_view file) {
  return std::find_if(std::begin(kTexts), std::end(kTexts), [&](const auto& text) { return text.first == file; })
      ->second;
}

/// Calls visit(line) for the lines of a text, with their ends.
template <class Visit>
void for_lines(std::string_view text, const Visit& visit) {
  while (!text.empty()) {
    const std::size_t length = std::min(text.find('\n'), text.size() - 1) + 1;
    visit(text.substr(0, length));
    text.remove_prefix(length);
  }
}

/// Modules one below the other: without the lines that import, and with the word `export` or without.
template <std::size_t Count>
std::string joined(const std::string_view (&files)[Count], bool exports) {
  constexpr std::string_view kExport = "export ";
  std::string all;
  for (const std::string_view file : files) {
    for_lines(text_of(file), [&](std::string_view line) {
      if (line.starts_with("import ")) return;
      all += !exports && line.starts_with(kExport) ? line.substr(kExport.size()) : line;
    });
  }
  return all;
}

std::string base64(std::string_view bytes) {
  using namespace boost::archive::iterators;
  using Letters = base64_from_binary<transform_width<std::string_view::const_iterator, 6, 8>>;
  std::string out(Letters(bytes.begin()), Letters(bytes.end()));
  out.append((3 - bytes.size() % 3) % 3, '=');
  return out;
}

std::string compressed(std::string_view bytes) {
  std::string all;
  for (const std::string& piece : gzip({bytes})) all += piece;
  return all;
}

/// JSON that may stand in a script of HTML.
std::string script_of(const Json& json) {
  std::string text = json.dump(-1, ' ', true, Json::error_handler_t::replace);
  for (std::size_t at = 0; (at = text.find("</", at)) != std::string::npos;) text.replace(at, 2, "<\\/");
  return text;
}

/// Without the comments: the functions alone.
std::string without_comments(std::string_view text) {
  std::string out;
  for_lines(text, [&](std::string_view line) {
    const std::string_view code = line.substr(0, std::min(line.find("//"), line.size()));
    if (code.find_first_not_of(" \n") != std::string_view::npos)
      out.append(code).append(code.ends_with('\n') ? "" : "\n");
  });
  return out;
}

/// Whether it is the space around an object of a stage.
bool is_volume(const Transfer& transfer) { return transfer.grid && !transfer.kind->in_medium; }

/// What the shaders of a file depend on, as relight.js looks at its header.
Json needs_of(const Transfer& transfer) {
  const Json header = Json::parse(transfer_header(transfer));
  const auto without_error = [&](const char* key) {
    Json json = header.value(key, Json());
    if (json.is_object()) json.erase("error");
    return json;
  };
  return {{"kind", header["kind"]},
          {"degree", header["degree"]},
          {"rows", header["rows"]},
          {"storage", without_error("storage")},
          {"indirect", without_error("indirect")},
          {"brdfs", header.contains("brdfs")}};
}

Json json_of(const LitPass& pass) {
  return {{"shader", pass.shader}, {"texture", pass.texture}, {"rows", pass.rows}, {"parts", pass.parts}};
}

Json shaders_of(const Transfer& transfer, const FileShaders& shaders) {
  Json lit = Json::array();
  for (const LitPass& pass : shaders.lit) lit.push_back(json_of(pass));
  return {{"needs", needs_of(transfer)}, {"relight", shaders.relight}, {"lit", lit}};
}

Json all_shaders_of(const Transfer& transfer) {
  const FileShaders shaders = file_shaders(transfer);
  Json json = shaders_of(transfer, shaders);
  if (shaders.pixels) {
    json["pixels"] = {{"vertex", shaders.pixels->vertex},
                      {"fragment", shaders.pixels->fragment},
                      {"vectors", shaders.pixels->vectors}};
    if (shaders.pixels->texels) json["pixels"]["texels"] = json_of(*shaders.pixels->texels);
  }
  return json;
}

/// Of rows that the page makes itself: for objects that gather light at their vertices, under the shadows of others.
Json shaders_of_rows(const Transfer& transfer) {
  Transfer rows;
  rows.kind = transfer.kind;
  rows.shape = transfer.shape;
  rows.shape.storage = {};
  return shaders_of(rows, file_shaders(rows));
}

void add_kernels(std::initializer_list<std::string_view> families, int degree, Json& kernels) {
  for (const std::string_view family : families) {
    const std::string name = kernel_name(family, degree);
    kernels[name] = without_comments(shader_text(name + ".glsl"));
  }
}

/// The functions with which JavaScript makes uniforms of a light.
void add_kernels_of_uniforms(const Transfer& transfer, Json& kernels) {
  if (transfer.kind->stores_visibility()) add_kernels({"transfer_prepare"}, transfer.degree(), kernels);
}

/// All that the page needs for its lights and its drawings of functions on the sphere.
Json kernels_of_page(const Viewed& viewed, int degree) {
  Json kernels = Json::object();
  add_kernels({"rotate", "add_cap_rgb", "basis", "evaluate_rgb"}, degree, kernels);
  if (degree > 0) {
    add_kernels(
        {"window_hann", "window_lanczos", "window_lanczos2", "window_lanczos4", "window_laplacian", "window_gaussian"},
        degree, kernels);
  }
  for (const ViewedFile& file : viewed.files) {
    const Transfer& transfer = *file.transfer;
    if (is_volume(transfer)) {
      add_kernels({"basis"}, transfer.shape.function_degree(), kernels);
      continue;
    }
    add_kernels({"basis", "rotate"}, transfer.degree(), kernels);
    add_kernels({"evaluate_rgb"}, transfer.shape.function_degree(), kernels);
    add_kernels_of_uniforms(transfer, kernels);
  }
  return kernels;
}

Json skies() {
  Json all = Json::array();
  for (int type = 1; type <= kSkyTypes; ++type) {
    const SkyParameters& sky = sky_parameters(type);
    all.push_back({sky.a, sky.b, sky.c, sky.d, sky.e});
  }
  return all;
}

/// The factors of the window `fejer` of strength 1, for each degree of a light.
Json fejer_kernels(int degree) {
  Json all = Json::array();
  for (int n = 0; n <= degree; ++n) all.push_back(window_factors({WindowType::kFejer, 1.0}, n));
  return all;
}

Json json_of(const ViewedLight& light) {
  Json coefficients = Json::array();
  for (int channel = 0; channel < 3; ++channel) {
    const double* first = &light.coefficients.at(channel, 0);
    coefficients.push_back(std::vector<double>(first, first + light.coefficients.bands_squared()));
  }
  return {{"name", light.name}, {"degree", light.coefficients.degree}, {"coefficients", coefficients}};
}

Json xyz(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

Json json_of(const Camera& camera) {
  return {{"position", xyz(camera.position)},
          {"target", xyz(camera.target)},
          {"up", xyz(camera.up)},
          {"field_of_view", camera.vertical_field_of_view}};
}

Json json_of(const ViewedFile& file, FilesOfPage where, std::size_t number) {
  Json json = {{"name", file.name}, {"bytes", file.bytes.size()}};
  json.update(is_volume(*file.transfer) ? Json{{"isVolume", true}} : all_shaders_of(*file.transfer));
  if (where == FilesOfPage::kServed) {
    json["url"] = fmt::format("file/{}", number);
  } else {
    json["data"] = base64(compressed(file.bytes));
  }
  return json;
}

Json json_of(const StageObject& object, std::size_t file, std::optional<std::size_t> volume) {
  Json keys = Json::array();
  for (const Motion::Key& key : object.motion.keys) {
    keys.push_back({{"time", key.time}, {"position", xyz(key.position)}, {"degrees", key.degrees}});
  }
  Json json = {{"file", file},
               {"axis", xyz(object.motion.axis)},
               {"keys", keys},
               {"proxy", {{"center", xyz(object.proxy.center)}, {"radius", object.proxy.radius}}}};
  if (volume) json["volume"] = *volume;
  if (object.per_vertex) json["rows"] = shaders_of_rows(*object.transfer);
  return json;
}

Json json_of(const ViewedSubject& subject) {
  Json objects = Json::array();
  for (std::size_t i = 0; i < subject.files.size(); ++i) {
    objects.push_back(subject.objects.empty() ? Json{{"file", subject.files[i]}}
                                              : json_of(subject.objects[i], subject.files[i], subject.volumes[i]));
  }
  return {{"name", subject.name}, {"title", subject.title}, {"objects", objects}};
}

/// The template with `value` in place of {{name}}.
void fill(std::string_view name, std::string_view value, std::string& page) {
  const std::string mark = fmt::format("{{{{{}}}}}", name);
  page.replace(page.find(mark), mark.size(), value);
}

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) out += c == '&' ? "&amp;" : c == '<' ? "&lt;" : std::string(1, c);
  return out;
}

}  // namespace

std::string viewer_page(const Viewed& viewed, const ViewedLight& light, const std::optional<Camera>& camera,
                        FilesOfPage where) {
  std::size_t bytes = 0;
  for (const ViewedFile& file : viewed.files) bytes += file.bytes.size();
  if (where == FilesOfPage::kInside && bytes > kMostEmbedded) {
    throw std::invalid_argument(
        fmt::format("{} bytes of transfer files: a page holds at most {}; use --serve, or bake with `--compress 128 8`",
                    bytes, kMostEmbedded));
  }
  const int degree = light.coefficients.degree;
  Json data = {{"degree", degree},
               {"light", json_of(light)},
               {"skies", skies()},
               {"fejer", fejer_kernels(degree)},
               {"kernels", kernels_of_page(viewed, degree)}};
  for (const std::string_view shader : kShaders) data["shaders"][std::string(shader)] = text_of(shader);
  data["shaders"]["atlas.glsl"] = shader_text("atlas.glsl");
  data["served"] = where == FilesOfPage::kServed;
  if (camera) data["camera"] = json_of(*camera);
  for (std::size_t i = 0; i < viewed.files.size(); ++i) data["files"].push_back(json_of(viewed.files[i], where, i));
  for (const ViewedSubject& subject : viewed.subjects) data["subjects"].push_back(json_of(subject));
  std::string page(text_of("index.html"));
  fill("style", text_of("style.css"), page);
  fill("modules", joined(kModule, false) + joined(kPage, false), page);
  fill("data", script_of(data), page);
  fill("title", escaped(viewed.subjects.front().title), page);
  return page;
}

std::string viewer_module(const Transfer& transfer) {
  Json kernels = Json::object();
  add_kernels({"rotate"}, transfer.degree(), kernels);
  add_kernels_of_uniforms(transfer, kernels);
  return fmt::format(
      "// `prt view`: reads and relights transfer files of kind {} and degree {}; relight.d.ts has the types.\n{}\n"
      "/** What `load` takes: the shaders of these files, and the functions that make their uniforms. */\n"
      "export const runtime = {};\n",
      transfer.kind->letters, transfer.degree(), joined(kModule, true),
      Json{{"shaders", shaders_of(transfer, file_shaders(transfer))}, {"kernels", kernels}}.dump(2));
}

}  // namespace sh::prt
