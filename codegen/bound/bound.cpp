#include "codegen/bound/bound.hpp"

#include <queue>
#include <stdexcept>

#include "codegen/bound/size.hpp"
#include "codegen/bound/straight.hpp"

namespace sh::codegen::bound {
namespace {

constexpr double kLeastInput = 1e-30;  // far from subnormal numbers

// A box with the largest bound of all outputs.
struct Piece {
  Box box;
  Sized error;
  double urgency = 0;
};
bool operator<(const Piece& a, const Piece& b) { return a.urgency < b.urgency; }

class Search {
 public:
  Search(const Kernel& kernel, const Domain& domain, const Format& format, const Effort& effort)
      : kernel_(straight(kernel)),
        format_(format),
        effort_(effort),
        region_(region_of(kernel_, domain, format)),
        analysis_(kernel_, region_, format),
        sizes_(kernel_, domain, region_, format) {
    if (analysis_.terms() > effort.most_terms) throw std::domain_error("too many products of coefficients to analyze");
  }

  Bound run() {
    for (const Box& box : first_boxes(region_, format_)) add(box);
    first_ = largest();
    std::vector<Piece> pieces = std::move(pieces_);
    pieces_.clear();
    for (Piece& piece : pieces) queue_.push(with_urgency(std::move(piece)));
    const int most = std::min(effort_.most_boxes, static_cast<int>(effort_.operations / analysis_.cost()));
    while (!region_.root.empty() && boxes_ < most) split();
    while (!queue_.empty()) {
      pieces_.push_back(queue_.top());
      queue_.pop();
    }
    const Sized error = largest();
    Bound result{error.relative / format_.epsilon(), error.absolute, boxes_};
    result.domain = region_.text;
    result.worst_box = worst_piece().box;
    result.worst = worst_input(result.worst_box);
    return result;
  }

 private:
  void add(const Box& box) {
    ++boxes_;
    Piece piece{box, {}, 0};
    const std::vector<Magnitudes>& errors = analysis_(box);
    for (std::size_t output = 0; output < errors.size(); ++output) {
      const Sized error = sizes_(errors[output], output, box);
      piece.error.relative = std::max(piece.error.relative, error.relative);
      piece.error.absolute = std::max(piece.error.absolute, error.absolute);
    }
    pieces_.push_back(std::move(piece));
  }

  [[nodiscard]] Sized largest() const {
    Sized most;
    for (const Piece& piece : pieces_) {
      most.relative = std::max(most.relative, piece.error.relative);
      most.absolute = std::max(most.absolute, piece.error.absolute);
    }
    return most;
  }

  [[nodiscard]] Piece with_urgency(Piece piece) const {
    const auto part = [](double error, double of) { return of > 0 ? error / of : 0; };
    piece.urgency = std::max(part(piece.error.relative, first_.relative), part(piece.error.absolute, first_.absolute));
    return piece;
  }

  void split() {
    const Piece worst = queue_.top();
    queue_.pop();
    for (const Box& half : halves(worst.box, region_)) add(half);
    for (Piece& piece : pieces_) queue_.push(with_urgency(std::move(piece)));
    pieces_.clear();
  }

  [[nodiscard]] const Piece& worst_piece() const {
    return *std::max_element(pieces_.begin(), pieces_.end(),
                             [](const Piece& a, const Piece& b) { return a.error.relative < b.error.relative; });
  }

  // The middle of a box, with the coefficients that the bound assumes.
  std::vector<double> worst_input(const Box& box) {
    Box middle;
    for (const Interval& side : box) middle.push_back({side.low + side.width() / 2, side.low + side.width() / 2});
    const std::vector<Magnitudes> errors = analysis_(middle);
    std::size_t output = 0;
    for (std::size_t other = 1; other < errors.size(); ++other) {
      if (sizes_(errors[other], other, middle).relative > sizes_(errors[output], output, middle).relative)
        output = other;
    }
    std::vector<double> input = sizes_.worst_coefficients(errors[output]);
    const std::vector<int> signs = analysis_.signs(output);
    for (std::size_t i = 0; i < input.size(); ++i) {
      const int coordinate = region_.coordinate[i];
      input[i] = coordinate >= 0 ? middle[coordinate].low : signs[i] < 0 ? -input[i] : input[i];
      if (std::abs(input[i]) < kLeastInput) input[i] = 0;
    }
    return input;
  }

  Kernel kernel_;
  Format format_;
  Effort effort_;
  Region region_;
  RoundingAnalysis analysis_;
  Sizes sizes_;
  std::vector<Piece> pieces_;
  std::priority_queue<Piece> queue_;
  Sized first_;
  int boxes_ = 0;
};

}  // namespace

Bound bound(const Kernel& kernel, const Domain& domain, const Format& format, const Effort& effort) {
  try {
    return Search(kernel, domain, format, effort).run();
  } catch (const std::domain_error& reason) {
    Bound none;
    none.missing = reason.what();
    return none;
  }
}

}  // namespace sh::codegen::bound
