// Reads the window of a light.
#include <limits>

#include "prt/scene/scene_parts.hpp"

namespace sh::prt {
namespace {

/// The accepted words: the names of types, and `auto`.
WindowChoice choice_named(const JsonReader& reader) {
  WindowChoice choice;
  const std::string word =
      reader.one_of({"auto", kWindowNames[0], kWindowNames[1], kWindowNames[2], kWindowNames[3], kWindowNames[4]});
  choice.window.type = value_called<WindowType>(word, kWindowNames).value_or(choice.window.type);
  return choice;
}

}  // namespace

WindowChoice read_window(const JsonReader& reader) {
  if (reader.is_text()) return choice_named(reader);
  reader.allow({"type", "width", "lambda", "strength", "power", "keep"});
  WindowChoice choice = choice_named(reader.at("type"));
  const std::string_view key = number_key(choice.window.type);
  const bool is_sinc = choice.window.type == WindowType::kSinc;
  if (is_sinc) {
    reader.allow({"type", key, "power", "keep"});
  } else {
    reader.allow({"type", key, "keep"});
  }
  reader.take("power", choice.window.power, &JsonReader::integer, 1, kMaxPower);
  if (const auto number = reader.find(key)) {
    choice.automatic = false;
    choice.window.size = number->number(0.0, std::numeric_limits<double>::max(), "a number of 0 or more");
    if (const std::string flaw = window_flaw(choice.window); !flaw.empty()) number->expected(flaw);
  }
  reader.take("keep", choice.keep, [](const JsonReader& value) {
    return value.one_of({"radiance", "irradiance"}) == "radiance" ? Keep::kRadiance : Keep::kIrradiance;
  });
  return choice;
}

}  // namespace sh::prt
