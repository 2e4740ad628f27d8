#include "numeric/plot/map.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <vector>

#include "numeric/plot/field.hpp"

namespace sh::numeric::plot {
namespace {

constexpr double kWidth = 1000;
constexpr double kTop = 58;
constexpr Box kLatLongBox{78, kTop, 784, 392};
constexpr Box kCrossBox{40, kTop, 820, 615};
constexpr double kBarLeft = 892;
constexpr double kBarWidth = 18;
constexpr int kGraticule = 30;  // degrees
constexpr Colour kGraticuleColour{0, 0, 0, 60};
constexpr Colour kTag{255, 255, 255, 205};

class MapFigure {
 public:
  MapFigure(const SphereFunction& f, Projection projection, const Figure& figure)
      : f_(f),
        projection_(projection),
        largest_(largest_magnitude(f)),
        area_(projection == Projection::kLatLong ? kLatLongBox : kCrossBox),
        canvas_(canvas_for(figure, kWidth, kTop + area_.height + (projection == Projection::kLatLong ? 84 : 44))),
        title_(figure.title) {}

  std::string draw() {
    for (const auto& panel : panels_of(projection_)) draw_panel(panel);
    if (projection_ == Projection::kLatLong) draw_lat_long_axes();
    draw_words();
    if (largest_.magnitude > 0) draw_bar();
    return canvas_->finish();
  }

 private:
  [[nodiscard]] FieldStyle style(const PixelBox& where) const {
    return {f_.channels, largest_.magnitude > 0 ? largest_.magnitude : 1, canvas_->scale(), where};
  }

  void paint(const Sampler& sampler, const Box& box) {
    const PixelBox where = canvas_->pixels(box);
    canvas_->image(where, paint_field(sampler, style(where)));
  }

  void draw_frame(const Box& box) {
    auto corners = corners_of(box);
    corners.push_back(corners.front());
    canvas_->line(corners, 1, kInk);
  }

  [[nodiscard]] Box box_of(const Panel& panel) const {
    if (projection_ == Projection::kLatLong) return area_;
    const double side = area_.width / 4;
    return {area_.x + panel.column * side, area_.y + panel.row * side, side, side};
  }

  void draw_panel(const Panel& panel) {
    const Box box = box_of(panel);
    paint([&](const Point& p) { return f_.value(panel.direction(p)); }, box);
    for (auto& line : graticule(panel, kGraticule)) {
      for (auto& p : line) p = {box.x + p.x * box.width, box.y + p.y * box.height};
      canvas_->line(line, 0.7, kGraticuleColour);
    }
    draw_frame(box);
    if (projection_ == Projection::kCubeMap) {
      draw_tag({box.x + 24, box.y + 24}, panel.label);
      draw_centre({box.x + box.width / 2, box.y + box.height / 2});
    }
  }

  // A label that is legible on any colour.
  void draw_tag(const Point& centre, const std::string& words) {
    canvas_->polygon(corners_of({centre.x - 16, centre.y - 13, 32, 26}), kTag);
    canvas_->text({centre.x, centre.y + 6}, words, 18, Anchor::kMiddle, kInk);
  }

  void draw_centre(const Point& p) {
    canvas_->line(std::vector<Point>{{p.x - 5, p.y}, {p.x + 5, p.y}}, 1.4, kInk);
    canvas_->line(std::vector<Point>{{p.x, p.y - 5}, {p.x, p.y + 5}}, 1.4, kInk);
  }

  void draw_lat_long_axes() {
    const double bottom = area_.y + area_.height;
    static constexpr const char* kAxes[] = {"-x", "+y", "+x", "-y", "-x"};
    for (int phi = 180; phi >= -180; phi -= 30) {
      const double x = area_.x + (180 - phi) / 360.0 * area_.width;
      canvas_->line(std::vector<Point>{{x, bottom}, {x, bottom + 5}}, 1, kInk);
      canvas_->text({x, bottom + 20}, std::to_string(phi), kLabelSize, Anchor::kMiddle, kInk);
      if (phi % 90 == 0) {
        canvas_->text({x, bottom + 40}, kAxes[(180 - phi) / 90], 18, Anchor::kMiddle, kInk);
      }
    }
    for (int theta = 0; theta <= 180; theta += 30) {
      const double y = area_.y + theta / 180.0 * area_.height;
      canvas_->line(std::vector<Point>{{area_.x - 5, y}, {area_.x, y}}, 1, kInk);
      canvas_->text({area_.x - 9, y + 5}, std::to_string(theta), kLabelSize, Anchor::kEnd, kInk);
    }
    canvas_->text({20, area_.y + 6}, "+z", 18, Anchor::kMiddle, kInk);
    canvas_->text({20, bottom + 6}, "-z", 18, Anchor::kMiddle, kInk);
    canvas_->text({area_.x - 9, area_.y + area_.height / 4 + 5}, "theta", kLabelSize, Anchor::kEnd, kInk);
    canvas_->text({area_.x + area_.width * 0.375, bottom + 40}, "phi, degrees", kLabelSize, Anchor::kMiddle, kInk);
  }

  void draw_words() {
    const double bottom = area_.y + area_.height;
    canvas_->text({area_.x, 34}, title_, kTitleSize, Anchor::kStart, kInk);
    canvas_->text({area_.x + area_.width, 34}, describe(largest_, f_.exponent), kLabelSize, Anchor::kEnd, kInk);
    const bool light = f_.channels == 3;
    const std::string words = std::string("hatched: ") + (light ? "a channel is negative" : "negative") +
                              (light ? "; grey line: zero" : "; black line: zero") +
                              "; seen from the centre, z up, every 30 degrees a line";
    canvas_->text({area_.x, bottom + (projection_ == Projection::kLatLong ? 68 : 28)}, words, kLabelSize,
                  Anchor::kStart, kInk);
    if (largest_.magnitude == 0) {
      canvas_->text({area_.x + area_.width / 2, area_.y + area_.height / 2 - 12}, "zero function", kTitleSize,
                    Anchor::kMiddle, kInk);
    }
  }

  void draw_bar() {
    const Box bar{kBarLeft, area_.y, kBarWidth, area_.height};
    paint(
        [&](const Point& p) {
          const double v = largest_.magnitude * (1 - 2 * p.y);
          return Channels{v, v, v};
        },
        bar);
    draw_frame(bar);
    for (int i = -2; i <= 2; ++i) {
      const double y = bar.y + bar.height * (2 - i) / 4;
      canvas_->line(std::vector<Point>{{bar.x + bar.width, y}, {bar.x + bar.width + 5, y}}, 1, kInk);
      canvas_->text({bar.x + bar.width + 9, y + 5}, format_value(i * largest_.magnitude / 2, f_.exponent), kLabelSize,
                    Anchor::kStart, kInk);
    }
  }

  const SphereFunction& f_;
  Projection projection_;
  Largest largest_;
  Box area_;
  std::unique_ptr<Canvas> canvas_;
  std::string title_;
};

}  // namespace

std::string draw_map(const SphereFunction& f, Projection projection, const Figure& figure) {
  return MapFigure(f, projection, figure).draw();
}

}  // namespace sh::numeric::plot
