// report_json of report.hpp: the schema is in README.md.
#include <cmath>
#include <nlohmann/json.hpp>

#include "numeric/report/report.hpp"

namespace sh::numeric {
namespace {

using Json = nlohmann::ordered_json;

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

}  // namespace

std::string report_json(const Report& report) {
  Json json = {
      {"format", "shforge report 1"},
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

}  // namespace sh::numeric
