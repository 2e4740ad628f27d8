// The drivers of sh::batch beside the kernels they run.
#include <cmath>

#include "generated/cpp/basis.hpp"
#include "generated/cpp/basis_gradient.hpp"
#include "generated/cpp/evaluate.hpp"
#include "generated/cpp/evaluate_rgb.hpp"
#include "generated/cpp/product.hpp"
#include "generated/cpp/rotate.hpp"
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

template <class T>
std::vector<T> random_rotation(std::mt19937& random) {
  const std::vector<double> q = random_numbers<double>(4, random);
  const double s = 2 / (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  const auto entry = [&](double value) { return static_cast<T>(s * value); };
  return {static_cast<T>(1 - s * (q[2] * q[2] + q[3] * q[3])),
          entry(q[1] * q[2] - q[0] * q[3]),
          entry(q[1] * q[3] + q[0] * q[2]),
          entry(q[1] * q[2] + q[0] * q[3]),
          static_cast<T>(1 - s * (q[1] * q[1] + q[3] * q[3])),
          entry(q[2] * q[3] - q[0] * q[1]),
          entry(q[1] * q[3] - q[0] * q[2]),
          entry(q[2] * q[3] + q[0] * q[1]),
          static_cast<T>(1 - s * (q[1] * q[1] + q[2] * q[2]))};
}

template <class T>
Subject<T> rotate_subject(int degree) {
  return {"rotate",
          degree,
          {9, count_of(degree)},
          count_of(degree),
          [degree](std::size_t j, std::mt19937& random) {
            return j == 0 ? random_rotation<T>(random) : random_vector<T>(degree, random);
          },
          [degree](std::size_t n, const auto& in, Records<T> out) { batch::rotate(degree, n, in[0], in[1], out); },
          [degree](const auto& in, T* out) {
            with_degree<10>(degree, [&]<int kDegree>() { rotate<kDegree>(in[0], in[1], out); });
          },
          16,
          64};
}

template <class T>
Subject<T> gradient_subject(int degree) {
  const std::size_t size = count_of(degree);
  return {"basis_gradient",
          degree,
          {3},
          4 * size,
          [](std::size_t /*j*/, std::mt19937& random) { return random_direction<T>(random); },
          [degree](std::size_t n, const auto& in, Records<T> out) { batch::basis_gradient(degree, n, in[0], out); },
          [degree, size](const auto& in, T* out) {
            with_degree<10>(degree, [&]<int kDegree>() {
              basis_gradient<kDegree>(in[0][0], in[0][1], in[0][2], out, out + size, out + 2 * size, out + 3 * size);
            });
          },
          400,
          400};
}

template <class T>
Subject<T> evaluate_subject(int degree) {
  return {"evaluate",
          degree,
          {count_of(degree), 3},
          1,
          [degree](std::size_t j, std::mt19937& random) {
            return j == 0 ? random_vector<T>(degree, random) : random_direction<T>(random);
          },
          [degree](std::size_t n, const auto& in, Records<T> out) { batch::evaluate(degree, n, in[0], in[1], out); },
          [degree](const auto& in, T* out) {
            with_degree<10>(degree,
                            [&]<int kDegree>() { *out = evaluate<kDegree>(in[0], in[1][0], in[1][1], in[1][2]); });
          },
          16,
          400};
}

template <class T>
Subject<T> evaluate_rgb_subject(int degree) {
  return {
      "evaluate_rgb",
      degree,
      {3 * count_of(degree), 3},
      3,
      [degree](std::size_t j, std::mt19937& random) {
        return j == 0 ? random_numbers<T>(3 * count_of(degree), random) : random_direction<T>(random);
      },
      [degree](std::size_t n, const auto& in, Records<T> out) { batch::evaluate_rgb(degree, n, in[0], in[1], out); },
      [degree](const auto& in, T* out) {
        with_degree<10>(degree,
                        [&]<int kDegree>() { evaluate_rgb<kDegree>(in[0], in[1][0], in[1][1], in[1][2], out); });
      },
      64,
      64};
}

}  // namespace

template <class T>
std::vector<Subject<T>> subjects() {
  std::vector<Subject<T>> all;
  for (const int degree : {0, 1, 2, 4, 5, 9, 10}) all.push_back(basis_subject<T>(degree));
  for (const int degree : {0, 2, 4, 6}) all.push_back(product_subject<T>(degree));
  for (const int degree : {0, 1, 3, 6, 10}) {
    all.push_back(rotate_subject<T>(degree));
    all.push_back(gradient_subject<T>(degree));
    all.push_back(evaluate_subject<T>(degree));
    all.push_back(evaluate_rgb_subject<T>(degree));
  }
  return all;
}

template std::vector<Subject<float>> subjects<float>();
template std::vector<Subject<double>> subjects<double>();

}  // namespace sh::test
