// Numbers of engines' JSON files. Messages have no file name; whoever read the file puts it in front.
#pragma once
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace sh::prt::formats {

/// The value at a JSON pointer such as /object/sh; throws std::runtime_error if there is none.
inline const nlohmann::json& value_at(const nlohmann::json& json, const std::string& pointer) {
  const nlohmann::json::json_pointer place(pointer);
  if (!json.contains(place)) throw std::runtime_error(fmt::format("{}: the key is missing", pointer));
  return json.at(place);
}

/// An array of so many numbers there; throws std::runtime_error for anything else.
inline std::vector<double> numbers_at(const nlohmann::json& json, const std::string& pointer, std::size_t count) {
  const nlohmann::json& array = value_at(json, pointer);
  if (!array.is_array() || array.size() != count) {
    throw std::runtime_error(fmt::format("{}: expected {} numbers, got {}", pointer, count,
                                         array.is_array() ? std::to_string(array.size()) : array.type_name()));
  }
  std::vector<double> numbers;
  for (const nlohmann::json& value : array) {
    if (!value.is_number()) {
      throw std::runtime_error(fmt::format("{}: expected {} numbers, got {}", pointer, count, value.type_name()));
    }
    numbers.push_back(value.get<double>());
  }
  return numbers;
}

/// A number there, or `otherwise` if the key is missing.
inline double number_at(const nlohmann::json& json, const std::string& pointer, double otherwise) {
  const nlohmann::json::json_pointer place(pointer);
  if (!json.contains(place)) return otherwise;
  if (!json.at(place).is_number()) {
    throw std::runtime_error(fmt::format("{}: expected a number, got {}", pointer, json.at(place).type_name()));
  }
  return json.at(place).get<double>();
}

}  // namespace sh::prt::formats
