#include "codegen/bound/bound.hpp"

#include <numeric>
#include <queue>
#include <stdexcept>

#include "codegen/bound/bilinear.hpp"
#include "codegen/bound/every_number.hpp"
#include "codegen/bound/size.hpp"
#include "codegen/passes/passes.hpp"

namespace sh::codegen::bound {
namespace {

constexpr double kLeastInput = 1e-30;  // far from subnormal numbers

// A box, and the outputs whose errors there are not known to be small.
struct Piece {
  Box box;
  std::vector<std::size_t> outputs;
  Sized error;
  double urgency = 0;
};
bool operator<(const Piece& a, const Piece& b) { return a.urgency < b.urgency; }

Sized larger(Sized a, Sized b) { return {std::max(a.relative, b.relative), std::max(a.absolute, b.absolute)}; }

Box middle_of(const Box& box) {
  Box middle;
  for (const Interval& side : box) middle.push_back({side.low + side.width() / 2, side.low + side.width() / 2});
  return middle;
}

class Search {
 public:
  /// kernel: straight
  Search(const Kernel& kernel, const Domain& domain, const Region& region, const Format& format, const Effort& effort)
      : kernel_(kernel),
        format_(format),
        effort_(effort),
        region_(region),
        analysis_(kernel_, region_, format),
        sizes_(kernel_, domain, region_, format) {}

  Bound run() {
    std::vector<std::size_t> all(kernel_.outputs.size());
    std::iota(all.begin(), all.end(), 0);
    for (const Box& box : first_boxes(region_, format_)) queue_.push(piece(box, all));
    look_at_worst();
    const double most_visits = visits_ + effort_.operations * static_cast<double>(region_.root.size());
    Sized earlier = queue_.top().error;
    for (int next = std::max(kFirstCheck, 2 * boxes_); visits_ < most_visits && queue_.top().urgency > kNear;) {
      split();
      if (boxes_ < next) continue;
      look_at_worst();
      const Sized now = queue_.top().error;
      if (now.relative > earlier.relative * kLeastGain && now.absolute >= earlier.absolute * kLeastGain) break;
      earlier = now;
      next = 2 * boxes_;
    }
    Sized error = attained_;
    Box worst = queue_.top().box;
    double most = 0;
    for (; !queue_.empty(); queue_.pop()) {
      error = larger(error, queue_.top().error);
      if (queue_.top().error.relative <= most) continue;
      most = queue_.top().error.relative;
      worst = queue_.top().box;
    }
    Bound result{error.relative / format_.epsilon(), error.absolute, boxes_};
    result.domain = region_.text;
    result.worst_box = worst;
    result.worst = worst_input(worst);
    return result;
  }

 private:
  static constexpr double kNear = 1.05;       // of the error at a point: smaller boxes would gain no more
  static constexpr double kLeastGain = 0.98;  // of twice the boxes
  static constexpr int kFirstCheck = 1000;    // boxes

  // Outputs with errors below those attained elsewhere stay out of the parts of the box.
  Piece piece(const Box& box, const std::vector<std::size_t>& outputs) {
    ++boxes_;
    visits_ += static_cast<double>(kernel_.nodes.size());
    Piece piece{box, {}, {}, 0};
    analysis_.move_to(box);
    for (const std::size_t output : outputs) {
      visits_ += static_cast<double>(analysis_.cost(output));
      const Sized error = sizes_(analysis_.error(output), output, box);
      if (error.relative > attained_.relative || error.absolute > attained_.absolute) piece.outputs.push_back(output);
      piece.error = larger(piece.error, error);
    }
    set_urgency(piece);
    return piece;
  }

  // The error by the one that is attained.
  void set_urgency(Piece& piece) const {
    const auto part = [](double error, double of) { return of > 0 ? error / of : error; };
    piece.urgency =
        std::max(part(piece.error.relative, attained_.relative), part(piece.error.absolute, attained_.absolute));
  }

  // The bound at the middle of the worst box: no splitting of boxes gives a bound much below it.
  void look_at_worst() {
    const Box box = middle_of(queue_.top().box);
    const Piece middle = piece(box, queue_.top().outputs);
    if (middle.error.relative <= attained_.relative && middle.error.absolute <= attained_.absolute) return;
    attained_ = larger(attained_, middle.error);
    std::priority_queue<Piece> queue;
    for (; !queue_.empty(); queue_.pop()) {
      Piece next = queue_.top();
      set_urgency(next);
      queue.push(std::move(next));
    }
    queue_ = std::move(queue);
  }

  void split() {
    const Piece worst = queue_.top();
    queue_.pop();
    for (const Box& half : halves(worst.box, region_)) queue_.push(piece(half, worst.outputs));
  }

  // The middle of a box, with the coefficients that the bound assumes.
  std::vector<double> worst_input(const Box& box) {
    const Box middle = middle_of(box);
    analysis_.move_to(middle);
    std::size_t output = 0;
    double most = 0;
    for (std::size_t other = 0; other < kernel_.outputs.size(); ++other) {
      const double error = sizes_(analysis_.error(other), other, middle).relative;
      if (error <= most) continue;
      most = error;
      output = other;
    }
    std::vector<double> input = sizes_.worst_coefficients(analysis_.error(output));
    const std::vector<int> signs = analysis_.signs(output);
    for (std::size_t i = 0; i < input.size(); ++i) {
      const int coordinate = region_.coordinate[i];
      input[i] = coordinate >= 0 ? middle[coordinate].low : signs[i] < 0 ? -input[i] : input[i];
      if (std::abs(input[i]) < kLeastInput) input[i] = 0;
    }
    return input;
  }

  const Kernel& kernel_;
  Format format_;
  Effort effort_;
  const Region& region_;
  RoundingAnalysis analysis_;
  Sizes sizes_;
  std::priority_queue<Piece> queue_;
  Sized attained_;
  int boxes_ = 0;
  double visits_ = 0;
};

// All arrays of coefficients at once.
Bound of_products(const Kernel& kernel, const Domain& domain, const Region& region, const Format& format,
                  const Effort& effort) {
  const Sizes sizes(kernel, domain, region, format);
  const double work = static_cast<double>(kernel.nodes.size()) * static_cast<double>(region.coordinate.size()) *
                      static_cast<double>(kernel.outputs.size());
  if (work > effort.most_work) throw std::domain_error("too many products of coefficients to analyze");
  BilinearAnalysis analysis(kernel, format);
  Bound result{.boxes = 1, .domain = region.text};
  Sized most;
  for (std::size_t output = 0; output < kernel.outputs.size(); ++output) {
    const BilinearError error = analysis(output);
    const Sized sized = sizes(error, output);
    if (sized.relative > most.relative) result.worst = error.worst;
    most = {std::max(most.relative, sized.relative), std::max(most.absolute, sized.absolute)};
  }
  result.eps = most.relative / format.epsilon();
  result.absolute = most.absolute;
  return result;
}

}  // namespace

Bound bound(const Kernel& kernel, const Domain& domain, const Format& format, const Effort& effort) {
  try {
    const Kernel nodes = passes::unroll(kernel);
    const Region region = region_of(nodes, domain, format);
    if (is_bilinear(nodes, region)) return of_products(nodes, domain, region, format, effort);
    if (auto of_points = bound_at_every_number(nodes, domain, region, format)) return *of_points;
    return Search(nodes, domain, region, format, effort).run();
  } catch (const std::domain_error& reason) {
    Bound none;
    none.missing = reason.what();
    return none;
  }
}

}  // namespace sh::codegen::bound
