// The commands of the tool `shcheck`: options in, results on standard output, progress and messages on standard error.
// A command reports an error by an exception with one line.
#pragma once

#include <array>
#include <stdexcept>
#include <string>

#include "numeric/commands/command_line.hpp"

namespace sh::numeric {

void add_kernel_commands(Command& tool);     ///< kernels, worst
void add_reference_commands(Command& tool);  ///< eval, legendre, rotation, gaunt, cap
void add_identify_commands(Command& tool);   ///< identify, rotation-matrix
void add_plot_command(Command& tool);
void add_report_commands(Command& tool);  ///< report, advise

void add_rotation_command(Command& tool);

/// The Count parts of "a,b,c". Throws std::invalid_argument: "OPTION: expected SHAPE separated by commas, got 'TEXT'"; a
/// shape is, for example, "three numbers x,y,z".
template <std::size_t Count>
std::array<std::string, Count> split_numbers(const std::string& option, const std::string& text,
                                             const std::string& shape) {
  std::array<std::string, Count> parts;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < Count; ++i) {
    const auto comma = text.find(',', begin);
    if ((comma == std::string::npos) != (i + 1 == Count)) {
      throw std::invalid_argument(option + ": expected " + shape + " separated by commas, got '" + text + "'");
    }
    parts[i] = text.substr(begin, comma - begin);
    begin = comma + 1;
  }
  return parts;
}

}  // namespace sh::numeric
