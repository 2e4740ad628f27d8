// The sections of the longer sources; symbolic/errata/errata.cpp joins them.
#pragma once

#include <vector>

#include "symbolic/errata/entry.hpp"

namespace sh::symbolic::errata {

std::vector<Entry> green_monte_carlo();     ///< G-01 to G-11
std::vector<Entry> green_sampling();        ///< G-12 to G-16
std::vector<Entry> green_legendre();        ///< G-17 to G-28
std::vector<Entry> green_basis();           ///< G-29 to G-37
std::vector<Entry> green_projection();      ///< G-38 to G-46
std::vector<Entry> green_reconstruction();  ///< G-47 to G-49
std::vector<Entry> green_products();        ///< G-50 to G-57
std::vector<Entry> green_rotation();        ///< G-58 to G-62
std::vector<Entry> green_euler_angles();    ///< G-63 to G-70
std::vector<Entry> green_transfer();        ///< G-71 to G-79
std::vector<Entry> green_rendering();       ///< G-80 to G-86
std::vector<Entry> green_environments();    ///< G-87 to G-91
std::vector<Entry> green_lights();          ///< G-92 to G-94
std::vector<Entry> green_appendix();        ///< G-95 to G-98

std::vector<Entry> gpfault_foundations();  ///< GP-01 to GP-14
std::vector<Entry> gpfault_basis();        ///< GP-15 to GP-24
std::vector<Entry> gpfault_real_basis();   ///< GP-25 to GP-31
std::vector<Entry> gpfault_projection();   ///< GP-32 to GP-39
std::vector<Entry> gpfault_evaluation();   ///< GP-40 to GP-43
std::vector<Entry> gpfault_irradiance();   ///< GP-44 to GP-54

std::vector<Entry> sloan_basis();       ///< S-01 to S-07
std::vector<Entry> sloan_properties();  ///< S-08 to S-14
std::vector<Entry> sloan_transfer();    ///< S-15 to S-23
std::vector<Entry> sloan_simulation();  ///< S-24 to S-30
std::vector<Entry> sloan_sampling();    ///< S-31 to S-38

}  // namespace sh::symbolic::errata
