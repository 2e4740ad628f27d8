// The library over many records against loops over the headers, on any processor: plain records, few and many.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <utility>
#include <vector>

#include "generated/batch/batch.hpp"
#include "generated/cpp/basis.hpp"
#include "generated/cpp/evaluate.hpp"
#include "generated/cpp/product.hpp"
#include "generated/cpp/relight_rgb.hpp"
#include "generated/cpp/rotate.hpp"

namespace {

namespace batch = sh::batch;

constexpr std::size_t kMost = 37;
constexpr std::size_t size_of(int degree) { return std::size_t(degree + 1) * std::size_t(degree + 1); }

bool failed = false;

// Numbers from -1 to 1 that are the same everywhere.
std::vector<float> numbers(std::size_t count) {
  static unsigned state = 1;
  std::vector<float> out(count);
  for (float& value : out) {
    state = 1664525U * state + 1013904223U;
    value = float(state >> 8) / 8388608.0F - 1.0F;
  }
  return out;
}

std::vector<float> directions(std::size_t count) {
  std::vector<float> out = numbers(3 * count);
  for (std::size_t i = 0; i < out.size(); i += 3) {
    const float length = std::sqrt(out[i] * out[i] + out[i + 1] * out[i + 1] + out[i + 2] * out[i + 2]);
    for (std::size_t k = 0; k < 3; ++k) out[i + k] /= length;
  }
  return out;
}

std::vector<float> rotations(std::size_t count) {
  std::vector<float> out;
  for (const float angle : numbers(count)) {
    const float c = std::cos(3 * angle);
    const float s = std::sin(3 * angle);
    out.insert(out.end(), {c, -s, 0, 0.6F * s, 0.6F * c, -0.8F, 0.8F * s, 0.8F * c, 0.6F});
  }
  return out;
}

void compare(const char* what, int degree, std::size_t n, const std::vector<float>& ours,
             const std::vector<float>& wanted) {
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (std::abs(ours[i] - wanted[i]) <= 1e-5F * (1 + std::abs(wanted[i]))) continue;
    std::printf("%s, degree %d, %zu records: %zu is %g, expected %g\n", what, degree, n, i, double(ours[i]),
                double(wanted[i]));
    failed = true;
    return;
  }
}

// The whole blocks of records of `size` numbers, one coefficient of 16 records after the other.
template <class Number>
std::vector<Number> in_blocks(const std::vector<Number>& records, std::size_t size) {
  std::vector<Number> blocks(records.size() / (16 * size) * 16 * size);
  for (std::size_t i = 0; i < blocks.size() / size; ++i) {
    for (std::size_t k = 0; k < size; ++k) blocks[i / 16 * 16 * size + 16 * k + i % 16] = records[i * size + k];
  }
  return blocks;
}

// Blocks of records in any precision against the records, one after the other.
template <int Degree, class Number, class Wanted>
void check_stored(const char* what, std::size_t n, const std::vector<Number>& records, const Wanted& wanted_of) {
  constexpr std::size_t kSize = size_of(Degree);
  const std::vector<float> light = numbers(3 * kSize);
  const std::vector<float> scales(kSize, 1.0F / 127.0F);
  const std::vector<Number> blocks = in_blocks(records, kSize);
  std::vector<float> wanted(n / 16 * 16 * 3);
  std::vector<float> ours(wanted.size());
  wanted_of(n / 16 * 16, light.data(), wanted.data());
  const batch::StoredBlocks<Number> stored{blocks.data(), scales.data(), 1, kSize};
  batch::relight_stored(stored, n / 16, light.data(), nullptr, ours.data());
  compare(what, Degree, n, ours, wanted);
}

template <int Degree>
void check(std::size_t n) {
  constexpr std::size_t kSize = size_of(Degree);
  const std::vector<float> d = directions(n);
  const std::vector<float> a = numbers(n * kSize);
  const std::vector<float> b = numbers(n * kSize);
  const std::vector<float> r = rotations(n);
  std::vector<float> ours(n * kSize);
  std::vector<float> wanted(n * kSize);
  const auto each = [&](const auto& kernel) {
    for (std::size_t i = 0; i < n; ++i) kernel(i);
  };
  batch::basis(Degree, n, batch::plain(d.data()), batch::plain(ours.data()));
  each([&](std::size_t i) { sh::basis<Degree>(d[3 * i], d[3 * i + 1], d[3 * i + 2], &wanted[i * kSize]); });
  compare("basis", Degree, n, ours, wanted);
  batch::rotate(Degree, n, batch::plain(r.data()), batch::plain(a.data()), batch::plain(ours.data()));
  each([&](std::size_t i) { sh::rotate<Degree>(&r[9 * i], &a[i * kSize], &wanted[i * kSize]); });
  compare("rotate", Degree, n, ours, wanted);
  each([&](std::size_t i) { batch::rotate_one(Degree, &r[9 * i], &a[i * kSize], &ours[i * kSize]); });
  compare("rotate_one", Degree, n, ours, wanted);
  each([&](std::size_t i) { sh::product<Degree>(&a[i * kSize], &b[i * kSize], &wanted[i * kSize]); });
  if (Degree <= 6) {
    batch::product(Degree, n, batch::plain(a.data()), batch::plain(b.data()), batch::plain(ours.data()));
    compare("product", Degree, n, ours, wanted);
  }
  each([&](std::size_t i) { batch::product_one(Degree, &a[i * kSize], &b[i * kSize], &ours[i * kSize]); });
  compare("product_one", Degree, n, ours, wanted);
  std::vector<float> values(n);
  std::vector<float> exact(n);
  batch::evaluate(Degree, n, batch::shared(a.data()), batch::plain(d.data()), batch::plain(values.data()));
  each([&](std::size_t i) { exact[i] = sh::evaluate<Degree>(a.data(), d[3 * i], d[3 * i + 1], d[3 * i + 2]); });
  compare("evaluate", Degree, n, values, exact);
  const std::vector<float> light = numbers(3 * kSize);
  std::vector<float> rgb(3 * n);
  std::vector<float> sums(3 * n);
  batch::relight_rgb(Degree, n, batch::plain(a.data()), light.data(), batch::plain(rgb.data()));
  each([&](std::size_t i) { sh::relight_rgb<Degree>(&a[i * kSize], light.data(), &sums[3 * i]); });
  compare("relight_rgb", Degree, n, rgb, sums);
  const auto relit = [&](const auto* records) {
    return [=](std::size_t count, const float* by, float* out) {
      batch::relight_rgb(Degree, count, batch::plain(records), by, batch::plain(out));
    };
  };
  std::vector<batch::Half> halves(a.size());
  std::vector<std::int8_t> bytes(a.size());
  std::vector<float> of_bytes(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    halves[i] = batch::Half(0x3000 + int(1000 * a[i]));
    bytes[i] = std::int8_t(127 * a[i]);
    of_bytes[i] = float(bytes[i]) / 127.0F;
  }
  check_stored<Degree>("relight_stored of float", n, a, relit(a.data()));
  check_stored<Degree>("relight_stored of halves", n, halves, relit(static_cast<const batch::Half*>(halves.data())));
  check_stored<Degree>("relight_stored of bytes", n, bytes, relit(of_bytes.data()));
}

template <int... Degree>
void check_all(std::integer_sequence<int, Degree...>) {
  for (const std::size_t n : {std::size_t{1}, std::size_t{2}, std::size_t{3}, std::size_t{7}, std::size_t{16}, kMost}) {
    (check<Degree>(n), ...);
  }
}

}  // namespace

int main() {
  check_all(std::make_integer_sequence<int, 11>());
  std::printf(failed ? "failed\n" : "degree 0 to 10: the batches are the loops\n");
  return failed ? 1 : 0;
}
