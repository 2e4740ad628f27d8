// Scenes of any size, a generated city and copies of a model, and commands in processes of their own, so that memory is
// theirs.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace sh::bench {

/// Writes a scene of houses of several heights and colors on a ground, with about so many receivers; returns how many.
std::size_t write_city(const std::string& file, double receivers);

/// Writes a scene of copies of a model file side by side on a ground, with about so many receivers but one copy at least;
/// returns how many.
std::size_t write_copies(const std::string& file, const std::string& model, double receivers);

struct Cost {
  double seconds = 0.0;  // of the processor, of all threads and children
  double elapsed = 0.0;  // seconds on the clock
  double bytes = 0.0;    // of memory at the most, of the largest process
};

/// Runs a program, the first word, and waits. Throws std::runtime_error if it fails.
Cost run(const std::vector<std::string>& words);

}  // namespace sh::bench
