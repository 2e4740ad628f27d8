// three.js: a LightProbe as LightProbe.toJSON writes it and ObjectLoader reads it.
#include <fmt/format.h>

#include "prt/formats/json_numbers.hpp"
#include "prt/formats/writers.hpp"
#include "prt/transfer/checksum.hpp"

namespace sh::prt::formats {
namespace {

// Equal lights have equal names.
std::string uuid_of(const std::vector<double>& numbers) {
  const std::size_t bytes = numbers.size() * sizeof(double);
  const std::uint64_t high = checksum(numbers.data(), bytes);
  const std::uint64_t low = checksum(numbers.data() + 1, bytes - sizeof(double));
  return fmt::format("{:08x}-{:04x}-8{:03x}-8{:03x}-{:012x}", high >> 32U, high >> 16U & 0xFFFFU, high >> 4U & 0xFFFU,
                     low >> 52U, low & 0xFFFFFFFFFFFFU);
}

}  // namespace

std::string write_threejs(const EngineLight& light) {
  std::vector<double> sh;
  for (const auto& triple : light.coefficients) sh.insert(sh.end(), triple.begin(), triple.end());
  nlohmann::ordered_json json = {{"metadata", {{"version", 4.7}, {"type", "Object"}, {"generator", "prt export"}}},
                                 {"object",
                                  {{"uuid", uuid_of(sh)},
                                   {"type", "LightProbe"},
                                   {"layers", 1},
                                   {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}},
                                   {"up", {0, 1, 0}},
                                   {"color", 0xFFFFFF},
                                   {"intensity", 1},
                                   {"sh", sh}}}};
  return json.dump(2) + "\n";
}

std::optional<Triples> read_threejs(const Document& document) {
  if (!document.json || document.json->value("/object/type"_json_pointer, nlohmann::json()) != "LightProbe") return {};
  const std::vector<double> sh = numbers_at(*document.json, "/object/sh", 27);
  const double intensity = number_at(*document.json, "/object/intensity", 1.0);
  Triples triples;
  for (std::size_t i = 0; i < sh.size(); i += 3) {
    triples.push_back({intensity * sh[i], intensity * sh[i + 1], intensity * sh[i + 2]});
  }
  return triples;
}

}  // namespace sh::prt::formats
