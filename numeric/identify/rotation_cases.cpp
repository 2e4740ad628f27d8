// Reads rotations and their matrices from a table; see rotation_check.hpp.
#include <algorithm>
#include <cmath>

#include "numeric/identify/rotation_check.hpp"
#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/rotation_matrices.hpp"
#include "numeric/output/formatted.hpp"

namespace sh::numeric::identify {
namespace {

constexpr double kRotationTolerance = 1e-5;  // of R R^T from 1: six printed digits, or float

struct Layout {
  int degree = -1;
  bool full = false;
};

Layout layout_of(const Table& table) {
  const auto columns = static_cast<int>(table.rows.front().cells.size());
  int in_bands = 1;
  for (int l = 1; l <= kMaxDegree; ++l) {
    in_bands += (2 * l + 1) * (2 * l + 1);
    const int size = coefficient_count(l);
    if (columns == 9 + size * size) return {l, true};
    if (columns == 9 + in_bands) return {l, false};
  }
  refuse(table.file, table.rows.front().line,
         output::formatted("expected the 9 columns of a rotation and (bands^2)^2 entries (16, 81, 256, ...) or the "
                           "bands' own (10, 35, 84, ...), degree 1 to %d, got %d columns",
                           kMaxDegree, columns));
}

std::array<long double, 9> rotation_of(const Table& table, const Row& row) {
  std::array<double, 9> r{};
  for (int i = 0; i < 9; ++i) {
    if (row.cells[i].imag() != 0)
      refuse(table.file, row.line, "columns 1 to 9: expected real numbers, got complex ones");
    r[i] = row.cells[i].real();
  }
  const double defect = orthogonality_defect(r);
  if (!(defect <= kRotationTolerance)) {
    refuse(table.file, row.line,
           output::formatted("columns 1 to 9: expected a rotation, |R R^T - 1| at most %.3g, got %.3g",
                             kRotationTolerance, defect));
  }
  if (determinant(r) < 0) {
    refuse(table.file, row.line, "columns 1 to 9: expected a rotation, determinant 1, got a reflection, -1");
  }
  return nearest_rotation<long double>(r.data());
}

void take_bands(const Row& row, int degree, RotationCase& result) {
  auto next = row.cells.begin() + 9;
  for (int l = 0; l <= degree; ++l) {
    const auto end = next + (2 * l + 1) * (2 * l + 1);
    result.bands.emplace_back(next, end);
    next = end;
  }
}

void take_full(const Row& row, int degree, RotationCase& result) {
  const int size = coefficient_count(degree);
  const auto band_of = [](int i) { return static_cast<int>(std::sqrt(i)); };
  result.bands.resize(degree + 1);
  for (int i = 0; i < size; ++i) {
    for (int k = 0; k < size; ++k) {
      const auto& entry = row.cells[9 + i * size + k];
      if (band_of(i) == band_of(k)) {
        result.bands[band_of(i)].push_back(entry);
      } else {
        result.between_bands = std::max(result.between_bands, std::abs(entry));
      }
    }
  }
}

std::array<long double, 4> quaternion(const RotationCase& rotation) {
  std::array<long double, 4> q{};
  quaternion_of_matrix(rotation.r.data(), q.data());
  return q;
}

}  // namespace

RotationCases read_rotation_cases(const Table& table) {
  const Layout layout = layout_of(table);
  RotationCases result{table.file, layout.degree, false, {}};
  for (const Row& row : table.rows) {
    RotationCase one{row.line, rotation_of(table, row), {}, 0};
    (layout.full ? take_full : take_bands)(row, layout.degree, one);
    result.complex = result.complex || std::any_of(row.cells.begin() + 9, row.cells.end(),
                                                   [](const auto& cell) { return cell.imag() != 0; });
    result.cases.push_back(std::move(one));
  }
  if (std::none_of(result.cases.begin(), result.cases.end(), is_general)) {
    refuse(table.file, 0,
           "expected a rotation by 0.2 to 2.9 radians about an axis away from the planes x = 0, y = 0, z = 0, such as "
           "`shcheck rotation-matrix --rotations 40` prints, got none");
  }
  return result;
}

bool is_general(const RotationCase& rotation) {
  constexpr double kLeastAngle = 0.2;
  constexpr double kLeastComponent = 0.1;
  const auto angles = angles_of(rotation, {});
  const auto q = quaternion(rotation);
  const long double length = std::hypot(q[1], q[2], q[3]);
  const bool is_off_planes = std::all_of(
      q.begin() + 1, q.end(), [&](long double component) { return std::abs(component) >= kLeastComponent * length; });
  return is_off_planes && angles.from_identity >= kLeastAngle && angles.from_half_turn >= kLeastAngle;
}

RotationAngles angles_of(const RotationCase& rotation, const Axes& axes) {
  const auto q = quaternion(rotation);
  const long double length = std::hypot(q[1], q[2], q[3]);
  const int polar = 1 + axes.axis[2];
  const long double along = q[polar];
  const long double across = std::hypot(q[1 + polar % 3], q[1 + (polar + 1) % 3]);
  const auto twice_angle = [](long double sine, long double cosine) {
    return static_cast<double>(2 * std::atan2(std::abs(sine), std::abs(cosine)));
  };
  return {twice_angle(length, q[0]), twice_angle(q[0], length), twice_angle(across, std::hypot(q[0], along))};
}

}  // namespace sh::numeric::identify
