// Command lines of prt. Each byte stands for a word, so that a run of bytes is a command line with known options, files
// and values, good and bad, in any order. The files that are read must be the same afterwards.
#include <sys/stat.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <vector>

#include "prt/bake/bake_volume.hpp"
#include "prt/commands/commands.hpp"
#include "prt/medium/bake_medium.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "tests/fuzz/entry.hpp"
#include "tests/prt/rooms.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::fuzz {
namespace {

using prt::test::read_all;
using prt::test::write_all;

constexpr std::size_t kMostWords = 16;
constexpr std::size_t kCommands = 9;     // the first words
constexpr std::size_t kFirstWords = 11;  // the same, --help and --version

// New words go to the end, so that the committed inputs keep their meaning.
constexpr std::array kWords = {"bake",
                               "relight",
                               "render",
                               "shader",
                               "info",
                               "project",
                               "reconstruct",
                               "plan",
                               "compare",
                               "--help",
                               "--version",
                               "a.json",
                               "a.transfer",
                               "b.transfer",
                               "stage.json",
                               "lights.json",
                               "a.stl",
                               "none.json",
                               "missing/x.png",
                               ".",
                               "",
                               "-o",
                               "x.png",
                               "x.ply",
                               "x.transfer",
                               "x.webp",
                               "x.jpg",
                               "a.png",
                               "/dev/null",
                               "0",
                               "1",
                               "2",
                               "4",
                               "8",
                               "16",
                               "-1",
                               "1e9",
                               "nan",
                               "inf",
                               "1e-30",
                               "0.5",
                               "360",
                               "99999999999999999999",
                               "x",
                               "--degree",
                               "--directions",
                               "--sampler",
                               "sobol",
                               "cosine",
                               "--seed",
                               "--kind",
                               "shadowed",
                               "unshadowed",
                               "interreflected",
                               "--plan",
                               "none",
                               "exact",
                               "lossy",
                               "--error",
                               "--light-turns",
                               "any",
                               "--without",
                               "bands,storage",
                               "--threads",
                               "--estimate",
                               "--bounce-memory",
                               "--instruction-set",
                               "sse4.2",
                               "--strict",
                               "--checkpoint",
                               "--no-checkpoint",
                               "--restart",
                               "--budget-seconds",
                               "--checkpoint-seconds",
                               "--json",
                               "--scene",
                               "--light",
                               "constant",
                               "overcast",
                               "--mapping",
                               "mirror_ball",
                               "--window",
                               "auto",
                               "gaussian:0.1",
                               "sinc:2:4",
                               "hann:nan",
                               "--keep",
                               "irradiance",
                               "--turn",
                               "--white",
                               "--recolor",
                               "--local",
                               "octahedron",
                               "--frames",
                               "--turntable",
                               "object",
                               "camera",
                               "--width",
                               "--height",
                               "--samples",
                               "--exposure",
                               "--fixed-exposure",
                               "--tone",
                               "linear",
                               "--background",
                               "light",
                               "--fps",
                               "--quality",
                               "--limit",
                               "--draw",
                               "all",
                               "--show",
                               "both",
                               "--axes",
                               "--title",
                               "--no-marks",
                               "--language",
                               "es300",
                               "DS",
                               "DI",
                               "--transfers",
                               "glossy_unshadowed",
                               "glossy_shadowed",
                               "g.transfer",
                               "--eye",
                               "fix-view",
                               "grid",
                               "--degrees",
                               "--half-angles",
                               "--direction",
                               "--compress",
                               "--sharp",
                               "--compress-auto",
                               "--fit-lobes",
                               "view",
                               "export",
                               "import",
                               "splats",
                               "rotate",
                               "convert",
                               "s.ply",
                               "x.glb",
                               "x.spz",
                               "x.html",
                               "x.js",
                               "x.json",
                               "--to",
                               "threejs",
                               "filament-ktx",
                               "gltf",
                               "usd",
                               "npz",
                               "glb",
                               "--axis",
                               "0,0,1",
                               "--quaternion",
                               "1,0,0,0",
                               "--scale",
                               "--translate",
                               "--crop",
                               "-1,-1,-1,1,1,1",
                               "--axes-in",
                               "RUB",
                               "--spz-version",
                               "--sh-bits",
                               "8,8",
                               "--drop-invalid",
                               "--vectors",
                               "--lobe",
                               "light-at",
                               "probes",
                               "volume",
                               "--at",
                               "--face",
                               "--time",
                               "--counts",
                               "2,2,2",
                               "--box",
                               "--check",
                               "unity",
                               "--result-degree",
                               "--element",
                               "byte",
                               "--memory",
                               "m.json",
                               "m.nrrd",
                               "m.transfer",
                               "n.transfer",
                               "space.json",
                               "--log",
                               "json",
                               "translucent",
                               "--thickness",
                               "t.json",
                               "--reflected",
                               "merge",
                               "shards",
                               "lightmap",
                               "--shard",
                               "1/2",
                               "2/2",
                               "p.1",
                               "p.2",
                               "--parts",
                               "-n",
                               "--for",
                               "slurm",
                               "--price",
                               "--of",
                               "u.json",
                               "u.transfer",
                               "kept.json",
                               "--bounce-directions",
                               "x.exr"};
static_assert(kWords.size() <= 256);

// The triangles with these corners; assimp reads it without the megabytes that other formats take.
std::string stl(const std::vector<std::string>& corners) {
  std::string text = "solid a\n";
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (std::size_t k = i; k < i + 3; ++k) text += "vertex " + corners[k] + "\n";
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid a\n";
}

int run(std::vector<std::string> words) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  return prt::run_tool(static_cast<int>(words.size()), arguments.data());
}

/// A folder with small files of every type; the tool runs in it.
class Workplace {
 public:
  Workplace() {
    using prt::write_transfer;
    std::filesystem::current_path(folder_.path());
    write_all("a.stl", stl({"0 0 0", "1 0 0", "1 1 0", "0 0 0", "1 1 0", "0 1 0", "0 0 0", "1 0 0", "0 0 1"}));
    write_all("a.json", R"({"meshes": [{"file": "a.stl"}], "lights": [{"type": "directional", "direction": [0, 1, 1]}],
                            "bake": {"degree": 1, "directions": 16}})");
    write_all("t.json",
              R"({"meshes": [{"file": "a.stl", "translucent": {"transmission": [1, 1, 1], "extinction": [1, 1, 1]}},
                                       {"file": "a.stl", "subsurface": {"absorption": [1, 1, 1], "scattering": [9, 9, 9]}}],
                            "bake": {"degree": 1, "directions": 16}})");
    write_all("u.json", R"({"meshes": [{"primitive": "box", "texels": 8}], "bake": {"degree": 1, "directions": 16}})");
    write_all("stage.json",
              R"({"objects": [{"transfer": "a.transfer"}, {"transfer": "a.transfer", "position": [2, 0, 0],
                                "move": [{"time": 0}, {"time": 1, "degrees": 90}]}]})");
    write_all("lights.json", R"([{"type": "cap", "direction": [1, 0, 1], "half_angle": 10},
                                 {"type": "sphere", "position": [0, 0, 9], "radius": 1}])");
    write_transfer("a.transfer", prt::test::baked(prt::test::primitive_mesh("box"), &prt::kShadowed, 16, 1));
    write_transfer("b.transfer", prt::test::baked(prt::test::primitive_mesh("box"), &prt::kInterreflected, 16, 1));
    write_transfer("g.transfer", prt::test::baked(prt::test::primitive_mesh("box"), &prt::kGlossyShadowed, 16, 1));
    write_all("m.nrrd", "NRRD0001\ntype: uint8\ndimension: 3\nsizes: 2 1 2\nencoding: raw\n\n\1\2\3\4");
    write_all("m.json", R"({"medium": {"density": {"file": "m.nrrd"}, "box": [[0, 0, 0], [1, 1, 1]], "extinction": 0.3},
                            "bake": {"degree": 1, "directions": 24}})");
    write_transfer("m.transfer", prt::bake_medium(prt::load_scene("m.json", prt::OnFlaw::kRefuse), 0));
    write_transfer("n.transfer",
                   prt::bake_volume(prt::test::scene_of(prt::test::primitive_mesh("box"), &prt::kShadowed),
                                    {.counts = {2, 2, 2}, .degree = 1, .result_degree = 1, .directions = 16}, {}));
    write_all("space.json",
              R"({"objects": [{"transfer": "a.transfer"}, {"transfer": "b.transfer", "position": [2, 0, 0],
                                             "volume": "n.transfer"}],
                                "lights": [{"type": "directional", "direction": [0, 1, 1]}]})");
    run({"prt", "bake", "u.json", "-o", "u.transfer"});
    run({"prt", "plan", "a.json", "-o", "kept.json"});
    run({"prt", "bake", "a.json", "--shard", "1/2", "-o", "p.1"});
    run({"prt", "bake", "a.json", "--shard", "2/2", "-o", "p.2"});
    std::filesystem::copy_file("a.transfer", "a.png");
    std::filesystem::copy_file(SHFORGE_SOURCE_DIR "/tests/data/fuzz/splats/little.ply", "s.ply");
    for (const auto& entry : std::filesystem::directory_iterator(".")) {
      const std::string name = entry.path().string();
      files_[name] = {read_all(name), state_of(name)};
    }
  }

  /// The files that are not as they were; makes them so again and removes new ones.
  std::vector<std::string> restore() {
    std::vector<std::string> changed;
    std::vector<std::filesystem::path> added;
    for (const auto& entry : std::filesystem::directory_iterator(".")) {
      if (!files_.contains(entry.path().string())) added.push_back(entry.path());
    }
    for (const std::filesystem::path& path : added) std::filesystem::remove(path);
    for (auto& [name, file] : files_) {
      if (state_of(name) == file.state) continue;
      if (read_all(name) != file.bytes) changed.push_back(std::filesystem::path(name).filename().string());
      write_all(name, file.bytes);
      file.state = state_of(name);
    }
    return changed;
  }

 private:
  // Tells whether anybody wrote to a file: its number in the file system, its size, and when it changed.
  using State = std::array<std::int64_t, 4>;
  static State state_of(const std::string& name) {
    struct stat file {};
    if (stat(name.c_str(), &file) != 0) return {};
    return {static_cast<std::int64_t>(file.st_ino), file.st_size, file.st_ctim.tv_sec, file.st_ctim.tv_nsec};
  }

  struct File {
    std::string bytes;
    State state;
  };

  // One thread, so that an input always takes the same branches.
  tbb::global_control one_thread_{tbb::global_control::max_allowed_parallelism, 1};
  prt::test::TemporaryFolder folder_;
  std::map<std::string, File> files_;
};

// Whether it is no number, one of at most `most`, or far too large.
bool is_small(const std::string& word, double most = 16) {
  const double number = std::strtod(word.c_str(), nullptr);
  return !(number > most && number < 1e6);
}

// Whether the word behind the option is small; so is what nobody names.
bool is_small_option(const std::vector<std::string>& words, std::string_view option, double most) {
  const auto found = std::find(words.begin(), words.end(), option);
  return words.end() - found < 2 || is_small(*std::next(found), most);
}

// Whether a command line that says more than "no such command" begins with this word.
bool may_begin(std::string_view word) {
  const auto* const end = kWords.begin() + kFirstWords;
  constexpr std::array<std::string_view, 13> kLaterCommands{"fix-view", "grid",     "view",    "export", "import",
                                                            "splats",   "light-at", "probes",  "volume", "translucent",
                                                            "merge",    "shards",   "lightmap"};
  return std::find(kWords.begin(), end, word) != end || std::ranges::find(kLaterCommands, word) != kLaterCommands.end();
}

bool has_word(const std::vector<std::string>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

// Whether sampled light takes a moment: few probes, pixels and rays, and lights that are points, as those of two files
// are; all others are looked up in large pictures.
bool samples_little(const std::vector<std::string>& words) {
  const bool is_few = words[1] != "probes" ||
                      (words.size() > 4 && words[2] == "--counts" && words[3] == "2,2,2" && words[4] == "--check");
  return is_few && (has_word(words, "a.json") || has_word(words, "space.json")) && !has_word(words, "--light") &&
         is_small_option(words, "--check", 1) && is_small_option(words, "--face", 4) &&
         is_small_option(words, "--samples", 4);
}

// A picture takes 16 rays for each pixel, of half a million unless its size is given. The space around an object has
// thousands of points unless they are counted. A mesh file alone gets a ground of thousands of vertices.
bool is_quick(const std::vector<std::string>& words) {
  const std::string command = words.size() > 1 ? words[1] : "";
  const bool draws = command == "render" || command == "compare" || command == "grid";
  const bool has_width = words.size() > 3 && words[2] == "--width" && is_small(words[3]);
  const bool has_height = words.size() > 5 && words[4] == "--height" && is_small(words[5]);
  const bool has_counts = words.size() > 3 && words[2] == "--counts" && words[3] == "2,2,2";
  bool is_mesh_alone = false;  // not only an output
  for (std::size_t i = 2; i < words.size(); ++i) {
    is_mesh_alone = is_mesh_alone || words[i] == "a.stl";
    if (words[i] == "-o" || words[i] == "--checkpoint") ++i;  // its value, which may look like an option
  }
  return (!draws || (has_width && (has_height || command == "grid"))) && (command != "volume" || has_counts) &&
         ((command != "light-at" && command != "probes") || samples_little(words)) &&
         is_small_option(words, "--frames", 16) && !is_mesh_alone;
}

// Whether the words name the file as output and nowhere else, neither themselves nor in a scene or stage.
bool is_only_output(const std::string& file, const std::vector<std::string>& words) {
  const auto named = std::find(words.begin(), words.end(), file);
  constexpr std::array<std::array<const char*, 2>, 9> kReads{{{"a.json", "a.stl"},
                                                              {"kept.json", "a.json"},
                                                              {"kept.json", "a.stl"},
                                                              {"t.json", "a.stl"},
                                                              {"stage.json", "a.transfer"},
                                                              {"m.json", "m.nrrd"},
                                                              {"space.json", "a.transfer"},
                                                              {"space.json", "b.transfer"},
                                                              {"space.json", "n.transfer"}}};
  const bool is_read =
      std::ranges::any_of(kReads, [&](const auto& read) { return file == read[1] && has_word(words, read[0]); });
  return named != words.end() && (*std::prev(named) == "-o" || *std::prev(named) == "--vectors") && !is_read &&
         std::count(named, words.end(), file) == 1;
}

}  // namespace

void run_command(std::string_view bytes) {
  static Workplace workplace;
  std::vector<std::string> words{"prt"};
  for (const char byte : bytes.substr(0, kMostWords)) {
    const std::size_t number = static_cast<unsigned char>(byte);
    if (number < kWords.size()) words.emplace_back(kWords[number]);
  }
  // All options of all commands are set up where none is named: most runs would only do that.
  if (words.size() > 1 && !may_begin(words[1])) words[1] = kWords[static_cast<unsigned char>(bytes[0]) % kCommands];
  if (!is_quick(words)) return;
  const int status = run(words);
  require(status == 0 || status == 1 || status == 2, "the exit code is 0, 1 or 2");
  for (const std::string& file : workplace.restore()) require(is_only_output(file, words), "no input is written");
}

}  // namespace sh::fuzz
