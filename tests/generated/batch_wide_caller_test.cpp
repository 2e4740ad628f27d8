// A caller that is compiled for AVX-512: loops of degree 0 and 1 stay in it up to more records.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstring>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include "generated/batch/batch.hpp"

namespace sh::test {
namespace {

static_assert(batch::detail::kFewPlain > 32, "the header sees an AVX-512 caller");

template <class T>
struct Outputs {
  std::vector<T> basis, gradient, evaluated;
};

// Degree: an integral constant, which the compiler knows, or a number that it does not.
template <class T, class Degree>
Outputs<T> outputs(Degree degree, std::size_t bands, std::size_t n, const T* directions, const T* coefficients) {
  const std::size_t size = bands * bands;
  Outputs<T> to{std::vector<T>(n * size, T(-7)), std::vector<T>(n * 4 * size, T(-7)), std::vector<T>(n, T(-7))};
  batch::basis(degree, n, batch::plain(directions), batch::plain(to.basis.data()));
  batch::basis_gradient(degree, n, batch::plain(directions), batch::plain(to.gradient.data()));
  batch::evaluate(degree, n, batch::plain(coefficients), batch::plain(directions), batch::plain(to.evaluated.data()));
  return to;
}

template <class T>
bool refuses_null(std::size_t n) {
  T out[4096];
  const T* const none = nullptr;
  try {
    batch::basis(0, n, batch::plain(none), batch::plain(static_cast<T*>(out)));
  } catch (const std::invalid_argument&) {
    return true;
  }
  return false;
}

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

template <class T, int Degree>
void expect_same(std::size_t n) {
  constexpr std::size_t kBands = Degree + 1;
  std::vector<T> directions(3 * n), coefficients(kBands * kBands * n);
  for (std::size_t i = 0; i < directions.size(); ++i) directions[i] = T(1) / static_cast<T>(i % 17 + 3) - T(0.2);
  for (std::size_t i = 0; i < coefficients.size(); ++i) coefficients[i] = static_cast<T>(i % 13) - T(6.5);
  volatile int degree = Degree;
  const Outputs<T> known =
      outputs<T>(std::integral_constant<int, Degree>(), kBands, n, directions.data(), coefficients.data());
  const Outputs<T> unknown = outputs<T>(static_cast<int>(degree), kBands, n, directions.data(), coefficients.data());
  EXPECT_TRUE(same_bits(known.basis, unknown.basis)) << "basis " << Degree << ", " << n << " records";
  EXPECT_TRUE(same_bits(known.gradient, unknown.gradient)) << "basis_gradient " << Degree << ", " << n << " records";
  EXPECT_TRUE(same_bits(known.evaluated, unknown.evaluated)) << "evaluate " << Degree << ", " << n << " records";
}

TEST(WideCaller, HasTheBitsOfTheLibrary) {
  for (const std::size_t n : {0, 1, 3, 17, 32, 33, 100, 1023, 1024, 1025, 3000}) {
    expect_same<float, 0>(n);
    expect_same<float, 1>(n);
    expect_same<float, 2>(n);
    expect_same<double, 0>(n);
    expect_same<double, 1>(n);
    expect_same<double, 2>(n);
  }
}

TEST(WideCaller, RefusesMissingArraysUnlessThereIsNothingToDo) {
  for (const std::size_t n : {1, 17, 1000, 2000}) {
    EXPECT_TRUE(refuses_null<float>(n)) << n;
    EXPECT_TRUE(refuses_null<double>(n)) << n;
  }
  EXPECT_FALSE(refuses_null<float>(0));
}

}  // namespace
}  // namespace sh::test
