// relight_stored: transfer in blocks, of every type and instruction set, against a plain loop, bit for bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <vector>

#include "generated/batch/batch.hpp"

namespace sh::batch::test {
namespace {

constexpr std::size_t kLanes = 16;
constexpr std::size_t kChannels = 3;
constexpr InstructionSet kSets[] = {InstructionSet::kBaseline, InstructionSet::kAvx2, InstructionSet::kAvx512};

// Numbers of small magnitude and both signs that repeat late.
class Numbers {
 public:
  float next() {
    state_ = state_ * 1664525U + 1013904223U;
    return static_cast<float>(static_cast<std::int32_t>(state_)) * 4.6566129e-10F;
  }

 private:
  std::uint32_t state_ = 7;
};

template <class Stored>
Stored stored_of(float value);
template <>
float stored_of(float value) {
  return value;
}
template <>
std::int8_t stored_of(float value) {
  return static_cast<std::int8_t>(value * 127.0F);
}
template <>
Half stored_of(float value) {  // by the bits of single precision, cut; denormals of half become zero
  std::uint32_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  const std::int32_t exponent = static_cast<std::int32_t>(bits >> 23U & 255U) - 112;
  const std::uint32_t magnitude =
      exponent <= 0 ? 0 : static_cast<std::uint32_t>(exponent) << 10U | (bits >> 13U & 1023U);
  return static_cast<Half>((bits >> 16U & 0x8000U) | magnitude);
}

float value_of(float stored, float /*scale*/) { return stored; }
float value_of(std::int8_t stored, float scale) { return static_cast<float>(stored) * scale; }
float value_of(Half stored, float /*scale*/) {
  const auto half = static_cast<std::uint32_t>(stored);
  if ((half & 0x7fffU) == 0) return (half & 0x8000U) != 0 ? -0.0F : 0.0F;
  const std::uint32_t bits = (half & 0x8000U) << 16U | ((half & 0x7fffU) + (112U << 10U)) << 13U;
  float value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

// The radiance of receivers, and their blocks.
template <class Stored>
struct Case {
  Case(std::size_t rows, std::size_t columns, std::size_t blocks)
      : scales(rows * columns), light(kChannels * columns), data(blocks * kLanes * rows * columns) {
    Numbers numbers;
    for (float& scale : scales) scale = 0.01F + std::abs(numbers.next());
    for (float& value : light) value = numbers.next();
    for (Stored& value : data) value = stored_of<Stored>(numbers.next());
    transfer = {data.data(), scales.data(), rows, columns};
    for (std::size_t i = 0; i < blocks * kLanes; ++i) {
      for (std::size_t channel = 0; channel < kChannels; ++channel) {
        float sum = 0.0F;
        for (std::size_t k = 0; k < columns; ++k) {
          const std::size_t number = (rows == 1 ? 0 : channel * columns) + k;
          const std::size_t place = i / kLanes * kLanes * rows * columns + number * kLanes + i % kLanes;
          sum += value_of(data[place], scales[number]) * light[channel * columns + k];
        }
        expected.push_back(sum);
      }
    }
  }
  std::vector<float> scales, light;
  std::vector<Stored> data;
  StoredBlocks<Stored> transfer;
  std::vector<float> expected;
};

template <class Stored>
class RelightStored : public ::testing::Test {
 protected:
  ~RelightStored() override { use_instruction_set(widest_); }

 private:
  InstructionSet widest_ = instruction_set();
};
using Types = ::testing::Types<float, Half, std::int8_t>;
TYPED_TEST_SUITE(RelightStored, Types);

TYPED_TEST(RelightStored, HasTheBitsOfAPlainLoop) {
  for (const InstructionSet set : kSets) {
    if (!available(set)) continue;
    use_instruction_set(set);
    for (const std::size_t rows : {1U, 3U}) {
      for (const std::size_t columns : {1U, 3U, 4U, 9U, 25U, 121U, 441U}) {
        for (const std::size_t blocks : {0U, 1U, 2U, 5U}) {
          const Case<TypeParam> c(rows, columns, blocks);
          std::vector<float> out(c.expected.size() + 1, 7.0F);  // one more, which stays
          relight_stored(c.transfer, blocks, c.light.data(), nullptr, out.data());
          EXPECT_TRUE(std::equal(c.expected.begin(), c.expected.end(), out.begin()))
              << rows << ' ' << columns << ' ' << blocks;
          EXPECT_EQ(out.back(), 7.0F);
        }
      }
    }
  }
}

TYPED_TEST(RelightStored, TakesArraysOfAnyAlignment) {
  for (const InstructionSet set : kSets) {
    if (!available(set)) continue;
    use_instruction_set(set);
    const Case<TypeParam> c(1, 9, 3);
    std::vector<TypeParam> moved(c.data.size() + 1);
    std::copy(c.data.begin(), c.data.end(), moved.begin() + 1);
    std::vector<float> out(c.expected.size() + 1);
    relight_stored({moved.data() + 1, c.scales.data(), 1, 9}, 3, c.light.data(), nullptr, out.data() + 1);
    EXPECT_TRUE(std::equal(c.expected.begin(), c.expected.end(), out.begin() + 1));
  }
}

TYPED_TEST(RelightStored, MultipliesByFactorsWhereverItWrites) {
  for (const InstructionSet set : kSets) {
    if (!available(set)) continue;
    use_instruction_set(set);
    for (const std::size_t rows : {1U, 3U}) {
      const Case<TypeParam> c(rows, 9, 3);
      const std::size_t count = c.expected.size();
      std::vector<float> factors(count);
      for (std::size_t i = 0; i < count; ++i) factors[i] = 0.1F * static_cast<float>(i);
      for (const bool past_caches : {false, true}) {
        for (std::size_t skipped = 0; skipped < 6; ++skipped) {  // aligned to 16 bytes, and not
          std::vector<float> out(count + 7, 7.0F);
          relight_stored(c.transfer, 3, c.light.data(), factors.data(), out.data() + skipped, past_caches);
          for (std::size_t i = 0; i < count; ++i) ASSERT_EQ(out[skipped + i], c.expected[i] * factors[i]) << i;
          relight_stored(c.transfer, 3, c.light.data(), nullptr, out.data() + skipped, past_caches);
          for (std::size_t i = 0; i < count; ++i) ASSERT_EQ(out[skipped + i], c.expected[i]) << i;
          EXPECT_EQ(std::count(out.begin(), out.end(), 7.0F), 7);
        }
      }
    }
  }
}

TYPED_TEST(RelightStored, RefusesMissingArraysAndTwoRows) {
  const Case<TypeParam> c(1, 4, 1);
  std::vector<float> out(c.expected.size());
  const auto refuses = [&](const StoredBlocks<TypeParam>& transfer, const float* light, float* to) {
    EXPECT_THROW(relight_stored(transfer, 1, light, nullptr, to), std::invalid_argument);
  };
  refuses({c.data.data(), c.scales.data(), 2, 2}, c.light.data(), out.data());
  refuses({nullptr, c.scales.data(), 1, 4}, c.light.data(), out.data());
  refuses(c.transfer, nullptr, out.data());
  refuses(c.transfer, c.light.data(), nullptr);
  if constexpr (sizeof(TypeParam) == 1) refuses({c.data.data(), nullptr, 1, 4}, c.light.data(), out.data());
}

}  // namespace
}  // namespace sh::batch::test
