// Parts of the study that need no rays: storage types, and windows on the light.
#include <array>

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

StudyPoint stored(const StudySetup& setup, Element element, int degree, const Radiances& reference) {
  TransferShape shape = kShadowed.shape(degree);
  shape.storage.element = element;
  const TransferRows back{degree, decode(encode(truncated(setup.reference, degree).values, shape), shape)};
  const auto bytes = static_cast<double>(shape.row_bytes());
  return {.at = bytes,
          .error = radiance_error(setup.vertices, setup.relit(back, setup.light, degree), reference),
          .coefficient_error = coefficient_error(back, setup.reference),
          .bytes_a_vertex = bytes};
}

// Reaches 0 at the first omitted degree.
WindowChoice fixed(WindowType type, int degree) {
  WindowChoice choice;
  choice.window = {type, degree + 1.0, 1};
  choice.automatic = false;
  return choice;
}

struct NamedWindow {
  const char* name;
  void (*apply)(int degree, LightCoefficients& light);
};

constexpr std::array kWindows = {
    NamedWindow{"none", [](int, LightCoefficients&) {}},
    NamedWindow{"sinc (Lanczos)",
                [](int d, LightCoefficients& light) { apply_window(fixed(WindowType::kSinc, d), light); }},
    NamedWindow{"hann", [](int d, LightCoefficients& light) { apply_window(fixed(WindowType::kHann, d), light); }},
    NamedWindow{"auto: least window without negative values",
                [](int, LightCoefficients& light) { apply_window(WindowChoice(), light); }}};

}  // namespace

StudyPart study_storage(const StudySetup& setup) {
  StudyPart part{.name = "storage", .axis = "bytes a vertex, by degree", .reference = setup.all_degrees_name()};
  const Radiances reference = setup.all_degrees();
  for (const Element element : {Element::kSingle, Element::kHalf, Element::kByte}) {
    StudySeries series{.name = std::string(word_of(element, kElementNames))};
    for (int degree = 1; degree <= kMaxDegree - (setup.whole ? 0 : 1); ++degree) {
      series.points.push_back(stored(setup, element, degree, reference));
    }
    part.series.push_back(series);
  }
  return part;
}

StudyPart study_windows(const StudySetup& setup) {
  StudyPart part{.name = "windows", .axis = "bands (degree + 1)", .reference = setup.all_degrees_name()};
  const Radiances reference = setup.all_degrees();
  for (const auto& [name, apply] : kWindows) {
    StudySeries series{.name = name};
    for (int degree = 1; degree <= kMaxDegree - (setup.whole ? 0 : 1); ++degree) {
      LightCoefficients light = first_bands(setup.light, degree);
      apply(degree, light);
      series.points.push_back(
          {.at = degree + 1.0,
           .error = radiance_error(setup.vertices, setup.relit(setup.reference, light, degree), reference)});
    }
    part.series.push_back(series);
  }
  return part;
}

}  // namespace sh::prt
