// report_json and read_report of report.hpp: the schema is in numeric/README.md.
#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "numeric/output/parse_json.hpp"
#include "numeric/output/printable.hpp"
#include "numeric/output/read_file.hpp"
#include "numeric/report/report.hpp"

namespace sh::numeric {
namespace {

using Json = nlohmann::ordered_json;
constexpr const char* kFormat = "shforge report 1";

Json worst_json(const WorstCase& worst) {
  constexpr std::size_t kMostWritten = 16;
  Json json = {{"input", worst.input}, {"output", worst.output}};
  if (worst.values.size() <= kMostWritten) json["values"] = worst.values;
  return json;
}

// JSON knows no infinity.
Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json point_json(const Point& p) {
  return {{"task", p.info.task},
          {"degree", p.info.degree},
          {"method", p.info.name},
          {"scalar", p.info.scalar},
          {"mode", to_string(p.info.mode)},
          {"ns", p.nanoseconds},
          {"error", number(p.error)},
          {"error_eps", number(p.error_eps)},
          {"unit", p.unit},
          {"inputs", p.inputs},
          {"worst", worst_json(p.worst)},
          {"on_front", p.on_front},
          {"header", p.info.header},
          {"call", p.info.call},
          {"leaves_out", p.info.leaves_out},
          {"source", p.info.source}};
}

Json series_json(const ConvergenceSeries& s) {
  Json points = Json::array();
  for (const auto& p : s.points) {
    points.push_back(
        {{"samples", p.samples}, {"error_rms", p.error_rms}, {"error_max", p.error_max}, {"ns", p.nanoseconds}});
  }
  return {{"rule", s.rule}, {"function", s.function}, {"seeds", s.seeds}, {"points", points}};
}

Json claim_json(const SourceClaim& c) {
  return {{"id", c.id},
          {"claim", c.claim},
          {"source", c.source},
          {"printed", c.printed},
          {"measured", c.measured},
          {"unit", c.unit},
          {"reproduced", c.reproduced},
          {"how", c.how}};
}

Mode mode_of(const std::string& text) {
  const auto found = std::find_if(kModes.begin(), kModes.end(), [&](Mode mode) { return text == to_string(mode); });
  if (found == kModes.end()) throw std::runtime_error("'mode': expected one, prepared or batch, got '" + text + "'");
  return *found;
}

double error_of(const Json& value) {
  const double error = value.is_null() ? std::numeric_limits<double>::infinity() : value.get<double>();
  if (!(error >= 0)) throw std::runtime_error("an error: expected 0 or more, got " + std::to_string(error));
  return error;
}

// A whole number. The library would cut 2.5 to 2 and take -1 for the largest.
template <class Whole>
Whole whole_of(const Json& json, const char* key) {
  const Json& value = json.at(key);
  constexpr std::uint64_t kMost = std::numeric_limits<Whole>::max();
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() > kMost) {
    throw std::runtime_error("'" + std::string(key) + "': expected a whole number from 0 to " + std::to_string(kMost) +
                             ", got " + value.dump());
  }
  return value.get<Whole>();
}

// One statement a member: where a member after one in braces throws, g++ 12 destroys that one twice.
Point point_of(const Json& json) {
  Point point;
  point.info = {.task = json.at("task"),
                .name = json.at("method"),
                .degree = whole_of<int>(json, "degree"),
                .scalar = json.at("scalar"),
                .mode = mode_of(json.at("mode")),
                .header = json.at("header"),
                .call = json.at("call"),
                .leaves_out = json.at("leaves_out"),
                .source = json.at("source")};
  point.nanoseconds = json.at("ns");
  point.error = error_of(json.at("error"));
  point.error_eps = error_of(json.at("error_eps"));
  point.unit = json.at("unit");
  point.inputs = whole_of<std::size_t>(json, "inputs");
  point.worst.input = json.at("worst").at("input");
  point.worst.output = json.at("worst").at("output");
  point.on_front = json.at("on_front");
  if (!(point.nanoseconds > 0))
    throw std::runtime_error("'ns': expected a positive number, got " + std::to_string(point.nanoseconds));
  return point;
}

}  // namespace

std::string report_json(const Report& report) {
  Json json = {
      {"format", kFormat},
      {"machine", report.machine},
      {"instruction_set", report.instruction_set},
      {"quick", report.quick},
      {"seconds", report.seconds},
      {"convention", "orthonormal real spherical harmonics, no Condon-Shortley phase, index l(l+1)+m, z polar"},
      {"points", Json::array()},
      {"convergence", Json::array()},
      {"claims", Json::array()}};
  for (const auto& point : report.points) json["points"].push_back(point_json(point));
  for (const auto& series : report.convergence) json["convergence"].push_back(series_json(series));
  for (const auto& claim : report.claims) json["claims"].push_back(claim_json(claim));
  return json.dump(1) + "\n";
}

std::vector<Point> read_report(const std::string& file) {
  const std::string text = output::read_file(file);
  std::vector<Point> points;
  try {
    const auto json = output::parse_json<Json>(text);
    if (json.at("format") != kFormat) throw std::runtime_error(std::string("'format': expected '") + kFormat + "'");
    for (const auto& point : json.at("points")) points.push_back(point_of(point));
  } catch (const std::exception& error) {
    throw std::runtime_error(file + ": expected a report of shcheck: " + output::printable(error.what()));
  }
  return points;
}

}  // namespace sh::numeric
