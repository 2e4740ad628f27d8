// Projecting weighted samples: by moments of the coordinates and one linear map, against basis and multiply-add.
#include <cmath>
#include <string>
#include <utility>

#include "generated/batch/batch.hpp"
#include "generated/cpp/basis.hpp"
#include "numeric/oracle/basis.hpp"
#include "tests/bench/harness.hpp"

namespace sh::bench {
namespace {

constexpr std::size_t kSamples = 1024;
constexpr double kNano = 1e9;

// Basis, then sum += weight * value, sixteen samples at a time.
template <int Degree>
void basis_and_add(const float* directions, const float* weights, float* sum) {
  constexpr std::size_t kSize = coefficient_count(Degree);
  Sixteen lanes[kSize];
  for (std::size_t block = 0; block < kSamples / 16; ++block) {
    const auto* d = reinterpret_cast<const Sixteen*>(directions + 48 * block);
    const Sixteen weight = reinterpret_cast<const Sixteen*>(weights)[block];
    Sixteen values[kSize];
    sh::basis<Degree>(d[0], d[1], d[2], static_cast<Sixteen*>(values));
    const auto add = [&]<std::size_t... K>(std::index_sequence<K...>) {
      ((lanes[K] = lanes[K] + weight * values[K]), ...);
    };
    add(std::make_index_sequence<kSize>());
  }
  const auto* all = reinterpret_cast<const float*>(lanes);
  for (std::size_t k = 0; k < kSize; ++k) {
    for (std::size_t lane = 0; lane < 16; ++lane) sum[k] += all[16 * k + lane];
  }
  keep(*sum);
}

// Largest error of the sum of Y, of weights that add up to 1.
double error_of(int degree, const std::vector<float>& directions, const std::vector<float>& sum) {
  std::vector<double> exact(coefficient_count(degree), 0.0);
  std::vector<double> values(coefficient_count(degree));
  for (std::size_t i = 0; i < kSamples; ++i) {
    const auto x = static_cast<double>(directions[3 * i]);
    const auto y = static_cast<double>(directions[3 * i + 1]);
    const auto z = static_cast<double>(directions[3 * i + 2]);
    const double length = std::hypot(x, y, z);
    numeric::basis(degree, x / length, y / length, z / length, values.data());
    for (std::size_t k = 0; k < exact.size(); ++k) exact[k] += values[k] / kSamples;
  }
  double largest = 0;
  for (std::size_t k = 0; k < exact.size(); ++k) {
    largest = std::fmax(largest, std::abs(exact[k] - static_cast<double>(sum[k])));
  }
  return largest;
}

}  // namespace

void project(Table& table) {
  table.section("Projecting samples, float, blocked, ns a sample",
                "control: basis and multiply-add in lanes; largest error of a mean beside it; moments to degree 5");
  const std::vector<float> plain = random_directions(kSamples);
  const Buffer<float> directions = to_blocks(plain, 3);
  const Buffer<float> weights = make_buffer<float>(kSamples, 1.F / kSamples);
  for_degrees<2, 6>([&]<int kDegree>() {
    std::vector<float> ours(coefficient_count(kDegree), 0.F);
    std::vector<float> other(coefficient_count(kDegree), 0.F);
    batch::project(kDegree, kSamples, batch::blocked(directions.get()), batch::plain(weights.get()), ours.data());
    basis_and_add<kDegree>(directions.get(), weights.get(), other.data());
    const std::string errors =
        scientific(error_of(kDegree, plain, ours)) + " (" + scientific(error_of(kDegree, plain, other)) + ")";
    const std::vector<double> t =
        least_times({[&] {
                       batch::project(kDegree, kSamples, batch::blocked(directions.get()), batch::plain(weights.get()),
                                      ours.data());
                     },
                     [&] { basis_and_add<kDegree>(directions.get(), weights.get(), other.data()); }});
    table.ratio("project, degree " + std::to_string(kDegree) + ", error " + errors, "ns", t[0] * kNano / kSamples,
                t[1] * kNano / kSamples, "basis and add", 1.0);
  });
}

}  // namespace sh::bench
