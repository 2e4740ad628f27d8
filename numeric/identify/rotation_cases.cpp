// See rotation_cases.hpp.
#include "numeric/identify/rotation_cases.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/rotation_matrices.hpp"
#include "numeric/output/formatted.hpp"

namespace sh::numeric::identify {
namespace {

std::string format(double value) { return output::formatted("%.3g", value); }

std::size_t entries_in_bands(int degree) {
  std::size_t count = 0;
  for (int l = 0; l <= degree; ++l) count += static_cast<std::size_t>((2 * l + 1) * (2 * l + 1));
  return count;
}

std::size_t entries_in_full(int degree) {
  const auto size = static_cast<std::size_t>(coefficient_count(degree));
  return size * size;
}

struct Layout {
  int degree = -1;
  bool full = false;
};

Layout layout_with(std::size_t entries) {
  for (int l = 1; l <= kMaxDegree; ++l) {
    if (entries == entries_in_full(l)) return {l, true};
    if (entries == entries_in_bands(l)) return {l, false};
  }
  return {};
}

Layout layout_of(const Table& table) {
  const std::size_t columns = table.rows.front().cells.size();
  const Layout layout = layout_with(columns < 9 ? 0 : columns - 9);
  if (layout.degree >= 0) return layout;
  refuse_line(table.file, table.rows.front().line,
              std::to_string(columns) + " columns; it should be the 9 of a rotation and (bands^2)^2 entries (16, 81, " +
                  "256, ...) or the bands' own (10, 35, 84, ...), degree 1 to " + std::to_string(kMaxDegree));
}

std::array<long double, 9> rotation_of(const Table& table, const Row& row) {
  std::array<double, 9> r{};
  std::array<long double, 9> wide{};
  for (std::size_t i = 0; i < 9; ++i) {
    if (row.cells[i].imag() != 0) refuse_line(table.file, row.line, "the rotation (columns 1 to 9) is not real");
    r[i] = row.cells[i].real();
    wide[i] = r[i];
  }
  const double defect = orthogonality_defect(r);
  if (!(defect <= kRotationTolerance)) {
    refuse_line(table.file, row.line,
                "columns 1 to 9 are no rotation: R R^T differs from 1 by " + format(defect) +
                    "; it should be at most " + format(kRotationTolerance));
  }
  if (determinant(r) < 0) {
    refuse_line(table.file, row.line, "columns 1 to 9 are a reflection: the determinant is -1; it should be 1");
  }
  std::array<long double, 9> nearest{};
  nearest_rotation(wide.data(), nearest.data());
  return nearest;
}

void take_bands(const Row& row, const Layout& layout, RotationCase& result) {
  std::size_t next = 9;
  for (int l = 0; l <= layout.degree; ++l) {
    const auto width = static_cast<std::size_t>(2 * l + 1);
    std::vector<std::complex<double>> band;
    for (std::size_t i = 0; i < width * width; ++i) band.push_back(row.cells[next++]);
    result.bands.push_back(std::move(band));
  }
}

void take_full(const Row& row, const Layout& layout, RotationCase& result) {
  const auto size = static_cast<std::size_t>(coefficient_count(layout.degree));
  const auto band_of = [](std::size_t i) { return static_cast<std::size_t>(std::sqrt(static_cast<double>(i))); };
  result.bands.resize(static_cast<std::size_t>(layout.degree) + 1);
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t k = 0; k < size; ++k) {
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
    if (layout.full) {
      take_full(row, layout, one);
    } else {
      take_bands(row, layout, one);
    }
    result.complex = result.complex || std::any_of(row.cells.begin() + 9, row.cells.end(),
                                                   [](const auto& cell) { return cell.imag() != 0; });
    result.cases.push_back(std::move(one));
  }
  if (std::none_of(result.cases.begin(), result.cases.end(), is_general)) {
    refuse_file(table.file,
                "no rotation is general enough to decide; it should have one by 0.2 to 2.9 radians about an axis away "
                "from the planes x = 0, y = 0, z = 0, such as `shcheck rotation-matrix --rotations 40` prints");
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
  const auto polar = static_cast<std::size_t>(1 + axes.axis[2]);
  const long double along = q[polar];
  const long double across = std::hypot(q[1 + polar % 3], q[1 + (polar + 1) % 3]);
  const auto twice_angle = [](long double sine, long double cosine) {
    return static_cast<double>(2 * std::atan2(std::abs(sine), std::abs(cosine)));
  };
  return {twice_angle(length, q[0]), twice_angle(q[0], length), twice_angle(across, std::hypot(q[0], along))};
}

}  // namespace sh::numeric::identify
