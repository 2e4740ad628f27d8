// The answer of rotation_check.hpp as text and as JSON.
#include "numeric/identify/report_parts.hpp"
#include "numeric/identify/rotation_check.hpp"

namespace sh::numeric::identify {
namespace {

std::string reading_text(const RotationReading& reading) {
  const auto& [own, world] = reading.presets;
  std::string text = reading.describe();
  if (!own.empty()) text += ": as " + join(own);
  if (!world.empty()) text += (own.empty() ? ": as " : "; ") + join(world) + " with rotations given in our world";
  return text;
}

std::string wrong_text(const WrongEntry& w) {
  return output::formatted("first wrong: line %d, band l=%d, row m=%d, column m=%d: found %s, expected %s%s%s\n",
                           w.line, w.degree, w.row, w.column, number(w.found, 7).c_str(), number(w.expected, 7).c_str(),
                           w.reason.empty() ? "" : ": ", w.reason.c_str());
}

// The case of a band's largest error.
RotationAngles worst_angles(const RotationCheck& result, const BandErrors& band) {
  return angles_of(result.cases.cases[band.worst], result.readings.front().convention.axes);
}

std::string bands_text(const RotationCheck& result) {
  std::string text = output::formatted("%4s  %-13s  %-10s  %-10s  %s\n", "band", "orthogonal to", "true error", "limit",
                                       "worst: line, radians from identity, from a half turn, tilt of the polar axis");
  for (const BandErrors& band : result.bands) {
    const auto [identity, half_turn, tilt] = worst_angles(result, band);
    text += output::formatted("%4d  %-13.1e  %-10.1e  %-10.1e  %d, %.2g, %.2g, %.2g\n", band.degree, band.defect,
                              band.error, band.limit, result.cases.cases[band.worst].line, identity, half_turn, tilt);
  }
  return text;
}

std::string failing_text(const RotationCheck& result) {
  if (result.failing.empty()) return "every rotation is within the limit\n";
  double defect = 0;
  double error = 0;
  for (const BandErrors& band : result.bands) {
    defect = std::max(defect, band.defect);
    error = std::max(error, band.error);
  }
  std::string text = output::formatted(
      "%zu of %zu rotations are wrong, the first on line %d: orthogonal to %.1e, wrong by up to %.1e\n",
      result.failing.size(), result.cases.cases.size(), result.cases.cases[result.failing.front()].line, defect, error);
  text += "largest error by how far the polar axis is tilted, or from turned over:\n";
  for (const TiltErrors& tilts : result.tilts) {
    text +=
        output::formatted("  %7.0e to %7.1e  %4d rotations  %.1e\n", tilts.from, tilts.to, tilts.cases, tilts.error);
  }
  return result.diagnosis.empty() ? text : text + "diagnosis: " + result.diagnosis + "\n";
}

Json reading_json(const RotationReading& reading) {
  return {{"description", reading.describe()},
          {"complex", reading.convention.complex},
          {"condon_shortley", reading.convention.condon_shortley},
          {"order", name_of(reading.convention.order)},
          {"axes", reading.convention.axes.to_string()},
          {"inverse", reading.inverse},
          {"transposed", reading.transposed},
          {"presets", reading.presets.own},
          {"presets_in_world", reading.presets.world}};
}

Json band_json(const RotationCheck& result, const BandErrors& band) {
  const auto [identity, half_turn, tilt] = worst_angles(result, band);
  return {{"degree", band.degree},
          {"orthogonality_defect", band.defect},
          {"error", band.error},
          {"limit", band.limit},
          {"worst",
           {{"line", result.cases.cases[band.worst].line},
            {"from_identity", identity},
            {"from_half_turn", half_turn},
            {"tilt", tilt}}}};
}

Json wrong_json(const WrongEntry& w) {
  return {{"line", w.line},
          {"degree", w.degree},
          {"row", w.row},
          {"column", w.column},
          {"found", complex_json(w.found)},
          {"expected", complex_json(w.expected)},
          {"reason", w.reason}};
}

}  // namespace

std::string format_text(const RotationCheck& result, bool all_readings) {
  std::string text = output::formatted("%s: %zu rotations, degree %d\n", result.cases.file.c_str(),
                                       result.cases.cases.size(), result.cases.degree);
  text += result.fits ? "convention: " : "no convention fits; the nearest is ";
  text += reading_text(result.readings.front()) + "\n";
  for (const WrongEntry& w : result.wrong) text += wrong_text(w);
  if (result.fits) {
    text += bands_text(result);
    if (result.between_bands > 0)
      text += output::formatted("largest entry between bands: %.1e\n", result.between_bands);
    text += failing_text(result);
  }
  return text + other_readings(result.readings, all_readings, "", reading_text);
}

std::string format_json(const RotationCheck& result) {
  Json json = {
      {"file", result.cases.file},     {"degree", result.cases.degree}, {"rotations", result.cases.cases.size()},
      {"fits", result.fits},           {"passes", result.passes()},     {"between_bands", result.between_bands},
      {"diagnosis", result.diagnosis}, {"readings", Json::array()},     {"bands", Json::array()},
      {"failing_lines", Json::array()}};
  if (!result.wrong.empty()) json["first_wrong"] = wrong_json(result.wrong.front());
  for (const auto& reading : result.readings) json["readings"].push_back(reading_json(reading));
  for (const auto& band : result.bands) json["bands"].push_back(band_json(result, band));
  for (const std::size_t i : result.failing) json["failing_lines"].push_back(result.cases.cases[i].line);
  return json.dump(2) + "\n";
}

}  // namespace sh::numeric::identify
