// See family_record.hpp.
#include "numeric/kernels/family_record.hpp"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <nlohmann/json.hpp>
#include <numeric>
#include <stdexcept>

namespace sh::numeric {

// Its lines; written by kernel_bindings.cmake.
extern const std::vector<std::string_view> kFamiliesRecordLines;

namespace {

using Json = nlohmann::json;

Parameter parsed_parameter(const Json& json) {
  const auto shape = json.value("shape", std::vector<int>{});
  Parameter parameter;
  parameter.name = json.at("name");
  parameter.role = json.at("role");
  parameter.degree = json.value("degree", -1);
  parameter.channels = json.value("channels", 1);
  parameter.count = shape.empty() ? 0 : std::accumulate(shape.begin(), shape.end(), 1, std::multiplies<>());
  if (parameter.role == "rotation matrix" || parameter.role == "quaternion") parameter.rows = shape[0];
  return parameter;
}

// A result with the name of a parameter is that parameter, updated in place; a scalar is returned.
Signature parsed_signature(const Json& json) {
  Signature signature;
  for (const Json& parameter : json.at("parameters")) signature.parameters.push_back(parsed_parameter(parameter));
  const std::size_t inputs = signature.parameters.size();
  for (const Json& result : json.at("results")) {
    const Parameter parameter = parsed_parameter(result);
    const auto end = signature.parameters.begin() + static_cast<std::ptrdiff_t>(inputs);
    const auto updated =
        std::find_if(signature.parameters.begin(), end, [&](const Parameter& p) { return p.name == parameter.name; });
    if (parameter.count == 0) {
      signature.returns_value = true;
    } else if (updated != end) {
      updated->access = Access::kInOut;
    } else {
      signature.parameters.push_back(parameter);
      signature.parameters.back().access = Access::kOut;
    }
  }
  return signature;
}

RoundingAndTotal parsed_errors(const Json& json) {
  RoundingAndTotal errors{json.at("rounding_eps"), json.at("total_eps")};
  if (json.contains("bound_eps")) errors.bound = json.at("bound_eps");
  return errors;
}

KernelRecord parsed_kernel(const Json& json) {
  KernelRecord kernel;
  kernel.name = json.at("name");
  kernel.degree = json.at("degree");
  kernel.family = kernel.name.substr(0, kernel.name.rfind("_l"));
  kernel.signature = parsed_signature(json);
  kernel.in_float = parsed_errors(json.at("float"));
  kernel.in_double = parsed_errors(json.at("double"));
  return kernel;
}

FamilyRecord parsed_family(const Json& json) {
  FamilyRecord family;
  family.family = json.at("name");
  family.unit = json.at("unit");
  family.sizes = json.at("sizes");
  family.normalized = !json.at("nearest").get<std::string>().empty();
  if (json.contains("lengths")) family.lengths = json.at("lengths");
  for (const Json& kernel : json.at("kernels")) family.kernels.push_back(parsed_kernel(kernel));
  return family;
}

Promise parsed_promise(const Json& json) {
  Promise promise{json.at("kernels"), json.at("scalar"), {}, {}, json.at("reason")};
  if (json.contains("rounding_eps")) promise.rounding = json.at("rounding_eps");
  if (json.contains("total")) promise.total_absolute = json.at("total");
  return promise;
}

// The array of one degree for another.
void resize(Parameter& array, int from, int to) {
  if (array.degree < 0 || array.degree % std::max(from, 1) != 0) return;  // of no degree, or of one that is fixed
  const int degree = from == 0 ? to : array.degree / from * to;
  const auto count = [&](int d) {
    if (array.role == "zonal coefficients") return d + 1;
    if (array.role == "band matrices") return (d + 1) * (2 * d + 1) * (2 * d + 3) / 3;
    return array.channels * (d + 1) * (d + 1);
  };
  array.count = count(degree);
  array.degree = degree;
}

}  // namespace

Signature FamilyRecord::signature(int degree) const {
  if (kernels.empty()) throw std::invalid_argument(family + ": expected a kernel in the record, got none");
  const auto nearest =
      std::min_element(kernels.begin(), kernels.end(), [degree](const KernelRecord& a, const KernelRecord& b) {
        return std::abs(a.degree - degree) < std::abs(b.degree - degree);
      });
  Signature signature = nearest->signature;
  if (nearest->degree == degree) return signature;
  for (Parameter& parameter : signature.parameters) resize(parameter, nearest->degree, degree);
  return signature;
}

const KernelRecord* FamiliesRecord::find_kernel(const std::string& name) const {
  for (const FamilyRecord& family : families) {
    for (const KernelRecord& kernel : family.kernels) {
      if (kernel.name == name) return &kernel;
    }
  }
  return nullptr;
}

FamiliesRecord parse_record(std::string_view text) {
  constexpr const char* kFormat = "shforge families 1";
  try {
    const Json json = Json::parse(text);
    if (json.at("format") != kFormat) throw std::invalid_argument("another format");
    FamiliesRecord record;
    const Json& limits = json.at("limits");
    record.limit_factor = {limits.at("rounding_factor"), limits.at("total_factor")};
    record.least_limit = limits.at("least_eps");
    for (const Json& promise : limits.at("promises")) record.promises.push_back(parsed_promise(promise));
    for (const Json& family : json.at("families")) record.families.push_back(parsed_family(family));
    return record;
  } catch (const std::exception& error) {
    throw std::invalid_argument("families.json: expected \"" + std::string(kFormat) + "\", got: " + error.what());
  }
}

const FamiliesRecord& families_record() {
  static const FamiliesRecord kRecord = [] {
    std::string text;
    for (const std::string_view line : kFamiliesRecordLines) text += line;
    return parse_record(text);
  }();
  return kRecord;
}

std::string without_variant(const std::string& family) {
  const std::string ending = "_accurate";
  return family.ends_with(ending) ? family.substr(0, family.size() - ending.size()) : family;
}

}  // namespace sh::numeric
