// Whole numbers of JSON files.
#pragma once
#include <fmt/format.h>

#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace sh::prt {

/// A whole number from `least` to `most`; Json: of nlohmann's library, which would cut 2.5 to 2, take -1 for 4294967295 and
/// convert 1e67 without a defined result. Throws std::invalid_argument, which begins with `place`.
template <class Whole, class Json>
Whole whole_number(const Json& json, std::string_view place, Whole least = 0,
                   Whole most = std::numeric_limits<Whole>::max()) {
  const auto lies_within = [&](auto value) {
    return std::cmp_less_equal(least, value) && std::cmp_less_equal(value, most);
  };
  if (!json.is_number_integer() || !(json.is_number_unsigned() ? lies_within(json.template get<std::uint64_t>())
                                                               : lies_within(json.template get<std::int64_t>()))) {
    throw std::invalid_argument(
        fmt::format("{} {}, expected a whole number from {} to {}", place, json.dump(), least, most));
  }
  return json.template get<Whole>();
}

}  // namespace sh::prt
