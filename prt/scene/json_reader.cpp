#include "prt/scene/json_reader.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "numeric/output/parse_json.hpp"
#include "numeric/output/printable.hpp"
#include "numeric/output/read_file.hpp"

namespace sh::prt {

namespace {

constexpr std::size_t kLongestQuote = 60;
constexpr float kLargest = std::numeric_limits<float>::max();
constexpr double kMost = static_cast<double>(kLargest);

// The text of a value in the file, truncated if it is long.
std::string quote(const nlohmann::json& value) {
  const std::string text = value.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  return text.size() <= kLongestQuote ? text : text.substr(0, kLongestQuote - 3) + "...";
}

}  // namespace

nlohmann::json read_json(const std::string& file) {
  const std::string text = output::read_file(file);
  try {
    return output::parse_json<nlohmann::json>(text);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(fmt::format("{}: {}", file, error.what()));
  }
}

std::string JsonReader::place() const { return fmt::format("{}: {}", *file_, path_.empty() ? "/" : path_); }

void JsonReader::expected(std::string_view what) const {
  throw std::runtime_error(fmt::format("{}: expected {}, got {}", place(), what, quote(*value_)));
}

void JsonReader::allow(const std::vector<std::string_view>& keys) const {
  if (!value_->is_object()) expected("an object");
  for (const auto& [key, value] : value_->items()) {
    if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
      throw std::runtime_error(fmt::format("{}: {}/{}: unknown key, expected one of {}", *file_, path_,
                                           output::printable(key), fmt::join(keys, ", ")));
    }
  }
}

std::optional<JsonReader> JsonReader::find(std::string_view key) const {
  const auto entry = value_->find(std::string(key));
  if (entry == value_->end()) return std::nullopt;
  return JsonReader(*this, fmt::format("{}/{}", path_, key), *entry);
}

JsonReader JsonReader::at(std::string_view key) const {
  if (!value_->is_object()) expected("an object");
  const std::optional<JsonReader> value = find(key);
  if (!value) {
    throw std::runtime_error(fmt::format("{}: the key `{}` is missing", place(), key));
  }
  return *value;
}

std::vector<JsonReader> JsonReader::items() const {
  if (!value_->is_array()) expected("an array");
  std::vector<JsonReader> items;
  for (std::size_t i = 0; i < value_->size(); ++i) {
    items.push_back(JsonReader(*this, fmt::format("{}/{}", path_, i), (*value_)[i]));
  }
  return items;
}

std::vector<JsonReader> JsonReader::items(std::string_view key) const {
  const auto array = find(key);
  return array ? array->items() : std::vector<JsonReader>();
}

std::vector<std::pair<std::string, JsonReader>> JsonReader::members() const {
  if (!value_->is_object()) expected("an object");
  std::vector<std::pair<std::string, JsonReader>> members;
  for (const auto& [key, value] : value_->items()) {
    members.emplace_back(key, JsonReader(*this, fmt::format("{}/{}", path_, output::printable(key)), value));
  }
  return members;
}

bool JsonReader::is(std::string_view type) const { return value_->type_name() == type; }

std::string JsonReader::text() const {
  const auto* text = value_->get_ptr<const std::string*>();
  if (text == nullptr || text->empty()) expected("a string that is not empty");
  if (output::printable(*text) != *text) expected("a string without control characters");
  return *text;
}

std::string JsonReader::one_of(const std::vector<std::string_view>& words) const {
  if (!value_->is_string() || std::find(words.begin(), words.end(), value_->get<std::string>()) == words.end()) {
    expected(fmt::format("one of {}", fmt::join(words, ", ")));
  }
  return value_->get<std::string>();
}

double JsonReader::number(double least, double most, std::string_view what) const {
  if (!value_->is_number()) expected(what);
  const auto number = value_->get<double>();
  if (!(number >= least && number <= most)) expected(what);
  return number;
}

bool JsonReader::boolean() const {
  if (!value_->is_boolean()) expected("true or false");
  return value_->get<bool>();
}

double JsonReader::degrees(double least, double most) const {
  const double value = number(least, most, fmt::format("degrees from {:g} to {:g}", least, most));
  const double twelfths = 12.0 * value / std::numbers::pi;
  const double whole = std::round(twelfths);
  if (whole != 0.0 && std::abs(whole) <= 24.0 && std::abs(twelfths - whole) < 1e-3) {
    expected(fmt::format("degrees; this looks like {:g}/12 pi radians, which are {:g} degrees", whole, 15.0 * whole));
  }
  return value;
}

float JsonReader::finite() const { return static_cast<float>(number(-kLargest, kLargest, "a number")); }

float JsonReader::positive() const {
  return static_cast<float>(number(std::numeric_limits<float>::min(), kLargest, "a positive number"));
}

int JsonReader::integer(int least, int most) const {
  const std::string what = fmt::format("an integer from {} to {}", least, most);
  if (!value_->is_number_integer()) expected(what);
  return static_cast<int>(number(least, most, what));
}

double JsonReader::real() const { return number(-kMost, kMost, "a number"); }

Eigen::Vector3f JsonReader::vector() const { return vector_within(-kLargest, kLargest); }

Eigen::Vector3f JsonReader::vector_within(float least, float most) const {
  return numbers(static_cast<double>(least), static_cast<double>(most)).cast<float>();
}

Eigen::Vector3d JsonReader::point() const { return numbers(-kMost, kMost); }

Eigen::Vector3d JsonReader::numbers(double least, double most) const {
  const bool any = most == kMost;
  const std::string what = !any           ? fmt::format("three numbers from {} to {}", least, most)
                           : least == 0.0 ? "three numbers of 0 or more"
                                          : "three numbers";
  if (!value_->is_array() || value_->size() != 3) expected(what);
  Eigen::Vector3d vector;
  int i = 0;
  for (const JsonReader& item : items()) vector[i++] = item.number(least, most, any && least < 0.0 ? "a number" : what);
  return vector;
}

}  // namespace sh::prt
