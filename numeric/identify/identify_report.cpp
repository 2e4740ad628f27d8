// The answer of identify.hpp as text and as JSON.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "numeric/identify/identify.hpp"
#include "numeric/output/formatted.hpp"

namespace sh::numeric::identify {
namespace {

using Json = nlohmann::ordered_json;
using Complex = std::complex<double>;

std::string join(const std::vector<std::string>& words, const char* between = ", ") {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

std::string number(Complex value) {
  return value.imag() == 0 ? output::formatted("%.9g", value.real())
                           : output::formatted("%.9g%+.9gi", value.real(), value.imag());
}

std::string name_of(const Coefficient& c) {
  if (c.function.is_hole()) return output::formatted("coefficient %d (a hole)", c.index);
  return output::formatted("coefficient %d (l=%d, m=%d)", c.index, c.function.degree, c.function.order);
}

// What values of functions cannot show of the presets named.
std::string folded_note(const Identification& result) {
  std::vector<std::string> names;
  for (const Preset& preset : presets()) {
    const bool named = std::any_of(result.readings.begin(), result.readings.end(), [&](const Reading& reading) {
      return std::count(reading.presets.begin(), reading.presets.end(), preset.name) > 0;
    });
    if (named && preset.coefficients_hold != Folded::kNothing) names.push_back(preset.name);
  }
  if (names.empty()) return "";
  return "note: coefficients of " + join(names, " and ") +
         " hold A_l / pi too, which values of functions cannot show\n";
}

// "presets directxmath, gaussian-splatting; unreal where directions are in our world's axes".
std::string presets_text(const Reading& reading) {
  std::vector<std::string> parts;
  if (!reading.presets.empty()) {
    parts.push_back((reading.presets.size() > 1 ? "presets " : "preset ") + join(reading.presets));
  }
  if (!reading.world_presets.empty()) {
    parts.push_back("preset " + join(reading.world_presets) +
                    " with directions given in our world (x right, y forward, z up)");
  }
  return join(parts, "; ");
}

std::string handedness(const Reading& reading) {
  return reading.convention.axes.determinant() < 0 ? " (mirrored: the other handedness)" : "";
}

std::string reading_text(const Reading& reading) {
  const auto presets = presets_text(reading);
  return describe(reading.convention) + handedness(reading) + (presets.empty() ? "" : ": " + presets);
}

std::string wrong_text(const Samples& samples, const Coefficient& c) {
  return name_of(c) + ": " + c.reason +
         output::formatted("; on line %d found %s, expected %s\n", samples.lines[c.worst_row], number(c.found).c_str(),
                           number(c.expected).c_str());
}

std::string wrong_list(const Samples& samples, const std::vector<Coefficient>& coefficients) {
  constexpr int kMost = 10;
  std::string text;
  int count = 0;
  for (const auto& c : coefficients) {
    if (!c.wrong) continue;
    ++count;
    if (count <= kMost) text += (count == 1 ? "first wrong: " : "then ") + wrong_text(samples, c);
  }
  return text + (count > kMost ? output::formatted("and %d more\n", count - kMost) : "");
}

// Worst agreement and rounded constants of the coefficients that fit.
std::string agreement_text(const Identification& result) {
  const Coefficient* worst = nullptr;
  std::string rounded;
  for (const auto& c : result.coefficients) {
    if (c.wrong || c.function.is_hole()) continue;
    if (worst == nullptr || c.deviation > worst->deviation) worst = &c;
    if (!c.reason.empty()) {
      rounded += "warning: " + name_of(c) + ": " + c.reason +
                 output::formatted("; relative deviation %.1e\n", std::abs(c.ratio - Complex(1)));
    }
  }
  if (worst == nullptr) return "";
  return output::formatted("the %s agree to %.1f digits; worst is %s on line %d, found %s, expected %s\n",
                           result.fits() ? "values" : "others", result.digits(), name_of(*worst).c_str(),
                           result.samples.lines[worst->worst_row], number(worst->found).c_str(),
                           number(worst->expected).c_str()) +
         rounded;
}

// The readings after the first: those that are presets, the rest counted or listed.
std::string other_readings(const Identification& result, bool all_readings) {
  constexpr std::size_t kFew = 4;
  std::string text;
  int hidden = 0;
  for (std::size_t i = 1; i < result.readings.size(); ++i) {
    const Reading& reading = result.readings[i];
    const bool shown =
        all_readings || result.readings.size() <= kFew || !reading.presets.empty() || !reading.world_presets.empty();
    if (shown) text += "  or: " + reading_text(reading) + "\n";
    hidden += shown ? 0 : 1;
  }
  if (hidden > 0)
    text += output::formatted("  or: %d further readings that are no preset (--all lists them)\n", hidden);
  if (text.empty()) return "";
  const char* why = result.samples.degree <= 1 ? "; values of degree 2 or more can tell most of them apart" : "";
  return output::formatted("%zu readings are the same on these data%s:\n", result.readings.size(), why) + text;
}

std::string doubt_text(const Identification& result) {
  if (result.doubts.empty()) return "";
  std::string text = output::formatted("that is no preset, and degree %d cannot tell it from a wrong coefficient:\n",
                                       result.samples.degree);
  for (const Doubt& doubt : result.doubts) {
    text += "as " + reading_text(doubt.reading) + ",\n  " + wrong_list(result.samples, doubt.wrong);
  }
  return text;
}

Json complex_json(Complex value) {
  if (value.imag() == 0) return value.real();
  return {{"re", value.real()}, {"im", value.imag()}};
}

Json reading_json(const Reading& reading) {
  const Convention& c = reading.convention;
  return {{"complex", c.complex},
          {"normalisation", name_of(c.normalisation)},
          {"condon_shortley", c.condon_shortley},
          {"order", name_of(c.order)},
          {"folded", name_of(c.folded)},
          {"axes", c.axes.to_string()},
          {"mirrored", c.axes.determinant() < 0},
          {"presets", reading.presets},
          {"presets_in_world", reading.world_presets}};
}

Json coefficient_json(const Samples& samples, const Coefficient& c) {
  Json json = {{"index", c.index}};
  if (!c.function.is_hole()) {
    json["degree"] = c.function.degree;
    json["order"] = c.function.order;
  }
  json["ratio"] = complex_json(c.ratio);
  json["deviation"] = c.deviation;
  json["line"] = samples.lines[c.worst_row];
  json["found"] = complex_json(c.found);
  json["expected"] = complex_json(c.expected);
  json["wrong"] = c.wrong;
  if (!c.reason.empty()) json["reason"] = c.reason;
  return json;
}

}  // namespace

std::string format_text(const Identification& result, bool all_readings) {
  const Samples& s = result.samples;
  std::string text = output::formatted("%s: %zu directions, %zu values each, degree %d\n", s.file.c_str(),
                                       s.directions.size(), s.columns.size(), s.degree);
  const bool fits = result.fits();
  if (!fits) {
    const auto wrong =
        std::count_if(result.coefficients.begin(), result.coefficients.end(), [](const auto& c) { return c.wrong; });
    text += output::formatted("no convention fits; the nearest explains %zu of %zu coefficients:\n",
                              result.coefficients.size() - static_cast<std::size_t>(wrong), result.coefficients.size());
  }
  text += (fits ? "convention: " : "") + reading_text(result.readings.front()) + "\n";
  if (!fits) text += wrong_list(s, result.coefficients);
  return text + agreement_text(result) + folded_note(result) + doubt_text(result) +
         other_readings(result, all_readings);
}

std::string format_json(const Identification& result) {
  const Coefficient* wrong = result.first_wrong();
  Json json = {{"file", result.samples.file},
               {"degree", result.samples.degree},
               {"directions", result.samples.directions.size()},
               {"recognised", result.recognised()},
               {"digits", result.digits()},
               {"first_wrong", wrong == nullptr ? Json() : coefficient_json(result.samples, *wrong)},
               {"readings", Json::array()},
               {"coefficients", Json::array()}};
  for (const auto& reading : result.readings) json["readings"].push_back(reading_json(reading));
  for (const auto& c : result.coefficients) json["coefficients"].push_back(coefficient_json(result.samples, c));
  for (const Doubt& doubt : result.doubts) {
    json["doubts"].push_back(reading_json(doubt.reading));
    for (const auto& c : doubt.wrong) json["doubts"].back()["wrong"].push_back(coefficient_json(result.samples, c));
  }
  return json.dump(2) + "\n";
}

}  // namespace sh::numeric::identify
