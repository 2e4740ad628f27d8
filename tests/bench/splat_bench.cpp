// A million splats of degree 3 turned and converted, against `cp` of the same file, both until the bytes are on the disk.
// All tasks take turns, and the least of several passes counts. Exit 1 if a target is missed by more than the noise.
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "prt/splats/convert_splats.hpp"
#include "prt/splats/ply_header.hpp"
#include "tests/bench/harness.hpp"
#include "tests/temporary_folder.hpp"

namespace {

using sh::prt::convert_splats;
using sh::prt::PlyProperty;
using sh::prt::SplatEdit;

constexpr std::size_t kSplats = 1'000'000;
constexpr int kDegree = 3;
constexpr int kPasses = 5;

/// Numbers of a million splats that differ.
void make_file(const std::string& file) {
  std::vector<PlyProperty> properties;
  for (const std::string& name : sh::prt::splat_properties(kDegree)) properties.push_back({name});
  std::ofstream out(file, std::ios::binary);
  out << sh::prt::ply_header_text(properties, kSplats, nullptr);
  std::vector<float> record(properties.size());
  float value = 0.0F;
  for (std::size_t i = 0; i < kSplats; ++i) {
    for (float& number : record) {
      value = value > 1.0F ? -0.9F : value + 0.0137F;
      number = value;
    }
    out.write(reinterpret_cast<const char*>(record.data()), static_cast<std::streamsize>(4 * record.size()));
  }
}

void copy(const std::string& from, const std::string& to) {
  if (std::system(("cp " + from + " " + to + " && sync " + to).c_str()) != 0) std::abort();
}

void splats(sh::bench::Table& table) {
  const sh::test::TemporaryFolder folder;
  const std::string in = folder.file("in.ply");
  make_file(in);
  SplatEdit turn;
  turn.similarity.turn = Eigen::AngleAxisd(0.5, Eigen::Vector3d(0.6, 0.0, 0.8)).toRotationMatrix();
  const auto to = [&](const std::string& ending, const SplatEdit& edit) {
    return [&folder, in, ending, edit] { convert_splats(in, folder.file("out" + ending), edit); };
  };
  const std::vector<double> t = sh::bench::least_times(
      {[&] { copy(in, folder.file("copy")); }, to(".ply", turn), to(".ply", {}), to(".glb", {}), to(".spz", {})},
      kPasses);
  table.section("A million Gaussian splats of degree 3, 248 MB", "control: cp and sync of the .ply file");
  table.ratio("rotate .ply to .ply", "s", t[1], t[0], "cp", 1.5);
  table.ratio("convert .ply to .ply, nothing asked", "s", t[2], t[0], "cp", 1.5);
  table.ratio("convert .ply to .glb", "s", t[3], t[0], "cp", 2.0);
  table.ratio("convert .ply to .spz (gzip takes most of it)", "s", t[4], t[0], "cp", 20.0);
}

}  // namespace

int main(int argc, char** argv) { return sh::bench::run_sections(argc, argv, {{"splats", splats}}); }
