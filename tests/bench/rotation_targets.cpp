// Rotation of coefficient vectors against the classic z-x90-z rotation, and its error over all tilts.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "generated/batch/batch.hpp"
#include "generated/cpp/rotate.hpp"
#include "numeric/methods/classic_rotation.hpp"
#include "numeric/oracle/rotation.hpp"
#include "numeric/oracle/rotation_matrices.hpp"
#include "tests/bench/harness.hpp"

namespace sh::bench {
namespace {

constexpr std::size_t kRotations = 64;

// f on AVX2, where that is available.
template <class F>
auto on_avx2(const F& f) {
  return [f] {
    struct Scope {
      batch::InstructionSet before = batch::instruction_set();
      ~Scope() { batch::use_instruction_set(before); }
    } const scope;
    if (batch::available(batch::InstructionSet::kAvx2)) batch::use_instruction_set(batch::InstructionSet::kAvx2);
    return f();
  };
}

void times(Table& table) {
  table.section("Rotation by a matrix, float, ns", "control: z-x90-z with angles from the matrix; building included");
  const std::vector<float> r = random_rotations(kRotations);
  const Buffer<float> blocks_r = to_blocks(r, 9);
  for_degrees<2, 10>([&]<int kDegree>() {
    constexpr std::size_t kSize = coefficient_count(kDegree);
    const std::vector<float> c = random_vectors(kRotations, kSize);
    const Buffer<float> out = make_buffer<float>(kRotations * kSize);
    const Buffer<float> blocks_c = to_blocks(c, kSize);
    const auto one_by_one = [&](auto rotate_one) {
      return [&, rotate_one] {
        for (std::size_t i = 0; i < kRotations; ++i) {
          rotate_one(&r[9 * i], &c[kSize * i], &out[kSize * i]);
          keep(out[0]);
        }
      };
    };
    const auto with_simd =
        one_by_one([](const float* m, const float* v, float* o) { batch::rotate_one(kDegree, m, v, o); });
    const std::vector<double> t = least_times(
        {one_by_one([](const float* m, const float* v, float* o) { sh::rotate<kDegree>(m, v, o); }),
         one_by_one([](const float* m, const float* v, float* o) { textbook::classic_rotation<kDegree>(m, v, o); }),
         [&] {
           batch::rotate(kDegree, kRotations, batch::blocked(blocks_r.get()), batch::blocked(blocks_c.get()),
                         batch::blocked(out.get()));
         },
         with_simd, on_avx2(with_simd)});
    const double ns = 1e9 / kRotations;
    const std::string degree = "degree " + std::to_string(kDegree);
    table.ratio("rotate, " + degree, "ns", t[0] * ns, t[1] * ns, "z-x90-z", 0.9);
    table.ratio("rotate, batch of pairs, " + degree, "ns", t[2] * ns, t[1] * ns, "z-x90-z", 0.1);
    table.cell("rotate, one vector", kDegree, t[0] * ns);
    table.cell("the classic z-x90-z rotation", kDegree, t[1] * ns);
    if (kDegree > 2) table.cell("rotate, one with SIMD inside", kDegree, t[3] * ns);
    table.cell("rotate, one of a batch", kDegree, t[2] * ns);
    if (kDegree < 3 || kDegree > 7) return;
    table.ratio("rotate, one with SIMD inside, " + degree, "ns", t[3] * ns, t[1] * ns, "z-x90-z", 0.6);
    if (!batch::available(batch::InstructionSet::kAvx2)) return;
    table.ratio("rotate, one in AVX2 lanes, " + degree, "ns", t[4] * ns, t[0] * ns, "rotate, one vector", 0.95);
  });
}

void prepared(Table& table) {
  table.section("Many rotations by one matrix, one at a time, float, ns",
                "control: rotate_one, which takes a matrix each time");
  const std::vector<float> r = random_rotations(kRotations);
  for (int degree = 2; degree <= 10; ++degree) {
    const std::size_t size = coefficient_count(degree);
    const std::vector<float> c = random_vectors(kRotations, size);
    const Buffer<float> out = make_buffer<float>(kRotations * size);
    const Buffer<float> matrix = make_buffer<float>(batch::rotate_prepared_size(degree));
    batch::rotate_prepare(degree, r.data(), matrix.get());
    const std::vector<double> t =
        least_times({[&] {
                       for (std::size_t i = 0; i < kRotations; ++i) {
                         batch::rotate_prepared_one(degree, matrix.get(), &c[size * i], &out[size * i]);
                         keep(out[0]);
                       }
                     },
                     [&] {
                       for (std::size_t i = 0; i < kRotations; ++i) {
                         batch::rotate_one(degree, &r[9 * i], &c[size * i], &out[size * i]);
                         keep(out[0]);
                       }
                     }});
    const double ns = 1e9 / kRotations;
    table.ratio("rotate_prepared_one, degree " + std::to_string(degree), "ns", t[0] * ns, t[1] * ns, "rotate_one", 0.4);
    table.cell("rotate by a prepared matrix, one at a time", degree, t[0] * ns);
  }
}

using Wide = long double;
// Largest error of rotated unit vectors over tilts from 1e-9 to pi; matrix and vector are rounded to T first.
template <int Degree, class T, class F>
double largest_error(const F& rotate) {
  constexpr std::size_t kSize = coefficient_count(Degree);
  constexpr std::size_t kVectors = 4;
  const std::vector<float> vectors = random_vectors(kVectors, kSize);
  std::mt19937 random(2);
  std::uniform_real_distribution<Wide> angle(-3.2L, 3.2L);
  Wide largest = 0;
  for (Wide exponent = -9; exponent < 0.4971L; exponent += 0.01L) {
    const auto exact = numeric::tilted_turn<Wide>(angle(random), std::pow(10.0L, exponent), angle(random));
    std::array<T, 9> r;
    for (std::size_t i = 0; i < 9; ++i) r[i] = static_cast<T>(exact[i]);
    const auto rounded = numeric::nearest_rotation<Wide>(r.data());
    for (std::size_t v = 0; v < kVectors; ++v) {
      std::array<T, kSize> c;
      std::array<Wide, kSize> wide;
      for (std::size_t i = 0; i < kSize; ++i) wide[i] = c[i] = static_cast<T>(vectors[v * kSize + i]);
      std::array<T, kSize> out;
      rotate(static_cast<const T*>(r.data()), static_cast<const T*>(c.data()), out.data());
      std::array<Wide, kSize> expected;
      numeric::rotate<Wide>(Degree, rounded.data(), wide.data(), expected.data());
      for (std::size_t i = 0; i < kSize; ++i) largest = std::max(largest, std::abs(Wide{out[i]} - expected[i]));
    }
  }
  return static_cast<double>(largest);
}

void errors(Table& table) {
  table.section("Rotation, largest error for unit vectors over tilts from 1e-9 to pi", "against the oracle");
  for_degrees<2, 5>([&]<int kDegree>() {
    const std::string degree = ", degree " + std::to_string(kDegree);
    const auto kernel = [](const auto* r, const auto* c, auto* out) { sh::rotate<kDegree>(r, c, out); };
    table.figure("rotate" + degree + ", float", "", largest_error<kDegree, float>(kernel), 1e-6);
    table.figure("rotate" + degree + ", double", "", largest_error<kDegree, double>(kernel), 4e-15);
  });
  for_degrees<3, 7>([&]<int kDegree>() {
    const auto lanes = [](const float* r, const float* c, float* out) { batch::rotate_one(kDegree, r, c, out); };
    const auto error = [&] { return largest_error<kDegree, float>(lanes); };
    const std::string degree = "rotate, degree " + std::to_string(kDegree);
    table.figure(degree + ", one with SIMD inside", "", error(), 1e-6);
    if (!batch::available(batch::InstructionSet::kAvx2)) return;
    table.figure(degree + ", one in AVX2 lanes", "", on_avx2(error)(), 1e-6);
  });
}

}  // namespace

void rotation(Table& table) {
  times(table);
  prepared(table);
  errors(table);
}

}  // namespace sh::bench
