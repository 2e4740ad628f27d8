// Transfers of every kind and storage, with the radiance that emitted run times have to give.
#pragma once
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "prt/basis.hpp"
#include "prt/runtime/glossy.hpp"
#include "prt/runtime/relight.hpp"
#include "prt/transfer/kept_bands.hpp"
#include "prt/transfer/storage.hpp"
#include "tests/prt/lights.hpp"

namespace sh::prt::test {

inline const Eigen::Vector3d kEye(1.5, -2.0, 3.0);

struct EmittedCase {
  std::string name;
  Transfer transfer;
  std::vector<std::uint32_t> light = {};  // the coefficients that the light has; empty: all
};

// As a file holds it.
inline Transfer stored(Transfer transfer, Element element, std::vector<std::uint32_t> kept = {},
                       bool one_channel = false) {
  transfer.shape.storage = {element, one_channel, std::move(kept)};
  transfer.stored = encode(transfer.coefficients, transfer.shape);
  transfer.coefficients.clear();
  return transfer;
}

inline Transfer with_lobes(const TransferKind& kind, int degree, std::size_t vertices,
                           const TransferShape& indirect = {}) {
  Transfer transfer = random_transfer(kind, degree, vertices);
  transfer.mesh.specular = transfer.mesh.albedo;
  for (std::size_t v = 0; v < vertices; ++v) {
    transfer.mesh.specular[v] *= 0.5F;
    transfer.mesh.exponent.push_back(static_cast<float>(v) * 7.5F);
    transfer.mesh.normals[v] = Eigen::Vector3f(0.1F * static_cast<float>(v % 7), -0.3F, 0.8F).normalized();
  }
  if (kind.indirect != nullptr) {
    transfer.indirect_shape = indirect;
    transfer.indirect = random_values(vertices * indirect.length(), 91);
    transfer.indirect = decode(encode(transfer.indirect, indirect), indirect);
  }
  return transfer;
}

inline TransferShape matrices(int degree, std::size_t channels, Element element) {
  TransferShape shape = kGlossyInterreflected.indirect(degree);
  shape.channels = channels;
  shape.storage.element = element;
  return shape;
}

inline Transfer keeping(Transfer transfer, const KeptBands& kept) {
  keep_bands(kept, transfer);
  return transfer;
}

/// Visibility of fewer bands, and matrices of fewer rows or columns.
inline void add_kept_cases(std::vector<EmittedCase>& all) {
  const auto visibility = [](int degree, Element element, int band) {
    Transfer transfer = keeping(with_lobes(kGlossyShadowed, degree, 19), {band});
    return stored(transfer, element, transfer.shape.storage.kept);
  };
  all.push_back({"kept_half", visibility(4, Element::kHalf, 6)});
  all.push_back({"kept_byte", visibility(3, Element::kByte, 2)});
  all.push_back({"kept_single_zonal", visibility(2, Element::kSingle, 3), {0, 2, 6}});
  all.push_back({"kept_constant", visibility(1, Element::kSingle, 0)});
  const auto bounces = [](int degree, std::size_t channels, Element element, const KeptBands& kept) {
    return keeping(with_lobes(kGlossyInterreflected, degree, 17, matrices(degree, channels, element)), kept);
  };
  all.push_back({"few_columns", bounces(4, 3, Element::kHalf, {8, 4, 2})});
  all.push_back({"few_rows", bounces(2, 3, Element::kSingle, {4, 1, 2})});
  all.push_back({"few_rows_gray", bounces(3, 1, Element::kHalf, {3, 0, 3})});
  all.push_back({"few_columns_gray_zonal", bounces(2, 1, Element::kSingle, {4, 2, 1}), {0, 2, 6}});
}

inline std::vector<EmittedCase> emitted_cases() {
  std::vector<EmittedCase> all;
  all.push_back({"one_vertex", random_transfer(kShadowed, 0, 1)});
  all.push_back({"single", random_transfer(kShadowed, 4, 32)});
  all.push_back({"half", stored(random_transfer(kShadowed, 4, 37), Element::kHalf)});
  all.push_back({"byte_kept", stored(random_transfer(kShadowed, 4, 37), Element::kByte, {0, 2, 6, 12, 20})});
  all.push_back({"normals", stored(random_transfer(kUnshadowed, kMaxDegree, 17), Element::kHalf)});
  all.push_back({"colored_byte", stored(random_transfer(kInterreflected, 4, 33), Element::kByte)});
  all.push_back({"gray_bounces", stored(random_transfer(kInterreflected, 2, 16), Element::kHalf, {}, true)});
  Transfer emitting = random_transfer(kInterreflected, 2, 15);
  emitting.emitted = emitting.mesh.albedo;
  all.push_back({"emitting_masked", emitting, {0, 2, 6}});
  all.push_back({"glossy_unshadowed", with_lobes(kGlossyUnshadowed, 3, 18)});
  all.push_back({"glossy", with_lobes(kGlossyShadowed, 4, 35)});
  all.push_back({"glossy_constant", with_lobes(kGlossyShadowed, 0, 5)});
  all.push_back({"glossy_half", stored(with_lobes(kGlossyShadowed, 2, 16), Element::kHalf)});
  all.push_back({"glossy_byte", stored(with_lobes(kGlossyShadowed, 3, 18), Element::kByte)});
  all.push_back({"glossy_zonal", with_lobes(kGlossyShadowed, 4, 16), {0, 2, 6, 12, 20}});
  Transfer dull = with_lobes(kGlossyShadowed, 1, 9);
  dull.mesh.specular.clear();
  dull.mesh.exponent.clear();
  all.push_back({"dull", dull});
  Transfer black = with_lobes(kGlossyShadowed, 3, 9);
  for (Eigen::Vector3f& albedo : black.mesh.albedo) albedo.setZero();
  all.push_back({"mirror_like", black});
  all.push_back({"bounces", with_lobes(kGlossyInterreflected, 1, 17, matrices(1, 3, Element::kSingle))});
  all.push_back(
      {"bounces_gray_zonal", with_lobes(kGlossyInterreflected, 2, 17, matrices(2, 1, Element::kHalf)), {0, 2, 6}});
  add_kept_cases(all);
  return all;
}

/// Of the highest degree.
inline std::vector<EmittedCase> highest_cases() {
  std::vector<EmittedCase> all;
  all.push_back({"glossy_highest", with_lobes(kGlossyShadowed, kHighestProduct, 18)});
  all.push_back({"bounces_highest",
                 with_lobes(kGlossyInterreflected, kHighestProduct, 17, matrices(kHighestProduct, 3, Element::kHalf))});
  return all;
}

inline LightCoefficients light_of(const EmittedCase& one) {
  LightCoefficients light = random_light(one.transfer.degree(), 77);
  std::vector<std::uint32_t> kept = one.light;
  if (kept.empty() && one.transfer.shape.meets == Meets::kDot) kept = one.transfer.shape.storage.kept;
  for (std::size_t i = 0; !kept.empty() && i < light.values.size(); ++i) {
    const auto index = static_cast<std::uint32_t>(i % light.bands_squared());
    if (std::find(kept.begin(), kept.end(), index) == kept.end()) light.values[i] = 0.0;
  }
  return light;
}

inline std::vector<Eigen::Vector3f> expected(const EmittedCase& one) {
  const LightCoefficients light = light_of(one);
  if (!one.transfer.kind->is_glossy()) return relight(one.transfer, light);
  return exit_radiance(one.transfer, TransferredRadiance(one.transfer, light), kEye, one.transfer.mesh.albedo);
}

inline void expect_near(const std::vector<Eigen::Vector3f>& got, const std::vector<Eigen::Vector3f>& wanted,
                        const std::string& name) {
  ASSERT_EQ(got.size(), wanted.size()) << name;
  float largest = 1e-3F;
  for (const Eigen::Vector3f& value : wanted) largest = std::max(largest, value.cwiseAbs().maxCoeff());
  for (std::size_t v = 0; v < got.size(); ++v) {
    EXPECT_LT((got[v] - wanted[v]).cwiseAbs().maxCoeff(), 4e-6F * largest) << name << " " << v;
  }
}

}  // namespace sh::prt::test
