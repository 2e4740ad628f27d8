// Finds a place for each label beside its point that covers neither a point nor another label. Used by chart.cpp.
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace sh::output {

struct Box {
  double left;
  double top;
  double right;
  double bottom;
};

/// Width of a text in a sans-serif font of this size, by estimate (an average of 0.55 of the size a letter).
double text_width(const std::string& text, double size);

struct LabelPlace {
  double x;  ///< left end of the text
  double y;  ///< base line
  bool led;  ///< so far away that a line has to lead to it
};

/// Keeps what is taken, in a frame. Places are tried near first, in a fixed order.
class LabelPlacer {
 public:
  LabelPlacer(const Box& frame, double font_size) : frame_(frame), font_size_(font_size) {}
  void take(const Box& box) { taken_.push_back(box); }
  /// Takes the place that it returns; nothing where there is no room.
  std::optional<LabelPlace> place(double x, double y, const std::string& text, bool only_near = false);

 private:
  [[nodiscard]] bool is_free(const Box& box) const;

  Box frame_;
  double font_size_;
  std::vector<Box> taken_;
};

}  // namespace sh::output
