// The errata of the sources, each decided exactly: one list for `shgen errata`, for tests, and for readers.
#pragma once

#include <string>
#include <vector>

#include "symbolic/errata/entry.hpp"

namespace sh::symbolic::errata {

struct Source {
  std::string prefix;  ///< of its entries: "G"
  std::string name;    ///< author, title, year
  std::vector<Entry> entries;
};

std::vector<Entry> green();              ///< G: Green 2003
std::vector<Entry> gpfault();            ///< GP: gpfault 2026
std::vector<Entry> sloan();              ///< S: Sloan, Kautz, Snyder 2002
std::vector<Entry> brown();              ///< B: Brown 2004
std::vector<Entry> ivanic_ruedenberg();  ///< IR: Ivanic, Ruedenberg 1996, corrections 1998
std::vector<Entry> choi();               ///< CH: Choi, Ivanic, Gordon, Ruedenberg 1999
std::vector<Entry> blanco();             ///< BL: Blanco, Florez, Bermejo 1997
std::vector<Entry> ramamoorthi();        ///< RH: Ramamoorthi, Hanrahan 2001

std::vector<Source> all_sources();

}  // namespace sh::symbolic::errata
