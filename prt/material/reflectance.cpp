#include "prt/material/reflectance.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "prt/arrays.hpp"

namespace sh::prt {

namespace {

constexpr std::size_t kRow = even_count(kMaxDegree);

const float* row_of(const float* table, int view, std::size_t part) {
  return table + (static_cast<std::size_t>(view) * kReflectionParts + part) * kRow;
}

// The weights of four neighbors at distances 0, 1, 2, 3 in the polynomial of degree 3 through them (Lagrange).
std::array<float, 4> cubic_weights(float t) {
  return {-(t - 1) * (t - 2) * (t - 3) / 6, t * (t - 2) * (t - 3) / 2, -t * (t - 1) * (t - 3) / 2,
          t * (t - 1) * (t - 2) / 6};
}

}  // namespace

std::array<Eigen::Vector3f, kReflectionParts> colors_of_parts(bool is_measured, const Eigen::Vector3f& albedo) {
  if (is_measured) return {Eigen::Vector3f::UnitX(), Eigen::Vector3f::UnitY(), Eigen::Vector3f::UnitZ()};
  return {albedo, Eigen::Vector3f::Ones(), Eigen::Vector3f::Zero()};
}

std::size_t Reflectances::number_of(const Reflectance& reflectance) {
  for (std::size_t i = 0; i < heads.size(); ++i) {
    const bool is_alike = heads[i].name == reflectance.name && heads[i].is_measured == reflectance.is_measured;
    if (is_alike && at(i) == reflectance) return i;
  }
  if (heads.size() == kMostBrdfs) {
    throw std::runtime_error(fmt::format(
        "more than {} different BRDFs; expected fewer, such as one roughness for several materials", kMostBrdfs));
  }
  heads.push_back({reflectance.name, reflectance.is_measured});
  rows.insert(rows.end(), reflectance.table.begin(), reflectance.table.end());
  return heads.size() - 1;
}

Reflectance Reflectances::at(std::size_t number) const {
  const auto [from, is_measured] = table(number);
  return {heads[number].name, is_measured, {from, from + kReflectanceTableSize}};
}

void reflectance_at(const float* table, int degree, float angle, float* out) {
  constexpr float kStep = static_cast<float>(std::numbers::pi / 2) / (kViews - 1);
  const float place = std::min(angle / kStep, kViews - 1.0F);
  const int first = std::clamp(static_cast<int>(place) - 1, 0, kViews - 4);
  const std::array<float, 4> weights = cubic_weights(place - static_cast<float>(first));
  const std::size_t count = even_count(degree);
  for (std::size_t part = 0; part < kReflectionParts; ++part) {
    const auto weighed = [&](int k) {
      return weights[static_cast<std::size_t>(k)] * as_array(row_of(table, first + k, part), count);
    };
    as_array(out + part * count, count) = weighed(0) + weighed(1) + weighed(2) + weighed(3);
  }
}

double share_of_bands(const BrdfTable& table, int degree) {
  const std::array<Eigen::Vector3f, kReflectionParts> colors =
      colors_of_parts(table.is_measured, Eigen::Vector3f::Constant(0.5F));
  Eigen::MatrixX3d seen = Eigen::MatrixX3d::Zero(kRow, 3);  // red, green and blue
  for (std::size_t part = 0; part < kReflectionParts; ++part) {
    const auto row = as_array(row_of(table.rows, (kViews - 1) / 2, part), kRow).matrix();
    seen += (row * colors[part].transpose()).cast<double>();
  }
  const double all = seen.squaredNorm();
  return all > 0.0 ? seen.topRows(Eigen::Index(even_count(degree))).squaredNorm() / all : 1.0;
}

Eigen::Vector3d hemispherical_reflectance(const float* table, int view) {
  const auto sum_of = [&](std::size_t part) { return static_cast<double>(row_of(table, view, part)[0]); };
  return std::sqrt(4.0 * std::numbers::pi) * Eigen::Vector3d(sum_of(0), sum_of(1), sum_of(2));  // of constant light
}

}  // namespace sh::prt
