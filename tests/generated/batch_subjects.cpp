// The drivers of sh::batch beside the kernels they run.
#include <cmath>
#include <map>

#include "generated/cpp/basis.hpp"
#include "generated/cpp/basis_gradient.hpp"
#include "generated/cpp/evaluate.hpp"
#include "generated/cpp/evaluate_rgb.hpp"
#include "generated/cpp/product.hpp"
#include "generated/cpp/relight.hpp"
#include "generated/cpp/relight_colored.hpp"
#include "generated/cpp/relight_rgb.hpp"
#include "generated/cpp/rotate.hpp"
#include "generated/cpp/transfer_apply.hpp"
#include "generated/cpp/transfer_apply_rgb.hpp"
#include "generated/cpp/transfer_glossy.hpp"
#include "generated/cpp/transfer_glossy_rgb.hpp"
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
  std::vector<T> values = random_numbers<T>(coefficient_count(degree), random);
  double square = 0;
  for (const T value : values) square += static_cast<double>(value) * static_cast<double>(value);
  for (T& value : values) value = static_cast<T>(static_cast<double>(value) / std::sqrt(square));
  return values;
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

// The kinds of input records.
enum class Kind { kDirection, kRotation, kVector, kColors, kVisibility, kLobe };

int size_of(Kind kind, int degree) {
  switch (kind) {
    case Kind::kDirection:
      return 3;
    case Kind::kRotation:
      return 9;
    case Kind::kVector:
      return coefficient_count(degree);
    case Kind::kVisibility:
      return coefficient_count(2 * degree);
    case Kind::kLobe:
      return degree + 1;
    default:
      return 3 * coefficient_count(degree);
  }
}

template <class T>
std::vector<T> random_record(Kind kind, int degree, std::mt19937& random) {
  switch (kind) {
    case Kind::kDirection:
      return random_direction<T>(random);
    case Kind::kRotation:
      return random_rotation<T>(random);
    case Kind::kVector:
      return random_vector<T>(degree, random);
    case Kind::kVisibility:
      return random_vector<T>(2 * degree, random);
    default:
      return random_numbers<T>(size_of(kind, degree), random);
  }
}

// tolerances: the largest difference from the kernel, in machine epsilons, without and with a shared input
template <class T, int Largest = 10, class Run, class Kernel>
Subject<T> subject(const char* name, int degree, const std::vector<Kind>& kinds, int out,
                   std::array<double, 2> tolerances, Run run, Kernel kernel) {
  Subject<T> result{
      .name = name,
      .degree = degree,
      .out = out,
      .record = [kinds, degree](std::size_t j,
                                std::mt19937& random) { return random_record<T>(kinds[j], degree, random); },
      .run = run,
      .kernel =
          [degree, kernel](const auto& in, T* to) {
            with_degree<Largest>(degree, [&]<int kDegree>() { kernel.template operator()<kDegree>(in, to); });
          },
      .tolerance = tolerances[0],
      .tolerance_shared = tolerances[1]};
  for (const Kind kind : kinds) result.in.push_back(size_of(kind, degree));
  return result;
}

template <class T>
Subject<T> basis_subject(int degree) {
  return subject<T>(
      "basis", degree, {Kind::kDirection}, coefficient_count(degree), {40, 40},
      [degree](std::size_t n, const auto& in, Records<T> out) { batch::basis(degree, n, in[0], out); },
      []<int kDegree>(const auto& in, T* out) { basis<kDegree>(in[0][0], in[0][1], in[0][2], out); });
}

template <class T>
Subject<T> product_subject(int degree) {
  return subject<T, 6>(
      "product", degree, {Kind::kVector, Kind::kVector}, coefficient_count(degree), {2, 2},
      [degree](std::size_t n, const auto& in, Records<T> out) { batch::product(degree, n, in[0], in[1], out); },
      []<int kDegree>(const auto& in, T* out) { product<kDegree>(in[0], in[1], out); });
}

template <class T>
Subject<T> rotate_subject(int degree) {
  return subject<T>(
      "rotate", degree, {Kind::kRotation, Kind::kVector}, coefficient_count(degree), {16, 64},
      [degree](std::size_t n, const auto& in, Records<T> out) { batch::rotate(degree, n, in[0], in[1], out); },
      []<int kDegree>(const auto& in, T* out) { rotate<kDegree>(in[0], in[1], out); });
}

template <class T>
Subject<T> gradient_subject(int degree) {
  return subject<T>(
      "basis_gradient", degree, {Kind::kDirection}, 4 * coefficient_count(degree), {400, 400},
      [degree](std::size_t n, const auto& in, Records<T> out) { batch::basis_gradient(degree, n, in[0], out); },
      []<int kDegree>(const auto& in, T* out) {
        constexpr int kSize = coefficient_count(kDegree);
        basis_gradient<kDegree>(in[0][0], in[0][1], in[0][2], out, out + kSize, out + 2 * kSize, out + 3 * kSize);
      });
}

template <class T>
Subject<T> evaluate_subject(int degree) {
  return subject<T>(
      "evaluate", degree, {Kind::kVector, Kind::kDirection}, 1, {16, 400},
      [degree](std::size_t n, const auto& in, Records<T> out) { batch::evaluate(degree, n, in[0], in[1], out); },
      []<int kDegree>(const auto& in, T* out) { *out = evaluate<kDegree>(in[0], in[1][0], in[1][1], in[1][2]); });
}

template <class T>
Subject<T> evaluate_rgb_subject(int degree) {
  return subject<T>(
      "evaluate_rgb", degree, {Kind::kColors, Kind::kDirection}, 3, {96, 96},
      [degree](std::size_t n, const auto& in, Records<T> out) { batch::evaluate_rgb(degree, n, in[0], in[1], out); },
      []<int kDegree>(const auto& in, T* out) { evaluate_rgb<kDegree>(in[0], in[1][0], in[1][1], in[1][2], out); });
}

// A light in three channels that serves all records.
template <class T>
const T* samples_of(int degree) {
  static std::map<int, std::vector<T>> known;
  std::mt19937 random(7);
  const std::size_t size = degree == 0 ? 1 : 8 * degree * degree + 4;
  return known.try_emplace(degree, random_numbers<T>(3 * size, random)).first->second.data();
}

template <class T>
Subject<T> transfer_subject(int degree) {
  return subject<T, 6>(
      "transfer_apply_rgb", degree, {Kind::kVisibility}, 3 * coefficient_count(degree), {8, 8},
      [degree](std::size_t n, const auto& in, Records<T> out) {
        batch::transfer_apply_rgb(degree, n, in[0], samples_of<T>(degree), out);
      },
      []<int kDegree>(const auto& in, T* out) { transfer_apply_rgb<kDegree>(in[0], samples_of<T>(kDegree), out); });
}

template <class T>
Subject<T> gray_transfer_subject(int degree) {
  return subject<T, 6>(
      "transfer_apply", degree, {Kind::kVisibility}, coefficient_count(degree), {8, 8},
      [degree](std::size_t n, const auto& in, Records<T> out) {
        batch::transfer_apply(degree, n, in[0], samples_of<T>(degree), out);
      },
      []<int kDegree>(const auto& in, T* out) { transfer_apply<kDegree>(in[0], samples_of<T>(kDegree), out); });
}

template <class T>
Subject<T> glossy_subject(int degree) {
  return subject<T, 6>(
      "transfer_glossy", degree, {Kind::kVisibility, Kind::kLobe, Kind::kDirection}, 1, {32, 32},
      [degree](std::size_t n, const auto& in, Records<T> out) {
        batch::transfer_glossy(degree, n, in[0], samples_of<T>(degree), in[1], in[2], out);
      },
      []<int kDegree>(const auto& in, T* out) {
        *out = transfer_glossy<kDegree>(in[0], samples_of<T>(kDegree), in[1], in[2][0], in[2][1], in[2][2]);
      });
}

template <class T>
Subject<T> glossy_rgb_subject(int degree) {
  return subject<T, 6>(
      "transfer_glossy_rgb", degree, {Kind::kVisibility, Kind::kLobe, Kind::kDirection}, 3, {32, 32},
      [degree](std::size_t n, const auto& in, Records<T> out) {
        batch::transfer_glossy_rgb(degree, n, in[0], samples_of<T>(degree), in[1], in[2], out);
      },
      []<int kDegree>(const auto& in, T* out) {
        transfer_glossy_rgb<kDegree>(in[0], samples_of<T>(kDegree), in[1], in[2][0], in[2][1], in[2][2], out);
      });
}

template <class T>
Subject<T> relight_subject(int degree) {
  return subject<T>(
      "relight", degree, {Kind::kVector}, 1, {32, 32},
      [degree](std::size_t n, const auto& in, Records<T> out) {
        batch::relight(degree, n, in[0], samples_of<T>(degree), out);
      },
      []<int kDegree>(const auto& in, T* out) { *out = relight<kDegree>(in[0], samples_of<T>(kDegree)); });
}

template <class T>
Subject<T> relight_rgb_subject(int degree) {
  return subject<T>(
      "relight_rgb", degree, {Kind::kVector}, 3, {32, 32},
      [degree](std::size_t n, const auto& in, Records<T> out) {
        batch::relight_rgb(degree, n, in[0], samples_of<T>(degree), out);
      },
      []<int kDegree>(const auto& in, T* out) { relight_rgb<kDegree>(in[0], samples_of<T>(kDegree), out); });
}

template <class T>
Subject<T> relight_colored_subject(int degree) {
  return subject<T>(
      "relight_colored", degree, {Kind::kColors}, 3, {256, 256},
      [degree](std::size_t n, const auto& in, Records<T> out) {
        batch::relight_colored(degree, n, in[0], samples_of<T>(degree), out);
      },
      []<int kDegree>(const auto& in, T* out) { relight_colored<kDegree>(in[0], samples_of<T>(kDegree), out); });
}

}  // namespace

template <class T>
std::vector<Subject<T>> subjects() {
  std::vector<Subject<T>> all;
  for (const int degree : {0, 1, 2, 4, 5, 9, 10}) all.push_back(basis_subject<T>(degree));
  for (const int degree : {0, 2, 4, 6}) all.push_back(product_subject<T>(degree));
  for (const int degree : {0, 1, 2, 4, 6}) {
    all.push_back(glossy_subject<T>(degree));
    all.push_back(glossy_rgb_subject<T>(degree));
  }
  // In stages from degree 2 on; odd and even degrees fold their angles.
  for (const int degree : {0, 1, 2, 3, 4, 5, 6}) {
    all.push_back(transfer_subject<T>(degree));
    all.push_back(gray_transfer_subject<T>(degree));
  }
  for (const int degree : {0, 1, 3, 6, 10}) {
    all.push_back(rotate_subject<T>(degree));
    all.push_back(gradient_subject<T>(degree));
    all.push_back(evaluate_subject<T>(degree));
    all.push_back(evaluate_rgb_subject<T>(degree));
    all.push_back(relight_subject<T>(degree));
    all.push_back(relight_rgb_subject<T>(degree));
    all.push_back(relight_colored_subject<T>(degree));
  }
  return all;
}

template std::vector<Subject<float>> subjects<float>();
template std::vector<Subject<double>> subjects<double>();

}  // namespace sh::test
