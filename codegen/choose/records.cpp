#include "codegen/choose/records.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "codegen/print/describe.hpp"
#include "codegen/print/statements.hpp"

namespace sh::codegen {
namespace {

// --- MANIFEST

std::string times(const std::vector<std::optional<Timing>>& timings, double Timing::*which) {
  std::string text;
  for (const auto& timing : timings)
    text += (text.empty() ? "" : "/") + (timing ? fmt::format("{:.3g}", (*timing).*which) : "-");
  return text.empty() ? "-" : text;
}

// "7.6/4.3": the proved bound and the largest error seen; "-/4.3": no bound is proved.
std::string bound_and_seen(const MeasuredError& error) {
  if (!error.proved) return "-";
  const std::string bound =
      error.proved->is_proved() ? fmt::format("{:.1f}", print::raised(error.proved->eps, 1)) : "-";
  return bound + fmt::format("/{:.1f}", error.rounding.eps);
}

// --- families.json

using Json = nlohmann::ordered_json;

// The allowed error of a kernel with other inputs, compilers and languages, in multiples of its recorded error. With
// the inputs of numeric/, the measured rounding error is at most 2.6 times the recorded one, and 1.0 times for half of
// the kernels. The total error also depends on the distance of the inputs from the domain, which differs between two
// sets of inputs; it is at most 6.2 times the recorded one.
constexpr double kRoundingFactor = 4;
constexpr double kTotalFactor = 8;
// The error that every kernel may have, in epsilon x size: two roundings may add up even if the record has none.
constexpr double kLeastLimit = 1;

Json parameters(const std::vector<Parameter>& arrays) {
  Json list = Json::array();
  for (const Parameter& array : arrays) {
    Json json = {{"name", array.name}, {"role", role_name(array.role)}};
    if (!array.shape.empty()) json["shape"] = array.shape;
    if (array.degree >= 0) json["degree"] = array.degree;
    if (array.channels() > 1) json["channels"] = array.channels();
    list.push_back(std::move(json));
  }
  return list;
}

Json errors(const MeasuredError& measured) {
  const auto hundredths = [](double eps) { return std::round(eps * 100) / 100; };
  Json json = {{"rounding_eps", hundredths(measured.rounding.eps)}, {"total_eps", hundredths(measured.total.eps)}};
  if (measured.proved && measured.proved->is_proved()) json["bound_eps"] = print::raised(measured.proved->eps, 2);
  return json;
}

Json promise(const Promise& promised) {
  Json json = {{"kernels", promised.kernels}, {"scalar", promised.scalar}};
  if (promised.rounding_eps > 0) json["rounding_eps"] = promised.rounding_eps;
  if (promised.total > 0) json["total"] = promised.total;
  json["reason"] = promised.reason;
  return json;
}

// Puts each kernel of an object on its own line, so that a comparison shows changes.
std::string family_text(const RecordedFamily& recorded) {
  const Domain& domain = recorded.family->domain;
  Json json = {{"name", recorded.family->name},
               {"inputs", domain.inputs},
               {"nearest", recorded.nearest},
               {"unit", domain.unit},
               {"sizes", domain.sizes}};
  if (domain.lengths[0] != domain.lengths[1]) json["lengths"] = domain.lengths;
  std::string text = json.dump();
  text.back() = ',';
  text += "\n  \"kernels\": [";
  for (std::size_t i = 0; i < recorded.kernels.size(); ++i) {
    text += (i == 0 ? "\n    " : ",\n    ") + recorded.kernels[i];
  }
  return text + "]}";
}

}  // namespace

ManifestRow manifest_row(const ManifestEntry& entry) {
  const FinishedKernel& f = entry.finished;
  std::string files;
  for (const std::string& file : entry.files) files += (files.empty() ? "" : " ") + file;
  const auto field = [](const std::string& name, const std::string& value) { return "  " + name + "=" + value; };
  return {f.kernel.name,
          field("recipe", f.kernel.recipe),
          field("mul", std::to_string(f.cost.mul)),
          field("add", std::to_string(f.cost.add + f.cost.neg)),
          field("other", std::to_string(f.cost.div + f.cost.sqrt + f.cost.select)),
          field("chain", std::to_string(f.cost.depth)),
          field("live", std::to_string(f.cost.max_live)),
          field("float_eps", bound_and_seen(f.in_float)),
          field("double_eps", bound_and_seen(f.in_double)),
          field("float_rounding", print::two_digits(f.in_float.rounding.absolute)),
          field("float_total", print::two_digits(f.in_float.total.absolute)),
          field("double_rounding", print::two_digits(f.in_double.rounding.absolute)),
          field("double_total", print::two_digits(f.in_double.total.absolute)),
          field("ns", times(entry.timings, &Timing::call)),
          field("lane_ns", times(entry.timings, &Timing::lane)),
          field("files", files.empty() ? "-" : files)};
}

std::string kernel_record(const FinishedKernel& finished) {
  const Kernel& k = finished.kernel;
  Json json = {{"name", k.name},
               {"degree", k.degree},
               {"recipe", k.recipe},
               {"parameters", parameters(k.parameters)},
               {"results", parameters(k.results)},
               {"float", errors(finished.in_float)},
               {"double", errors(finished.in_double)}};
  return json.dump();
}

std::string print_manifest(const std::vector<ManifestRow>& rows) {
  std::string machines;
  for (const auto& [name, wisdom] : committed_wisdom()) machines += (machines.empty() ? "" : "/") + name;
  std::string text =
      "# Every kernel and every recipe for it, one a line. Written by `shgen write`; licence MIT-0.\n"
      "# mul, add: operations (add holds subtractions and negations); other: divisions, square roots, selections;\n"
      "# chain: the longest one; live: most values held at once; ns, lane_ns: tuned time of a float call, and of a "
      "lane of\n"
      "# a SIMD register, on " +
      machines +
      ";\n"
      "# float_eps, double_eps: the rounding error in the unit of the family, at most (proved) / largest seen; -/ "
      "where no\n"
      "# bound is proved, - where the recipe is not written; rounding, total: the largest absolute error seen, as "
      "explained\n"
      "# at the head of each file, for recipes that are not written among the tested inputs alone;\n"
      "# files: what is written with this recipe, - when another one was chosen.\n"
      "# families.json: roles, shapes, units and limits of these kernels, for programs.\n";
  for (const std::string& line : print::align_columns(rows)) text += line + "\n";
  return text;
}

std::string print_families_record(const std::vector<RecordedFamily>& families) {
  Json limits = {{"rounding_factor", kRoundingFactor},
                 {"total_factor", kTotalFactor},
                 {"least_eps", kLeastLimit},
                 {"promises", Json::array()}};
  std::string list;
  for (const RecordedFamily& recorded : families) {
    for (const Promise& promised : recorded.family->promises) limits["promises"].push_back(promise(promised));
    list += (list.empty() ? "\n " : ",\n ") + family_text(recorded);
  }
  const Json about =
      "Roles, shapes, units, sizes, the largest errors seen of every kernel and the proved bounds of its rounding "
      "error. "
      "eps counts machine epsilon x size; a kernel may err by the factors times the errors seen, or by least_eps where "
      "that is more, but not beyond its bound. shader: false where no shader is written. Written by `shgen write`; "
      "licence MIT-0.";
  return "{\"format\": \"shforge families 1\",\n\"about\": " + about.dump() + ",\n\"limits\": " + limits.dump() +
         ",\n\"families\": [" + list + "]}\n";
}

}  // namespace sh::codegen
