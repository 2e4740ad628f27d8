// See kernel_limits.hpp.
#include "numeric/kernels/kernel_limits.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

#include "numeric/kernels/checks/checks.hpp"

namespace sh::numeric {
namespace {

struct Row {
  const char* family;
  int first_degree, last_degree;
  KernelLimits in_float;
  KernelLimits in_double;
};

// The promises: rounding of basis at most twice what Sloan's recurrence errs by on the same inputs (1.3, 1.3, 2.8, 4.4,
// 6.5, 8.2, 9.6, 11.1, 12.6 eps at degree 2 to 10 in float), of its accuracy choice at most 8; products less than 4.
// Whatever has no such reason: between 1.7 and 4 times what was measured on the inputs of the family's check, so that
// other compilers and rounding of the same formula fit. A variant without a row of its own has that of its family.
// Those of caps in float hold for every float (exhaustive.hpp).
// clang-format off
constexpr std::array kRows = {
    //  family                   degrees      float: rounding, total          double: rounding, total
    Row{"basis",                  0,  0,   {   0.9,    0.9 },               {   0.9,    0.9 }},
    Row{"basis",                  1,  1,   {   0.9,    2.0 },               {   0.9,    2.0 }},
    Row{"basis",                  2,  2,   {   2.6,      5 },               {   2.2,      5 }},
    Row{"basis",                  3,  3,   {   2.6,      7 },               {   2.9,      7 }},
    Row{"basis",                  4,  4,   {   5.6,     12, 7e-7 },         {   6.9,     12, 3e-15 }},
    Row{"basis",                  5,  5,   {   8.7,     20 },               {  10.8,     20 }},
    Row{"basis",                  6,  6,   {  13.0,     28 },               {  13.5,     28 }},
    Row{"basis",                  7,  7,   {  16.4,     35 },               {  16.4,     35 }},
    Row{"basis",                  8,  8,   {  19.2,     40 },               {  19.1,     40 }},
    Row{"basis",                  9,  9,   {  22.2,     45 },               {  21.4,     45 }},
    Row{"basis",                 10, 10,   {  25.1,     50 },               {  25.2,     50 }},
    Row{"basis_accurate",         0, 10,   {   8.0,     24 },               {   8.0,     24 }},
    Row{"basis_gradient",               0,  1,   {    1.0,    1.0 },               {    0.8,    0.8 }},
    Row{"basis_gradient",               2,  3,   {    4.5,    4.5 },               {    3.5,    3.5 }},
    Row{"basis_gradient",               4,  5,   {    9.3,    9.3 },               {   13.7,   13.7 }},
    Row{"basis_gradient",               6,  7,   {   18.0,   18.0 },               {   25.2,   25.2 }},
    Row{"basis_gradient",               8,  8,   {   20.9,   20.9 },               {   33.8,   33.8 }},
    Row{"basis_gradient",               9,  9,   {   25.7,   25.7 },               {   39.1,   39.1 }},
    Row{"basis_gradient",              10, 10,   {   32.4,   32.4 },               {   48.1,   48.1 }},
    Row{"basis_gradient_accurate",      8,  8,   {   32.7,   32.7 },               {   27.8,   27.8 }},
    Row{"basis_gradient_accurate",      9,  9,   {   37.6,   37.6 },               {   35.0,   35.0 }},
    Row{"basis_gradient_accurate",     10, 10,   {   43.7,   43.7 },               {   42.9,   42.9 }},
    Row{"basis_normalised",             0,  1,   {    2.8,    2.8 },               {    2.4,    2.4 }},
    Row{"basis_normalised",             2,  3,   {    9.9,    9.9 },               {   11.5,   11.5 }},
    Row{"basis_normalised",             4,  5,   {   23.0,   23.0 },               {   27.6,   27.6 }},
    Row{"basis_normalised",             6,  7,   {   38.0,   38.0 },               {   53.6,   53.6 }},
    Row{"basis_normalised",             8,  8,   {   46.6,   46.6 },               {   68.1,   68.1 }},
    Row{"basis_normalised",             9,  9,   {   56.4,   56.4 },               {   87.3,   87.3 }},
    Row{"basis_normalised",            10, 10,   {   65.5,   65.5 },               {    108,    108 }},
    Row{"basis_normalised_accurate",    7,  7,   {   35.4,   35.4 },               {   50.5,   50.5 }},
    Row{"basis_normalised_accurate",    8,  8,   {   35.4,   35.4 },               {   50.5,   50.5 }},
    Row{"basis_normalised_accurate",   10, 10,   {   58.3,   58.3 },               {   78.4,   78.4 }},
    Row{"evaluate",                     0,  1,   {    1.6,    1.8 },               {    2.4,    3.0 }},
    Row{"evaluate",                     2,  3,   {    2.2,    3.2 },               {    2.1,    3.7 }},
    Row{"evaluate",                     4,  5,   {    5.1,    5.1 },               {    4.6,   10.4 }},
    Row{"evaluate",                     6,  7,   {   10.4,   10.8 },               {    7.6,   15.2 }},
    Row{"evaluate",                     8,  8,   {    8.3,   12.2 },               {    7.3,   20.4 }},
    Row{"evaluate",                     9,  9,   {    8.0,   15.3 },               {    9.5,   26.0 }},
    Row{"evaluate",                    10, 10,   {   12.5,   15.2 },               {   14.1,   27.2 }},
    Row{"evaluate_prepare",             0,  1,   {    1.3,    1.3 },               {    0.6,    0.6 }},
    Row{"evaluate_prepare",             2,  3,   {    1.2,    1.2 },               {    1.4,    1.4 }},
    Row{"evaluate_prepare",             4,  5,   {    1.2,    1.2 },               {    1.3,    1.3 }},
    Row{"evaluate_prepare",             6,  7,   {    1.5,    1.5 },               {    1.1,    1.1 }},
    Row{"evaluate_prepare",             8,  8,   {    1.2,    1.2 },               {    1.3,    1.3 }},
    Row{"evaluate_prepare",             9,  9,   {    1.1,    1.1 },               {    1.3,    1.3 }},
    Row{"evaluate_prepare",            10, 10,   {    1.3,    1.3 },               {    1.1,    1.1 }},
    Row{"evaluate_prepared",            0,  1,   {    1.7,    1.4 },               {    1.6,    2.2 }},
    Row{"evaluate_prepared",            2,  3,   {    3.7,    3.8 },               {    3.0,    4.3 }},
    Row{"evaluate_prepared",            4,  5,   {    7.2,    7.5 },               {    7.9,   11.3 }},
    Row{"evaluate_prepared",            6,  7,   {   28.3,   29.3 },               {   23.6,   28.1 }},
    Row{"evaluate_prepared",            8,  8,   {   59.3,   59.6 },               {   56.7,   64.4 }},
    Row{"evaluate_prepared",            9,  9,   {    125,    122 },               {    182,    186 }},
    Row{"evaluate_prepared",           10, 10,   {    427,    430 },               {    235,    226 }},
    Row{"evaluate_rgb",                 0,  1,   {    2.3,    2.1 },               {    2.4,    3.0 }},
    Row{"evaluate_rgb",                 2,  3,   {    3.2,    3.4 },               {    3.9,    5.1 }},
    Row{"evaluate_rgb",                 4,  5,   {    7.3,    8.2 },               {    6.4,   10.5 }},
    Row{"evaluate_rgb",                 6,  7,   {   11.2,   11.4 },               {    7.6,   17.2 }},
    Row{"evaluate_rgb",                 8,  8,   {   10.7,   12.2 },               {    8.8,   21.2 }},
    Row{"evaluate_rgb",                 9,  9,   {   14.3,   15.3 },               {   11.9,   29.6 }},
    Row{"evaluate_rgb",                10, 10,   {   12.5,   16.4 },               {   14.1,   29.0 }},
    Row{"project",                      0,  1,   {    2.1,    2.1 },               {    1.6,    2.3 }},
    Row{"project",                      2,  3,   {    3.1,    3.7 },               {    3.5,    6.6 }},
    Row{"project",                      4,  5,   {   10.8,   13.2 },               {    9.6,   16.0 }},
    Row{"project",                      6,  7,   {   23.5,   29.8 },               {   16.0,   31.8 }},
    Row{"project",                      8,  8,   {   29.0,   38.0 },               {   22.3,   43.9 }},
    Row{"project",                      9,  9,   {   33.1,   47.1 },               {   25.9,   55.6 }},
    Row{"project",                     10, 10,   {   33.9,   57.4 },               {   31.9,   68.9 }},
    Row{"project_finish",               0,  1,   {    1.0,    1.0 },               {    0.6,    0.6 }},
    Row{"project_finish",               2,  3,   {    1.2,    1.2 },               {    1.0,    1.0 }},
    Row{"project_finish",               4,  5,   {    4.0,    4.0 },               {    4.3,    4.3 }},
    Row{"project_finish",               6,  7,   {   17.5,   17.5 },               {   17.9,   17.9 }},
    Row{"project_finish",               8,  8,   {   69.3,   69.3 },               {   63.2,   63.2 }},
    Row{"project_finish",               9,  9,   {   70.2,   70.2 },               {   76.1,   76.1 }},
    Row{"project_finish",              10, 10,   {    236,    236 },               {    322,    322 }},
    Row{"project_moments",              0,  1,   {    1.7,    1.8 },               {    1.8,    2.5 }},
    Row{"project_moments",              2,  3,   {    2.6,    3.0 },               {    4.2,    5.5 }},
    Row{"project_moments",              4,  5,   {    3.6,    5.2 },               {    5.8,    8.7 }},
    Row{"project_moments",              6,  7,   {    6.0,    7.5 },               {    7.5,   11.7 }},
    Row{"project_moments",              8,  8,   {    6.0,    8.3 },               {    8.5,   13.3 }},
    Row{"project_moments",              9,  9,   {    7.8,    9.1 },               {    9.0,   14.5 }},
    Row{"project_moments",             10, 10,   {    8.5,   10.0 },               {   10.3,   16.3 }},
    Row{"add_cap",                0,  1,   {   1.9,    1.9 },               {   1.6,    1.8 }},
    Row{"add_cap",                2,  3,   {   2.2,    3.0 },               {   2.7,    4.1 }},
    Row{"add_cap",                4,  5,   {    11,    8.8 },               {    11,    9.6 }},
    Row{"add_cap",                6,  9,   {    25,     21 },               {    28,     27 }},
    Row{"add_cap",               10, 10,   {    29,     23 },               {    29,     33 }},
    Row{"add_cap_rgb",            0,  1,   {   2.4,    2.4 },               {   2.1,    2.3 }},
    Row{"add_cap_rgb",            2,  3,   {   2.6,    3.3 },               {   3.2,    4.5 }},
    Row{"add_cap_rgb",            4,  5,   {    12,    9.4 },               {    12,     10 }},
    Row{"add_cap_rgb",            6,  9,   {    26,     21 },               {    28,     27 }},
    Row{"add_cap_rgb",           10, 10,   {    12,     14 },               {    24,     49 }},
    Row{"cap",                    0,  4,   {   2.4,    2.4 },               {   2.2,    2.2 }},
    Row{"cap",                    5,  6,   {   2.8,    2.8 },               {   3.2,    3.2 }},
    Row{"cap",                    7, 10,   {    23,     23 },               {    19,     19 }},
    Row{"cap_accurate",           7, 10,   {   7.5,    7.5 },               {   6.3,    6.3 }},
    Row{"irradiance",             0,  0,   {   0.4,    0.4 },               {   0.4,    0.4 }},
    Row{"irradiance",             1, 10,   {   1.3,    1.3 },               {   1.7,    1.7 }},
    Row{"irradiance_evaluate",    0,  0,   {   0.4,    0.4 },               {   0.4,    0.4 }},
    Row{"irradiance_evaluate",    1,  2,   {   2.2,    2.5 },               {   2.0,    2.2 }},
    Row{"irradiance_evaluate",    3,  6,   {   1.4,    1.6 },               {   2.0,    2.1 }},
    Row{"irradiance_evaluate",    7, 10,   {   1.2,    1.3 },               {   1.2,    1.3 }},
    Row{"irradiance_matrix",      2,  2,   {   0.7,    0.7 },               {   0.8,    0.8 }},
    Row{"lightmap",               1,  1,   {   1.5,    1.5 },               {   1.0,    1.0 }},
    Row{"lightmap_evaluate",      1,  1,   {   1.7,    1.7 },               {   1.7,    1.9 }},
    Row{"lightmap_project",       1,  1,   {   0.9,    0.9 },               {   1.1,    1.3 }},
    Row{"product",                0, 10,   {   0.8,    0.8 },               {   0.8,    0.8 }},
    Row{"product_full",           0, 10,   {   0.8,    0.8 },               {   0.8,    0.8 }},
    Row{"product_zonal",          0,  6,   {   0.4,    0.4 },               {   0.3,    0.3 }},
    Row{"product_zonal",          7, 10,   {  0.25,   0.25 },               {   0.3,    0.3 }},
    Row{"rotate",                   0,  1,   {   1.4,    1.4 },               {   1.2,    3.7 }},
    Row{"rotate",                   2,  3,   {   5.7,    5.8 },               {   7.7,   17.1 }},
    Row{"rotate",                   4,  5,   {   8.9,    8.1 },               {  11.9,   21.2 }},
    Row{"rotate",                   6,  7,   {  12.4,   12.9 },               {  13.1,   75.2 }},
    Row{"rotate",                   8, 10,   {  21.2,   21.7 },               {  20.4,   76.1 }},
    Row{"rotate_accurate",          2,  3,   {   2.6,    2.9 },               {   2.8,    9.5 }},
    Row{"rotate_accurate",          4,  5,   {   5.1,    4.7 },               {   9.0,   36.9 }},
    Row{"rotate_accurate",          6,  7,   {   9.0,   15.4 },               {   9.8,   51.9 }},
    Row{"rotate_accurate",          8, 10,   {   9.1,   12.6 },               {  11.5,   59.0 }},
    Row{"rotate_apply",             0,  1,   {   1.4,    1.4 },               {   1.2,    1.2 }},
    Row{"rotate_apply",             2,  3,   {   2.1,    2.1 },               {   1.8,    1.8 }},
    Row{"rotate_apply",             4,  5,   {   1.8,    1.8 },               {   2.0,    2.0 }},
    Row{"rotate_apply",             6,  7,   {   2.2,    2.2 },               {   1.8,    1.8 }},
    Row{"rotate_apply",             8, 10,   {   1.9,    1.9 },               {   2.4,    2.4 }},
    Row{"rotate_build",             0,  1,   {   0.4,    0.7 },               {   0.4,    4.5 }},
    Row{"rotate_build",             2,  3,   {   3.5,    6.8 },               {   3.8,   26.2 }},
    Row{"rotate_build",             4,  5,   {  11.0,   16.7 },               {  10.9,   64.3 }},
    Row{"rotate_build",             6,  7,   {  20.0,   28.4 },               {  22.0,    121 }},
    Row{"rotate_build",             8, 10,   {  33.0,   53.9 },               {  36.8,    234 }},
    Row{"rotate_build_accurate",    4,  5,   {   5.4,    6.8 },               {   9.4,   23.8 }},
    Row{"rotate_evaluate",          0,  1,   {   2.2,    1.9 },               {   1.3,    3.1 }},
    Row{"rotate_evaluate",          2,  3,   {   2.6,    2.2 },               {   2.1,    8.3 }},
    Row{"rotate_evaluate",          4,  5,   {   3.5,    4.2 },               {   3.6,   13.7 }},
    Row{"rotate_evaluate",          6,  7,   {   3.8,    6.6 },               {   5.4,   18.8 }},
    Row{"rotate_evaluate",          8, 10,   {   5.1,    6.4 },               {   8.8,   28.5 }},
    Row{"rotate_quaternion",        0,  1,   {   1.7,    2.3 },               {   1.6,    4.0 }},
    Row{"rotate_quaternion",        2,  3,   {  12.4,   12.2 },               {  12.3,   19.1 }},
    Row{"rotate_quaternion",        4,  5,   {  14.8,   14.9 },               {  11.1,   19.2 }},
    Row{"rotate_quaternion",        6,  7,   {  17.2,   31.8 },               {  19.7,   69.1 }},
    Row{"rotate_quaternion",        8, 10,   {  26.2,   40.5 },               {  28.6,   74.4 }},
    Row{"rotate_quaternion_accurate", 2,  3,   {   5.0,    8.7 },               {   6.7,   13.6 }},
    Row{"rotate_z",                 0,  1,   {   1.1,    1.4 },               {   1.1,    1.9 }},
    Row{"rotate_z",                 2,  3,   {   1.9,    3.5 },               {   1.8,    6.8 }},
    Row{"rotate_z",                 4,  5,   {   3.4,    5.5 },               {   3.1,   21.2 }},
    Row{"rotate_z",                 6,  7,   {   4.3,   12.2 },               {   4.2,   19.2 }},
    Row{"rotate_z",                 8, 10,   {   7.8,   19.0 },               {   8.6,   41.7 }},
    Row{"rotate_z_accurate",        2,  3,   {   1.5,    1.9 },               {   1.5,    3.7 }},
    Row{"rotate_z_accurate",        4,  5,   {   1.6,    2.7 },               {   1.7,    5.8 }},
    Row{"rotate_z_accurate",        6,  7,   {   1.6,    2.9 },               {   2.4,    5.3 }},
    Row{"rotate_z_accurate",        8, 10,   {   2.3,    3.0 },               {   2.5,    6.8 }},
    Row{"square",                 0, 10,   {   0.7,    0.7 },               {   0.8,    0.8 }},
    Row{"triple",                 0,  6,   {   0.5,    0.5 },               {   0.4,    0.4 }},
    Row{"triple",                 7, 10,   {  0.19,   0.19 },               {   0.2,    0.2 }},
    Row{"window_gaussian",        1,  2,   {   1.2,    1.2 },               {   1.2,    1.2 }},
    Row{"window_gaussian",        3,  5,   {   4.5,    4.5 },               {   4.3,    4.3 }},
    Row{"window_gaussian",        6, 10,   {   8.1,    8.1 },               {    14,     14 }},
    Row{"window_hann",            1,  4,   {   2.7,    2.7 },               {   2.3,    2.3 }},
    Row{"window_hann",            5,  8,   {   8.6,    8.6 },               {   8.9,    8.9 }},
    Row{"window_hann",            9, 10,   {    12,     12 },               {    15,     15 }},
    Row{"window_lanczos",         1,  2,   {   1.2,    1.2 },               {   1.3,    1.3 }},
    Row{"window_lanczos",         3,  5,   {   4.7,    4.7 },               {   4.3,    4.3 }},
    Row{"window_lanczos",         6, 10,   {   9.9,    9.9 },               {    11,     11 }},
    Row{"window_lanczos2",        1,  2,   {   1.9,    1.9 },               {   1.7,    1.7 }},
    Row{"window_lanczos2",        3,  5,   {   8.6,    8.6 },               {   8.1,    8.1 }},
    Row{"window_lanczos2",        6, 10,   {    17,     17 },               {    22,     22 }},
    Row{"window_lanczos4",        1,  2,   {   2.9,    2.9 },               {   2.7,    2.7 }},
    Row{"window_lanczos4",        3,  5,   {    17,     17 },               {    16,     16 }},
    Row{"window_lanczos4",        6, 10,   {    34,     34 },               {    42,     42 }},
    Row{"window_laplacian",       1, 10,   {   1.7,    1.7 },               {   1.3,    1.3 }},
    Row{"zonal",                  0,  0,   {   0.4,    0.4 },               {   0.4,    0.4 }},
    Row{"zonal",                  1,  1,   {   0.8,    1.1 },               {   0.9,    1.3 }},
    Row{"zonal",                  2,  3,   {   2.1,    3.6 },               {   2.2,    4.6 }},
    Row{"zonal",                  4,  5,   {    12,     14 },               {    11,     14 }},
    Row{"zonal",                  6, 10,   {    29,     39 },               {    28,     42 }},
    Row{"zonal_accurate",         4,  6,   {   6.1,    8.2 },               {   7.5,     16 }},
    Row{"zonal_accurate",         7,  9,   {    17,     21 },               {    13,     31 }},
    Row{"zonal_accurate",        10, 10,   {    21,     26 },               {    15,     35 }},
};
// clang-format on

// Kernels, by the start of their names, in which Mesa 22 multiplies neighbouring constants together although the result
// is declared invariant. Their errors in GLSL are held to the limits all the same.
constexpr std::array kRegroupedAnyway = {"product_l5",         "product_l8", "product_l10",
                                         "square_l5",          "square_l8",  "square_l10",
                                         "triple_l8",          "triple_l10", "basis_gradient_accurate_l",
                                         "evaluate_prepare_l", "project_l"};

std::string exceeded(const std::string& what, double value, double limit, const WorstCase& worst) {
  std::array<char, 64> numbers{};
  std::snprintf(numbers.data(), numbers.size(), " %.3g exceeds %.3g", value, limit);
  std::string text = what + numbers.data() + " (" + worst.output + " at " + worst.input;
  constexpr std::size_t kMostPrinted = 4;
  for (std::size_t i = 0; i < worst.values.size() && worst.values.size() <= kMostPrinted; ++i) {
    std::snprintf(numbers.data(), numbers.size(), "%s%.17g", i == 0 ? ": " : ", ", worst.values[i]);
    text += numbers.data();
  }
  return text + ")";
}

void check_errors(const KernelResult& result, const std::string& name, std::vector<std::string>& failures) {
  const auto limits = limits_for(result.family, result.degree, result.scalar);
  if (!limits) {
    failures.push_back(name + "no limit is set");
    return;
  }
  const double rounding = result.rounding.scaled().max();
  if (!(rounding <= limits->rounding)) {
    failures.push_back(name + exceeded("rounding error in eps", rounding, limits->rounding, result.worst_rounding));
  }
  const double total = result.total.scaled().max();
  if (!(total <= limits->total)) {
    failures.push_back(name + exceeded("total error in eps", total, limits->total, result.worst_total));
  }
  const double absolute = result.total.absolute().max();
  if (!(absolute <= limits->total_absolute)) {
    failures.push_back(name + exceeded("total error", absolute, limits->total_absolute, result.worst_total));
  }
}

}  // namespace

std::optional<KernelLimits> limits_for(const std::string& family, int degree, const std::string& scalar) {
  for (const std::string& name : {family, without_variant(family)}) {
    const auto* const row = std::find_if(kRows.begin(), kRows.end(), [&](const Row& r) {
      return name == r.family && degree >= r.first_degree && degree <= r.last_degree;
    });
    if (row != kRows.end()) return scalar == "float" ? row->in_float : row->in_double;
  }
  return {};
}

bool bits_must_agree(const KernelResult& result) {
  const auto is_excused = [&](const char* start) { return result.kernel.starts_with(start); };
  return result.operations.other == 0 && std::none_of(kRegroupedAnyway.begin(), kRegroupedAnyway.end(), is_excused);
}

std::vector<std::string> failures_of(const KernelResult& result) {
  const std::string name = result.kernel + " " + result.language + " " + result.scalar + ": ";
  std::vector<std::string> failures;
  check_errors(result, name, failures);
  if (result.different_in_place > 0) {
    failures.push_back(name + std::to_string(result.different_in_place) +
                       " values change when an input array is overwritten by the output");
  }
  if (result.bits && result.bits->different > 0 && bits_must_agree(result)) {
    failures.push_back(name + std::to_string(result.bits->different) + " of " + std::to_string(result.bits->compared) +
                       " values differ from c++ float in their bits; first: " + result.bits->first_difference);
  }
  return failures;
}

}  // namespace sh::numeric
