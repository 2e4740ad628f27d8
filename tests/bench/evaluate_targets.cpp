// Evaluating functions given by coefficients: one for many directions, and one each (Gaussian splats).
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "generated/batch/batch.hpp"
#include "generated/cpp/basis.hpp"
#include "numeric/oracle/basis.hpp"
#include "tests/bench/harness.hpp"

namespace sh::bench {
namespace {

constexpr double kNano = 1e9;
constexpr std::size_t kCached = 1024;  // directions; in and out stay in the first cache
constexpr int kSplatDegree = 3;
constexpr std::size_t kSplatValues = 3 * coefficient_count(kSplatDegree);

// Basis, then the sum of products, sixteen directions at a time.
template <int Degree>
void basis_and_dot(const float* c, const float* directions, std::size_t n, float* out) {
  constexpr std::size_t kSize = coefficient_count(Degree);
  for (std::size_t block = 0; block < n / 16; ++block) {
    const auto* d = reinterpret_cast<const Sixteen*>(directions + 48 * block);
    Sixteen values[kSize];
    sh::basis<Degree>(d[0], d[1], d[2], static_cast<Sixteen*>(values));
    Sixteen sums[4];  // short chains
    const auto add = [&]<std::size_t... K>(std::index_sequence<K...>) {
      ((sums[K % 4] = sums[K % 4] + Sixteen(c[K]) * values[K]), ...);
    };
    add(std::make_index_sequence<kSize>());
    reinterpret_cast<Sixteen*>(out)[block] = (sums[0] + sums[1]) + (sums[2] + sums[3]);
  }
}

// Largest error for a function of unit length.
double error_of(int degree, const std::vector<float>& c, const std::vector<float>& directions, const float* values) {
  double largest = 0;
  std::vector<double> basis(coefficient_count(degree));
  for (std::size_t i = 0; i < directions.size() / 3; ++i) {
    const auto x = static_cast<double>(directions[3 * i]);
    const auto y = static_cast<double>(directions[3 * i + 1]);
    const auto z = static_cast<double>(directions[3 * i + 2]);
    const double length = std::hypot(x, y, z);
    numeric::basis(degree, x / length, y / length, z / length, basis.data());
    double exact = 0;
    for (std::size_t k = 0; k < basis.size(); ++k) exact += static_cast<double>(c[k]) * basis[k];
    largest = std::max(largest, std::abs(exact - static_cast<double>(values[i])));
  }
  return largest;
}

void one_function(Table& table) {
  table.section("One function at many directions, float, blocked, ns a direction",
                "control: basis and dot in lanes; largest error beside it");
  const std::vector<float> plain = random_directions(kCached);
  const Buffer<float> directions = to_blocks(plain, 3);
  const Buffer<float> ours = make_buffer<float>(kCached);
  const Buffer<float> other = make_buffer<float>(kCached);
  for_degrees<3, 6>([&]<int kDegree>() {
    const std::vector<float> c = random_vectors(1, coefficient_count(kDegree));
    const std::vector<double> t =
        least_times({[&] {
                       batch::evaluate(kDegree, kCached, batch::shared(c.data()), batch::blocked(directions.get()),
                                       batch::blocked(ours.get()));
                     },
                     [&] { basis_and_dot<kDegree>(c.data(), directions.get(), kCached, other.get()); }});
    table.ratio("evaluate, degree " + std::to_string(kDegree) + ", error " +
                    scientific(error_of(kDegree, c, plain, ours.get())) + " (" +
                    scientific(error_of(kDegree, c, plain, other.get())) + ")",
                "ns", t[0] * kNano / kCached, t[1] * kNano / kCached, "basis and dot", 0.5);
    table.cell("one function at a direction, of a batch", kDegree, t[0] * kNano / kCached);
    table.cell("basis and dot in 16 lanes", kDegree, t[1] * kNano / kCached);
  });
}

// The color of a Gaussian splat in a direction, degree 3, as renderers usually write it: a polynomial for every basis
// function, three channels (Kerbl, Kopanas, Leimkuehler and Drettakis 2023). Splat i of a block or, where `Step` is 1, of an
// array: value k of its coefficients at c[k * Step], its color at rgb[channel * Step].
template <std::size_t Step>
[[gnu::always_inline]] inline void splat_color(const float* c, float x, float y, float z, float* rgb,
                                               std::size_t of_function, std::size_t of_channel) {
  const float xx = x * x;
  const float yy = y * y;
  const float zz = z * z;
  const float xy = x * y;
  const float yz = y * z;
  const float xz = x * z;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const auto at = [&](std::size_t k) { return c[(of_function * k + of_channel * channel) * Step]; };
    float color = 0.28209479F * at(0);
    color += 0.48860251F * y * at(1) + 0.48860251F * z * at(2) + 0.48860251F * x * at(3);
    color += 1.0925485F * xy * at(4) + 1.0925485F * yz * at(5) + 0.31539157F * (2 * zz - xx - yy) * at(6) +
             1.0925485F * xz * at(7) + 0.54627422F * (xx - yy) * at(8);
    color += 0.59004359F * y * (3 * xx - yy) * at(9) + 2.8906114F * xy * z * at(10) +
             0.45704580F * y * (4 * zz - xx - yy) * at(11) + 0.37317633F * z * (2 * zz - 3 * xx - 3 * yy) * at(12) +
             0.45704580F * x * (4 * zz - xx - yy) * at(13) + 1.4453057F * z * (xx - yy) * at(14) +
             0.59004359F * x * (xx - 3 * yy) * at(15);
    rgb[channel * Step] = color;
  }
}

std::function<void()> usual_splats(const std::vector<float>& c, const std::vector<float>& directions, float* rgb) {
  return [&c, &directions, rgb] {
    for (std::size_t i = 0; i < directions.size() / 3; ++i) {
      splat_color<1>(&c[kSplatValues * i], directions[3 * i], directions[3 * i + 1], directions[3 * i + 2], rgb + 3 * i,
                     3, 1);
    }
    keep(*rgb);
  };
}

// The same over blocks of 16, which the compiler vectorises: channel by channel, as those of the library.
std::function<void()> splats_of_blocks(const float* c, const float* directions, std::size_t n, float* rgb) {
  return [c, directions, n, rgb] {
    for (std::size_t block = 0; block < n / 16; ++block) {
      const float* const from = c + block * 16 * kSplatValues;
      const float* const d = directions + block * 48;
      float* __restrict const to = rgb + block * 48;
#ifdef __clang__
#pragma clang loop vectorize(assume_safety)
#else
#pragma GCC ivdep
#endif
      for (std::size_t i = 0; i < 16; ++i) {
        splat_color<16>(from + i, d[i], d[16 + i], d[32 + i], to + i, 1, coefficient_count(kSplatDegree));
      }
    }
    keep(*rgb);
  };
}

void splats(Table& table, std::size_t n, const std::string& where) {
  const std::vector<float> c = random_vectors(n, kSplatValues);
  const std::vector<float> plain = random_directions(n);
  const Buffer<float> directions = to_blocks(plain, 3);
  const Buffer<float> blocks = to_blocks(c, kSplatValues);
  Buffer<batch::Half> halves =
      make_buffer<batch::Half>(batch::blocked_size<float>(n, kSplatValues), batch::Half{0x3400});
  const Buffer<float> rgb = make_buffer<float>(batch::blocked_size<float>(n, 3));
  const auto half_values = reinterpret_cast<const float*>(halves.get());
  const std::vector<double> t = least_times(
      {[&] {
         batch::evaluate_rgb(kSplatDegree, n, batch::blocked(blocks.get()), batch::blocked(directions.get()),
                             batch::blocked(rgb.get()));
       },
       usual_splats(c, plain, rgb.get()), read_task(blocks.get(), n * kSplatValues),
       [&] {
         batch::evaluate_rgb(kSplatDegree, n, batch::blocked<const batch::Half>(halves.get()),
                             batch::blocked(directions.get()), batch::blocked(rgb.get()));
       },
       read_task(half_values, n * kSplatValues / 2), splats_of_blocks(blocks.get(), directions.get(), n, rgb.get()),
       [&] {
         batch::evaluate_rgb(kSplatDegree, n, batch::interleaved<const float>(c.data()),
                             batch::plain<const float>(plain.data()), batch::plain(rgb.get()));
       }});
  const double ns = kNano / static_cast<double>(n);
  if (where == "in L1") {
    table.ratio("splats, " + where, "ns", t[0] * ns, t[5] * ns, "usual code on blocks", 1);
    table.ratio("splats in half precision, " + where, "ns", t[3] * ns, t[5] * ns, "usual code on blocks", 1.2);
    table.ratio("splats, interleaved, " + where, "ns", t[6] * ns, t[1] * ns, "usual code, splat by splat", 0.5);
  } else {
    table.ratio("splats, " + where, "ns", t[0] * ns, t[2] * ns, "read", 1.1);
    table.ratio("splats, interleaved, " + where, "ns", t[6] * ns, t[2] * ns, "read", 1.1);
    table.ratio("splats in half precision, " + where, "ns", t[3] * ns, t[4] * ns, "read", 1.2);
  }
}

}  // namespace

void evaluate(Table& table) {
  one_function(table);
  table.section(
      "Gaussian splats, degree 3, own color coefficients, float, blocked or interleaved, ns a splat",
      "controls: the usual code over the same blocks, vectorised, or over the same records, and reading them");
  splats(table, 128, "in L1");
  splats(table, 100'000, "100k");
  splats(table, 1'000'000, "1M");
}

}  // namespace sh::bench
