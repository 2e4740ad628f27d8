// The drivers of sh::batch beside the kernels they run.
#include <cmath>

#include "generated/cpp/basis.hpp"
#include "generated/cpp/product.hpp"
#include "tests/generated/batch_support.hpp"

namespace sh::test {
namespace {

template <class T>
std::vector<T> random_numbers(std::size_t count, std::mt19937& random) {
  std::normal_distribution<double> normal;
  std::vector<T> values(count);
  for (T& value : values) value = static_cast<T>(normal(random));
  return values;
}

template <class T>
std::vector<T> random_direction(std::mt19937& random) {
  const std::vector<double> v = random_numbers<double>(3, random);
  const double length = std::hypot(v[0], v[1], v[2]);
  return {static_cast<T>(v[0] / length), static_cast<T>(v[1] / length), static_cast<T>(v[2] / length)};
}

template <class T>
std::vector<T> random_vector(int degree, std::mt19937& random) {
  std::vector<T> values = random_numbers<T>(count_of(degree), random);
  double square = 0;
  for (const T value : values) square += static_cast<double>(value) * static_cast<double>(value);
  for (T& value : values) value = static_cast<T>(static_cast<double>(value) / std::sqrt(square));
  return values;
}

template <class T>
Subject<T> basis_subject(int degree) {
  return {"basis",
          degree,
          {3},
          count_of(degree),
          [](std::size_t /*j*/, std::mt19937& random) { return random_direction<T>(random); },
          [degree](std::size_t n, const auto& in, Records<T> out) { batch::basis(degree, n, in[0], out); },
          [degree](const auto& in, T* out) {
            with_degree<10>(degree, [&]<int kDegree>() { basis<kDegree>(in[0][0], in[0][1], in[0][2], out); });
          },
          40,
          40};
}

template <class T>
Subject<T> product_subject(int degree) {
  const std::size_t size = count_of(degree);
  return {"product",
          degree,
          {size, size},
          size,
          [degree](std::size_t /*j*/, std::mt19937& random) { return random_vector<T>(degree, random); },
          [degree](std::size_t n, const auto& in, Records<T> out) { batch::product(degree, n, in[0], in[1], out); },
          [degree](const auto& in, T* out) {
            with_degree<6>(degree, [&]<int kDegree>() { product<kDegree>(in[0], in[1], out); });
          },
          2,
          2};
}

}  // namespace

template <class T>
std::vector<Subject<T>> subjects() {
  std::vector<Subject<T>> all;
  for (const int degree : {0, 1, 2, 4, 5, 9, 10}) all.push_back(basis_subject<T>(degree));
  for (const int degree : {0, 2, 4, 6}) all.push_back(product_subject<T>(degree));
  return all;
}

template std::vector<Subject<float>> subjects<float>();
template std::vector<Subject<double>> subjects<double>();

}  // namespace sh::test
