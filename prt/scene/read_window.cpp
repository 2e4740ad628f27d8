// The window of a light: read_window of prt/scene/scene_parts.hpp.
#include <limits>

#include "prt/scene/scene_parts.hpp"

namespace sh::prt {
namespace {

/// One of the words, the kinds' names or `auto`.
WindowChoice choice_named(const JsonReader& reader) {
  WindowChoice choice;
  const std::string word =
      reader.one_of({"auto", kWindowNames[0], kWindowNames[1], kWindowNames[2], kWindowNames[3], kWindowNames[4]});
  for (std::size_t i = 0; i < std::size(kWindowNames); ++i) {
    if (word == kWindowNames[i]) {
      choice.window.type = static_cast<WindowType>(i);
    }
  }
  return choice;
}

}  // namespace

WindowChoice read_window(const JsonReader& reader) {
  if (reader.is_text()) {
    return choice_named(reader);
  }
  reader.allow({"type", "width", "lambda", "strength", "power", "keep"});
  WindowChoice choice = choice_named(reader.at("type"));
  const std::string_view key = number_key(choice.window.type);
  const bool is_sinc = choice.window.type == WindowType::kSinc;
  if (is_sinc) {
    reader.allow({"type", key, "power", "keep"});
  } else {
    reader.allow({"type", key, "keep"});
  }
  if (const auto power = reader.find("power")) {
    choice.window.power = power->integer(1, kMaxPower);
  }
  if (const auto number = reader.find(key)) {
    choice.automatic = false;
    choice.window.size = number->number(0.0, std::numeric_limits<double>::max(), "a number of 0 or more");
    if (const std::string flaw = window_flaw(choice.window); !flaw.empty()) {
      number->expected(flaw);
    }
  }
  if (const auto keep = reader.find("keep")) {
    choice.keep = keep->one_of({"radiance", "irradiance"}) == "radiance" ? Keep::kRadiance : Keep::kIrradiance;
  }
  return choice;
}

}  // namespace sh::prt
