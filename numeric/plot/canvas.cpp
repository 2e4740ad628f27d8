// The functions that both canvases share, and the canvas that writes SVG 1.1: one file, with embedded PNG pictures.
#include "numeric/plot/canvas.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>

#include "numeric/output/markup.hpp"
#include "numeric/output/png.hpp"

namespace sh::numeric::plot {
namespace {

// [RFC 4648] section 4.
std::string base64(std::string_view bytes) {
  static constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned group = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      group = group << 8U | (i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : 0U);
    }
    for (std::size_t j = 0; j < 4; ++j) out += i + j > bytes.size() ? '=' : kDigits[group >> (18 - 6 * j) & 63U];
  }
  return out;
}

std::string hex(const Color& c) { return fmt::format("#{:02x}{:02x}{:02x}", c.red, c.green, c.blue); }

const char* name(Anchor anchor) {
  return anchor == Anchor::kStart ? "start" : anchor == Anchor::kMiddle ? "middle" : "end";
}

class SvgCanvas : public Canvas {
 public:
  SvgCanvas(double width, double height, int size, const std::string& title) : Canvas(size / width) {
    const int rows = std::max(1, static_cast<int>(std::lround(height * scale())));
    text_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
        "font-family=\"Helvetica,Arial,DejaVu Sans,sans-serif\">\n<title>{2}</title>\n"
        "<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n",
        size, rows, output::escaped(title));
  }

  void polygon(std::span<const Point> corners, const Color& fill) override {
    text_ += fmt::format("<path d=\"{}z\" fill=\"{}\"{}/>\n", path(corners), hex(fill), opacity("fill", fill));
  }

  void line(std::span<const Point> points, double width, const Color& color) override {
    text_ += fmt::format(
        "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{:.2f}\" stroke-linejoin=\"round\"{}/>\n",
        path(points), hex(color), width * scale(), opacity("stroke", color));
  }

  void facets(std::span<const Polygon> polygons) override {
    text_ += "<g fill=\"currentColor\" stroke=\"currentColor\" stroke-width=\".7\" stroke-linejoin=\"round\">\n";
    for (const auto& [corners, fill] : polygons) {
      text_ += fmt::format("<path color=\"{}\" d=\"{}z\"/>\n", hex(fill), path(corners));
    }
    text_ += "</g>\n";
  }

  void text(const Point& place, const std::string& words, double size, Anchor anchor, const Color& color) override {
    text_ += fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{:.2f}\" text-anchor=\"{}\" fill=\"{}\">{}</text>\n",
                         output::svg_number(place.x * scale()), output::svg_number(place.y * scale()), size * scale(),
                         name(anchor), hex(color), output::escaped(words));
  }

  void image(const PixelBox& where, const Raster& picture) override {
    text_ += fmt::format(
        "<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" "
        "href=\"data:image/png;base64,{}\"/>\n",
        where.x, where.y, where.width, where.height,
        base64(output::encode_png(picture.width, picture.height, picture.rgb)));
  }

  [[nodiscard]] bool is_vector() const override { return true; }
  [[nodiscard]] std::string finish() override { return text_ + "</svg>\n"; }

 private:
  [[nodiscard]] std::string path(std::span<const Point> points) const { return output::svg_path(points, scale()); }

  static std::string opacity(const char* what, const Color& c) {
    return c.alpha == 255 ? "" : fmt::format(" {}-opacity=\"{:.2f}\"", what, c.alpha / 255.0);
  }

  std::string text_;
};

}  // namespace

Format format_of(const std::string& file) {
  if (file.ends_with(".svg")) return Format::kSvg;
  if (file.ends_with(".png")) return Format::kPng;
  throw std::invalid_argument(fmt::format("{}: expected the ending .svg or .png, which names the format", file));
}

std::unique_ptr<Canvas> canvas_for(const Figure& figure, double width, double height) {
  if (figure.format == Format::kPng) return png_canvas(width, height, figure.size);
  return std::make_unique<SvgCanvas>(width, height, figure.size, figure.title);
}

PixelBox Canvas::pixels(const Box& box) const {
  const auto whole = [this](double v) { return static_cast<int>(std::lround(v * scale())); };
  const int x = whole(box.x);
  const int y = whole(box.y);
  return {x, y, std::max(1, whole(box.x + box.width) - x), std::max(1, whole(box.y + box.height) - y)};
}

std::vector<Point> corners_of(const Box& b) {
  return {{b.x, b.y}, {b.x + b.width, b.y}, {b.x + b.width, b.y + b.height}, {b.x, b.y + b.height}};
}

void draw_tag(Canvas& canvas, const Point& center, const std::string& words) {
  constexpr Color kPaper{255, 255, 255, 205};
  canvas.polygon(corners_of({center.x - 14, center.y - 11, 28, 22}), kPaper);
  canvas.text({center.x, center.y + 6}, words, 17, Anchor::kMiddle, kInk);
}

}  // namespace sh::numeric::plot
