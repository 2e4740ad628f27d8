#include "numeric/plot/field.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "numeric/output/progress.hpp"

namespace sh::numeric::plot {
namespace {

// In units of the figure.
constexpr double kHatchPeriod = 6.5;
constexpr double kHatchWidth = 1.1;
constexpr double kZeroLine = 1.3;
constexpr Color kDarkHatch{0, 0, 0, 125};
constexpr Color kLightHatch{255, 255, 255, 150};  // black areas are what is negative in a picture of light
constexpr Color kGrayLine{128, 128, 128, 255};

struct Row {
  std::vector<Channels> values;  // from one pixel left of the picture to one right of it
  std::vector<double> least;
};

class FieldPainter {
 public:
  FieldPainter(const Sampler& sampler, const PixelBox& where, double unit, const FieldStyle& style)
      : sampler_(sampler), where_(where), unit_(unit), style_(style), width_(where.width), height_(where.height) {}

  [[nodiscard]] Raster paint() const {
    Raster picture(width_, height_);
    Row above = sample_row(-1);
    Row here = sample_row(0);
    output::Progress progress("plot", height_);
    for (int row = 0; row < height_; ++row) {
      Row below = sample_row(row + 1);
      for (int column = 0; column < width_; ++column) picture.set(column, row, pixel(above, here, below, column, row));
      above = std::move(here);
      here = std::move(below);
      progress.advance();
    }
    return picture;
  }

 private:
  [[nodiscard]] Row sample_row(int row) const {
    Row out;
    for (int column = -1; column <= width_; ++column) {
      out.values.push_back(sampler_({(column + 0.5) / width_, (row + 0.5) / height_}));
      const auto& v = out.values.back();
      out.least.push_back(style_.channels == 1 ? v[0] : std::min({v[0], v[1], v[2]}));
    }
    return out;
  }

  [[nodiscard]] Color pixel(const Row& above, const Row& here, const Row& below, int column, int row) const {
    const auto i = static_cast<std::size_t>(column) + 1;
    const double value = here.least[i];
    if (std::isnan(value)) return kWhite;
    if (!style_.marks) return base_color(here.values[i]);
    const double slope =
        std::hypot(here.least[i + 1] - here.least[i - 1], below.least[i] - above.least[i]) / 2;  // a pixel
    const double distance = slope > 0 ? std::abs(value) / slope : kFar;                          // from the zero line
    Color color = base_color(here.values[i]);
    if (value < 0) color = blend(color, hatch(), hatch_coverage(column, row));
    const double line = std::clamp(std::max(kZeroLine * unit_, 1.0) / 2 + 0.5 - distance, 0.0, 1.0);
    return blend(color, style_.channels == 1 ? kInk : kGrayLine, line);
  }

  [[nodiscard]] Color base_color(const Channels& v) const {
    if (style_.channels == 1) return diverging(v[0] / style_.largest);
    return encode({v[0] / style_.largest, v[1] / style_.largest, v[2] / style_.largest});
  }

  [[nodiscard]] Color hatch() const { return style_.channels == 1 ? kDarkHatch : kLightHatch; }

  // Rising diagonals of the whole picture, at least every four pixels.
  [[nodiscard]] double hatch_coverage(int column, int row) const {
    const double period = std::max(4.0, kHatchPeriod * unit_);
    const double width = std::max(1.0, kHatchWidth * unit_);
    const double across = (where_.x + column + where_.y + row) / std::sqrt(2.0);
    const double offset = std::abs(across - period * std::round(across / period));
    return std::clamp(width / 2 + 0.5 - offset, 0.0, 1.0);
  }

  static constexpr double kFar = 1e9;

  const Sampler& sampler_;
  PixelBox where_;
  double unit_;
  const FieldStyle& style_;
  int width_, height_;
};

}  // namespace

Raster paint_field(const Sampler& sampler, const PixelBox& where, double unit, const FieldStyle& style) {
  return FieldPainter(sampler, where, unit, style).paint();
}

}  // namespace sh::numeric::plot
