// read_report of advise.hpp: the points of report.json.
#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "numeric/output/read_file.hpp"
#include "numeric/report/advise.hpp"

namespace sh::numeric {
namespace {

using Json = nlohmann::json;

Mode mode_of(const std::string& text) {
  for (const Mode mode : {Mode::kOne, Mode::kPrepared, Mode::kBatch}) {
    if (text == to_string(mode)) return mode;
  }
  throw std::runtime_error("mode '" + text + "' should be one, prepared or batch");
}

// null stands for what is not finite.
double error_of(const Json& value) {
  const double error = value.is_null() ? std::numeric_limits<double>::infinity() : value.get<double>();
  if (!(error >= 0)) throw std::runtime_error("an error is negative");
  return error;
}

Point point_of(const Json& json) {
  Point point;
  point.info = {.task = json.at("task"),
                .name = json.at("method"),
                .degree = json.at("degree"),
                .scalar = json.at("scalar"),
                .mode = mode_of(json.at("mode")),
                .header = json.at("header"),
                .call = json.at("call"),
                .leaves_out = json.at("leaves_out"),
                .source = json.at("source")};
  point.nanoseconds = json.at("ns");
  if (!(point.nanoseconds > 0)) throw std::runtime_error("'ns' is not positive");
  point.error = error_of(json.at("error"));
  point.error_eps = error_of(json.at("error_eps"));
  point.unit = json.at("unit");
  point.inputs = json.at("inputs");
  point.worst = {json.at("worst").at("input"), {}, json.at("worst").at("output")};
  point.on_front = json.at("on_front");
  return point;
}

}  // namespace

std::vector<Point> read_report(const std::string& file) {
  const std::string text = output::read_file(file);
  std::vector<Point> points;
  try {
    const auto json = Json::parse(text);
    if (json.at("format") != "shforge report 1") throw std::runtime_error("'format' is not 'shforge report 1'");
    for (const auto& point : json.at("points")) points.push_back(point_of(point));
  } catch (const std::exception& error) {
    std::string reason = error.what();
    std::replace(reason.begin(), reason.end(), '\n', ' ');
    throw std::runtime_error(file + ": not a report of shcheck: " + reason);
  }
  return points;
}

}  // namespace sh::numeric
