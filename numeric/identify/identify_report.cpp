// The answer of identify.hpp as text and as JSON.
#include <algorithm>
#include <cmath>

#include "numeric/identify/identify.hpp"
#include "numeric/identify/report_parts.hpp"

namespace sh::numeric::identify {
namespace {

std::string name_of(const Coefficient& c) {
  if (c.function.is_hole()) return output::formatted("coefficient %d (a hole)", c.index);
  return output::formatted("coefficient %d (l=%d, m=%d)", c.index, c.function.degree, c.function.order);
}

// The factors of the named presets that values of functions cannot show.
std::string folded_note(const Identification& result) {
  std::vector<std::string> names;
  for (const Preset& preset : presets()) {
    const bool named = std::any_of(result.readings.begin(), result.readings.end(), [&](const Reading& reading) {
      return std::count(reading.presets.own.begin(), reading.presets.own.end(), preset.name) > 0;
    });
    if (named && preset.coefficients_hold != Folded::kNothing) names.push_back(preset.name);
  }
  if (names.empty()) return "";
  return "note: coefficients of " + join(names, " and ") +
         " hold A_l / pi too, which values of functions cannot show\n";
}

// "presets directxmath, gaussian-splatting; preset unreal with directions given in our world (...)".
std::string presets_text(const PresetNames& presets) {
  std::vector<std::string> parts;
  if (!presets.own.empty()) parts.push_back((presets.own.size() > 1 ? "presets " : "preset ") + join(presets.own));
  if (!presets.world.empty()) {
    parts.push_back("preset " + join(presets.world) + " with directions given in our world (x right, y forward, z up)");
  }
  return join(parts, "; ");
}

std::string reading_text(const Reading& reading) {
  const bool mirrored = reading.convention.axes.determinant() < 0;
  return describe(reading.convention) + (mirrored ? " (mirrored: the other handedness)" : "") +
         (reading.presets.empty() ? "" : ": ") + presets_text(reading.presets);
}

std::string wrong_text(const Samples& samples, const Coefficient& c) {
  return name_of(c) + ": " + c.reason +
         output::formatted("; on line %d found %s, expected %s\n", samples.lines[c.worst_row],
                           number(c.found, 9).c_str(), number(c.expected, 9).c_str());
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
                 output::formatted("; relative deviation %.1e\n", std::abs(c.ratio - 1.0));
    }
  }
  if (worst == nullptr) return "";
  return output::formatted("the %s agree to %.1f digits; worst is %s on line %d, found %s, expected %s\n",
                           result.fits() ? "values" : "others", result.digits(), name_of(*worst).c_str(),
                           result.samples.lines[worst->worst_row], number(worst->found, 9).c_str(),
                           number(worst->expected, 9).c_str()) +
         rounded;
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

// What is wrong with the whole table, or with single lines of it.
std::string mistake_text(const Identification& result) {
  if (!result.bad_lines.empty()) {
    constexpr std::size_t kMost = 10;
    std::string lines;
    for (std::size_t i = 0; i < std::min(kMost, result.bad_lines.size()); ++i)
      lines += (i > 0 ? ", " : "") + std::to_string(result.bad_lines[i]);
    return output::formatted("%zu of %zu lines contradict all others and are left out: %s%s\n", result.bad_lines.size(),
                             result.bad_lines.size() + result.samples.lines.size(), lines.c_str(),
                             result.bad_lines.size() > kMost ? ", ..." : "");
  }
  if (result.mistake.empty()) return "";
  return "the values fit a convention with this mistake: " + result.mistake + "; without it:\n";
}

std::string noise_text(const Identification& result) {
  constexpr double kWorthSaying = 1e-5;  // beyond what float or six printed digits explain
  if (result.noise <= kWorthSaying) return "";
  return output::formatted("warning: the values carry noise of standard deviation %.1e around sums of functions\n",
                           result.noise);
}

Json reading_json(const Reading& reading) {
  const Convention& c = reading.convention;
  return {{"complex", c.complex},
          {"normalisation", name_of(c.normalization)},
          {"condon_shortley", c.condon_shortley},
          {"order", name_of(c.order)},
          {"folded", name_of(c.folded)},
          {"axes", c.axes.to_string()},
          {"mirrored", c.axes.determinant() < 0},
          {"presets", reading.presets.own},
          {"presets_in_world", reading.presets.world}};
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
    const auto right =
        std::count_if(result.coefficients.begin(), result.coefficients.end(), [](const auto& c) { return !c.wrong; });
    text += output::formatted("no convention fits; the nearest explains %td of %zu coefficients:\n", right,
                              result.coefficients.size());
  }
  text += mistake_text(result);
  text += (fits ? "convention: " : "") + reading_text(result.readings.front()) + "\n";
  if (!fits) text += wrong_list(s, result.coefficients);
  const char* why = s.degree <= 1 ? "; values of degree 2 or more can tell most of them apart" : "";
  return text + agreement_text(result) + noise_text(result) + folded_note(result) + doubt_text(result) +
         other_readings(result.readings, all_readings, why, reading_text);
}

std::string format_json(const Identification& result) {
  const Coefficient* wrong = result.first_wrong();
  Json json = {{"file", result.samples.file},
               {"degree", result.samples.degree},
               {"directions", result.samples.directions.size()},
               {"recognised", result.recognized()},
               {"digits", result.digits()},
               {"mistake", result.mistake},
               {"bad_lines", result.bad_lines},
               {"noise", result.noise},
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
