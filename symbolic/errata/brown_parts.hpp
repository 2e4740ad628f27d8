// The sections of Brown's page; symbolic/errata/brown.cpp joins them.
#pragma once

#include <vector>

#include "symbolic/errata/entry.hpp"

namespace sh::symbolic::errata {

std::vector<Entry> brown_definition();  ///< B-01 to B-07
std::vector<Entry> brown_tables();      ///< B-08 to B-13
std::vector<Entry> brown_irradiance();  ///< B-14 to B-17
std::vector<Entry> brown_rotation();    ///< B-18, B-19
std::vector<Entry> brown_comments();    ///< B-20 to B-22

}  // namespace sh::symbolic::errata
