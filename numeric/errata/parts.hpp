// The parts of the list (one a source, four for the longest), and the forms that a reading takes in them.
#pragma once

#include <utility>

#include "numeric/errata/errata.hpp"

namespace sh::errata {

using enum Kind;
using enum Print;

/// A reading that is decided exactly.
inline Reading holds(std::string text, std::string statement) {
  return {std::move(text), true, std::move(statement), "", ""};
}
inline Reading fails(std::string text, std::string statement) {
  return {std::move(text), false, std::move(statement), "", ""};
}

/// The same for a text that has one reading only.
inline Reading holds(std::string statement) { return holds("as printed", std::move(statement)); }
inline Reading fails(std::string statement) { return fails("as printed", std::move(statement)); }

/// A claim that is measured.
inline Reading measured(bool holds, std::string text, std::string number, std::string unit = "") {
  return {std::move(text), holds, "", std::move(number), std::move(unit)};
}

std::vector<Entry> green_sampling();     ///< Monte Carlo integration, projection, reconstruction
std::vector<Entry> green_basis();        ///< Legendre functions, real spherical harmonics
std::vector<Entry> green_rotation();     ///< products and rotation
std::vector<Entry> green_lighting();     ///< transfer, skies, lights
std::vector<Entry> gpfault();            ///< GP
std::vector<Entry> sloan();              ///< S
std::vector<Entry> brown();              ///< B
std::vector<Entry> ivanic_ruedenberg();  ///< IR
std::vector<Entry> choi();               ///< CH
std::vector<Entry> blanco();             ///< BL
std::vector<Entry> ramamoorthi();        ///< RH
std::vector<Entry> basri_jacobs();       ///< BJ

}  // namespace sh::errata
