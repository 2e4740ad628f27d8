#include "prt/commands/light_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "numeric/plot/canvas.hpp"
#include "prt/angles.hpp"
#include "prt/image/tone_map.hpp"
#include "prt/light/light_shapes.hpp"
#include "prt/mesh/corners.hpp"
#include "prt/runtime/relight.hpp"
#include "prt/runtime/render.hpp"

namespace sh::prt {
namespace {

namespace plot = numeric::plot;

// In units of the figure, which is 1200 wide.
constexpr double kWidth = 1200.0;
constexpr double kLeft = 76.0;
constexpr double kTop = 56.0;
constexpr double kGap = 3.0;
constexpr double kText = 15.0;

constexpr int kSamples = 4;          // rays a pixel
constexpr int kPointsOfLight = 256;  // of a cap
constexpr float kExposure = 0.85F;   // of white that faces the light, whose radiance is 1
constexpr float kGray = 0.3F;        // linear, after exposure: where the picture shows no mesh
constexpr float kOffset = 1e-5F;     // of the mesh's extent: keeps a ray off the face that it starts from

void check(const LightGrid& grid) {
  for (const double angle : grid.half_angles) {
    if (!(angle > 0.0 && angle <= 90.0)) {
      throw std::invalid_argument(fmt::format("--half-angles {}: expected degrees above 0 to 90", angle));
    }
  }
  if (!(grid.direction.norm() > 0.0) || !grid.direction.allFinite()) {
    throw std::invalid_argument("--direction: expected a vector of finite length above 0");
  }
  const auto columns = static_cast<int>(2 * grid.degrees.size() + 1);
  const int least = 32 * columns;
  if (grid.width < least || grid.width > plot::kLargestSize) {
    throw std::invalid_argument(fmt::format("--width {}: expected {} to {} pixels for {} columns", grid.width, least,
                                            plot::kLargestSize, columns));
  }
}

Light cap_of(const LightGrid& grid, double half_angle) {
  LightSpec spec{.type = LightType::kCap, .direction = grid.direction.normalized()};
  const double half = half_angle * std::numbers::pi / 360.0;
  spec.one_minus_cos = 2.0 * std::sin(half) * std::sin(half);
  spec.radiance.setConstant(static_cast<float>(std::numbers::pi / cap_irradiance(spec.one_minus_cos)));
  Light light;
  light.spec = spec;
  return light;
}

/// Exit radiance under a cap by shadow rays to points of equal solid angle, without any cut of degree.
Surface lit_by_points(const Mesh& mesh, const Tracer& tracer, const Light& cap) {
  std::vector<Eigen::Vector3f> towards;
  const Eigen::Matrix3f frame = frame_about(cap.spec.direction.cast<float>().eval());
  for (int i = 0; i < kPointsOfLight; ++i) {  // spherical Fibonacci points [SwinbankPurser06], of the cap alone
    const double z = 1.0 - cap.spec.one_minus_cos * (i + 0.5) / kPointsOfLight;
    const double azimuth = 2.0 * std::numbers::pi * std::numbers::phi * i;
    const double out = std::sqrt(std::max(0.0, 1.0 - z * z));
    towards.emplace_back(frame *
                         Eigen::Vector3d(out * std::cos(azimuth), out * std::sin(azimuth), z).cast<float>().eval());
  }
  const double solid_angle = 2.0 * std::numbers::pi * cap.spec.one_minus_cos / kPointsOfLight;
  const Eigen::Vector3f each = cap.spec.radiance * static_cast<float>(solid_angle / std::numbers::pi);
  const float offset = kOffset * bounding_box(mesh.positions).diagonal().norm();
  return [&mesh, &tracer, towards, each, offset](const Hit& hit, const Eigen::Vector3f& /*direction*/) {
    const Eigen::Vector3f normal = interpolated(hit, mesh, mesh.normals).normalized();
    const Eigen::Vector3f flat = face_normal(mesh.positions, mesh.faces[hit.face]);
    std::vector<ShadowRay> rays;
    for (const Eigen::Vector3f& point : towards) {
      if (normal.dot(point) <= 0.0F || flat.dot(point) <= 0.0F) continue;
      rays.emplace_back().aim(interpolated(hit, mesh, mesh.positions) + offset * flat, point);
    }
    tracer.occluded(rays);
    float cosines = 0.0F;
    for (const ShadowRay& ray : rays) cosines += ray.blocked() ? 0.0F : normal.dot(ray.direction);
    return Eigen::Vector3f(cosines * each.cwiseProduct(interpolated(hit, mesh, mesh.albedo)));
  };
}

Eigen::Vector3f gray(const Eigen::Vector3f& /*direction*/) { return Eigen::Vector3f::Constant(kGray / kExposure); }

class GridDrawing {
 public:
  GridDrawing(const Transfer& transfer, const Camera& camera, const LightGrid& grid, const std::vector<GridRow>& rows)
      : transfer_(transfer),
        camera_(camera),
        grid_(grid),
        rows_(rows),
        tracer_(transfer.mesh),
        cell_((kWidth - kLeft) / static_cast<double>(2 * grid.degrees.size() + 1)),
        canvas_(plot::png_canvas(kWidth, kTop + cell_height() * static_cast<double>(grid.half_angles.size()),
                                 grid.width)) {}

  std::string draw() {
    for (std::size_t row = 0; row < grid_.half_angles.size(); ++row) draw_row(row);
    return canvas_->finish();
  }

 private:
  [[nodiscard]] double cell_height() const { return 0.75 * cell_; }

  void draw_row(std::size_t row) {
    const double angle = grid_.half_angles[row];
    write({kLeft - 8.0, kTop + (static_cast<double>(row) + 0.5) * cell_height()}, fmt::format("{:g} deg", angle),
          plot::Anchor::kEnd);
    const std::size_t degrees = grid_.degrees.size();
    for (std::size_t column = 0; column < 2 * degrees; ++column) {
      draw_cell(row, column, diffuse_surface(transfer_.mesh, relight(transfer_, rows_[row].columns[column])),
                {fmt::format("degree {}", grid_.degrees[column % degrees]),
                 column < degrees ? "" : "window " + grid_.window.window});
    }
    draw_cell(row, 2 * degrees, lit_by_points(transfer_.mesh, tracer_, rows_[row].cap), {"all degrees", "shadow rays"});
  }

  void draw_cell(std::size_t row, std::size_t column, const Surface& surface, const std::vector<std::string>& head) {
    const plot::Box box{kLeft + static_cast<double>(column) * cell_, kTop + static_cast<double>(row) * cell_height(),
                        cell_ - kGap, cell_height() - kGap};
    if (row == 0) {
      for (std::size_t i = 0; i < head.size(); ++i) {
        write({box.x + 0.5 * box.width, 22.0 + 20.0 * static_cast<double>(i)}, head[i], plot::Anchor::kMiddle);
      }
    }
    const plot::PixelBox where = canvas_->pixels(box);
    const Picture picture = render(transfer_.mesh, tracer_, surface, camera_, {where.width, where.height, kSamples},
                                   gray, fmt::format("grid: {:g} degrees, {}", grid_.half_angles[row], head.front()));
    plot::Raster raster(where.width, where.height);
    raster.rgb = tone_map(picture.radiance, kExposure);
    canvas_->image(where, raster);
  }

  void write(const plot::Point& place, const std::string& words, plot::Anchor anchor) {
    canvas_->text(place, words, kText, anchor, plot::kInk);
  }

  const Transfer& transfer_;
  const Camera& camera_;
  const LightGrid& grid_;
  const std::vector<GridRow>& rows_;
  Tracer tracer_;
  double cell_;  // width, with the gap
  std::unique_ptr<plot::Canvas> canvas_;
};

}  // namespace

std::vector<GridRow> grid_rows(const LightGrid& grid) {
  check(grid);
  std::vector<GridRow> rows;
  for (const double angle : grid.half_angles) {
    GridRow& row = rows.emplace_back(GridRow{cap_of(grid, angle), {}});
    for (const WindowOptions& window : {WindowOptions(), grid.window}) {
      for (const int degree : grid.degrees) row.columns.push_back(project_windowed({row.cap}, degree, window));
    }
  }
  return rows;
}

std::string draw_light_grid(const Transfer& transfer, const Camera& camera, const LightGrid& grid,
                            const std::vector<GridRow>& rows) {
  return GridDrawing(transfer, camera, grid, rows).draw();
}

}  // namespace sh::prt
