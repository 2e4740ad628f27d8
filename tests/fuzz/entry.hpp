// What the fuzzers run: functions that take any bytes, as a file or a command line would hold them. A reader may refuse
// the bytes with one line; it may not crash, hang, or accept what it promises to refuse. A broken promise aborts.
#pragma once
#include <string>
#include <string_view>

namespace sh::fuzz {

void run_transfer(std::string_view bytes);    // a transfer file
void run_checkpoint(std::string_view bytes);  // the records of a checkpoint, or a whole one
void run_scene(std::string_view bytes);       // a scene's JSON
void run_stage(std::string_view bytes);       // a stage's JSON; its transfer files are those of tests/data/transfer_v1
void run_parts(std::string_view bytes);       // the plan, bake, camera or lights of a scene
void run_plan(std::string_view bytes);        // the file of a plan, which a bake of two triangles follows
void run_table(std::string_view bytes);       // CSV for `shcheck identify` and `rotation-matrix`: its numbers
void run_identify(std::string_view bytes);    // the same of few numbers, and the answers of both commands
void run_image(std::string_view bytes);       // OpenEXR, Radiance, PNG, JPEG
void run_light(std::string_view bytes);       // a light in an engine's format
void run_report(std::string_view bytes);      // a report.json of shcheck
void run_splats(std::string_view bytes);      // Gaussian splats: PLY, GLB, SPZ
void run_density(std::string_view bytes);     // densities of a medium: NRRD, raw numbers
void run_command(std::string_view bytes);     // a command line of prt: each byte stands for a word

/// Prints `what` and aborts unless `holds`.
void require(bool holds, const char* what);

/// Runs `read`, which may throw std::exception with one line but not std::bad_alloc.
void run_reader(void (*read)(const std::string& file), std::string_view bytes);
void require_one_line(std::string_view message);

/// The bytes as a file that can be opened by name, and opened again.
class MemoryFile {
 public:
  MemoryFile();
  ~MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  void hold(std::string_view bytes) const;
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  int descriptor_;
  std::string path_;
};

}  // namespace sh::fuzz
