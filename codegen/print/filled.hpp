// Text with words to fill in: what printers of whole files use.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace sh::codegen::print {

/// The text with every $word (letters, digits, _) replaced by its value. Throws std::logic_error for a word without one.
std::string filled(std::string_view text, const std::map<std::string, std::string>& words);

/// The second and third line at the head of a generated file.
extern const char* const kStamp;

}  // namespace sh::codegen::print
