#include "prt/runtime/shader_texts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <utility>

namespace sh::prt {
namespace {

using namespace std::string_view_literals;
constexpr std::pair<std::string_view, std::string_view> kTexts[] = {
#include "shader_texts.inc"
};

}  // namespace

std::string_view shader_text(std::string_view file) {
  const auto* found =
      std::find_if(std::begin(kTexts), std::end(kTexts), [&](const auto& text) { return text.first == file; });
  if (found == std::end(kTexts)) throw std::logic_error(fmt::format("no shader text {}", file));
  return found->second;
}

std::string kernel_name(std::string_view family, int degree) { return fmt::format("{}_l{}", family, degree); }

}  // namespace sh::prt
