// paint_field of map.hpp.
#include <algorithm>
#include <cmath>

#include "numeric/output/progress.hpp"
#include "numeric/plot/map.hpp"

namespace sh::numeric::plot {
namespace {

// In units of the figure.
constexpr double kHatchPeriod = 6.5;
constexpr double kHatchWidth = 1.1;
constexpr double kZeroLine = 1.3;
constexpr Color kDarkHatch{0, 0, 0, 125};
constexpr Color kLightHatch{255, 255, 255, 150};  // negative areas of a picture of light are black
constexpr Color kGrayLine{128, 128, 128, 255};

struct Row {
  std::vector<Channels> values;  // from one pixel left of the picture to one right of it
  std::vector<double> least;
};

Row sample_row(const Sampler& sampler, const PixelBox& where, int channels, int row) {
  Row out;
  for (int column = -1; column <= where.width; ++column) {
    const Channels v = sampler({(column + 0.5) / where.width, (row + 0.5) / where.height});
    out.values.push_back(v);
    out.least.push_back(channels == 1 ? v[0] : std::min({v[0], v[1], v[2]}));
  }
  return out;
}

Color base_color(const Channels& v, const FieldStyle& style) {
  if (style.channels == 1) return diverging(v[0] / style.largest);
  return encode({v[0] / style.largest, v[1] / style.largest, v[2] / style.largest});
}

// Rising diagonals of the whole picture, at least every four pixels; `across` counts pixels along both axes.
double hatch_coverage(int across, double unit) {
  const double period = std::max(4.0, kHatchPeriod * unit);
  const double width = std::max(1.0, kHatchWidth * unit);
  const double place = across / std::sqrt(2.0);
  const double offset = std::abs(place - period * std::round(place / period));
  return std::clamp(width / 2 + 0.5 - offset, 0.0, 1.0);
}

}  // namespace

Raster paint_field(const Sampler& sampler, const PixelBox& where, double unit, const FieldStyle& style) {
  constexpr double kFar = 1e9;
  const bool single = style.channels == 1;
  Raster picture(where.width, where.height);
  Row above = sample_row(sampler, where, style.channels, -1);
  Row here = sample_row(sampler, where, style.channels, 0);
  output::Progress progress("plot", where.height);
  for (int row = 0; row < where.height; ++row) {
    Row below = sample_row(sampler, where, style.channels, row + 1);
    for (int column = 0; column < where.width; ++column) {
      const int i = column + 1;
      const double value = here.least[i];
      if (std::isnan(value)) continue;  // paper
      Color color = base_color(here.values[i], style);
      if (style.marks) {
        const double slope =
            std::hypot(here.least[i + 1] - here.least[i - 1], below.least[i] - above.least[i]) / 2;  // a pixel
        const double distance = slope > 0 ? std::abs(value) / slope : kFar;  // from the zero line
        if (value < 0) {
          color =
              blend(color, single ? kDarkHatch : kLightHatch, hatch_coverage(where.x + column + where.y + row, unit));
        }
        const double line = std::clamp(std::max(kZeroLine * unit, 1.0) / 2 + 0.5 - distance, 0.0, 1.0);
        color = blend(color, single ? kInk : kGrayLine, line);
      }
      picture.set(column, row, color);
    }
    above = std::move(here);
    here = std::move(below);
    progress.advance();
  }
  return picture;
}

}  // namespace sh::numeric::plot
