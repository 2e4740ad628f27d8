// See size_formula.hpp.
#include "numeric/kernels/size_formula.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace sh::numeric {

struct SizeFormula::Output {
  std::size_t flat = 0;   // among all outputs
  std::size_t index = 0;  // in its result
  std::size_t channel = 0, channels = 1;
  int band = 0;
};

namespace {

double band_maximum(int l) { return std::sqrt((2 * l + 1) / (4 * std::numbers::pi)); }

// |A_l|, from A_0 = pi and A_1 = 2 pi / 3 by the ratio A_(l+2) / A_l = -(l-1) / (l+4).
double clamped_cosine(int l) {
  if (l % 2 == 1) return l == 1 ? 2 * std::numbers::pi / 3 : 0;
  double factor = std::numbers::pi;
  for (int k = 0; k < l; k += 2) factor *= std::abs(static_cast<double>(k - 1)) / (k + 4);
  return factor;
}

double cap(double one_minus_cos, int l) {
  const double area = l == 0 ? one_minus_cos : one_minus_cos * (2 - one_minus_cos) / 2;
  return std::sqrt((2 * l + 1) * std::numbers::pi) * area;
}

double length(const double* v, std::size_t count) {
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) sum += v[i] * v[i];
  return std::sqrt(sum);
}

[[noreturn]] void refuse(const std::string& text) {
  throw std::invalid_argument("size formula: expected a factor such as |c|, |c[i]| or Y(l), got '" + text + "'");
}

}  // namespace

InputPlaces places_of(const Signature& signature, const std::string& name_or_role) {
  for (const bool by_role : {false, true}) {
    InputPlaces places;
    std::size_t next = 0;
    for (const Parameter& parameter : signature.parameters) {
      if (!parameter.is_read()) continue;
      const auto values = static_cast<std::size_t>(parameter.values());
      if ((by_role ? parameter.role : parameter.name) == name_or_role) {
        if (places.count == 0) places.first = next;
        places.count += values;
      }
      next += values;
    }
    if (places.count > 0) return places;
  }
  return {};
}

SizeFormula::Factor SizeFormula::factor(const std::string& text, const Signature& signature, int degree,
                                        const std::function<double(std::size_t)>& gain) {
  if (text == "l") return [](const double*, const Output& o) { return static_cast<double>(o.band); };
  if (text == "Y(l)") return [](const double*, const Output& o) { return band_maximum(o.band); };
  if (text == "Y(L)") return [size = band_maximum(degree)](const double*, const Output&) { return size; };
  if (text == "Y(0..L)") {
    return [size = (degree + 1) / std::sqrt(4 * std::numbers::pi)](const double*, const Output&) { return size; };
  }
  if (text == "A(l)") return [](const double*, const Output& o) { return clamped_cosine(o.band); };
  if (text == "gain" && gain) return [gain](const double*, const Output& o) { return gain(o.flat); };
  if (text == "cap(l)") {
    const InputPlaces places = places_of(signature, "cap size");
    if (places.count != 1) refuse(text);
    return [at = places.first](const double* in, const Output& o) { return cap(in[at], o.band); };
  }
  if (text.empty() || text[0] != '|') {
    std::istringstream stream(text);
    double number = 0;
    if (!(stream >> number) || !stream.eof()) refuse(text);
    return [number](const double*, const Output&) { return number; };
  }
  const std::size_t end = text.rfind('|');
  const std::string power = text.substr(end + 1);
  const std::size_t bracket = std::min(text.find('['), end);
  const std::string subscript = text.substr(bracket, end - bracket);
  const InputPlaces x = places_of(signature, text.substr(1, bracket - 1));
  if (end == 0 || x.count == 0) refuse(text);
  if (subscript == "[i]") return [x](const double* in, const Output& o) { return std::abs(in[x.first + o.index]); };
  if (subscript == "[l]") {
    return [x](const double* in, const Output& o) { return std::abs(in[x.first + o.band]); };
  }
  if (subscript == "[k]") {
    return [x](const double* in, const Output& o) {
      const std::size_t count = x.count / o.channels;
      return length(in + x.first + o.channel * count, count);
    };
  }
  if (!subscript.empty()) refuse(text);
  if (power.empty()) return [x](const double* in, const Output&) { return length(in + x.first, x.count); };
  if (power != "^l" && power != "^(l-1)") refuse(text);
  return [x, less = power == "^l" ? 0 : 1](const double* in, const Output& o) {
    return o.band < less ? 0 : std::pow(length(in + x.first, x.count), o.band - less);
  };
}

SizeFormula::Sum SizeFormula::parsed(const std::string& text, const Signature& signature, int degree,
                                     const std::function<double(std::size_t)>& gain) {
  Sum sum(1);
  std::istringstream stream(text);
  for (std::string word; stream >> word;) {
    if (word == "+") {
      sum.emplace_back();
    } else {
      sum.back().push_back(factor(word, signature, degree, gain));
    }
  }
  if (std::any_of(sum.begin(), sum.end(), [](const auto& product) { return product.empty(); })) refuse(text);
  return sum;
}

SizeFormula::SizeFormula(const std::vector<std::string>& texts, const Signature& signature, int degree,
                         std::function<double(std::size_t output)> gain) {
  if (texts.empty()) refuse("");
  std::size_t end = 0;
  const auto add = [&](const Parameter& p) {
    end += static_cast<std::size_t>(p.values());
    const std::string& text = texts[std::min(results_.size(), texts.size() - 1)];
    // The values of several functions are one a channel.
    const int channels = p.role == "value" ? p.values() : p.channels;
    results_.push_back({end, static_cast<std::size_t>(p.values()), static_cast<std::size_t>(channels),
                        p.role == "zonal coefficients", parsed(text, signature, degree, gain)});
  };
  if (signature.returns_value) add({.name = "value", .role = "value"});
  for (const Parameter& parameter : signature.parameters) {
    if (parameter.is_written()) add(parameter);
  }
}

double SizeFormula::operator()(const double* in, std::size_t output) const {
  const auto found =
      std::find_if(results_.begin(), results_.end(), [&](const Result& result) { return output < result.end; });
  if (found == results_.end()) throw std::out_of_range("size formula: no such output");
  const std::size_t index = output - (found->end - found->values);
  const std::size_t each = found->values / found->channels;
  const std::size_t in_channel = index % each;
  const auto place_in_bands = static_cast<double>(in_channel);
  const int band = static_cast<int>(found->zonal ? place_in_bands : std::sqrt(place_in_bands));
  const Output place{output, index, index / each, found->channels, band};
  double size = 0;
  for (const auto& product : found->sum) {
    double term = 1;
    for (const Factor& factor : product) term *= factor(in, place);
    size += term;
  }
  return size;
}

}  // namespace sh::numeric
