// Why a coefficient differs from the value that a convention expects, in words; see identify.hpp.
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "numeric/identify/identify.hpp"
#include "numeric/output/formatted.hpp"

namespace sh::numeric::identify {
namespace {

using Complex = std::complex<double>;

constexpr double kSame = 1e-4;  // largest relative deviation of a function or factor that counts as the same

std::string number(double value, int digits = 7) { return output::formatted("%.*g", digits, value); }

double largest(const std::vector<Complex>& column) {
  double square = 0;
  for (const Complex& v : column) square = std::max(square, std::norm(v));
  return std::sqrt(square);
}

// Largest |a - factor * b|, relative to the largest |b|.
double distance(const std::vector<Complex>& a, const std::vector<Complex>& b, double factor, bool conjugate = false) {
  double square = 0;
  for (std::size_t row = 0; row < a.size(); ++row) {
    square = std::max(square, std::norm(a[row] - factor * (conjugate ? std::conj(b[row]) : b[row])));
  }
  return std::sqrt(square) / std::max(largest(b), 1e-300);
}

// +1 or -1 where a is that times b, else 0.
int sign_between(const std::vector<Complex>& a, const std::vector<Complex>& b) {
  if (largest(b) == 0) return 0;
  if (distance(a, b, 1) <= kRounded) return 1;
  return distance(a, b, -1) <= kRounded ? -1 : 0;
}

std::string other_function(const Samples& samples, const Columns& expected, std::size_t j) {
  for (std::size_t k = 0; k < expected.size(); ++k) {
    const int sign = k == j ? 0 : sign_between(samples.columns[j], expected[k]);
    if (sign == 0) continue;
    const bool both = sign_between(samples.columns[k], expected[j]) != 0;
    return std::string(both ? "swapped with coefficient " : "holds the function of coefficient ") + std::to_string(k) +
           (sign < 0 ? ", sign flipped" : "");
  }
  return "";
}

std::string named_factor(double ratio, int degree) {
  const double width = 2.0 * degree + 1;
  constexpr double kPi = std::numbers::pi;
  const std::array<std::pair<double, const char*>, 11> factors = {{{2, "2"},
                                                                   {std::sqrt(2.0), "sqrt 2"},
                                                                   {4, "4"},
                                                                   {3, "3"},
                                                                   {std::sqrt(3.0), "sqrt 3"},
                                                                   {kPi, "pi"},
                                                                   {std::sqrt(kPi), "sqrt pi"},
                                                                   {4 * kPi, "4 pi"},
                                                                   {std::sqrt(4 * kPi), "sqrt(4 pi)"},
                                                                   {width, "2l+1"},
                                                                   {std::sqrt(width), "sqrt(2l+1)"}}};
  const std::string sign = ratio < 0 ? ", sign flipped" : "";
  for (const auto& [value, name] : factors) {
    if (std::abs(std::abs(ratio) / value - 1) <= kSame) return std::string("too large by the factor ") + name + sign;
    if (std::abs(std::abs(ratio) * value - 1) <= kSame) return std::string("too small by the factor ") + name + sign;
  }
  return "";
}

double constant_of(const Convention& c, const Function& f) {
  const auto size = static_cast<double>(relative_size(c, f.degree, f.order) * primitive_constant(f.degree, f.order));
  return c.complex && f.order != 0 ? size / std::numbers::sqrt2 : size;
}

std::string factor_reason(const Convention& convention, const Coefficient& c) {
  if (std::abs(c.ratio.imag()) > kSame * std::abs(c.ratio)) {
    return "multiplied by the complex number " + number(c.ratio.real()) + " + " + number(c.ratio.imag()) + "i";
  }
  const double ratio = c.ratio.real();
  if (std::abs(ratio + 1) <= kRounded) return "sign flipped";
  if (auto named = named_factor(ratio, c.function.degree); !named.empty()) return named;
  if (auto rounded = rounding_of(convention, c); !rounded.empty()) return rounded;
  const double constant = constant_of(convention, c.function);
  return "constant mistyped? " + number(ratio) + " times what it should be (" + number(ratio * constant) + " for " +
         number(constant) + ")";
}

// The rows that differ, where they are the smaller part.
std::string single_lines(const Samples& samples, const Columns& expected, std::size_t j) {
  constexpr std::size_t kMostNamed = 5;
  const double limit = kRounded * largest(expected[j]);
  std::vector<int> lines;
  for (std::size_t row = 0; row < samples.lines.size(); ++row) {
    if (std::abs(samples.columns[j][row] - expected[j][row]) > limit) lines.push_back(samples.lines[row]);
  }
  if (lines.empty() || 4 * lines.size() > samples.lines.size()) return "";
  std::string text =
      "differs on " + std::to_string(lines.size()) + " of " + std::to_string(samples.lines.size()) + " lines only: ";
  for (std::size_t i = 0; i < std::min(lines.size(), kMostNamed); ++i) {
    text += (i > 0 ? ", " : "") + std::to_string(lines[i]);
  }
  return text + (lines.size() > kMostNamed ? ", ..." : "");
}

// The column as a sum of the expected ones, by least squares.
std::string as_sum(const Samples& samples, const Columns& expected, std::size_t j) {
  const auto rows = static_cast<Eigen::Index>(samples.lines.size());
  std::vector<int> used;
  Eigen::MatrixXcd functions(rows, 0);
  for (std::size_t k = 0; k < expected.size(); ++k) {
    if (largest(expected[k]) == 0) continue;
    used.push_back(static_cast<int>(k));
    functions.conservativeResize(rows, functions.cols() + 1);
    functions.rightCols(1) = Eigen::Map<const Eigen::VectorXcd>(expected[k].data(), rows);
  }
  const Eigen::Map<const Eigen::VectorXcd> values(samples.columns[j].data(), rows);
  const Eigen::VectorXcd parts = functions.householderQr().solve(values);
  const double rest = (values - functions * parts).cwiseAbs().maxCoeff();
  if (rest > kRounded * largest(samples.columns[j])) return "is no sum of functions up to this degree";
  std::vector<Eigen::Index> by_size(used.size());
  std::iota(by_size.begin(), by_size.end(), Eigen::Index{0});
  const auto weight = [&](Eigen::Index k) { return std::abs(parts[k]) * functions.col(k).cwiseAbs().maxCoeff(); };
  std::sort(by_size.begin(), by_size.end(), [&](auto a, auto b) { return weight(a) > weight(b); });
  std::string text = "is not a multiple of its function but";
  for (std::size_t i = 0; i < by_size.size() && i < 3 && weight(by_size[i]) > kSame * weight(by_size[0]); ++i) {
    const Complex part = parts[by_size[i]];
    const bool real = std::abs(part.imag()) <= kSame * std::abs(part);
    text += (i > 0 ? " + (" : " (") + number(part.real(), 4) + (real ? "" : " + " + number(part.imag(), 4) + "i") +
            ") x coefficient " + std::to_string(used[by_size[i]]) + "'s";
  }
  return text;
}

// `digits` significant decimals of |value|, rounded or cut off.
double shortened(double value, int digits, bool cut) {
  const double unit = std::pow(10, std::floor(std::log10(value)) + 1 - digits);
  return (cut ? std::floor(value / unit) : std::round(value / unit)) * unit;
}

}  // namespace

Columns expected_columns(const Samples& samples, const Convention& convention) {
  Columns columns(samples.columns.size());
  for (const auto& direction : samples.directions) {
    const auto values = convention_values(convention, samples.degree, direction);
    for (std::size_t j = 0; j < columns.size(); ++j) columns[j].push_back(values[j]);
  }
  return columns;
}

std::string rounding_of(const Convention& convention, const Coefficient& c) {
  const double constant = std::abs(constant_of(convention, c.function));
  const double found = c.ratio.real() * constant;
  const double noise = std::max(2e-7, 2 * c.shape) * constant;
  if (!(std::abs(found - constant) > noise)) return "";
  for (int digits = 2; digits <= 8; ++digits) {
    for (const bool cut : {false, true}) {
      if (std::abs(shortened(constant, digits, cut) - found) > noise) continue;
      return "constant " + number(found, digits) + " for " + number(constant, 10) +
             (cut ? ", cut off after " : ", rounded to ") + std::to_string(digits) + " digits";
    }
  }
  return "";
}

std::string reason_of(const Samples& samples, const Convention& convention, const Columns& expected,
                      const Coefficient& c, double noise) {
  const auto j = static_cast<std::size_t>(c.index);
  const auto& column = samples.columns[j];
  if (largest(expected[j]) == 0) return c.function.is_hole() ? "a hole of the array; it should hold zero" : "not zero";
  if (largest(column) == 0) return "is zero everywhere";
  const bool nearly_right = distance(column, expected[j], 1) <= kRounded;
  if (!nearly_right && distance(column, expected[j], 1, true) <= kRounded)
    return "conjugate: the imaginary part has the wrong sign";
  const double noisy = kNoiseAllowance * noise / largest(expected[j]);
  if (distance(column, expected[j], -1) <= kRounded + noisy) return "sign flipped";
  if (auto other = other_function(samples, expected, j); !nearly_right && !other.empty()) return other;
  if (c.shape <= kRounded * std::abs(c.ratio)) return factor_reason(convention, c);
  if (auto lines = single_lines(samples, expected, j); !lines.empty()) return lines;
  return as_sum(samples, expected, j);
}

}  // namespace sh::numeric::identify
