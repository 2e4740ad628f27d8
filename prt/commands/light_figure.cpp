#include "prt/commands/light_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "numeric/plot/map.hpp"
#include "numeric/sampling/sphere_nodes.hpp"
#include "prt/commands/commands.hpp"
#include "prt/image/tone_map.hpp"

namespace sh::prt {
namespace {

namespace plot = numeric::plot;

// In units of the figure, which is 1000 wide.
constexpr double kWidth = 1000.0;
constexpr double kMargin = 16.0;
constexpr double kTop = 52.0;
constexpr double kCaption = 30.0;
constexpr int kLeastWidth = 100;

struct Panel {
  ImageMapping mapping;
  bool original;
};

std::vector<Panel> panels_of(const LightFigure& figure) {
  std::vector<Panel> out;
  for (const ImageMapping mapping : figure.mappings) {
    if (figure.original) out.push_back({mapping, true});
    if (figure.reconstruction) out.push_back({mapping, false});
  }
  return out;
}

class Drawing {
 public:
  Drawing(const std::vector<Light>& lights, const LightCoefficients& coefficients, const LightFigure& figure)
      : lights_(lights), coefficients_(coefficients), figure_(figure), panels_(panels_of(figure)) {
    const int count = static_cast<int>(panels_.size());
    columns_ = std::min(count, figure.original && figure.reconstruction ? 2 : 3);
    cell_width_ = (kWidth - kMargin) / columns_ - kMargin;
    for (const Panel& panel : panels_) {
      const MappingShape shape = mapping_shape(panel.mapping);
      cell_height_ =
          std::max(cell_height_, cell_width_ * std::min(0.75, static_cast<double>(shape.height) / shape.width));
    }
    const int rows = (count + columns_ - 1) / columns_;
    bottom_ = kTop + rows * (cell_height_ + kCaption);
    canvas_ = plot::png_canvas(kWidth, bottom_ + 36.0, figure.width);
    white_ = 1.0 / exposure();
  }

  std::string draw() {
    write({kMargin, 33.0}, figure_.title, plot::kTitleSize, plot::Anchor::kStart);
    for (std::size_t i = 0; i < panels_.size(); ++i) draw_panel(panels_[i], box_of(static_cast<int>(i)));
    write({kMargin, bottom_ + 16.0}, legend(), plot::kLabelSize, plot::Anchor::kStart);
    return canvas_->finish();
  }

 private:
  void write(const plot::Point& place, const std::string& words, double size, plot::Anchor anchor) {
    canvas_->text(place, words, size, anchor, plot::kInk);
  }

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
    const MappingShape shape = mapping_shape(panels_[i].mapping);
    const double unit = std::min(cell_width_ / shape.width, cell_height_ / shape.height);
    const int row = i / columns_, column = i % columns_;
    const double x = kMargin + column * (cell_width_ + kMargin);
    const double y = kTop + row * (cell_height_ + kCaption);
    return {x + 0.5 * (cell_width_ - unit * shape.width), y, unit * shape.width, unit * shape.height};
  }

  void draw_panel(const Panel& panel, const plot::Box& box) {
    const auto values = [&](const Eigen::Vector3d& d) {
      const Eigen::Vector3d color = value(panel.original, d);
      return plot::Channels{color.x(), color.y(), color.z()};
    };
    plot::paint_map(*canvas_, panel.mapping, box, values, {3, white_, !panel.original && figure_.mark_negative});
    if (figure_.axes) plot::draw_axis_tags(*canvas_, panel.mapping, box);
    const std::string degree = panel.original ? "" : fmt::format(", degree {}", coefficients_.degree);
    write({box.x + 0.5 * box.width, box.y + box.height + 20.0},
          fmt::format("{}{}", numeric::name_of(panel.mapping), degree), plot::kLabelSize, plot::Anchor::kMiddle);
  }

  [[nodiscard]] std::string legend() const {
    const std::string exposed = fmt::format("white is {:.3g} W m^-2 sr^-1", white_);
    return figure_.reconstruction && figure_.mark_negative
               ? "hatched: a channel is negative; gray line: where that begins; " + exposed
               : exposed;
  }

  const std::vector<Light>& lights_;
  const LightCoefficients& coefficients_;
  const LightFigure& figure_;
  std::vector<Panel> panels_;
  int columns_ = 1;
  double cell_width_ = 0.0;
  double cell_height_ = 0.0;
  double bottom_ = 0.0;
  double white_ = 1.0;
  std::unique_ptr<plot::Canvas> canvas_;
};

}  // namespace

std::string draw_lights(const std::vector<Light>& lights, const LightCoefficients& coefficients,
                        const LightFigure& figure) {
  if (figure.width < kLeastWidth || figure.width > plot::kLargestSize) {
    throw std::invalid_argument(
        fmt::format("--width {}: expected {} to {} pixels", figure.width, kLeastWidth, plot::kLargestSize));
  }
  require_stops(figure.exposure_stops);
  return Drawing(lights, coefficients, figure).draw();
}

}  // namespace sh::prt
