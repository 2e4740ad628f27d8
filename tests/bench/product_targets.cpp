// Products of two functions against the classic factoring into pairs of coefficients, chosen greedily [Snyder06].
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "generated/batch/batch.hpp"
#include "generated/cpp/product.hpp"
#include "tests/bench/controls/greedy_pairs_product.hpp"
#include "tests/bench/harness.hpp"

namespace sh::bench {
namespace {

constexpr std::size_t kProducts = 64;

// Of the time of greedy pairs, for one product, one with SIMD inside (on AVX-512), and one of a batch.
struct Target {
  double single;
  double single_simd;
  double batched;
};
constexpr std::array<Target, 4> kTargets{{{1.25, 0.55, 0.11}, {1.3, 0.44, 0.1}, {0.8, 0.23, 0.08}, {0.8, 0.17, 0.1}}};

// Every product of two sets of vectors, one by one.
template <std::size_t Size, class F>
std::function<void()> one_by_one(const std::vector<float>& a, const std::vector<float>& b, float* out, const F& f) {
  return [&a, &b, out, f] {
    for (std::size_t i = 0; i < a.size(); i += Size) {
      f(&a[i], &b[i], out + i);
      keep(*out);
    }
  };
}

// Largest error of a coefficient of product_one for unit vectors, in epsilons, against the header in double.
template <int Degree>
double largest_error(const std::vector<float>& a, const std::vector<float>& b) {
  constexpr std::size_t kSize = coefficient_count(Degree);
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); i += kSize) {
    std::array<double, kSize> in_a{};
    std::array<double, kSize> in_b{};
    std::array<double, kSize> exact{};
    std::array<float, kSize> out{};
    std::copy_n(&a[i], kSize, in_a.begin());
    std::copy_n(&b[i], kSize, in_b.begin());
    sh::product<Degree>(in_a.data(), in_b.data(), exact.data());
    batch::product_one(Degree, &a[i], &b[i], out.data());
    for (std::size_t k = 0; k < kSize; ++k) {
      largest = std::fmax(largest, std::abs(exact[k] - static_cast<double>(out[k])));
    }
  }
  return largest / static_cast<double>(std::numeric_limits<float>::epsilon());
}

void errors(Table& table) {
  constexpr std::size_t kPairs = 20000;
  table.section("Products, largest error of product_one for 20000 pairs of unit vectors, in epsilons",
                "against the header in double");
  for_degrees<2, 6>([&]<int kDegree>() {
    const std::vector<float> a = random_vectors(kPairs, coefficient_count(kDegree));
    const std::vector<float> b(a.rbegin(), a.rend());
    table.figure("product_one, degree " + std::to_string(kDegree), "eps", largest_error<kDegree>(a, b), 4);
  });
}

}  // namespace

void product(Table& table) {
  table.section("Products, float, ns", "control: greedy pairs; one by one, and per product of a blocked batch");
  for_degrees<2, 5>([&]<int kDegree>() {
    constexpr std::size_t kSize = coefficient_count(kDegree);
    const std::vector<float> a = random_vectors(kProducts, kSize);
    const std::vector<float> b(a.rbegin(), a.rend());
    const Buffer<float> out = make_buffer<float>(kProducts * kSize);
    const Buffer<float> blocks_a = to_blocks(a, kSize);
    const Buffer<float> blocks_b = to_blocks(b, kSize);
    const std::vector<double> t = least_times(
        {one_by_one<kSize>(a, b, out.get(),
                           [](const float* p, const float* q, float* o) { sh::product<kDegree>(p, q, o); }),
         one_by_one<kSize>(
             a, b, out.get(),
             [](const float* p, const float* q, float* o) { control::greedy_pairs_product<kDegree>(p, q, o); }),
         [&] {
           batch::product(kDegree, kProducts, batch::blocked(blocks_a.get()), batch::blocked(blocks_b.get()),
                          batch::blocked(out.get()));
         },
         one_by_one<kSize>(a, b, out.get(),
                           [](const float* p, const float* q, float* o) { batch::product_one(kDegree, p, q, o); })});
    const double ns = 1e9 / kProducts;
    const std::string what = "product, " + std::to_string(kDegree + 1) + " bands";
    const Target target = kTargets[kDegree - 2];
    table.ratio(what, "ns", t[0] * ns, t[1] * ns, "greedy pairs", target.single);
    table.ratio(what + ", one with SIMD inside", "ns", t[3] * ns, t[1] * ns, "greedy pairs", target.single_simd);
    table.ratio(what + ", batch", "ns", t[2] * ns, t[1] * ns, "greedy pairs", target.batched);
    table.cell("product, one", kDegree, t[0] * ns);
    table.cell("greedy pairs [Snyder 2006]", kDegree, t[1] * ns);
    table.cell("product, one with SIMD inside", kDegree, t[3] * ns);
    table.cell("product, one of a batch", kDegree, t[2] * ns);
  });
  errors(table);
}

}  // namespace sh::bench
