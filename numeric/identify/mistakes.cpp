// Mistakes that spoil a whole table, undone; see identify.hpp.
#include <cmath>
#include <utility>

#include "numeric/identify/identify.hpp"

namespace sh::numeric::identify {
namespace {

using Vector = std::array<double, 3>;

Samples with_directions(Samples samples, Vector (*changed)(const Vector& d)) {
  for (Vector& d : samples.directions) d = changed(d);
  return samples;
}

double across(const Vector& d) { return std::hypot(d[0], d[1]); }
Vector polar(double cos_theta, double sin_theta, double phi) {
  return {sin_theta * std::cos(phi), sin_theta * std::sin(phi), cos_theta};
}

// The direction whose theta is the longitude of d, and whose longitude is the theta of d. Functions that take sin theta
// from cos theta see no sign of it.
Vector exchanged(const Vector& d) {
  const double phi = std::atan2(d[1], d[0]);
  return polar(std::cos(phi), std::sin(phi), std::atan2(across(d), d[2]));
}
Vector exchanged_by_root(const Vector& d) {
  const double phi = std::atan2(d[1], d[0]);
  return polar(std::cos(phi), std::abs(std::sin(phi)), std::atan2(across(d), d[2]));
}

// Latitude for theta: its sine and cosine change places.
Vector by_latitude(const Vector& d) { return polar(across(d), d[2], std::atan2(d[1], d[0])); }
Vector by_latitude_and_root(const Vector& d) { return polar(across(d), std::abs(d[2]), std::atan2(d[1], d[0])); }

// The columns of m and -m in each other's place.
Samples with_orders_exchanged(const Samples& samples, IndexOrder order) {
  Samples result = samples;
  for (int l = 0; l <= samples.degree; ++l) {
    for (int m = 0; m <= l; ++m) {
      const auto cosine = static_cast<std::size_t>(storage_position(order, samples.degree, l, m));
      // The array has a hole for the sine of m = 0.
      const bool is_array = order == IndexOrder::kCosineSineArray;
      const auto sine = is_array ? cosine + samples.columns.size() / 2
                                 : static_cast<std::size_t>(storage_position(order, samples.degree, l, -m));
      std::swap(result.columns[cosine], result.columns[sine]);
    }
  }
  return result;
}

Samples conjugated(Samples samples) {
  for (auto& column : samples.columns) {
    for (auto& value : column) value = std::conj(value);
  }
  return samples;
}

bool is_complex(const Samples& samples) {
  for (const auto& column : samples.columns) {
    for (const auto& value : column) {
      if (value.imag() != 0) return true;
    }
  }
  return false;
}

}  // namespace

std::vector<Undone> undone_mistakes(const Samples& samples) {
  const bool complex = is_complex(samples);
  std::vector<Undone> all;
  if (complex) all.push_back({"every value conjugated", conjugated(samples)});
  for (const auto changed : {exchanged, exchanged_by_root})
    all.push_back({"theta and phi exchanged", with_directions(samples, changed)});
  for (const auto changed : {by_latitude, by_latitude_and_root})
    all.push_back({"sine and cosine of theta exchanged (latitude for theta)", with_directions(samples, changed)});
  if (complex) return all;
  for (const IndexOrder order : orders_of(samples))
    all.push_back({"sine and cosine of m phi exchanged (m for -m)", with_orders_exchanged(samples, order)});
  return all;
}

}  // namespace sh::numeric::identify
