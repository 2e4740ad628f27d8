// Camera and draw_surface of lobes.hpp.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "numeric/output/progress.hpp"
#include "numeric/plot/lobes.hpp"

namespace sh::numeric::plot {
namespace {

constexpr int kSamples = 3;     // a side of a pixel
constexpr int kStripRows = 16;  // pixels; bounds the memory of a large picture

// Lambert's law softened towards the terminator, and a weak highlight [Blinn77].
class Light {
 public:
  explicit Light(const Camera& camera)
      : light_((-0.45 * camera.right + 0.6 * camera.up + 0.75 * camera.toward).normalized()),
        half_((light_ + camera.toward).normalized()) {}

  [[nodiscard]] LinearColor shade(const LinearColor& paint, const Vector3& normal) const {
    const Vector3 n = normal.normalized();
    const double diffuse = std::max(0.0, (n.dot(light_) + 0.25) / 1.25);
    const double highlight = 0.18 * std::pow(std::max(0.0, n.dot(half_)), 40);
    LinearColor out{};
    for (std::size_t i = 0; i < 3; ++i) out[i] = paint[i] * (0.22 + 1.05 * diffuse) + highlight;
    return out;
  }

 private:
  Vector3 light_, half_;
};

struct Corner {
  double x, y, depth;  // samples, y down; depth towards the viewer
  Vector3 normal;
};

// Rows [first, first + rows) of the picture, in samples.
class Strip {
 public:
  Strip(int width, int first, int rows)
      : width_(width * kSamples),
        first_(first * kSamples),
        rows_(rows * kSamples),
        depth_(count(), kNothing),
        color_(count(), {1, 1, 1}) {}

  void draw(const Corner& a, const Corner& b, const Corner& c, const LinearColor& paint, const Light& light) {
    const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    if (area == 0) return;
    const auto [low_x, high_x] = range(a.x, b.x, c.x, 0, width_);
    const auto [low_y, high_y] = range(a.y, b.y, c.y, first_, first_ + rows_);
    for (int row = low_y; row < high_y; ++row) {
      for (int column = low_x; column < high_x; ++column) {
        const double x = column + 0.5;
        const double y = row + 0.5;
        const double u = ((b.x - x) * (c.y - y) - (b.y - y) * (c.x - x)) / area;
        const double v = ((c.x - x) * (a.y - y) - (c.y - y) * (a.x - x)) / area;
        const double w = 1 - u - v;
        if (u < 0 || v < 0 || w < 0) continue;
        const double depth = u * a.depth + v * b.depth + w * c.depth;
        const std::size_t i = place(column, row);
        if (depth <= depth_[i]) continue;
        depth_[i] = depth;
        color_[i] = light.shade(paint, u * a.normal + v * b.normal + w * c.normal);
      }
    }
  }

  // The mean of a pixel's samples.
  [[nodiscard]] Color pixel(int column, int row) const {
    LinearColor sum{};
    for (int k = 0; k < kSamples * kSamples; ++k) {
      const auto& sample = color_[place(column * kSamples + k % kSamples, row * kSamples + k / kSamples)];
      for (std::size_t i = 0; i < 3; ++i) sum[i] += std::min(1.0, sample[i]) / (kSamples * kSamples);
    }
    return encode(sum);
  }

 private:
  static constexpr double kNothing = -std::numeric_limits<double>::infinity();

  [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(width_) * static_cast<std::size_t>(rows_); }

  // Of a sample.
  [[nodiscard]] std::size_t place(int column, int row) const {
    return static_cast<std::size_t>(row - first_) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(column);
  }

  // Samples whose center is between the least and the largest.
  static std::pair<int, int> range(double a, double b, double c, int from, int to) {
    const double low = std::clamp(std::ceil(std::min({a, b, c}) - 0.5), double(from), double(to));
    const double high = std::clamp(std::floor(std::max({a, b, c}) - 0.5) + 1, double(from), double(to));
    return {static_cast<int>(low), static_cast<int>(high)};
  }

  int width_, first_, rows_;
  std::vector<double> depth_;
  std::vector<LinearColor> color_;
};

Raster render(const Surface& surface, const Camera& camera, int width, int height, double pixels_a_unit) {
  Raster picture(width, height);
  const Light light(camera);
  std::vector<Corner> corners;
  for (const auto& vertex : surface.vertices) {
    const Vector3 p = camera.project(vertex.position);
    corners.push_back({kSamples * (width / 2.0 + pixels_a_unit * p[0]),
                       kSamples * (height / 2.0 - pixels_a_unit * p[1]), p[2], vertex.normal});
  }
  output::Progress progress("plot", height);
  for (int first = 0; first < height; first += kStripRows) {
    const int rows = std::min(kStripRows, height - first);
    Strip strip(width, first, rows);
    for (const auto& facet : surface.facets) {
      const auto corner = [&](int k) -> const Corner& { return corners[facet.corners[k]]; };
      for (int k = 1; k + 1 < facet.count; ++k) strip.draw(corner(0), corner(k), corner(k + 1), facet.paint, light);
    }
    for (int row = first; row < first + rows; ++row) {
      for (int column = 0; column < width; ++column) picture.set(column, row, strip.pixel(column, row));
    }
    progress.advance(rows);
  }
  return picture;
}

double signed_area(const std::vector<Point>& corners) {
  double sum = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const auto& a = corners[k];
    const auto& b = corners[(k + 1) % corners.size()];
    sum += a.x * b.y - b.x * a.y;
  }
  return sum / 2;
}

// Facets that face the viewer, back to front by their mean depth.
std::vector<Polygon> visible_facets(const Surface& surface, const Camera& camera, const Point& center, double unit) {
  const Light light(camera);
  std::vector<std::pair<double, Polygon>> facets;
  for (const auto& facet : surface.facets) {
    Polygon flat;
    double depth = 0;
    Vector3 normal = Vector3::Zero();
    for (int k = 0; k < facet.count; ++k) {
      const auto& vertex = surface.vertices[facet.corners[k]];
      const Vector3 p = camera.project(vertex.position);
      flat.corners.push_back({center.x + unit * p[0], center.y - unit * p[1]});
      depth += p[2] / facet.count;
      normal += vertex.normal;
    }
    constexpr double kSmallest = 0.01;  // square units; counter-clockwise is negative where y is down
    if (-signed_area(flat.corners) < kSmallest) continue;
    flat.fill = encode(light.shade(facet.paint, normal));
    facets.emplace_back(depth, std::move(flat));
  }
  std::stable_sort(facets.begin(), facets.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Polygon> polygons;
  polygons.reserve(facets.size());
  for (auto& facet : facets) polygons.push_back(std::move(facet.second));
  return polygons;
}

}  // namespace

Camera::Camera(const View& view) {
  const double a = view.azimuth * std::numbers::pi / 180;
  const double e = view.elevation * std::numbers::pi / 180;
  right = {-std::sin(a), std::cos(a), 0};
  up = {-std::sin(e) * std::cos(a), -std::sin(e) * std::sin(a), std::cos(e)};
  toward = {std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)};
}

void draw_surface(Canvas& canvas, const Surface& surface, const Camera& camera, const Box& box, double unit,
                  bool facets) {
  if (facets && canvas.is_vector()) {
    const Point center{box.x + box.width / 2, box.y + box.height / 2};
    canvas.facets(visible_facets(surface, camera, center, unit));
    return;
  }
  const PixelBox where = canvas.pixels(box);
  canvas.image(where, render(surface, camera, where.width, where.height, unit * canvas.scale()));
}

}  // namespace sh::numeric::plot
