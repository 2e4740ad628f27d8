// The subject of a picture: a function on the unit sphere, of one channel or of three (red, green, blue).
// From coefficients (numeric/README.md: index l(l+1)+m, channel by channel) by the oracle, or any callable.
#pragma once
#include <Eigen/Core>
#include <array>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace sh::numeric::plot {

using Vector3 = Eigen::Vector3d;

/// (sin theta cos phi, sin theta sin phi, cos theta).
Vector3 direction(double theta, double phi);

/// Value of each channel; one channel uses the first place.
using Channels = std::array<double, 3>;

/// f(s) = value(s) 2^exponent. `value` takes unit vectors and is finite; calls with the same z in a row may be faster.
/// `degree` is the highest that matters: it sets how finely a picture is sampled.
struct SphereFunction {
  int channels = 1;  // 1 or 3
  int degree = 0;
  std::function<Channels(const Vector3&)> value;
  int exponent = 0;  // keeps values near 1, whatever the magnitude of f
};

/// The sum of coefficients (channels, bands^2) times Y_i, evaluated in double by the row recurrence of legendre.hpp,
/// once a ring where z repeats. Throws std::invalid_argument unless the count is bands^2 or 3 bands^2, every value is
/// finite and the degree is at most kLargestDegree.
SphereFunction function_of_coefficients(std::span<const double> coefficients);
constexpr int kLargestDegree = 64;

/// One basis function. Precondition: |order| <= degree <= kLargestDegree.
SphereFunction basis_function(int degree, int order);

/// One channel of a function of three.
SphereFunction channel_of(const SphereFunction& f, int channel);

/// The largest |value| of any channel and where: a grid finer than the degree, then a local search to about 1e-9 of
/// the angle. 0 at the pole for the zero function.
struct Largest {
  double magnitude = 0;
  Vector3 where{0, 0, 1};
};
Largest largest_magnitude(const SphereFunction& f);

/// "largest magnitude 0.846 at (0.00, 0.71, 0.71)", or "zero function".
std::string describe(const Largest& largest, int exponent);

/// `value` 2^exponent with three significant digits, of any magnitude.
std::string format_value(double value, int exponent);

/// The numbers of a text: decimals separated by commas or whitespace. Throws std::invalid_argument, which begins with
/// `name`, if there is no number, or one that is not a finite double.
std::vector<double> parse_numbers(const std::string& name, const std::string& text);

/// The same from a file, in which `#` begins a comment that ends with the line; messages begin with FILE:LINE. Throws
/// std::runtime_error if the file cannot be read or is larger than 4 MB.
std::vector<double> read_numbers(const std::string& file);

/// parse_numbers if `text` begins like a number, else read_numbers (./NAME is a file named like a number).
std::vector<double> numbers_from(const std::string& name, const std::string& text);

}  // namespace sh::numeric::plot
