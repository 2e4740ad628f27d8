// Which method to take: the cheapest that is exact enough, by measurements.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "numeric/report/measure.hpp"

namespace sh::numeric {

struct Need {
  std::string task;
  int degree = 0;
  double error = 0;         ///< at most; as Point::error
  std::string scalar = {};  ///< "float", "double"; empty: either
  bool batch = false;       ///< many records at once would do
  bool prepared = false;    ///< so would a part computed once for many calls
};

struct Advice {
  Point choice;
  bool good_enough = false;  ///< else the most exact there is
  /// The degree at which batches of the task end; -1: it has none; empty: there is one, or none was asked for.
  std::optional<int> last_batch = {};
  std::optional<Point> cheaper = {};     ///< the next faster one that nothing beats in both
  std::optional<Point> more_exact = {};  ///< the next more exact one
};

/// Float is preferred to double where both are exact enough and as fast within kSameTime. Throws std::invalid_argument,
/// one line, where no point has this task and degree; the line says which there are.
Advice advise(const std::vector<Point>& points, const Need& need);

/// Times that differ by this factor or less count as equal.
inline constexpr double kSameTime = 1.1;

/// Measures every method of the task at the degree, in a second or two. Throws std::invalid_argument, one line, for a
/// degree beyond the last that has a method; the line says where to go.
std::vector<Point> measure_for(const Need& need);

/// Some lines of text.
std::string format_advice(const Need& need, const Advice& advice);

}  // namespace sh::numeric
