#include <cmath>
#include <nlohmann/json.hpp>

#include "prt/study/study_output.hpp"

namespace sh::prt {

namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json to_json(const RadianceError& error, const Scene& scene) {
  const Eigen::Vector3f& place = scene.mesh.positions[error.worst_vertex];
  return {{"relative_rms", number(error.rms)},
          {"relative_largest", number(error.largest)},
          {"worst_vertex", error.worst_vertex},
          {"worst_place", {place.x(), place.y(), place.z()}}};
}

Json to_json(const StudyPoint& point, const Scene& scene) {
  Json json = {{"at", point.at}, {"error", to_json(point.error, scene)}};
  if (point.exact_error) json["error_against_closed_answer"] = to_json(*point.exact_error, scene);
  if (point.coefficient_error) {
    json["coefficient_error"] = {{"rms", point.coefficient_error->rms}, {"largest", point.coefficient_error->largest}};
  }
  if (point.bytes_a_vertex) json["bytes_a_vertex"] = *point.bytes_a_vertex;
  if (point.seconds) {
    json["passes"] = point.passes;
    json["time"] = {{"seconds_a_vertex", *point.seconds_a_vertex}, {"seconds_of_scene", *point.seconds}};
  }
  return json;
}

Json to_json(const StudySeries& series, const Scene& scene) {
  Json json = {{"name", series.name}};
  if (series.slope) json["slope"] = *series.slope;
  json["points"] = Json::array();
  for (const StudyPoint& point : series.points) json["points"].push_back(to_json(point, scene));
  return json;
}

Json to_json(const StudyPart& part, const Scene& scene) {
  Json json = {{"name", part.name}, {"axis", part.axis}, {"reference", part.reference}, {"series", Json::array()}};
  for (const StudySeries& series : part.series) json["series"].push_back(to_json(series, scene));
  for (const ErrorField& field : part.fields) {
    json["pictures"].push_back(
        {{"file", "errors_" + field.name + ".png"}, {"title", field.title}, {"error", to_json(field.error, scene)}});
  }
  return json;
}

}  // namespace

Json study_json(const Study& study, const Scene& scene) {
  Json json = {
      {"format", "shforge study"},
      {"scene", study.scene},
      {"vertices", study.vertices},
      {"faces", study.faces},
      {"studied", {{"every", study.step}, {"vertices", study.studied}, {"left_out_as_filled", study.left_out}}},
      {"degree", study.degree},
      {"directions", study.directions},
      {"reference_directions", study.reference_directions},
      {"instruction_set", study.instruction_set},
      {"error",
       "exit radiance under the scene's lights, all channels, over the root mean square of the reference; "
       "vertices weigh by area over the squared distance to the camera"},
      {"coefficient_error", "absolute, of the transfer vectors of the studied vertices, which hold cosine and 1/pi"},
      {"time",
       "processor time in seconds, the least of the passes; each pass has another seed, errors are the root "
       "mean square over passes"},
      {"slope", "of log error against log `at`, by least squares"},
      {"convention", "real SH, orthonormal, no Condon-Shortley phase, i = l(l+1)+m"},
      {"axes", "right-handed, z up"}};
  if (study.reference_error) json["reference_error_against_closed_answer"] = to_json(*study.reference_error, scene);
  json["parts"] = Json::array();
  for (const StudyPart& part : study.parts) json["parts"].push_back(to_json(part, scene));
  return json;
}

}  // namespace sh::prt
