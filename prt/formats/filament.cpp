// Filament: the text file of `cmgen --sh-output`, one line a coefficient.
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "prt/formats/writers.hpp"

namespace sh::prt::formats {
namespace {

constexpr std::string_view kNames[] = {"L00", "L1-1", "L10", "L11", "L2-2", "L2-1", "L20", "L21", "L22"};

// "( r, g, b); // ..."; false for anything else.
bool take_line(const std::string& line, std::array<double, 3>& triple) {
  const char* at = line.c_str();
  for (std::size_t channel = 0; channel < 3; ++channel) {
    while (*at == ' ' || *at == '\t') ++at;
    if (*at++ != (channel == 0 ? '(' : ',')) return false;
    char* end = nullptr;
    triple[channel] = std::strtod(at, &end);
    if (end == at) return false;
    at = end;
  }
  while (*at == ' ' || *at == '\t') ++at;
  return *at == ')';
}

}  // namespace

std::string write_filament(const EngineLight& light) {
  std::string text;
  for (std::size_t i = 0; i < light.coefficients.size(); ++i) {
    text += fmt::format("( {}); // {}, irradiance, pre-scaled base\n", joined(light.coefficients[i]), kNames[i]);
  }
  return text;
}

std::optional<Triples> read_filament(const Document& document) {
  if (!document.bytes.starts_with('(')) return {};
  Triples triples;
  std::size_t begin = 0;
  for (int line = 1; begin < document.bytes.size(); ++line) {
    const std::size_t end = std::min(document.bytes.find('\n', begin), document.bytes.size());
    const std::string text(document.bytes.substr(begin, end - begin));
    begin = end + 1;
    if (text.find_first_not_of(" \t\r") == std::string::npos) continue;
    if (!take_line(text, triples.emplace_back())) {
      throw std::runtime_error(fmt::format("line {}: expected ( red, green, blue);", line));
    }
    if (text.find("irradiance") != std::string::npos && text.find("pre-scaled") == std::string::npos) {
      throw std::runtime_error(
          fmt::format("line {}: expected coefficients with pre-scaled base (cmgen --sh-shader)", line));
    }
  }
  if (degree_of(triples) < 0) {
    throw std::runtime_error(fmt::format("expected 1, 4 or 9 coefficients, got {}", triples.size()));
  }
  return triples;
}

}  // namespace sh::prt::formats
