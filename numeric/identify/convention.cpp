// See convention.hpp.
#include "numeric/identify/convention.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <stdexcept>

#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/surd.hpp"
#include "numeric/oracle/zonal.hpp"

namespace sh::numeric::identify {
namespace {

constexpr long double kPi = std::numbers::pi_v<long double>;

// sqrt((2 - delta) (2l+1) / (4 pi) (l-a)! / (l+a)!): orthonormal over P_l^a cos(a phi).
long double legendre_factor(int l, int a) {
  auto square = static_cast<long double>((a == 0 ? 1 : 2) * (2 * l + 1)) / (4 * kPi);
  for (int k = l - a + 1; k <= l + a; ++k) square /= static_cast<long double>(k);
  return std::sqrt(square);
}

// The greatest number that divides every coefficient of d^a/dz^a P_l times Re or Im (x+iy)^a. P_l has the coefficients
// (-1)^k C(l, k) C(2l-2k, l) / 2^l of z^(l-2k). The binomial coefficients of Im share the largest power of two in a,
// those of Re nothing.
long double content(int l, int order) {
  const int a = std::abs(order);
  Integer common = 0;
  for (int k = 0; 2 * k <= l - a; ++k) {
    Integer coefficient = 1;
    for (int n = 1; n <= k; ++n) coefficient = coefficient * (l - k + n) / n;
    for (int n = 1; n <= l; ++n) coefficient = coefficient * (l - 2 * k + n) / n;
    for (int n = 0; n < a; ++n) coefficient *= l - 2 * k - n;
    common = gcd(common, coefficient);
  }
  for (int n = order; n < 0 && n % 2 == 0; n /= 2) common *= 2;
  return std::ldexp(static_cast<long double>(common), -l);
}

// Over SN3D with Y_00 = 1.
long double fuma_weight(int l, int a) {
  if (l == 0) return 1 / std::numbers::sqrt2_v<long double>;
  if (l == 2 && a > 0) return 2 / std::sqrt(3.0L);
  if (l == 3 && a > 0) return a == 1 ? std::sqrt(45.0L / 32) : a == 2 ? 3 / std::sqrt(5.0L) : std::sqrt(8.0L / 5);
  return 1;
}

long double normalization_size(Normalization normalization, int l, int order) {
  const auto width = static_cast<long double>(2 * l + 1);
  switch (normalization) {
    case Normalization::kOrthonormal:
      return 1;
    case Normalization::kFourPi:
      return std::sqrt(4 * kPi);
    case Normalization::kSchmidt:
      return std::sqrt(4 * kPi / width);
    case Normalization::kSn3d:
      return std::sqrt(1 / width);
    case Normalization::kUnnormalized:
      return 1 / legendre_factor(l, std::abs(order));
    case Normalization::kFuMa:
      return normalization_size(Normalization::kSchmidt, l, order) * fuma_weight(l, std::abs(order));
    case Normalization::kPrimitive:
      return 1 / primitive_constant(l, order);
  }
  throw std::invalid_argument("unknown normalization");
}

long double folded_size(Folded folded, int l) {
  if (folded == Folded::kNothing) return 1;
  const auto factor = clamped_cosine_factor<long double>(l);
  return folded == Folded::kCosine ? factor : factor / kPi;
}

}  // namespace

std::array<double, 3> Axes::apply(const std::array<double, 3>& d) const {
  std::array<double, 3> result{};
  for (std::size_t row = 0; row < 3; ++row) result[row] = sign[row] * d[(axis[row])];
  return result;
}

int Axes::determinant() const {
  const bool odd = (axis[0] > axis[1]) != ((axis[0] > axis[2]) != (axis[1] > axis[2]));
  return (odd ? -1 : 1) * sign[0] * sign[1] * sign[2];
}

std::string Axes::to_string() const {
  std::string text;
  for (std::size_t row = 0; row < 3; ++row) {
    text += std::string(row > 0 ? "," : "") + (sign[row] < 0 ? "-" : "") + "xyz"[axis[row]];
  }
  return text;
}

Axes parse_axes(const std::string& text) {
  for (const Axes& axes : all_axes()) {
    if (axes.to_string() == text) return axes;
  }
  throw std::invalid_argument("axes: expected x, y, z once each, with signs, such as x,z,-y, got '" + text + "'");
}

const std::vector<Axes>& all_axes() {
  static const std::vector<Axes> all = [] {
    std::vector<Axes> list;
    std::array<int, 3> axis{0, 1, 2};
    do {
      for (int signs = 0; signs < 8; ++signs) {
        list.push_back({axis, {(signs & 1) != 0 ? -1 : 1, (signs & 2) != 0 ? -1 : 1, (signs & 4) != 0 ? -1 : 1}});
      }
    } while (std::next_permutation(axis.begin(), axis.end()));
    return list;
  }();
  return all;
}

int largest_degree(const Convention& convention) {
  return convention.normalization == Normalization::kFuMa ? 3 : kMaxDegree;
}

int storage_size(IndexOrder order, int max_degree) {
  return coefficient_count(max_degree) * (order == IndexOrder::kCosineSineArray ? 2 : 1);
}

int storage_position(IndexOrder order, int max_degree, int degree, int order_m) {
  const int a = std::abs(order_m);
  const int band = degree * degree;
  switch (order) {
    case IndexOrder::kFuMa:
      if (degree == 1) return order_m == 0 ? 3 : order_m > 0 ? 1 : 2;
      return storage_position(IndexOrder::kZeroFirst, max_degree, degree, order_m);
    case IndexOrder::kAcn:
      return coefficient_index(degree, order_m);
    case IndexOrder::kZeroFirst:
      return band + 2 * a - (order_m > 0 ? 1 : 0);
    case IndexOrder::kCosineSineBands:
      return band + a + (order_m < 0 ? degree : 0);
    case IndexOrder::kCosineSineArray:
      return (max_degree + 1) * (degree + (order_m < 0 ? max_degree + 1 : 0)) + a;
  }
  throw std::invalid_argument("unknown index order");
}

std::vector<Function> functions_in_order(IndexOrder order, int max_degree) {
  std::vector<Function> functions((storage_size(order, max_degree)));
  for (int l = 0; l <= max_degree; ++l) {
    for (int m = -l; m <= l; ++m) {
      functions[(storage_position(order, max_degree, l, m))] = {l, m};
    }
  }
  return functions;
}

long double primitive_constant(int degree, int order) {
  static const std::vector<long double> kConstants = [] {
    std::vector<long double> constants;
    for (int l = 0; l <= kMaxDegree; ++l) {
      for (int m = -l; m <= l; ++m) constants.push_back(legendre_factor(l, std::abs(m)) * content(l, m));
    }
    return constants;
  }();
  return kConstants[coefficient_index(degree, order)];
}

long double relative_size(const Convention& convention, int degree, int order) {
  const bool phased = convention.condon_shortley && order % 2 != 0 && (order > 0 || !convention.complex);
  const long double size =
      normalization_size(convention.normalization, degree, order) * folded_size(convention.folded, degree);
  return phased ? -size : size;
}

std::vector<std::complex<double>> convention_values(const Convention& convention, int max_degree,
                                                    const std::array<double, 3>& direction) {
  const auto d = convention.axes.apply(direction);
  const auto unit = normalized<long double>(d[0], d[1], d[2]);
  std::vector<long double> ours((coefficient_count(max_degree)));
  basis(max_degree, unit[0], unit[1], unit[2], ours.data());
  const auto at = [&](int l, int m) { return ours[(coefficient_index(l, m))]; };
  std::vector<std::complex<double>> values((storage_size(convention.order, max_degree)));
  for (int l = 0; l <= max_degree; ++l) {
    for (int m = -l; m <= l; ++m) {
      const long double size = relative_size(convention, l, m);
      auto& value = values[(storage_position(convention.order, max_degree, l, m))];
      if (!convention.complex || m == 0) {
        value = static_cast<double>(size * at(l, m));
      } else {
        const long double half = size / std::numbers::sqrt2_v<long double>;
        value = {static_cast<double>(half * at(l, std::abs(m))),
                 static_cast<double>((m < 0 ? -half : half) * at(l, -std::abs(m)))};
      }
    }
  }
  return values;
}

}  // namespace sh::numeric::identify
