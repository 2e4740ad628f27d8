#include "codegen/bound/size.hpp"

#include <stdexcept>

namespace sh::codegen::bound {
namespace {

bool holds(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

}  // namespace

Sizes::Sizes(const Kernel& kernel, const Domain& domain, const Region& region, const Format& format)
    : kernel_(kernel), region_(region), scale_(format.scale), size_(size_of(kernel, domain)) {
  if (domain.size) throw std::domain_error("the size of its unit is that of another convention");
  const bool symbols = std::count(region.coordinate.begin(), region.coordinate.end(), -1) > 0;
  if (!symbols) return;
  for (const std::string& text : domain.sizes) {
    const bool elements = holds(text, "[i]") || holds(text, "[l]");
    if (!elements && !holds(text, "|")) throw std::domain_error("its size does not grow with its coefficients");
    if (holds(text, "cap(")) throw std::domain_error("its size depends on two arrays of inputs in different ways");
    kind_ = elements ? Kind::kSum : Kind::kNorm;
  }
}

Sized Sizes::operator()(const Magnitudes& error, std::size_t output, const Box& box) const {
  if (kind_ == Kind::kSum) return of_sum(error, output);
  if (kind_ == Kind::kNorm) return of_norm(error, output);
  const double absolute = error.one();
  if (absolute == 0) return {};
  const double size = of_box(box, output);
  if (!(size > 0)) throw std::domain_error("its size may be zero");
  return {absolute / size * kSlack, region_.homogeneous ? 0 : absolute};
}

double Sizes::at(const std::vector<double>& inputs, std::size_t output) const {
  return size_(inputs, static_cast<std::size_t>(kernel_.element(static_cast<int>(output)))) / kSlack;
}

// The least size on a box. The sizes of caps are concave in the only coordinate; all others depend on no coordinate but
// the length of the vector, which is 1.
double Sizes::of_box(const Box& box, std::size_t output) const {
  std::vector<double> inputs(region_.coordinate.size(), 0.0);
  if (region_.logarithmic < 0) {
    if (!inputs.empty()) inputs[0] = 1;
    return at(inputs, output);
  }
  const Interval cap = box[region_.logarithmic];
  inputs[0] = cap.low;
  const double low = at(inputs, output);
  inputs[0] = cap.high;
  return std::min(low, at(inputs, output));
}

// The size where one or two coefficients are 1 and all others 0. `second` is `first` for linear kernels.
double Sizes::of_unit(std::size_t first, std::size_t second, std::size_t output) const {
  const auto [position, added] = known_.try_emplace({first, second, output}, 0);
  if (added) {
    std::vector<double> inputs(region_.coordinate.size(), 0.0);
    inputs[first] = inputs[second] = 1;
    position->second = at(inputs, output);
  }
  return position->second;
}

// The size where every channel of every array has length 1.
double Sizes::of_unit_arrays(std::size_t output) const {
  std::vector<double> inputs(region_.coordinate.size(), 0.0);
  std::size_t first = 0;
  for (const Parameter& array : kernel_.parameters) {
    const int count = array.size() / array.channels();
    for (int i = 0; i < array.size(); i += count) inputs[first + i] = 1;
    first += array.size();
  }
  return at(inputs, output);
}

// |error| <= sum e_i |c_i| + e and size = sum s_i |c_i|, so the quotient is at most the largest e_i / s_i, and e / size.
Sized Sizes::of_sum(const Magnitudes& error, std::size_t output) const {
  Sized sized;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < error.inputs(); ++i) {
    if (error.of(i) == 0) continue;
    const double size = of_unit(i, i, output);
    if (!(size > 0)) throw std::domain_error("its size leaves out a coefficient");
    least = std::min(least, size);
    sized.relative = std::max(sized.relative, error.of(i) / size);
    sized.absolute += error.of(i);
  }
  if (error.one() > 0) sized.relative += error.one() * scale_ / least;
  return {sized.relative * kSlack, (sized.absolute + error.one()) * kSlack};
}

Sized Sizes::of_norm(const Magnitudes& error, std::size_t output) const {
  double square = 0;
  std::optional<std::size_t> used;
  for (std::size_t i = 0; i < error.inputs(); ++i) {
    square += error.of(i) * error.of(i);
    if (error.of(i) > 0) used = i;
  }
  if (!used) return {};
  const double absolute = std::sqrt(square) * kSlack + error.one() * scale_;
  return {absolute / of_unit(*used, *used, output) * kSlack, absolute};
}

Sized Sizes::operator()(const BilinearError& error, std::size_t output) const {
  if (kind_ != Kind::kNorm) throw std::domain_error("its size is not a product of lengths");
  const double absolute = error.bilinear + (2 * error.linear + error.one * scale_) * scale_;
  return {absolute / of_unit_arrays(output) * kSlack, absolute};
}

std::vector<double> Sizes::worst_coefficients(const Magnitudes& error) const {
  std::vector<double> input(error.inputs(), 0.0);
  double square = 0;
  for (std::size_t i = 0; i < input.size(); ++i) {
    const bool symbol = region_.coordinate[i] < 0;
    input[i] = !symbol ? 0 : kind_ == Kind::kNorm ? error.of(i) : 1;
    square += input[i] * input[i];
  }
  for (double& value : input) value /= square > 0 && kind_ == Kind::kNorm ? std::sqrt(square) : 1;
  return input;
}

}  // namespace sh::codegen::bound
