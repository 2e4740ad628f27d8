// Pictures of lights: prt/commands/light_figure.hpp.
#include "prt/commands/light_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "numeric/plot/canvas.hpp"
#include "numeric/plot/field.hpp"
#include "numeric/sampling/sphere_nodes.hpp"
#include "prt/image/tone_map.hpp"

namespace sh::prt {
namespace {

namespace plot = numeric::plot;

// In units of the figure, which is 1000 wide.
constexpr double kWidth = 1000.0;
constexpr double kMargin = 16.0;
constexpr double kTop = 52.0;
constexpr double kCaption = 30.0;
constexpr double kTitleSize = 22.0;
constexpr double kLabelSize = 15.0;
constexpr plot::Colour kTag{255, 255, 255, 205};
constexpr int kLeastWidth = 100;
constexpr int kMostWidth = 8192;

struct Panel {
  ImageMapping mapping;
  bool original;
};

bool is_disc(ImageMapping mapping) {
  return mapping == ImageMapping::kAngularMap || mapping == ImageMapping::kMirrorBall;
}

std::vector<Panel> panels_of(const LightFigure& figure) {
  std::vector<Panel> out;
  for (const ImageMapping mapping : figure.mappings) {
    if (figure.original) {
      out.push_back({mapping, true});
    }
    if (figure.reconstruction) {
      out.push_back({mapping, false});
    }
  }
  return out;
}

class Drawing {
 public:
  Drawing(const std::vector<Light>& lights, const LightCoefficients& coefficients, const LightFigure& figure)
      : lights_(lights), coefficients_(coefficients), figure_(figure), panels_(panels_of(figure)) {
    const bool pairs = figure.original && figure.reconstruction;
    columns_ = std::min<int>(static_cast<int>(panels_.size()), pairs ? 2 : 3);
    cell_width_ = (kWidth - kMargin) / columns_ - kMargin;
    cell_height_ = 0.0;
    for (const Panel& panel : panels_) {
      const MappingShape shape = mapping_shape(panel.mapping);
      cell_height_ =
          std::max(cell_height_, cell_width_ * std::min(0.75, static_cast<double>(shape.height) / shape.width));
    }
    const int rows = (static_cast<int>(panels_.size()) + columns_ - 1) / columns_;
    canvas_ = plot::png_canvas(kWidth, kTop + rows * (cell_height_ + kCaption) + 36.0, figure.width);
    white_ = 1.0 / exposure();
  }

  std::string draw() {
    canvas_->text({kMargin, 33.0}, figure_.title, kTitleSize, plot::Anchor::kStart, plot::kInk);
    for (std::size_t i = 0; i < panels_.size(); ++i) {
      draw_panel(panels_[i], box_of(static_cast<int>(i)));
    }
    const int rows = (static_cast<int>(panels_.size()) + columns_ - 1) / columns_;
    canvas_->text({kMargin, kTop + rows * (cell_height_ + kCaption) + 16.0}, legend(), kLabelSize, plot::Anchor::kStart,
                  plot::kInk);
    return canvas_->finish();
  }

 private:
  [[nodiscard]] Eigen::Vector3d value(bool original, const Eigen::Vector3d& d) const {
    return original ? radiance(lights_, d).cast<double>().eval() : radiance(coefficients_, d);
  }

  [[nodiscard]] double exposure() const {
    std::vector<Eigen::Vector3f> seen;
    for (const auto& node : numeric::fibonacci_nodes(4096)) {
      const Eigen::Vector3d d(node.x, node.y, node.z);
      seen.emplace_back(value(!figure_.reconstruction, d).cast<float>().cwiseMax(0.0F));
    }
    return static_cast<double>(automatic_exposure(seen) * std::exp2(figure_.exposure_stops));
  }

  /// Of a panel, in the middle of its cell.
  [[nodiscard]] plot::Box box_of(int i) const {
    const MappingShape shape = mapping_shape(panels_[static_cast<std::size_t>(i)].mapping);
    const double unit = std::min(cell_width_ / shape.width, cell_height_ / shape.height);
    const double x = kMargin + (i % columns_) * (cell_width_ + kMargin);
    const double y = kTop + (i / columns_) * (cell_height_ + kCaption);
    return {x + 0.5 * (cell_width_ - unit * shape.width), y, unit * shape.width, unit * shape.height};
  }

  void draw_panel(const Panel& panel, const plot::Box& box) {
    const plot::PixelBox where = canvas_->pixels(box);
    const plot::Sampler sampler = [&](const plot::Point& place) { return sample(panel, place); };
    canvas_->image(where, plot::paint_field(
                              sampler, {3, white_, canvas_->scale(), where, !panel.original && figure_.mark_negative}));
    if (figure_.axes) {
      draw_axes(panel.mapping, box);
    }
    const std::string caption = fmt::format("{}{}", kMappingNames[static_cast<std::size_t>(panel.mapping)],
                                            panel.original ? "" : fmt::format(", degree {}", coefficients_.degree));
    canvas_->text({box.x + 0.5 * box.width, box.y + box.height + 20.0}, caption, kLabelSize, plot::Anchor::kMiddle,
                  plot::kInk);
  }

  [[nodiscard]] plot::Channels sample(const Panel& panel, const plot::Point& place) const {
    const auto direction = mapped_direction(panel.mapping, place.x, place.y);
    if (!direction) {
      return {white_, white_, white_};  // no part of the picture: as the paper
    }
    const Eigen::Vector3d colour = value(panel.original, *direction);
    return {colour.x(), colour.y(), colour.z()};
  }

  void draw_axes(ImageMapping mapping, const plot::Box& box) {
    for (int axis = 0; axis < 6; ++axis) {
      const double sign = axis % 2 == 0 ? 1.0 : -1.0;
      const Eigen::Vector3d d = sign * Eigen::Vector3d::Unit(axis / 2);
      Eigen::Vector2d place = mapped_place(mapping, d);
      if (mapping == ImageMapping::kLatLong && axis / 2 == 2) {
        place.x() = 0.5;  // a pole is the whole edge
      }
      if (is_disc(mapping) && axis == 1) {
        place = {0.5, 1.0};  // -x is the whole rim
      }
      const double x = std::clamp(box.x + place.x() * box.width, box.x + 14.0, box.x + box.width - 14.0);
      const double y = std::clamp(box.y + place.y() * box.height, box.y + 11.0, box.y + box.height - 11.0);
      canvas_->polygon(plot::corners_of({x - 14.0, y - 11.0, 28.0, 22.0}), kTag);
      canvas_->text({x, y + 6.0}, fmt::format("{}{}", axis % 2 == 0 ? '+' : '-', "xyz"[axis / 2]), 17.0,
                    plot::Anchor::kMiddle, plot::kInk);
    }
  }

  [[nodiscard]] std::string legend() const {
    const std::string exposed = fmt::format("white is {:.3g} W m^-2 sr^-1", white_);
    return figure_.reconstruction && figure_.mark_negative
               ? "hatched: a channel is negative; grey line: where that begins; " + exposed
               : exposed;
  }

  const std::vector<Light>& lights_;
  const LightCoefficients& coefficients_;
  const LightFigure& figure_;
  std::vector<Panel> panels_;
  int columns_ = 1;
  double cell_width_ = 0.0;
  double cell_height_ = 0.0;
  double white_ = 1.0;
  std::unique_ptr<plot::Canvas> canvas_;
};

}  // namespace

std::string draw_lights(const std::vector<Light>& lights, const LightCoefficients& coefficients,
                        const LightFigure& figure) {
  if (figure.width < kLeastWidth || figure.width > kMostWidth) {
    throw std::invalid_argument(
        fmt::format("--width {}: {} to {} pixels can be drawn", figure.width, kLeastWidth, kMostWidth));
  }
  constexpr float kMostStops = 64.0F;
  if (!(std::abs(figure.exposure_stops) <= kMostStops)) {
    throw std::invalid_argument(
        fmt::format("--exposure {}: must be within {} stops", figure.exposure_stops, kMostStops));
  }
  return Drawing(lights, coefficients, figure).draw();
}

}  // namespace sh::prt
