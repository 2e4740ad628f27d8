// Parses JSON of any origin. nlohmann::json parses at any depth, but copies, compares and prints a value by recursion.
#pragma once
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>

namespace sh::output {

/// The deepest nesting of arrays and objects that parse_json accepts.
inline constexpr int kDeepestJson = 64;

/// Json is nlohmann::json or nlohmann::ordered_json. Throws std::runtime_error, one line without the file's name, for
/// text that is not JSON or is nested deeper than kDeepestJson.
template <class Json>
Json parse_json(std::string_view text) {
  using Event = typename Json::parse_event_t;
  const auto is_shallow = [](int depth, Event event, const Json& /*value*/) {
    if ((event == Event::array_start || event == Event::object_start) && depth >= kDeepestJson) {
      throw std::runtime_error("not JSON for this program: expected at most " + std::to_string(kDeepestJson) +
                               " levels of arrays and objects, got more");
    }
    return true;
  };
  try {
    return Json::parse(text, is_shallow);
  } catch (const typename Json::exception& error) {
    const std::string what = error.what();
    const std::size_t detail = what.find("] ");  // after the library's own name and number of the error
    std::string line = detail == std::string::npos ? what : what.substr(detail + 2);
    for (char& c : line) c = c == '\n' ? ' ' : c;
    throw std::runtime_error("not JSON: " + line);
  }
}

}  // namespace sh::output
