// Parts of the study that need no rays: storage types, and windows on the light.
#include <algorithm>
#include <cmath>

#include "prt/light/deringing.hpp"
#include "prt/light/window.hpp"
#include "prt/study/study_setup.hpp"
#include "prt/transfer/storage.hpp"

namespace sh::prt {

namespace {

TransferRows truncated(const TransferRows& rows, int degree) {
  const std::size_t count = coefficient_count(degree);
  TransferRows result{degree, {}};
  for (std::size_t i = 0; i * coefficient_count(rows.degree) < rows.values.size(); ++i) {
    result.values.insert(result.values.end(), rows.row(i), rows.row(i) + count);
  }
  return result;
}

CoefficientError difference(const std::vector<float>& a, const std::vector<float>& b) {
  CoefficientError error;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double d = std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i]));
    error.rms += d * d / static_cast<double>(a.size());
    error.largest = std::max(error.largest, d);
  }
  error.rms = std::sqrt(error.rms);
  return error;
}

StudyPoint stored(const StudySetup& setup, Element element, int degree, const Radiances& reference) {
  const TransferRows rows = truncated(setup.reference, degree);
  TransferShape shape = kShadowed.shape(degree);
  shape.storage.element = element;
  const TransferRows back{degree, decode(encode(rows.values, shape), shape)};
  StudyPoint point;
  point.bytes_a_vertex = static_cast<double>(shape.count() * bytes_of(element));
  point.at = *point.bytes_a_vertex;
  point.error = radiance_error(setup.vertices, setup.relit(back, setup.light, degree), reference);
  point.coefficient_error = difference(back.values, rows.values);
  return point;
}

struct NamedWindow {
  const char* name;
  std::optional<WindowChoice> (*of_degree)(int degree);
};

WindowChoice fixed(WindowType type, int degree) {
  WindowChoice choice;
  choice.window = {type, degree + 1.0, 1};
  choice.automatic = false;
  return choice;
}

// Fixed windows reach 0 at the first omitted degree.
const std::vector<NamedWindow>& windows() {
  static const std::vector<NamedWindow> kWindows = {
      {"none", [](int) -> std::optional<WindowChoice> { return std::nullopt; }},
      {"sinc (Lanczos)", [](int d) -> std::optional<WindowChoice> { return fixed(WindowType::kSinc, d); }},
      {"hann", [](int d) -> std::optional<WindowChoice> { return fixed(WindowType::kHann, d); }},
      {"auto: least window without negative values",
       [](int) -> std::optional<WindowChoice> { return WindowChoice(); }}};
  return kWindows;
}

}  // namespace

StudyPart study_storage(const StudySetup& setup) {
  StudyPart part;
  part.name = "storage";
  part.axis = "bytes a vertex, by degree";
  part.reference = setup.all_degrees_name();
  const Radiances reference = setup.all_degrees();
  for (const Element element : {Element::kSingle, Element::kHalf, Element::kByte}) {
    StudySeries series;
    series.name = kElementNames[static_cast<std::size_t>(element)];
    for (int degree = 1; degree <= kMaxDegree - (setup.whole ? 0 : 1); ++degree) {
      series.points.push_back(stored(setup, element, degree, reference));
    }
    part.series.push_back(series);
  }
  return part;
}

StudyPart study_windows(const StudySetup& setup) {
  StudyPart part;
  part.name = "windows";
  part.axis = "bands (degree + 1)";
  part.reference = setup.all_degrees_name();
  const Radiances reference = setup.all_degrees();
  for (const NamedWindow& window : windows()) {
    StudySeries series;
    series.name = window.name;
    for (int degree = 1; degree <= kMaxDegree - (setup.whole ? 0 : 1); ++degree) {
      LightCoefficients light = first_bands(setup.light, degree);
      if (const auto choice = window.of_degree(degree)) apply_window(*choice, light);
      StudyPoint point;
      point.at = degree + 1;
      point.error = radiance_error(setup.vertices, setup.relit(setup.reference, light, degree), reference);
      series.points.push_back(point);
    }
    part.series.push_back(series);
  }
  return part;
}

}  // namespace sh::prt
