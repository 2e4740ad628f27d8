#include "prt/study/error_picture.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "numeric/plot/canvas.hpp"
#include "prt/runtime/render.hpp"

namespace sh::prt {

namespace {

namespace plot = numeric::plot;

constexpr std::array<plot::Color, 5> kStops = {
    {{16, 14, 30}, {78, 28, 120}, {190, 44, 92}, {242, 130, 34}, {252, 246, 170}}};  // a decade apart
constexpr plot::Color kBackground{228, 230, 233};
constexpr double kUnits = 960.0;  // the width of the figure; text keeps its part of it
constexpr double kTitle = 40.0;
constexpr double kBar = 66.0;
constexpr double kText = 16.0;

plot::Raster paint(const ErrorMap& map) {
  plot::Raster raster(map.width, map.height);
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      const int pixel = row * map.width + column;
      const auto place = static_cast<double>(map.place[pixel]);
      raster.set(column, row, plot::blend(kBackground, false_color(place), static_cast<double>(map.coverage[pixel])));
    }
  }
  return raster;
}

void draw_bar(plot::Canvas& canvas, double top) {
  constexpr double kLeft = 24.0;
  constexpr double kLength = 520.0;
  constexpr double kHeight = 16.0;
  const plot::PixelBox where = canvas.pixels({kLeft, top, kLength, kHeight});
  plot::Raster bar(where.width, where.height);
  for (int row = 0; row < bar.height; ++row) {
    for (int column = 0; column < bar.width; ++column) bar.set(column, row, false_color((column + 0.5) / bar.width));
  }
  canvas.image(where, bar);
  const int decades = static_cast<int>(std::lround(std::log10(kMostShownError / kLeastShownError)));
  for (int i = 0; i <= decades; ++i) {
    const double x = kLeft + kLength * i / decades;
    const std::string text = fmt::format("{:g} %", 100.0 * kLeastShownError * std::pow(10.0, i));
    const auto anchor = i == 0 ? plot::Anchor::kStart : i == decades ? plot::Anchor::kEnd : plot::Anchor::kMiddle;
    canvas.text({x, top + kHeight + 20.0}, text, kText, anchor, plot::kInk);
  }
  canvas.text({kLeft + kLength + 24.0, top + kHeight - 2.0}, "of the reference's rms exit radiance", kText,
              plot::Anchor::kStart, plot::kInk);
}

}  // namespace

float error_place(double relative_error) {
  if (std::isnan(relative_error)) return 1.0F;
  const double place = std::log(std::max(relative_error, kLeastShownError) / kLeastShownError) /
                       std::log(kMostShownError / kLeastShownError);
  return static_cast<float>(std::min(place, 1.0));
}

plot::Color false_color(double place) {
  const double at = std::clamp(place, 0.0, 1.0) * static_cast<double>(kStops.size() - 1);
  const auto first = std::min(static_cast<std::size_t>(at), kStops.size() - 2);
  return plot::blend(kStops[first], kStops[first + 1], at - static_cast<double>(first));
}

std::string error_png(const ErrorMap& map, const std::string& title) {
  const double height = kUnits * map.height / map.width;
  const auto canvas = plot::png_canvas(kUnits, kTitle + height + kBar, map.width);
  canvas->text({24.0, 27.0}, title, 1.1 * kText, plot::Anchor::kStart, plot::kInk);
  plot::PixelBox where = canvas->pixels({0.0, kTitle, kUnits, height});
  where.width = map.width;
  where.height = map.height;
  canvas->image(where, paint(map));
  draw_bar(*canvas, kTitle + height + 14.0);
  return canvas->finish();
}

std::string error_picture(const Mesh& mesh, const Tracer& tracer, const std::vector<float>& relative_errors,
                          const Camera& camera, const PictureSize& size, const std::string& title,
                          const std::string& what) {
  std::vector<Eigen::Vector3f> places;
  places.reserve(relative_errors.size());
  for (const float error : relative_errors) {
    places.emplace_back(Eigen::Vector3f::Constant(error_place(static_cast<double>(error))));
  }
  const Background nothing = [](const Eigen::Vector3f& /*direction*/) { return Eigen::Vector3f::Zero().eval(); };
  Mesh shown = mesh;
  shown.mirror.clear();  // errors are those of the vertices themselves
  const Picture picture = render(shown, tracer, diffuse_surface(shown, places), camera, size, nothing, what);
  ErrorMap map{picture.width, picture.height, {}, picture.coverage};
  for (std::size_t i = 0; i < picture.radiance.size(); ++i) {
    map.place.push_back(picture.coverage[i] > 0.0F ? picture.radiance[i].x() / picture.coverage[i] : 0.0F);
  }
  return error_png(map, title);
}

}  // namespace sh::prt
