// Refusals of arguments outside their range, in one line and one form.
#pragma once

#include <limits>
#include <stdexcept>
#include <string>

namespace sh::numeric {

/// Throws std::invalid_argument, "NAME: expected LOW to HIGH, got VALUE" or "NAME: expected LOW or more, got VALUE",
/// for a value outside.
inline void require_range(const std::string& name, long value, long low, long high = std::numeric_limits<long>::max()) {
  if (value >= low && value <= high) return;
  const bool open = high == std::numeric_limits<long>::max();
  throw std::invalid_argument(name + ": expected " + std::to_string(low) +
                              (open ? " or more" : " to " + std::to_string(high)) + ", got " + std::to_string(value));
}

/// Throws std::invalid_argument, "NAME: expected N values, got SIZE", for another size.
inline void require_size(const std::string& name, long size, long expected) {
  if (size == expected) return;
  throw std::invalid_argument(name + ": expected " + std::to_string(expected) + " values, got " + std::to_string(size));
}

}  // namespace sh::numeric
