// Relighting against the memory that it has to move, one core, for every way of prt/runtime/relight.hpp. The limit only
// reads and writes as many bytes, of arrays larger than the caches (the faster of ordinary stores and stores past the
// caches). Both take turns, and the least of many passes counts. Exit 1 if a target is missed by more than the noise.
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <string>

#include "prt/large_pages.hpp"
#include "prt/runtime/light_at_rest.hpp"
#include "prt/runtime/neighborhood.hpp"
#include "prt/runtime/relight.hpp"
#include "tests/bench/harness.hpp"

namespace {

using sh::bench::Buffer;
using sh::bench::Table;
using sh::prt::Element;
using sh::prt::Encoded;
using sh::prt::kGlossyShadowed;
using sh::prt::kInterreflected;
using sh::prt::kNeighborhood;
using sh::prt::kShadowed;
using sh::prt::LightAtRest;
using sh::prt::LightCoefficients;
using sh::prt::PointGrid;
using sh::prt::shade_diffuse;
using sh::prt::Transfer;
using sh::prt::TransferKind;
using sh::prt::TransferredRadiance;

constexpr double kNano = 1e9;
constexpr double kMilli = 1e3;
constexpr std::size_t kFloats = 25'000'000;  // transfer of a case: 100 MB
constexpr int kPasses = 25;
constexpr double kOfMemory = 1.0 / 0.85;  // at least 85 % of its bandwidth

std::vector<float> made_up_numbers(std::size_t count) {
  std::vector<float> numbers(count);
  float value = 0.0F;
  for (float& number : numbers) {
    value = value > 1.0F ? -0.9F : value + 0.013F;
    number = value;
  }
  return numbers;
}

Transfer made_up_transfer(const TransferKind* kind, int degree, std::size_t vertices) {
  Transfer transfer = Transfer::of(*kind, degree);
  transfer.mesh.positions.resize(vertices, Eigen::Vector3f::Zero());
  sh::prt::renew_on_large_pages(transfer.mesh.albedo, vertices);
  std::fill(transfer.mesh.albedo.begin(), transfer.mesh.albedo.end(), Eigen::Vector3f(0.25F, 0.5F, 0.75F));
  sh::prt::renew_on_large_pages(transfer.coefficients, vertices * transfer.shape.length());
  const std::vector<float> numbers = made_up_numbers(transfer.coefficients.size());
  std::copy(numbers.begin(), numbers.end(), transfer.coefficients.begin());
  return transfer;
}

// As it is read from a file.
Transfer stored(Transfer transfer, Element element) {
  if (element == Element::kSingle) return transfer;
  transfer.shape.storage.element = element;
  Encoded encoded = encode(transfer.coefficients, transfer.shape);
  transfer.coefficients = {};
  sh::prt::renew_on_large_pages(transfer.stored.data, encoded.data.size());
  std::copy(encoded.data.begin(), encoded.data.end(), transfer.stored.data.begin());
  transfer.stored.scale = encoded.scale;
  to_blocks(transfer.stored, transfer.shape);
  return transfer;
}

LightCoefficients made_up_light(int degree, bool white) {
  LightCoefficients light = LightCoefficients::zero(degree);
  for (std::size_t i = 0; i < light.values.size(); ++i) {
    light.values[i] = 1.0 / (1.0 + static_cast<double>(white ? i % light.bands_squared() : i));
  }
  return light;
}

/// One way to relight.
struct Case {
  std::string name;
  const TransferKind* kind;
  int degree;        // of the transfer
  int light_degree;  // of the light
  bool white;
  std::size_t vertices;
  Element element = Element::kSingle;
};

struct Times {
  double ours;   // seconds
  double limit;  // seconds
};

Times measure(const Case& c) {
  const Transfer transfer = stored(made_up_transfer(c.kind, c.degree, c.vertices), c.element);
  const LightCoefficients light = made_up_light(c.light_degree, c.white);
  std::vector<Eigen::Vector3f> radiance;
  sh::prt::renew_on_large_pages(radiance, c.vertices);
  const std::size_t inputs =
      transfer.rows().bytes() / sizeof(float) + (c.kind == &kInterreflected ? 0 : 3 * c.vertices);
  const Buffer<float> in = sh::bench::make_buffer<float>(inputs, 1.0F);
  const Buffer<float> out = sh::bench::make_buffer<float>(3 * c.vertices);
  const std::vector<double> t =
      sh::bench::least_times({[&] { relight_into(transfer, light, radiance); },
                              sh::bench::stream_task(in.get(), inputs, out.get(), 3 * c.vertices, false),
                              sh::bench::stream_task(in.get(), inputs, out.get(), 3 * c.vertices, true)},
                             kPasses);
  return {t[0], std::min(t[1], t[2])};
}

std::size_t vertices_of(const TransferKind* kind, int degree) {
  return kFloats / std::max<std::size_t>(1, kind->shape(degree).length());
}

void targets(Table& table) {
  const std::size_t n = vertices_of(&kShadowed, 4);
  const Times rgb = measure({"", &kShadowed, 4, 4, false, n});
  const double ns = kNano / static_cast<double>(n);
  table.ratio("RGB, 25 coefficients, a million vertices", "ns", rgb.ours * ns, rgb.limit * ns, "memory", kOfMemory);
  const Times mesh = measure({"", &kShadowed, 4, 4, false, 100'000});
  table.figure("RGB, 25 coefficients, 100k vertices", "ms", mesh.ours * kMilli, 10.0);
}

void others(Table& table) {
  for (const Case& c : {Case{"DS or DU, 25 coefficients, white light", &kShadowed, 4, 4, true, 0},
                        Case{"DS or DU, 4 of 25 coefficients", &kShadowed, 4, 1, false, 0},
                        Case{"DS or DU, 4 coefficients", &kShadowed, 1, 1, false, 0},
                        Case{"DS or DU, 9 coefficients", &kShadowed, 2, 2, false, 0},
                        Case{"DS or DU, 121 coefficients", &kShadowed, 10, 10, false, 0},
                        Case{"DI, 3 x 25 coefficients", &kInterreflected, 4, 4, false, 0},
                        Case{"DI, 3 x 25 coefficients, white light", &kInterreflected, 4, 4, true, 0},
                        Case{"DS or DU, 25 coefficients in half", &kShadowed, 4, 4, false, 0, Element::kHalf},
                        Case{"DS or DU, 25 coefficients in 8 bits", &kShadowed, 4, 4, false, 0, Element::kByte},
                        Case{"DI, 3 x 25 coefficients in half", &kInterreflected, 4, 4, false, 0, Element::kHalf}}) {
    Case sized = c;
    sized.vertices = vertices_of(c.kind, c.degree);
    const Times t = measure(sized);
    const double ns = kNano / static_cast<double>(sized.vertices);
    table.ratio(c.name, "ns", t.ours * ns, t.limit * ns, "memory", kOfMemory);
  }
}

void vectors(Table& table) {
  table.section("Relighting, one core, ns a vertex",
                "limit: reading and writing the same bytes; RGB light unless it says otherwise");
  targets(table);
  others(table);
}

// Shadowed glossy transfer, where light and eye are free, and where one of them rests.
void glossy(Table& table) {
  table.section("Glossy transfer, one core", "control: light and eye free, in the same run");
  constexpr std::size_t kVertices = 131'072;
  constexpr int kDegree = 4;
  Transfer transfer = made_up_transfer(&kGlossyShadowed, kDegree, kVertices);
  transfer.mesh.normals.assign(kVertices, Eigen::Vector3f(0.36F, -0.48F, 0.8F));
  transfer.mesh.specular.assign(kVertices, Eigen::Vector3f(0.5F, 0.4F, 0.3F));
  transfer.mesh.exponent.assign(kVertices, 20.0F);
  const LightCoefficients light = made_up_light(kDegree, false);
  const LightAtRest at_rest(transfer, TransferredRadiance(transfer, light), transfer.mesh.albedo);
  Eigen::Vector3d eye(3.0, 1.0, 2.0);
  std::vector<Eigen::Vector3f> radiance;
  const std::vector<double> t = sh::bench::least_times(
      {[&] {
         eye.x() += 0.01;
         radiance = exit_radiance(transfer, TransferredRadiance(transfer, light), eye, transfer.mesh.albedo);
       },
       [&] {
         eye.x() += 0.01;
         radiance = at_rest.exit_radiance(eye);
       }},
      kPasses);
  const double ns = kNano / static_cast<double>(kVertices);
  table.ratio("GS, degree 4, light at rest, 131,072 vertices", "ns", t[1] * ns, t[0] * ns, "light free", 0.25);
  const Times rows = measure({"", &kInterreflected, kDegree, kDegree, false, vertices_of(&kInterreflected, kDegree)});
  const double row_ns = kNano / static_cast<double>(vertices_of(&kInterreflected, kDegree));
  table.ratio("view at rest: DI, 3 x 25 coefficients", "ns", rows.ours * row_ns, rows.limit * row_ns, "memory",
              kOfMemory);
}

// Around an object: all points under a light of degree 2, and diffuse receivers between them, spread as the vertices of
// a mesh are: neighbors follow each other.
void around(Table& table) {
  table.section("Around an object, one core", "light and volume of one frame");
  constexpr std::size_t kReceivers = 100'000;
  Transfer volume = Transfer::of(kNeighborhood, 2);
  volume.grid = PointGrid{{Eigen::Vector3d(-1.0, -1.0, -1.0), Eigen::Vector3d(1.0, 1.0, 1.0)}, {64, 64, 8}};
  const std::size_t points = volume.receivers();
  volume.coefficients = made_up_numbers(points * volume.shape.length());
  const LightCoefficients light = made_up_light(2, false);
  TransferredRadiance reaching(volume, light);
  std::vector<Eigen::Vector3f> positions(kReceivers);
  std::vector<Eigen::Vector3f> normals(kReceivers);
  for (std::size_t v = 0; v < kReceivers; ++v) {
    constexpr std::size_t kRow = 316;
    const float x = 2.0F * static_cast<float>(v % kRow) / kRow - 1.0F;
    const std::size_t row = v / kRow;
    const float y = 2.0F * static_cast<float>(row) / (kRow + 1) - 1.0F;
    positions[v] = {x, y, 0.3F * x * y - 0.2F};
    normals[v] = Eigen::Vector3f(-0.3F * y, -0.3F * x, 1.0F).normalized();
  }
  std::vector<Eigen::Vector3f> radiance(kReceivers);
  const std::size_t inputs = volume.coefficients.size();
  const std::size_t outputs = points * 75;
  const Buffer<float> in = sh::bench::make_buffer<float>(inputs, 1.0F);
  const Buffer<float> out = sh::bench::make_buffer<float>(outputs);
  const std::vector<double> t =
      sh::bench::least_times({[&] { reaching.meet(volume, light); },
                              [&] { shade_diffuse(*volume.grid, reaching, positions, normals, radiance); },
                              sh::bench::stream_task(in.get(), inputs, out.get(), outputs, false)},
                             kPasses);
  table.figure("64 x 64 x 8 points, light of degree 2, result of degree 4, RGB", "ms", t[0] * kMilli, 1.2);
  table.remark("  reading and writing as much takes " + std::to_string(t[2] * kMilli) + " ms");
  table.figure("diffuse receivers between them, 100k vertices", "ms", t[1] * kMilli, 5.0);
}

}  // namespace

int main(int argc, char** argv) {
  const tbb::global_control one_core(tbb::global_control::max_allowed_parallelism, 1);
  return sh::bench::run_sections(argc, argv, {{"vectors", vectors}, {"glossy", glossy}, {"around", around}});
}
