// Readers of files that this project writes: transfer files, checkpoints, reports; and pictures.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "numeric/output/parse_json.hpp"
#include "numeric/report/report.hpp"
#include "prt/bake/checkpoint.hpp"
#include "prt/formats/formats.hpp"
#include "prt/image/image.hpp"
#include "prt/medium/density_file.hpp"
#include "prt/medium/scattered_light.hpp"
#include "prt/runtime/glossy.hpp"
#include "prt/runtime/relight.hpp"
#include "prt/splats/convert_splats.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "prt/transfer/transfer_json.hpp"
#include "prt/transfer/transfer_layout.hpp"
#include "tests/fuzz/checkpoint_bytes.hpp"
#include "tests/fuzz/entry.hpp"
#include "tests/prt/rooms.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::fuzz {
namespace {

using namespace sh::prt;

bool is_finite(float value) { return std::isfinite(value); }

// The header describes all that was read.
void require_description(const nlohmann::json& header, const Transfer& transfer) {
  Transfer described;
  described.mesh = transfer.mesh;
  described.emitted = transfer.emitted;
  take_header(header, layout::kVersion, file_kinds(), described);
  require(transfer_header(described) == transfer_header(transfer), "a header reads back");
}

// What is accepted can be described, and be lit where all its columns are there.
void read_and_light(const std::string& file) {
  const Transfer transfer = read_transfer(file, file_kinds());
  const auto header = output::parse_json<nlohmann::json>(transfer_header(transfer));
  require_description(header, transfer);
  require(transfer.grid || header.at("vertices") == transfer.mesh.positions.size(), "the header counts the vertices");
  require(std::all_of(transfer.coefficients.begin(), transfer.coefficients.end(), is_finite),
          "coefficients are finite");
  LightCoefficients light = LightCoefficients::zero(transfer.degree());
  for (int channel = 0; channel < 3; ++channel) light.at(channel, 0) = 1.0;
  if (transfer.kind->in_medium) {
    const std::size_t numbers = scattered_light(transfer, light).size();
    require(numbers == transfer.receivers() * 3 * transfer.shape.rows(), "every point of a medium is lit");
    return;
  }
  if (transfer.grid) {
    std::vector<float> between(3 * coefficient_count(kMaxDegree));
    const TransferredRadiance reaching(transfer, light);
    reaching.at(GridCell(*transfer.grid, transfer.grid->box.center()), between.data());
    return;
  }
  const std::size_t lit =
      transfer.kind->is_glossy()
          ? exit_radiance(transfer, TransferredRadiance(transfer, light), {0.0, 0.0, 9.0}, transfer.mesh.albedo).size()
          : relight(transfer, light).size();
  require(lit == transfer.mesh.positions.size(), "every vertex is lit");
}

Mesh two_boxes() {
  Mesh mesh = sh::prt::test::primitive_mesh("box");
  append(mesh, sh::prt::test::primitive_mesh("box"));
  return mesh;
}

/// Of 48 vertices: two records.
struct SmallBake {
  SmallBake() {
    scene.bake.degree = 1;
    transfer = Transfer::of(*scene.bake.kind, 1);
    transfer.mesh = scene.mesh;
    transfer.coefficients.resize(scene.mesh.positions.size() * transfer.shape.length());
  }

  Scene scene = sh::prt::test::scene_of(two_boxes(), &kInterreflected, 64, 1);
  Transfer transfer;
  std::string key = bake_key(scene, "avx2", {});
};

void read_checkpoint(const std::string& file) {
  static const SmallBake kBake;
  Transfer transfer = kBake.transfer;
  const std::size_t vertices = transfer.mesh.positions.size();
  FormFactors factors(vertices);
  ShadowResult result{transfer, std::vector<Sight>(vertices), &factors};
  const Checkpoint checkpoint({file, false, 0.0}, kBake.key, result);
  require(std::all_of(transfer.coefficients.begin(), transfer.coefficients.end(), is_finite), "vectors are finite");
  for (std::size_t v = 0; v < vertices; ++v) {
    for (const FormFactor& factor : factors.row(v)) {
      require(factor.vertex < vertices && std::abs(factor.weight) <= 2.0, "form factors are parts of a hemisphere");
    }
  }
}

// NRRD files need a name of their own; all others are raw numbers.
void read_densities(const std::string& file) {
  static const prt::test::TemporaryFolder kFolder;
  const std::string named = kFolder.file("input.nrrd");
  if (!std::filesystem::exists(named)) std::filesystem::create_symlink(file, named);
  const bool is_nrrd = prt::test::read_all(file).starts_with("NRRD");
  const DensityValues read = is_nrrd ? read_density(named, std::nullopt) : read_density(file, Counts{2, 1, 1});
  require(read.values.size() == voxel_count(read.counts), "every voxel has a density");
  require(std::all_of(read.values.begin(), read.values.end(), [](float v) { return std::isfinite(v) && v >= 0.0F; }),
          "densities are finite and not below 0");
}

// What is accepted has finite coefficients, and is written again.
void read_engine_light(const std::string& file) {
  const formats::ImportedLight imported = formats::import_light(file);
  const auto is_number = [](double value) { return std::isfinite(value); };
  require(std::all_of(imported.light.values.begin(), imported.light.values.end(), is_number), "a light is finite");
  require(imported.light.degree <= imported.format->degree, "a format holds the degree of its lights");
  require(imported.format->convention.to(imported.light).size() == imported.light.bands_squared(),
          "all bands are there");
}

void read_picture(const std::string& file) {
  const Image image = read_image(file, OnFlaw::kMend);
  require(image.pixels.size() == static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height),
          "a picture has all its pixels");
  for (const Eigen::Vector3f& pixel : image.pixels) {
    require(pixel.allFinite() && pixel.minCoeff() >= 0.0F, "pixels are finite and not negative");
  }
}

// Valid splats have numbers that can be written, and the reader counts all of them.
void read_splats(const std::string& file) {
  const auto reader = splat_format_of(file).read(file);
  FlawCounts counts;
  std::size_t valid = 0;
  for_splats(*reader, {.drop = true}, counts, [&](const SplatBlock& block) {
    valid += block.count;
    require(std::all_of(block.position.begin(), block.position.end(), is_finite), "positions are finite");
    require(std::all_of(block.harmonics.begin(), block.harmonics.end(), is_finite), "coefficients are finite");
    for (std::size_t i = 0; i < block.count; ++i) {
      const float* q = &block.rotation[4 * i];
      require(std::any_of(q, q + 4, [](float v) { return v != 0.0F; }), "quaternions are not 0");
    }
  });
  require(valid + counts.dropped == reader->count(), "every splat is valid or counted");
}

}  // namespace

std::string checkpoint_with_front(std::string_view records) {
  static const std::string kFront = checkpoint_front(SmallBake().key);
  return kFront + std::string(records);
}

void run_transfer(std::string_view bytes) { run_reader(read_and_light, bytes); }

void run_checkpoint(std::string_view bytes) {
  const bool is_whole = bytes.starts_with("shpart");
  run_reader(read_checkpoint, is_whole ? std::string(bytes) : checkpoint_with_front(bytes));
}

void run_splats(std::string_view bytes) { run_reader(read_splats, bytes); }

void run_density(std::string_view bytes) { run_reader(read_densities, bytes); }

void run_image(std::string_view bytes) { run_reader(read_picture, bytes); }

void run_light(std::string_view bytes) { run_reader(read_engine_light, bytes); }

void run_report(std::string_view bytes) {
  run_reader([](const std::string& file) { numeric::read_report(file); }, bytes);
}

}  // namespace sh::fuzz
