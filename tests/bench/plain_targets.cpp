// Plain records, as programs have them: one call of a driver against a loop over the header's kernel, from one record on.
#include <string>
#include <vector>

#include "generated/batch/batch.hpp"
#include "generated/cpp/basis.hpp"
#include "generated/cpp/basis_gradient.hpp"
#include "generated/cpp/evaluate.hpp"
#include "generated/cpp/evaluate_rgb.hpp"
#include "generated/cpp/product.hpp"
#include "generated/cpp/project.hpp"
#include "generated/cpp/relight.hpp"
#include "generated/cpp/relight_rgb.hpp"
#include "generated/cpp/rotate.hpp"
#include "tests/bench/harness.hpp"

namespace sh::bench {
namespace {

constexpr double kNano = 1e9;
constexpr double kCall = 5;  // ns that a call of one or two records may take beside the kernel

template <class T>
std::vector<T> as(const std::vector<float>& values) {
  return {values.begin(), values.end()};
}

// Records of one call, their inputs and room for the largest output.
template <class T>
struct Records {
  std::size_t n;
  std::vector<T> directions, coefficients;
  Buffer<T> out;

  Records(std::size_t records, std::size_t size)
      : n(records),
        directions(as<T>(random_directions(records))),
        coefficients(as<T>(random_vectors(records, size))),
        out(make_buffer<T>(records * 4 * size)) {}
};

template <class T>
const char* scalar() {
  return sizeof(T) == 4 ? "float" : "double";
}

template <class T>
void compare(Table& table, const std::string& family, int degree, const Records<T>& records,
             const std::function<void()>& call, const std::function<void()>& loop) {
  const std::vector<double> t = least_times({call, loop});
  const std::string what = family + ", " + scalar<T>() + ", degree " + std::to_string(degree);
  const double each = kNano / static_cast<double>(records.n);
  if (records.n <= 2) {
    table.ratio(what, "ns", t[0] * kNano, t[1] * kNano + kCall, "the loop and 5 ns", 1);
  } else {
    table.ratio(what, "ns", t[0] * each, t[1] * each, "the loop", 1.02);  // 2 % of noise
  }
}

template <int Degree, class T>
void families(Table& table, std::size_t n) {
  constexpr std::size_t kSize = (Degree + 1) * (Degree + 1);
  const Records<T> records(n, kSize);
  const T* const directions = records.directions.data();
  const T* const c = records.coefficients.data();
  T* const out = records.out.get();
  const auto each = [=](const auto& kernel) {
    return [=] {
      for (std::size_t i = 0; i < n; ++i) kernel(i, directions + 3 * i);
      keep(*out);
    };
  };
  compare<T>(
      table, "basis", Degree, records, [=] { batch::basis(Degree, n, batch::plain(directions), batch::plain(out)); },
      each([out](std::size_t i, const T* d) { sh::basis<Degree>(d[0], d[1], d[2], out + i * kSize); }));
  compare<T>(
      table, "basis_gradient", Degree, records,
      [=] { batch::basis_gradient(Degree, n, batch::plain(directions), batch::plain(out)); },
      each([out](std::size_t i, const T* d) {
        T* const to = out + i * 4 * kSize;
        sh::basis_gradient<Degree>(d[0], d[1], d[2], to, to + kSize, to + 2 * kSize, to + 3 * kSize);
      }));
  compare<T>(
      table, "evaluate", Degree, records,
      [=] { batch::evaluate(Degree, n, batch::plain(c), batch::plain(directions), batch::plain(out)); },
      each([out, c](std::size_t i, const T* d) { out[i] = sh::evaluate<Degree>(c + i * kSize, d[0], d[1], d[2]); }));
}

// Functions that one matrix turns, and products.
template <int Degree>
void functions(Table& table, std::size_t n) {
  constexpr std::size_t kSize = (Degree + 1) * (Degree + 1);
  const Records<float> records(n, kSize);
  const std::vector<float> r = random_rotations(1);
  const std::vector<float> factors = random_vectors(n, kSize);
  const float* const c = records.coefficients.data();
  float* const out = records.out.get();
  compare<float>(
      table, "rotate", Degree, records,
      [&] { batch::rotate(Degree, n, batch::shared(r.data()), batch::plain(c), batch::plain(out)); },
      [&] {
        for (std::size_t i = 0; i < n; ++i) sh::rotate<Degree>(r.data(), c + i * kSize, out + i * kSize);
        keep(*out);
      });
  if constexpr (Degree <= 6) {  // the driver's largest
    const float* const a = factors.data();
    compare<float>(
        table, "product", Degree, records,
        [&] { batch::product(Degree, n, batch::plain(a), batch::plain(c), batch::plain(out)); },
        [&] {
          for (std::size_t i = 0; i < n; ++i) sh::product<Degree>(a + i * kSize, c + i * kSize, out + i * kSize);
          keep(*out);
        });
  }
}

// Vertices under one light, and samples that are added up.
template <int Degree>
void sums(Table& table, std::size_t n) {
  constexpr std::size_t kSize = (Degree + 1) * (Degree + 1);
  const Records<float> records(n, kSize);
  const std::vector<float> light = random_vectors(1, 3 * kSize);
  const float* const transfer = records.coefficients.data();
  const float* const d = records.directions.data();
  float* const out = records.out.get();
  const auto each = [=](const auto& kernel) {
    return [=] {
      for (std::size_t i = 0; i < n; ++i) kernel(i);
      keep(*out);
    };
  };
  compare<float>(
      table, "relight", Degree, records,
      [&] { batch::relight(Degree, n, batch::plain(transfer), light.data(), batch::plain(out)); },
      each([&](std::size_t i) { out[i] = sh::relight<Degree>(transfer + i * kSize, light.data()); }));
  compare<float>(
      table, "relight_rgb", Degree, records,
      [&] { batch::relight_rgb(Degree, n, batch::plain(transfer), light.data(), batch::plain(out)); },
      each([&](std::size_t i) { sh::relight_rgb<Degree>(transfer + i * kSize, light.data(), out + 3 * i); }));
  compare<float>(
      table, "project", Degree, records,
      [&] { batch::project(Degree, n, batch::plain(d), batch::plain(transfer), out); },
      each([&](std::size_t i) { sh::project<Degree>(d[3 * i], d[3 * i + 1], d[3 * i + 2], transfer[i], out); }));
}

// Colors, coefficient by coefficient; the loops take them apart for the header's kernels.
template <int Degree>
void colors(Table& table, std::size_t n) {
  constexpr std::size_t kSize = (Degree + 1) * (Degree + 1);
  const Records<float> records(n, 3 * kSize);
  const float* const directions = records.directions.data();
  const float* const c = records.coefficients.data();
  float* const out = records.out.get();
  compare<float>(
      table, "evaluate_rgb", Degree, records,
      [=] { batch::evaluate_rgb(Degree, n, batch::interleaved(c), batch::plain(directions), batch::plain(out)); },
      [=] {
        for (std::size_t i = 0; i < n; ++i) {
          float channels[3 * kSize];
#pragma GCC unroll 128
          for (std::size_t k = 0; k < 3 * kSize; ++k) channels[k % 3 * kSize + k / 3] = c[3 * kSize * i + k];
          const float* const d = directions + 3 * i;
          sh::evaluate_rgb<Degree>(static_cast<const float*>(channels), d[0], d[1], d[2], out + 3 * i);
        }
        keep(*out);
      });
  const std::vector<float> r = random_rotations(1);
  compare<float>(
      table, "rotate", Degree, records,
      [&] { batch::rotate(Degree, n, batch::shared(r.data()), batch::interleaved(c), batch::interleaved(out)); },
      [&] {
        for (std::size_t i = 0; i < n; ++i) {
          for (std::size_t channel = 0; channel < 3; ++channel) {
            float in[kSize];
            float rotated[kSize];
            for (std::size_t k = 0; k < kSize; ++k) in[k] = c[3 * (kSize * i + k) + channel];
            sh::rotate<Degree>(r.data(), static_cast<const float*>(in), static_cast<float*>(rotated));
            for (std::size_t k = 0; k < kSize; ++k) out[3 * (kSize * i + k) + channel] = rotated[k];
          }
        }
        keep(*out);
      });
}

}  // namespace

void plain(Table& table) {
  for (const std::size_t n :
       {std::size_t{1}, std::size_t{2}, std::size_t{3}, std::size_t{7}, std::size_t{17}, std::size_t{1024}}) {
    table.section("Plain records, " + std::to_string(n) + " in a call, ns " + (n <= 2 ? "a call" : "a record"),
                  "control: a loop over the header's kernel, compiled for this machine");
    for_degrees<0, 10>([&]<int kDegree>() {
      if (kDegree > 4 && kDegree % 2 == 1) return;
      families<kDegree, float>(table, n);
      families<kDegree, double>(table, n);
      functions<kDegree>(table, n);
      if constexpr (kDegree >= 1 && kDegree <= 4) sums<kDegree>(table, n);
    });
  }
  for (const std::size_t n : {std::size_t{1}, std::size_t{3}, std::size_t{7}, std::size_t{17}, std::size_t{1024}}) {
    table.section(
        "Interleaved colors, " + std::to_string(n) + " in a call, float, ns " + (n <= 2 ? "a call" : "a record"),
        "control: a loop over the header's kernel");
    for_degrees<1, 4>([&]<int kDegree>() { colors<kDegree>(table, n); });
  }
}

}  // namespace sh::bench
