#include "numeric/plot/lobes.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "numeric/oracle/index.hpp"

namespace sh::numeric::plot {
namespace {

constexpr double kWidth = 1000;
constexpr double kAxisLength = 1.25;
constexpr double kFacetLimit = 9000;  // about 60 bytes each

void draw_swatch(Canvas& canvas, const Point& place, const Color& color, const std::string& words) {
  canvas.polygon(corners_of({place.x, place.y - 12, 14, 14}), color);
  canvas.text({place.x + 21, place.y}, words, kLabelSize, Anchor::kStart, kInk);
}

void draw_legend(Canvas& canvas, double baseline) {
  draw_swatch(canvas, {40, baseline}, kPositive, "positive");
  draw_swatch(canvas, {140, baseline}, kNegative, "negative");
}

// Letters beyond the tips of the axes.
void draw_letters(Canvas& canvas, const Camera& camera, const Box& box, double unit, double length, double size) {
  static constexpr const char* kLetters[] = {"x", "y", "z"};
  for (int i = 0; i < 3; ++i) {
    const Vector3 p = camera.project(length * Vector3::Unit(i));
    canvas.text({box.x + box.width / 2 + unit * p[0], box.y + box.height / 2 - unit * p[1] + 0.35 * size}, kLetters[i],
                size, Anchor::kMiddle, kInk);
  }
}

// Rings of cells that follow every half-wave of the degree.
int rings_for(int degree, int least) { return std::max(least, 6 * (degree + 1)); }

// Facets on the side of the viewer: a ring has two cells a ring, half of them seen.
bool as_facets(const Canvas& canvas, int cells, int rings) {
  return canvas.is_vector() && double(cells) * rings * rings < kFacetLimit;
}

void draw_words(Canvas& canvas, const Figure& figure, const std::string& right) {
  canvas.text({40, 38}, figure.title, kTitleSize, Anchor::kStart, kInk);
  canvas.text({kWidth - 40, 38}, right, kLabelSize, Anchor::kEnd, kInk);
}

}  // namespace

std::string draw_lobes(const SphereFunction& f, const View& view, const Figure& figure) {
  constexpr double kTop = 52;
  const double side = kWidth / f.channels;
  const double height = std::min(side, 800.0);
  const auto canvas = canvas_for(figure, kWidth, kTop + height + 44);
  const auto largest = largest_magnitude(f);
  const Camera camera(view);
  const double unit = height / 2 / 1.4;
  const double baseline = kTop + height + 26;
  static constexpr const char* kNames[] = {"red", "green", "blue"};
  for (int channel = 0; channel < f.channels; ++channel) {
    const Box box{channel * side, kTop, side, height};
    Surface surface;
    add_axes(surface, kAxisLength);
    const int rings = rings_for(f.degree, f.channels == 1 ? 90 : 50);
    const int fine = std::max(rings, 180);
    const bool facets = as_facets(*canvas, f.channels, rings);
    if (largest.magnitude > 0) add_lobes(surface, channel_of(f, channel), 1 / largest.magnitude, facets ? rings : fine);
    draw_surface(*canvas, surface, camera, box, unit, facets);
    draw_letters(*canvas, camera, box, unit, kAxisLength + 0.09, f.channels == 1 ? 22 : kLabelSize);
    if (largest.magnitude == 0) {
      canvas->text({box.x + side / 2, kTop + 0.8 * height}, "zero function", kTitleSize, Anchor::kMiddle, kInk);
    }
    if (f.channels > 1) {
      canvas->text({box.x + side / 2, kTop + height - 4}, kNames[channel], kLabelSize, Anchor::kMiddle, kInk);
    }
  }
  draw_words(*canvas, figure, describe(largest, f.exponent));
  draw_legend(*canvas, baseline);
  canvas->text(
      {kWidth - 40, baseline},
      fmt::format("radius: magnitude; seen from azimuth {:g}, elevation {:g} degrees", view.azimuth, view.elevation),
      kLabelSize, Anchor::kEnd, kInk);
  return canvas->finish();
}

std::string draw_basis_grid(int degree, const View& view, const Figure& figure) {
  constexpr double kTop = 60;
  constexpr double kLeft = 40;
  const double side = (kWidth - 2 * kLeft) / (2 * std::max(degree, 1) + 1);
  const double letters = std::min(kLabelSize, 0.2 * side);
  const double row_height = side + 1.3 * letters;
  const auto canvas = canvas_for(figure, kWidth, kTop + row_height * (degree + 1) + 44);
  const Camera camera(view);
  // The addition theorem bounds |Y_lm| by sqrt((2l+1) / 4 pi), which Y_l0 reaches at the poles.
  const double bound = std::sqrt((2 * degree + 1) / (4 * std::numbers::pi));
  const int rings = rings_for(degree, 32);
  const int count = coefficient_count(degree);
  for (int l = 0; l <= degree; ++l) {
    for (int m = -l; m <= l; ++m) {
      const Box box{kWidth / 2 + (m - 0.5) * side, kTop + l * row_height, side, side};
      Surface surface;
      const auto f = basis_function(l, m);
      add_lobes(surface, f, std::ldexp(1 / bound, f.exponent), rings);
      draw_surface(*canvas, surface, camera, box, 0.5 * side, as_facets(*canvas, count, rings));
      canvas->text({box.x + side / 2, box.y + side + letters}, fmt::format("Y({},{})", l, m), letters, Anchor::kMiddle,
                   kInk);
    }
  }
  const Box corner{kLeft, kTop - 10, 110, 110};
  Surface axes;
  add_axes(axes, 1);
  draw_surface(*canvas, axes, camera, corner, 40, canvas->is_vector());
  draw_letters(*canvas, camera, corner, 40, 1.25, kLabelSize);
  draw_words(*canvas, figure, "rows: degree l, columns: order m; one scale");
  draw_legend(*canvas, kTop + row_height * (degree + 1) + 26);
  return canvas->finish();
}

}  // namespace sh::numeric::plot
