// Light that scatters below the surface of a torus, one thread: error against time by how coarsely far faces are taken.
// Control: the sum over all faces as points, one evaluation of R_d for each vertex and face. Usage: bodies_bench [SEGMENTS].
#include <oneapi/tbb/task_arena.h>

#include <cstdio>
#include <cstdlib>
#include <vector>

#include "prt/mesh/primitives.hpp"
#include "prt/mesh/weld.hpp"
#include "prt/transfer/unshadowed.hpp"
#include "prt/translucent/dipole.hpp"
#include "prt/translucent/surface_scatter.hpp"
#include "tests/bench/harness.hpp"

namespace {

using namespace sh::prt;

constexpr int kDegree = 4;
constexpr std::size_t kCount = coefficient_count(kDegree);
constexpr double kFinest = 0.1;  // errs by 1e-5

double sink = 0.0;

// What a plain double loop costs without any light: R_d alone.
void sum_all(const Mesh& mesh, const Dipole& dipole) {
  for (const Eigen::Vector3f& x : mesh.positions) {
    double sum = 0.0;
    for (const Face& face : mesh.faces) sum += dipole.at(double((mesh.positions[face[0]] - x).squaredNorm()));
    sink += sum;
  }
}

void measure(int segments) {
  const Soup soup = make_primitive("torus", segments);
  Mesh mesh = weld(soup, soup.positions.size());
  const Translucence material{
      .absorption = Eigen::Vector3f(0.1F, 0.4F, 2.0F), .scattering = Eigen::Vector3f(20.0F, 25.0F, 30.0F), .ior = 1.3F};
  mesh.translucence.assign(mesh.positions.size(),
                           static_cast<std::uint16_t>(1 + mesh.translucences.number_of(material)));
  const std::vector<float> arriving = unshadowed_transfer(kDegree, mesh.normals);
  const auto rows_of = [&](double far) {
    std::vector<float> rows(mesh.positions.size() * 3 * kCount, 0.0F);
    add_scattered(mesh, arriving, kCount, rows, far);
    return rows;
  };
  const std::vector<float> finest = rows_of(kFinest);
  double squares = 0.0;
  for (const float number : finest) squares += double(number) * double(number);
  const double control = sh::bench::least_times({[&] { sum_all(mesh, Dipole(0.1, 20.0, 1.3)); }}, 1)[0];
  std::printf(
      "A torus of %zu vertices, %zu faces, degree %d, three colors; control: R_d of every pair, one color, %.3g s\n",
      mesh.positions.size(), mesh.faces.size(), kDegree, control);
  std::printf("far faces   error (rms, of the light)   largest   seconds   times the control\n");
  for (const double far : {0.8, 0.6, 0.5, 0.4, 0.3, 0.25, 0.2}) {
    std::vector<float> rows;
    const double seconds = sh::bench::least_times({[&] { rows = rows_of(far); }}, 1)[0];
    double wrong = 0.0;
    double largest = 0.0;
    double peak = 0.0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double difference = double(rows[i]) - double(finest[i]);
      wrong += difference * difference;
      largest = std::max(largest, std::abs(difference));
      peak = std::max(peak, std::abs(double(finest[i])));
    }
    std::printf("%9.2f   %25.2e   %7.1e   %7.3g   %17.3g\n", far, std::sqrt(wrong / squares), largest / peak, seconds,
                seconds / control);
  }
}

}  // namespace

int main(int argc, char** argv) {
  oneapi::tbb::task_arena(1).execute([&] { measure(argc > 1 ? std::atoi(argv[1]) : 96); });
  return sink == 12345.0 ? 1 : 0;
}
