#include "codegen/bound/region.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>

namespace sh::codegen::bound {
namespace {

constexpr Interval kCoordinates = {-1.0625, 1.0625};  // of unit vectors and a little more
constexpr int kPiecesOfVectors = 4;                   // of each coordinate of a unit vector, to start with
constexpr int kPiecesOfParameters = 32;               // of any other coordinate
constexpr int kPiecesOfOctaves = 4;                   // of each octave of a logarithmic coordinate
constexpr int kLeastCap = 120;                        // caps are tested from 2^-120 on

// The number of octaves of caps' sizes.
int octave_count(const Format& format) { return std::min(kLeastCap, -(format.least_exponent + format.digits)); }

bool is_symbol(Role role) {
  return holds_coefficients(role) || role == Role::kWeight || role == Role::kColor || role == Role::kMoments ||
         role == Role::kLinearForm || role == Role::kEvaluatedCoefficients;
}

// The size of the unit vector that starts with this parameter; 0: none does.
int unit_vector_size(const Parameter& parameter) {
  switch (parameter.role) {
    case Role::kDirection:
    case Role::kVector:
      return parameter.axis == 0 ? 3 : 0;
    case Role::kCosine:
      return 2;
    case Role::kQuaternion:
      return 4;
    default:
      return 0;
  }
}

// The range of an input among the tested ones, to whole numbers.
Interval tested_range(const Domain& domain, int degree, std::size_t input) {
  Interval range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const std::vector<double>& inputs : domain.test_inputs(degree)) {
    range.low = std::min(range.low, std::floor(inputs[input]));
    range.high = std::max(range.high, std::ceil(inputs[input]));
  }
  return range;
}

void set_lengths(Region& region, const Domain& domain, const Format& format) {
  region.homogeneous = true;
  const bool narrow = format.name == "half";
  region.lengths = narrow ? Interval{0.5, 2} : Interval{domain.lengths[0], domain.lengths[1]};
}

void add_parameter(Region& region, const Parameter& parameter, const Kernel& kernel, const Domain& domain,
                   const Format& format) {
  const auto first = static_cast<int>(region.root.size());
  if (is_symbol(parameter.role)) {
    region.coordinate.insert(region.coordinate.end(), parameter.size(), -1);
    return;
  }
  if (const int size = unit_vector_size(parameter)) region.unit_vectors.push_back({first, size});
  if (parameter.role == Role::kVector && parameter.axis == 0) set_lengths(region, domain, format);
  const bool scalar = parameter.role == Role::kParameter || parameter.role == Role::kCapSize;
  const bool of_vector = parameter.role == Role::kDirection || parameter.role == Role::kVector ||
                         parameter.role == Role::kCosine || parameter.role == Role::kSine ||
                         parameter.role == Role::kQuaternion;
  if (!scalar && !of_vector) throw std::domain_error("an input is a " + role_name(parameter.role));
  if (parameter.role == Role::kCapSize) region.logarithmic = first;
  for (int i = 0; i < parameter.size(); ++i) {
    const std::size_t input = region.coordinate.size();
    region.coordinate.push_back(static_cast<int>(region.root.size()));
    region.root.push_back(scalar ? tested_range(domain, kernel.degree, input) : kCoordinates);
  }
}

// "-1 <= cos_pi_over_w <= 1; arrays of coefficients of length 2^-20 to 2^20"
std::string described(const Region& region, const Kernel& kernel, const Format& format) {
  std::vector<std::string> parts;
  bool symbols = false;
  std::size_t input = 0;
  for (const Parameter& parameter : kernel.parameters) {
    const int coordinate = region.coordinate[input];
    input += parameter.size();
    symbols = symbols || coordinate < 0;
    if (parameter.role == Role::kVector && parameter.axis == 0) {
      parts.push_back(fmt::format("vectors of length {:g} to {:g}", region.lengths.low, region.lengths.high));
    } else if (unit_vector_size(parameter) > 0) {
      const std::string name = parameter.role == Role::kCosine ? "cosine and sine" : "a " + role_name(parameter.role);
      parts.push_back(name + " off length 1 by at most 2 epsilon");
    } else if (parameter.role == Role::kCapSize) {
      parts.push_back(fmt::format("{} = 0 or 2^-{} to 2", parameter.name, octave_count(format)));
    } else if (parameter.role == Role::kParameter) {
      const Interval range = region.root[coordinate];
      parts.push_back(fmt::format("{:g} <= {} <= {:g}", range.low, parameter.name, range.high));
    }
  }
  if (symbols) {
    const int power = std::ilogb(format.scale);
    parts.push_back(fmt::format("coefficients of size 2^-{0} to 2^{0}", power));
  }
  return fmt::format("{}", fmt::join(parts, "; "));
}

// Keeps the part of x with x^2 in `square`.
bool contract(Interval& x, Interval square) {
  if (square.high < 0) return false;
  const double largest = above(std::sqrt(square.high));
  const double least = square.low > 0 ? std::max(0.0, below(std::sqrt(square.low))) : 0;
  x = {std::max(x.low, -largest), std::min(x.high, largest)};
  if (x.low > -least) x.low = std::max(x.low, least);
  if (x.high < least) x.high = std::min(x.high, -least);
  return x.low <= x.high;
}

// The pieces of the range of a cap's size. Their sizes and distances from 2 fall by octaves, down to the least of both.
std::vector<Interval> octaves(const Format& format) {
  std::vector<Interval> pieces{{0, 0}, {2, 2}};
  for (int k = 0; k < octave_count(format); ++k) {
    for (int i = 0; i < kPiecesOfOctaves; ++i) {
      const double unit = std::ldexp(1.0 / kPiecesOfOctaves, -k - 1);
      const double low = unit * (kPiecesOfOctaves + i);
      pieces.push_back({low, low + unit});
      if (k < format.digits) pieces.push_back({2 - low - unit, 2 - low});
    }
  }
  return pieces;
}

std::vector<Interval> pieces_of(const Region& region, int coordinate, const Format& format) {
  if (coordinate == region.logarithmic) return octaves(format);
  const bool of_vector = !region.unit_vectors.empty();
  const int count = of_vector ? kPiecesOfVectors : kPiecesOfParameters;
  const Interval range = region.root[coordinate];
  std::vector<Interval> pieces;
  const double step = range.width() / count;
  for (int i = 0; i < count; ++i) pieces.push_back({range.low + step * i, range.low + step * (i + 1)});
  return pieces;
}

}  // namespace

Region region_of(const Kernel& kernel, const Domain& domain, const Format& format) {
  Region region;
  for (const Parameter& parameter : kernel.parameters) add_parameter(region, parameter, kernel, domain, format);
  if (!region.homogeneous) {
    const double off = 2 * format.epsilon();
    region.length = {(1 - off) * (1 - off), (1 + off) * (1 + off)};
  }
  region.length = {below(region.length.low), above(region.length.high)};
  region.text = described(region, kernel, format);
  return region;
}

std::optional<Box> contracted(Box box, const Region& region) {
  for (int round = 0; round < 2; ++round) {
    for (const UnitVector& vector : region.unit_vectors) {
      for (int i = vector.first; i < vector.first + vector.size; ++i) {
        Interval rest = region.length;
        for (int k = vector.first; k < vector.first + vector.size; ++k) {
          if (k != i) rest = rest - square(box[k]);
        }
        if (!contract(box[i], rest)) return {};
      }
    }
  }
  return box;
}

std::vector<Box> first_boxes(const Region& region, const Format& format) {
  std::vector<Box> boxes{{}};
  for (int i = 0; i < static_cast<int>(region.root.size()); ++i) {
    std::vector<Box> longer;
    for (const Box& box : boxes) {
      for (const Interval piece : pieces_of(region, i, format)) {
        longer.push_back(box);
        longer.back().push_back(piece);
      }
    }
    boxes = std::move(longer);
  }
  std::vector<Box> meeting;
  for (const Box& box : boxes) {
    if (auto part = contracted(box, region)) meeting.push_back(std::move(*part));
  }
  return meeting;
}

std::vector<Box> halves(const Box& box, const Region& region) {
  const auto longest = std::max_element(box.begin(), box.end(),
                                        [](const Interval& a, const Interval& b) { return a.width() < b.width(); });
  const double middle = longest->low + longest->width() / 2;
  if (!(longest->low < middle && middle < longest->high)) return {box};
  std::vector<Box> parts;
  for (const Interval half : {Interval{longest->low, middle}, Interval{middle, longest->high}}) {
    Box part = box;
    part[longest - box.begin()] = half;
    if (auto meets = contracted(std::move(part), region)) parts.push_back(std::move(*meets));
  }
  return parts;
}

}  // namespace sh::codegen::bound
