// Relighting of diffuse vertices: transfer coefficients times the coefficients of a light.
#include "codegen/families/exact.hpp"
#include "codegen/measure/domains.hpp"
#include "codegen/recipes/product/product.hpp"

namespace sh::codegen {
namespace {

constexpr unsigned long kSeed = 20020703;
constexpr int kInputs = 400;

Reference relight_reference(int degree, int points, int transfer_channels, int light_channels) {
  const int count = coefficient_count(degree);
  const auto transfers = rational_vectors(points, transfer_channels * count, kSeed);
  const auto lights = rational_vectors(points, light_channels * count, kSeed + 1);
  return reference_at(joined(transfers, lights), [=](const Rationals& input) {
    std::vector<cln::cl_F> sums(light_channels, precise(0));
    for (int i = 0; i < light_channels * count; ++i) {
      const cln::cl_RA& transfer = input[transfer_channels == 1 ? i % count : i];
      sums[i / count] = sums[i / count] + precise(transfer * input[transfer_channels * count + i]);
    }
    return sums;
  });
}

// Vectors of norm 1, one for each channel of the transfer and of the light.
Inputs relight_inputs(int degree, int channels) {
  Inputs vectors(kInputs);
  for (int channel = 0; channel < channels; ++channel) {
    vectors = joined(std::move(vectors), unit_vectors(kInputs, coefficient_count(degree), kSeed + 2 + channel));
  }
  return vectors;
}

// single, grouped: BatchDriver.
Family relight_family(const std::string& name, int transfer_channels, int light_channels, const std::string& what,
                      const std::vector<int>& single, int grouped) {
  const std::string transfer = transfer_channels == 1 ? "|transfer|" : "|transfer[k]|";
  const std::string light = light_channels == 1 ? "|light|" : "|light[k]|";
  return {
      .name = name,
      .recipes = {{"sum", [=](int degree) { return recipes::relight(degree, transfer_channels, light_channels); }}},
      .reference = [=](int degree,
                       int points) { return relight_reference(degree, points, transfer_channels, light_channels); },
      .domain = {.inputs = "transfer and lights (random, of norm 1 in each channel)",
                 .unit = "|transfer| |light| of a channel",
                 .test_inputs = [=](int degree) { return relight_inputs(degree, transfer_channels + light_channels); },
                 .sizes = {transfer + " " + light}},
      .batch = BatchDriver{.what = what, .half = true, .scalar_products = true, .single = single, .grouped = grouped}};
}

}  // namespace

std::vector<Family> relight_families() {
  return {relight_family("relight", 1, 1, "Exit radiance of diffuse vertices under a light of one channel",
                         {15, 15, 15, 14, 11, 9, 7, 6}, 4),
          relight_family("relight_rgb", 1, 3, "The same under a light of three channels", {12, 12, 8, 6, 5, 4, 3}, 4),
          relight_family("relight_colored", 3, 3, "The same where transfer has three channels, too",
                         {16, 16, 12, 10, 8, 6, 5, 4}, -1)};
}

}  // namespace sh::codegen
