// Draws one scene under caps of light of several sizes, as shadowed transfer of several degrees shows it, without and with
// a window on the light, beside the same light without any cut [SloanKautzSnyder02, figure 10]. In: a shadowed transfer.
// Out: the bytes of a PNG picture; rows are sizes, columns are degrees.
#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "prt/commands/commands.hpp"
#include "prt/scene/camera.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {

struct LightGrid {
  std::vector<double> half_angles = {2.0, 10.0, 25.0, 60.0};  // degrees, above 0 to 90: a row each
  std::vector<int> degrees = {1, 2, 4, 10};                   // of the light: two columns each
  Eigen::Vector3d direction{-0.5, 0.5, 0.7};                  // towards the light, any length but zero
  WindowOptions window = {.window = "auto"};                  // of the second column of a degree
  int width = 1200;                                           // pixels of the whole picture
};

/// A row: a cap that gives a surface that faces it the irradiance pi, and its coefficients in every column.
struct GridRow {
  Light cap;
  std::vector<LightCoefficients> columns;
};

/// Throws std::invalid_argument, which names the option, for numbers out of range, and like project_windowed.
std::vector<GridRow> grid_rows(const LightGrid& grid);

/// The last column takes the light at 256 points of the cap, by shadow rays from every pixel. `rows` are those of `grid`;
/// `transfer` is shadowed, of the highest degree of the grid, of a mesh without mirrors.
std::string draw_light_grid(const Transfer& transfer, const Camera& camera, const LightGrid& grid,
                            const std::vector<GridRow>& rows);

}  // namespace sh::prt
