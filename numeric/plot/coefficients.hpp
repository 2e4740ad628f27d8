// Numbers that a user gives: in the command line, or in a file.
#pragma once
#include <string>
#include <vector>

namespace sh::numeric::plot {

/// Decimals separated by commas or whitespace; `name` begins each message. Throws std::invalid_argument: no number, not
/// a finite double.
std::vector<double> parse_numbers(const std::string& name, const std::string& text);

/// The same from a file, where `#` begins a comment that ends with the line; messages say FILE:LINE. Throws
/// std::runtime_error where it cannot be read or is larger than 4 MB.
std::vector<double> read_numbers(const std::string& file);

/// parse_numbers where `text` begins as a number does, else read_numbers (a file named like a number: ./NAME).
std::vector<double> numbers_from(const std::string& name, const std::string& text);

}  // namespace sh::numeric::plot
