// Calls whose degree the compiler knows: it may leave a kernel alone, or a loop, in the caller. Compiled for any machine, and for
// AVX-512, where loops over more records stay in the caller.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

#include "tests/generated/batch_support.hpp"
#include "tests/message_of.hpp"

namespace sh::test {
namespace {

template <class T>
class KnownDegrees : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(KnownDegrees, Scalars);

// Numbers of every kind: also zeros of both signs, denormal, huge and infinite ones, and some that are none.
template <class T>
std::vector<T> any_numbers(std::size_t count) {
  using Limits = std::numeric_limits<T>;
  const std::vector<T> special{T(0),           -T(0),       Limits::denorm_min(), Limits::min(), Limits::max(),
                               -Limits::max(), T(1) / T(3), Limits::infinity(),   T(-1),         Limits::quiet_NaN()};
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::vector<T> values(count);
  for (std::size_t i = 0; i < count; ++i) {
    values[i] = i % 3 == 0 ? special[i / 3 % special.size()] : static_cast<T>(normal(random));
  }
  return values;
}

// Of two inputs that are no numbers a processor returns the first, and compilers swap factors: the sign may differ.
template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const T& x, const T& y) {
    return std::memcmp(&x, &y, sizeof(T)) == 0 || (std::isnan(x) && std::isnan(y));
  });
}

// Runs call(degree, out) with a degree that the compiler knows and with one that it does not.
template <int Degree, class T, class Call>
void expect_same(const char* family, std::size_t n, std::size_t size, const Call& call) {
  const std::size_t room = batch::blocked_size<T>(n, size) + 1;
  std::vector<T> known(room, T(-7)), unknown(room, T(-7));
  volatile int degree = Degree;
  call(std::integral_constant<int, Degree>(), known.data());
  call(static_cast<int>(degree), unknown.data());
  EXPECT_TRUE(same_bits(known, unknown)) << family << " of degree " << Degree << ", " << n << " records";
}

template <int Degree, class T>
void expect_families(std::size_t n, Layout in, Layout out) {
  constexpr std::size_t kSize = (Degree + 1) * (Degree + 1);
  const std::vector<T> d = any_numbers<T>(batch::blocked_size<T>(n, 3));
  const std::vector<T> c = any_numbers<T>(batch::blocked_size<T>(n, 3 * kSize));
  const Records<const T> directions{d.data(), in};
  const Records<const T> coefficients{c.data(), in};
  const auto to = [out](T* values) { return Records<T>{values, out}; };
  expect_same<Degree, T>("basis", n, kSize,
                         [&](auto degree, T* values) { batch::basis(degree, n, directions, to(values)); });
  expect_same<Degree, T>("basis_gradient", n, 4 * kSize,
                         [&](auto degree, T* values) { batch::basis_gradient(degree, n, directions, to(values)); });
  expect_same<Degree, T>("evaluate", n, 1, [&](auto degree, T* values) {
    batch::evaluate(degree, n, coefficients, directions, to(values));
  });
  expect_same<Degree, T>("evaluate_rgb", n, 3, [&](auto degree, T* values) {
    batch::evaluate_rgb(degree, n, coefficients, directions, to(values));
  });
  const Records<const T> one{d.data(), Layout::kShared};
  for (const auto& first : {coefficients, one}) {
    if constexpr (Degree <= 6) {
      expect_same<Degree, T>("product", n, kSize, [&](auto degree, T* values) {
        batch::product(degree, n, first, coefficients, to(values));
      });
    }
  }
  const std::vector<T> r = any_numbers<T>(batch::blocked_size<T>(n + 1, 9));
  for (const Records<const T>& matrices :
       {Records<const T>{r.data(), in}, Records<const T>{r.data(), Layout::kShared}}) {
    expect_same<Degree, T>("rotate", n, kSize, [&](auto degree, T* values) {
      batch::rotate(degree, n, matrices, coefficients, to(values));
    });
  }
}

template <class T, int... Degree>
void expect_degrees(std::size_t n, Layout in, Layout out, std::integer_sequence<int, Degree...> /*degrees*/) {
  (expect_families<Degree, T>(n, in, out), ...);
}

TYPED_TEST(KnownDegrees, HaveTheBitsOfUnknownOnes) {
  using T = TypeParam;
  for (const std::size_t n : {0, 1, 2, 7, 31, 32, 33, 100}) {
    on_every_set([&] {
      for (const Layout in : {Layout::kPlain, Layout::kBlocked, Layout::kShared}) {
        for (const Layout out : {Layout::kPlain, Layout::kBlocked}) {
          expect_degrees<T>(n, in, out, std::make_integer_sequence<int, 11>());
        }
      }
    });
  }
}

// Plain arrays, as most programs have them.
TYPED_TEST(KnownDegrees, HaveTheBitsOfUnknownOnesWhereTheCompilerKnowsTheLayout) {
  using T = TypeParam;
  constexpr std::size_t kMost = batch::detail::kMostDirect + 1;
  const std::vector<T> d = any_numbers<T>(3 * kMost), c = any_numbers<T>(kMost);
  std::vector<std::size_t> counts{kMost - 2, kMost - 1, kMost};
  for (std::size_t n = 0; n <= 40; ++n) counts.push_back(n);
  for (const std::size_t n : counts) {
    on_every_set([&] {
      expect_same<0, T>("basis", n, 1, [&](auto degree, T* out) {
        batch::basis(degree, n, batch::plain(d.data()), batch::plain(out));
      });
      expect_same<1, T>("basis", n, 4, [&](auto degree, T* out) {
        batch::basis(degree, n, batch::plain(d.data()), batch::plain(out));
      });
      expect_same<1, T>("basis_gradient", n, 16, [&](auto degree, T* out) {
        batch::basis_gradient(degree, n, batch::plain(d.data()), batch::plain(out));
      });
      expect_same<0, T>("evaluate", n, 1, [&](auto degree, T* out) {
        batch::evaluate(degree, n, batch::plain(c.data()), batch::plain(d.data()), batch::plain(out));
      });
      expect_same<0, T>("rotate", n, 1, [&](auto degree, T* out) {
        batch::rotate(degree, n, batch::shared(d.data()), batch::plain(c.data()), batch::plain(out));
      });
      expect_same<0, T>("product", n, 1, [&](auto degree, T* out) {
        batch::product(degree, n, batch::plain(d.data()), batch::plain(c.data()), batch::plain(out));
      });
      expect_same<0, T>("product", n, 1, [&](auto degree, T* out) {
        batch::product(degree, n, batch::shared(d.data()), batch::plain(c.data()), batch::plain(out));
      });
    });
  }
}

TYPED_TEST(KnownDegrees, WriteOverAnInputOfTheSameShape) {
  using T = TypeParam;
  for (const std::size_t n : {1, 5, 32, 40}) {
    const std::vector<T> d = any_numbers<T>(3 * n);
    std::vector<T> c = any_numbers<T>(n), out(n);
    batch::evaluate(0, n, batch::plain(std::as_const(c).data()), batch::plain(d.data()), batch::plain(out.data()));
    batch::evaluate(0, n, batch::plain(std::as_const(c).data()), batch::plain(d.data()), batch::plain(c.data()));
    EXPECT_TRUE(same_bits(c, out)) << n;
  }
}

TYPED_TEST(KnownDegrees, RefuseNullPointersAndSharedOutputs) {
  using T = TypeParam;
  std::vector<T> values(100);
  const auto some = batch::plain(values.data());
  const Records<const T> none;
  EXPECT_EQ(message_of([&] { batch::basis(0, 7, none, some); }),
            "sh::batch::basis: expected arrays of 7 records, got a null pointer");
  EXPECT_EQ(message_of([&] { batch::evaluate(0, 7, Records<const T>(some), none, some); }),
            "sh::batch::evaluate: expected arrays of 7 records, got a null pointer");
  EXPECT_EQ(message_of([&] { batch::basis_gradient(1, 2, Records<const T>(some), Records<T>{}); }),
            "sh::batch::basis_gradient: expected arrays of 2 records, got a null pointer");
  EXPECT_EQ(message_of([&] { batch::basis(1, 2, Records<const T>(some), batch::shared(values.data())); }),
            "sh::batch::basis: expected a plain or blocked output, got a shared one");
  EXPECT_EQ(message_of([&] { batch::basis(0, 0, none, Records<T>{}); }), "nothing thrown");
  EXPECT_EQ(message_of([&] { batch::basis(-1, 1, Records<const T>(some), some); }),
            "sh::batch::basis: expected a degree of 0 to 10, got -1");
}

}  // namespace
}  // namespace sh::test
