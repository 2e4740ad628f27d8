// The canvas that paints pixels with Anti-Grain Geometry (polygons, strokes and stroke text, anti-aliased).
#include <agg_conv_stroke.h>
#include <agg_gsv_text.h>
#include <agg_path_storage.h>
#include <agg_pixfmt_rgb.h>
#include <agg_rasterizer_scanline_aa.h>
#include <agg_renderer_base.h>
#include <agg_renderer_scanline.h>
#include <agg_rendering_buffer.h>
#include <agg_scanline_p.h>

#include <algorithm>
#include <cmath>

#include "numeric/output/png.hpp"
#include "numeric/plot/canvas.hpp"

namespace sh::numeric::plot {
namespace {

using PixelFormat = agg::pixfmt_srgb24;
using Renderer = agg::renderer_base<PixelFormat>;

agg::srgba8 color_of(const Color& c) { return {c.red, c.green, c.blue, c.alpha}; }

class PngCanvas : public Canvas {
 public:
  PngCanvas(double width, double height, int size)
      : Canvas(size / width),
        picture_(size, std::max(1, static_cast<int>(std::lround(height * scale())))),
        buffer_(picture_.rgb.data(), static_cast<unsigned>(picture_.width), static_cast<unsigned>(picture_.height),
                3 * picture_.width),
        pixels_(buffer_),
        renderer_(pixels_) {}

  void polygon(std::span<const Point> corners, const Color& fill) override {
    agg::path_storage path = path_of(corners);
    path.close_polygon();
    paint(path, fill);
  }

  void line(std::span<const Point> points, double width, const Color& color) override {
    agg::path_storage path = path_of(points);
    stroke(path, width * scale(), color);
  }

  void text(const Point& place, const std::string& words, double size, Anchor anchor, const Color& color) override {
    agg::gsv_text letters;
    letters.flip(true);
    letters.size(kCapHeight * size * scale(), kCapWidth * size * scale());
    letters.text(words.c_str());
    const double width = letters.text_width();
    const double shift = anchor == Anchor::kStart ? 0 : anchor == Anchor::kMiddle ? width / 2 : width;
    letters.start_point(place.x * scale() - shift, place.y * scale());
    stroke(letters, std::max(kPen * size * scale(), 0.8), color);
  }

  void image(const PixelBox& where, const Raster& picture) override {
    for (int row = 0; row < picture.height && where.y + row < picture_.height; ++row) {
      for (int column = 0; column < picture.width && where.x + column < picture_.width; ++column) {
        picture_.set(where.x + column, where.y + row, picture.at(column, row));
      }
    }
  }

  void facets(std::span<const Polygon> polygons) override {
    for (const auto& [corners, fill] : polygons) polygon(corners, fill);
  }
  [[nodiscard]] bool is_vector() const override { return false; }
  [[nodiscard]] std::string finish() override {
    return output::encode_png(picture_.width, picture_.height, picture_.rgb);
  }

 private:
  // Of the stroke font, as parts of the em: measured against the sans-serif that SVG shows.
  static constexpr double kCapHeight = 0.72;
  static constexpr double kCapWidth = 0.66;
  static constexpr double kPen = 0.085;

  [[nodiscard]] agg::path_storage path_of(std::span<const Point> points) const {
    agg::path_storage path;
    for (const auto& p : points) {
      if (path.total_vertices() == 0) {
        path.move_to(p.x * scale(), p.y * scale());
      } else {
        path.line_to(p.x * scale(), p.y * scale());
      }
    }
    return path;
  }

  template <class Source>
  void stroke(Source& source, double width, const Color& color) {
    agg::conv_stroke<Source> outline(source);
    outline.width(width);
    outline.line_join(agg::round_join);
    outline.line_cap(agg::round_cap);
    paint(outline, color);
  }

  template <class Source>
  void paint(Source& source, const Color& color) {
    agg::rasterizer_scanline_aa<> rasterizer;
    rasterizer.clip_box(0, 0, picture_.width, picture_.height);
    rasterizer.add_path(source);
    agg::scanline_p8 scanline;
    agg::render_scanlines_aa_solid(rasterizer, scanline, renderer_, color_of(color));
  }

  Raster picture_;
  agg::rendering_buffer buffer_;
  PixelFormat pixels_;
  Renderer renderer_;
};

}  // namespace

std::unique_ptr<Canvas> png_canvas(double width, double height, int size) {
  return std::make_unique<PngCanvas>(width, height, size);
}

}  // namespace sh::numeric::plot
