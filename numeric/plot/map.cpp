#include "numeric/plot/map.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace sh::numeric::plot {
namespace {

constexpr double kWidth = 1000;
constexpr double kTop = 58;
constexpr double kBarLeft = 892;
constexpr double kBarWidth = 18;
constexpr int kGraticule = 30;  // degrees
constexpr Color kGraticuleColor{0, 0, 0, 60};
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr Channels kPaper = {kNone, kNone, kNone};

// A lat-long picture has room for angles at its left, and below; others fit into 820 x 700.
Box area_of(ImageMapping mapping) {
  if (mapping == ImageMapping::kLatLong) return {78, kTop, 784, 392};
  const MappingShape shape = mapping_shape(mapping);
  const double unit = std::min(820.0 / shape.width, 700.0 / shape.height);
  return {40, kTop, unit * shape.width, unit * shape.height};
}

class MapFigure {
 public:
  MapFigure(const SphereFunction& f, ImageMapping mapping, const Figure& figure)
      : f_(f),
        mapping_(mapping),
        largest_(largest_magnitude(f)),
        area_(area_of(mapping)),
        canvas_(canvas_for(figure, kWidth, kTop + area_.height + (is_lat_long() ? 84 : 44))),
        title_(figure.title) {}

  std::string draw() {
    paint_map(*canvas_, mapping_, area_, f_.value, style());
    for (const Panel& panel : panels_of(mapping_)) draw_lines(panel);
    if (is_lat_long()) draw_lat_long_axes();
    if (is_disc(mapping_)) draw_axis_tags(*canvas_, mapping_, area_);
    draw_words();
    if (largest_.magnitude > 0) draw_bar();
    return canvas_->finish();
  }

 private:
  [[nodiscard]] bool is_lat_long() const { return mapping_ == ImageMapping::kLatLong; }
  [[nodiscard]] FieldStyle style() const { return {f_.channels, largest_.magnitude > 0 ? largest_.magnitude : 1}; }

  void draw_frame(const Box& box) {
    auto corners = corners_of(box);
    corners.push_back(corners.front());
    canvas_->line(corners, 1, kInk);
  }

  void draw_lines(const Panel& panel) {
    const Box box = panel.box(area_);
    for (auto& line : graticule(panel, kGraticule)) {
      for (auto& p : line) p = {box.x + p.x * box.width, box.y + p.y * box.height};
      canvas_->line(line, 0.7, kGraticuleColor);
    }
    if (!is_disc(mapping_)) draw_frame(box);
    if (panel.face != nullptr) {
      draw_tag(*canvas_, {box.x + 24, box.y + 24}, axis_name(panel.face->forward));
      draw_center({box.x + box.width / 2, box.y + box.height / 2});
    }
  }

  void draw_center(const Point& p) {
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
      if (phi % 90 == 0) canvas_->text({x, bottom + 40}, kAxes[(180 - phi) / 90], 18, Anchor::kMiddle, kInk);
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
    canvas_->text({std::max(area_.x + area_.width, 860.0), 34}, describe(largest_, f_.exponent), kLabelSize,
                  Anchor::kEnd, kInk);
    const bool light = f_.channels == 3;
    const std::string words =
        std::string("hatched: ") + (light ? "a channel is negative" : "negative") +
        (light ? "; gray line: zero" : "; black line: zero") +
        (mapping_ == ImageMapping::kMirrorBall ? "; in a mirror ball" : "; seen from the center") +
        ", z up, every 30 degrees a line";
    canvas_->text({area_.x, bottom + (is_lat_long() ? 68 : 28)}, words, kLabelSize, Anchor::kStart, kInk);
    if (largest_.magnitude == 0) {
      canvas_->text({area_.x + area_.width / 2, area_.y + area_.height / 2 - 12}, "zero function", kTitleSize,
                    Anchor::kMiddle, kInk);
    }
  }

  void draw_bar() {
    const Box bar{kBarLeft, area_.y, kBarWidth, area_.height};
    const Sampler values = [&](const Point& p) {
      const double v = largest_.magnitude * (1 - 2 * p.y);
      return Channels{v, v, v};
    };
    const PixelBox where = canvas_->pixels(bar);
    canvas_->image(where, paint_field(values, where, canvas_->scale(), style()));
    draw_frame(bar);
    for (int i = -2; i <= 2; ++i) {
      const double y = bar.y + bar.height * (2 - i) / 4;
      canvas_->line(std::vector<Point>{{bar.x + bar.width, y}, {bar.x + bar.width + 5, y}}, 1, kInk);
      canvas_->text({bar.x + bar.width + 9, y + 5}, format_value(i * largest_.magnitude / 2, f_.exponent), kLabelSize,
                    Anchor::kStart, kInk);
    }
  }

  const SphereFunction& f_;
  ImageMapping mapping_;
  Largest largest_;
  Box area_;
  std::unique_ptr<Canvas> canvas_;
  std::string title_;
};

}  // namespace

std::string draw_map(const SphereFunction& f, ImageMapping mapping, const Figure& figure) {
  return MapFigure(f, mapping, figure).draw();
}

void paint_map(Canvas& canvas, ImageMapping mapping, const Box& area,
               const std::function<Channels(const Vector3&)>& value, const FieldStyle& style) {
  for (const Panel& panel : panels_of(mapping)) {
    const PixelBox where = canvas.pixels(panel.box(area));
    const Sampler sampler = [&](const Point& place) {
      const auto direction = panel.direction(place);
      return direction ? value(*direction) : kPaper;
    };
    canvas.image(where, paint_field(sampler, where, canvas.scale(), style));
  }
}

void draw_axis_tags(Canvas& canvas, ImageMapping mapping, const Box& area) {
  for (int axis = 0; axis < 6; ++axis) {
    const Vector3 d = (axis % 2 == 0 ? 1.0 : -1.0) * Vector3::Unit(axis / 2);
    Eigen::Vector2d place = mapped_place(mapping, d);
    if (mapping == ImageMapping::kLatLong && axis / 2 == 2) place.x() = 0.5;  // a pole is the whole edge
    if (is_disc(mapping) && axis == 1) place = {0.5, 1.0};                    // -x is the whole rim
    draw_tag(canvas,
             {std::clamp(area.x + place.x() * area.width, area.x + 14, area.x + area.width - 14),
              std::clamp(area.y + place.y() * area.height, area.y + 11, area.y + area.height - 11)},
             axis_name(d));
  }
}

}  // namespace sh::numeric::plot
