// Where figures are drawn: one drawing, as SVG text or as PNG pixels.
//
// A figure has units of its own, y down; the canvas scales them to pixels. Both canvases draw the same calls. SVG sets
// text in the sans-serif of the reader, PNG in the built-in stroke font of Anti-Grain Geometry: no font has to be
// installed, and bytes never differ.
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "numeric/output/markup.hpp"
#include "numeric/plot/color.hpp"

namespace sh::numeric::plot {

using output::Point;

struct Box {
  double x = 0, y = 0, width = 0, height = 0;
};

struct Polygon {
  std::vector<Point> corners;
  Color fill;
};

enum class Anchor { kStart, kMiddle, kEnd };

/// 8-bit sRGB pixels, (height, width, 3), top row first.
struct Raster {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;

  Raster(int w, int h) : width(w), height(h), rgb(std::size_t{3} * w * h, 255) {}
  [[nodiscard]] Color at(int column, int row) const {
    const auto* p = rgb.data() + place(column, row);
    return {p[0], p[1], p[2]};
  }
  void set(int column, int row, const Color& color) {
    auto* p = rgb.data() + place(column, row);
    p[0] = color.red;
    p[1] = color.green;
    p[2] = color.blue;
  }

 private:
  [[nodiscard]] std::size_t place(int column, int row) const { return std::size_t{3} * (row * width + column); }
};

/// Pixels of the finished picture, the whole ones that a box covers.
struct PixelBox {
  int x = 0, y = 0, width = 1, height = 1;
};

class Canvas {
 public:
  virtual ~Canvas() = default;
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  virtual void polygon(std::span<const Point> corners, const Color& fill) = 0;
  virtual void line(std::span<const Point> points, double width, const Color& color) = 0;
  /// The baseline starts, has its middle or ends at `place`; `size` is the height of the em. ASCII.
  virtual void text(const Point& place, const std::string& words, double size, Anchor anchor, const Color& color) = 0;
  /// `picture` has the pixels of `where`, 1:1.
  virtual void image(const PixelBox& where, const Raster& picture) = 0;
  /// A surface in opaque facets that touch, back to front. SVG closes the gaps between them; in PNG they would show.
  virtual void facets(std::span<const Polygon> polygons) = 0;
  [[nodiscard]] virtual bool is_vector() const = 0;
  /// The finished file.
  [[nodiscard]] virtual std::string finish() = 0;

  /// Pixels a unit.
  [[nodiscard]] double scale() const { return scale_; }
  [[nodiscard]] PixelBox pixels(const Box& box) const;

 protected:
  explicit Canvas(double scale) : scale_(scale) {}

 private:
  double scale_;
};

/// A white canvas of width x height units, `size` pixels wide.
std::unique_ptr<Canvas> png_canvas(double width, double height, int size);

enum class Format { kSvg, kPng };

/// From the ending .svg or .png. Throws std::invalid_argument naming the file.
Format format_of(const std::string& file);

/// The title, format and size in pixels of a picture.
struct Figure {
  std::string title;
  Format format = Format::kSvg;
  int size = 1000;  // width, kSmallestSize to kLargestSize
};
constexpr int kSmallestSize = 16;
constexpr int kLargestSize = 8192;

/// A white canvas of width x height units for the figure.
std::unique_ptr<Canvas> canvas_for(const Figure& figure, double width, double height);

/// Sizes of letters, in units.
constexpr double kTitleSize = 22;
constexpr double kLabelSize = 15;

/// Four corners, clockwise from the top left.
std::vector<Point> corners_of(const Box& box);

/// A label that is legible on any color.
void draw_tag(Canvas& canvas, const Point& center, const std::string& words);

}  // namespace sh::numeric::plot
