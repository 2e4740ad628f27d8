// Coefficients of a light as JSON, as `prt project` and `prt import` print them. The same text is a light of the type
// `coefficients`, in scenes and wherever a light is asked for.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string_view>
#include <vector>

#include "prt/light/light_coefficients.hpp"
#include "prt/scene/json_reader.hpp"

namespace sh::prt {

/// {"type": "coefficients", "degree", "convention", "axes", "unit", "color_space", "layout", "coefficients"}.
nlohmann::ordered_json coefficients_json(const LightCoefficients& light);

/// The keys that read_coefficients takes: those above, and what `prt project` and `prt light-at` say about their light, which is
/// left aside.
std::vector<std::string_view> coefficients_keys();

/// Throws std::runtime_error, `file: path: expected ...`, for another convention or unit than the project's, a degree
/// that is not that of the numbers, another count than three channels of bands^2, and numbers beyond single precision.
LightCoefficients read_coefficients(const JsonReader& reader);

}  // namespace sh::prt
