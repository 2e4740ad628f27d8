// Drivers over interleaved colors: the bits of the same call with plain records, or of one call a channel.
#include <gtest/gtest.h>

#include <cstring>
#include <stdexcept>

#include "generated/batch/batch.hpp"
#include "tests/generated/batch_support.hpp"
#include "tests/message_of.hpp"

namespace sh::test {
namespace {

constexpr std::size_t kChannels = 3;
constexpr std::array<std::size_t, 9> kLengths{0, 1, 2, 3, 15, 16, 17, 47, 700};  // 700: several chunks of copies

// Where value i of records of three channels, channel by channel, stands coefficient by coefficient.
std::size_t place_of(std::size_t i, std::size_t values) {
  return (i / values / kChannels * values + i % values) * kChannels + i / values % kChannels;
}

// n records of three channels of `values` each, channel by channel and coefficient by coefficient.
template <class T>
struct Colors {
  std::size_t n, values;
  FencedArray<T> plain, interleaved;

  Colors(std::size_t records, std::size_t values_of_channel, std::mt19937& random)
      : n(records), values(values_of_channel), plain(n * kChannels * values), interleaved(n * kChannels * values) {
    std::uniform_real_distribution<T> uniform(-1, 1);
    for (T& value : plain) value = uniform(random);
    interleave(plain.data(), interleaved.data());
  }
  void interleave(const T* from, T* to) const {
    for (std::size_t i = 0; i < n * kChannels * values; ++i) to[place_of(i, values)] = from[i];
  }
  [[nodiscard]] std::vector<T> channel(std::size_t c) const {
    std::vector<T> result(n * values);
    for (std::size_t i = 0; i < n; ++i) {
      std::copy_n(plain.data() + (i * kChannels + c) * values, values, result.data() + i * values);
    }
    return result;
  }
};

template <class T>
std::vector<T> random_values(std::size_t count, std::mt19937& random) {
  std::uniform_real_distribution<T> uniform(-1, 1);
  std::vector<T> result(count);
  for (T& value : result) value = uniform(random);
  return result;
}

template <class T>
std::vector<T> copy_of(const FencedArray<T>& values) {
  return {values.begin(), values.end()};
}

// Runs test(degree, n) on every instruction set.
template <class Test>
void at_every_length(std::initializer_list<int> degrees, const Test& test) {
  for (const int degree : degrees) {
    for (const std::size_t n : kLengths) {
      SCOPED_TRACE("degree " + std::to_string(degree) + ", " + std::to_string(n) + " records");
      on_every_set([&] { test(degree, n); });
    }
  }
}

template <class T>
class BatchInterleaved : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(BatchInterleaved, Scalars);

TYPED_TEST(BatchInterleaved, EvaluatesAndRelightsTheSameBits) {
  using T = TypeParam;
  std::mt19937 random(5);
  at_every_length({0, 1, 2, 3, 6, 10}, [&](int degree, std::size_t n) {
    const auto values = static_cast<std::size_t>(coefficient_count(degree));
    const Colors<T> c(n, values, random);
    const auto directions = random_values<T>(3 * n + 1, random);
    const FencedArray<T> expected(3 * n), out(3 * n);
    batch::evaluate_rgb(degree, n, batch::plain<const T>(c.plain.data()), batch::plain(directions.data()),
                        batch::plain(expected.data()));
    batch::evaluate_rgb(degree, n, batch::interleaved<const T>(c.interleaved.data()), batch::plain(directions.data()),
                        batch::plain(out.data()));
    EXPECT_EQ(copy_of(out), copy_of(expected));
    const auto light = random_values<T>(3 * values, random);
    batch::relight_colored(degree, n, batch::plain<const T>(c.plain.data()), light.data(),
                           batch::plain(expected.data()));
    batch::relight_colored(degree, n, batch::interleaved<const T>(c.interleaved.data()), light.data(),
                           batch::plain(out.data()));
    EXPECT_EQ(copy_of(out), copy_of(expected));
  });
}

TYPED_TEST(BatchInterleaved, TransfersTheSameBits) {
  using T = TypeParam;
  std::mt19937 random(7);
  at_every_length({0, 1, 3, 6}, [&](int degree, std::size_t n) {
    const auto values = static_cast<std::size_t>(coefficient_count(degree));
    const auto visibility = random_values<T>(n * static_cast<std::size_t>(coefficient_count(2 * degree)) + 1, random);
    const auto samples =
        random_values<T>(degree == 0 ? 3 : 3 * (8 * static_cast<std::size_t>(degree * degree) + 4), random);
    const Colors<T> out(n, values, random);
    std::vector<T> expected(n * kChannels * values), result(expected.size());
    batch::transfer_apply_rgb(degree, n, batch::plain(visibility.data()), samples.data(), batch::plain(result.data()));
    out.interleave(result.data(), expected.data());
    batch::transfer_apply_rgb(degree, n, batch::plain(visibility.data()), samples.data(),
                              batch::interleaved(out.interleaved.data()));
    EXPECT_EQ(copy_of(out.interleaved), expected);
  });
}

// Expects of run(c, out), which maps plain records of one channel, and of the same with colors the same values.
template <class T, class One, class Three>
void expect_channels(const Colors<T>& c, const One& one, const Three& three) {
  std::vector<T> expected(c.n * kChannels * c.values);
  for (std::size_t channel = 0; channel < kChannels; ++channel) {
    const auto in = c.channel(channel);
    std::vector<T> out(in.size() + 1);
    one(channel, batch::plain(in.data()), batch::plain(out.data()));
    for (std::size_t i = 0; i < in.size(); ++i) expected[i * kChannels + channel] = out[i];
  }
  const FencedArray<T> out(expected.size());
  three(batch::interleaved<const T>(c.interleaved.data()), batch::interleaved(out.data()));
  EXPECT_EQ(copy_of(out), expected);
  // Over the input.
  three(batch::interleaved<const T>(c.interleaved.data()), batch::interleaved(c.interleaved.data()));
  EXPECT_EQ(copy_of(c.interleaved), expected);
}

TYPED_TEST(BatchInterleaved, RotatesEachChannelByTheSameMatrix) {
  using T = TypeParam;
  std::mt19937 random(8);
  at_every_length({0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10}, [&](int degree, std::size_t n) {
    const auto rotations = random_rotations<T>(n + 1, random);
    std::vector<T> in_blocks(batch::blocked_size<T>(n, 9) + 1);
    constexpr std::size_t kBlock = batch::kBlock<T>;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = 0; k < 9; ++k) {
        in_blocks[i / kBlock * kBlock * 9 + k * kBlock + i % kBlock] = rotations[9 * i + k];
      }
    }
    for (const Records<const T> r :
         {Records<const T>(batch::plain(rotations.data())), Records<const T>(batch::shared(rotations.data())),
          Records<const T>(batch::blocked(in_blocks.data()))}) {
      const Colors<T> c(n, static_cast<std::size_t>(coefficient_count(degree)), random);
      expect_channels(
          c, [&](std::size_t, Records<const T> in, Records<T> out) { batch::rotate(degree, n, r, in, out); },
          [&](Records<const T> in, Records<T> out) { batch::rotate(degree, n, r, in, out); });
    }
  });
}

TYPED_TEST(BatchInterleaved, MultipliesEachChannelByOneFunctionOrByItsOwn) {
  using T = TypeParam;
  std::mt19937 random(9);
  at_every_length({0, 1, 2, 3, 4, 6}, [&](int degree, std::size_t n) {
    const auto values = static_cast<std::size_t>(coefficient_count(degree));
    const auto one = random_values<T>(n * values + values, random);
    for (const Records<const T> a :
         {Records<const T>(batch::plain(one.data())), Records<const T>(batch::shared(one.data()))}) {
      expect_channels(
          Colors<T>(n, values, random),
          [&](std::size_t, Records<const T> in, Records<T> out) { batch::product(degree, n, a, in, out); },
          [&](Records<const T> in, Records<T> out) { batch::product(degree, n, a, in, out); });
    }
    const Colors<T> b(n, values, random);
    expect_channels(
        Colors<T>(n, values, random),
        [&](std::size_t channel, Records<const T> in, Records<T> out) {
          batch::product(degree, n, in, batch::plain<const T>(b.channel(channel).data()), out);
        },
        [&](Records<const T> in, Records<T> out) {
          batch::product(degree, n, in, batch::interleaved<const T>(b.interleaved.data()), out);
        });
  });
}

TYPED_TEST(BatchInterleaved, RotatesMoreThanTheCachesHold) {
  using T = TypeParam;
  constexpr std::size_t n = 20'003;
  std::mt19937 random(10);
  const auto r = random_rotations<T>(1, random);
  const auto rotate = [&](Records<const T> in, Records<T> out) {
    batch::rotate(10, n, batch::shared(r.data()), in, out);
  };
  expect_channels(
      Colors<T>(n, 121, random), [&](std::size_t, Records<const T> in, Records<T> out) { rotate(in, out); }, rotate);
}

TEST(BatchInterleavedHalves, EvaluateTheSameBits) {
  std::mt19937 random(11);
  at_every_length({0, 1, 3, 10}, [&](int degree, std::size_t n) {
    const auto values = static_cast<std::size_t>(coefficient_count(degree));
    const Colors<float> like(n, values, random);
    std::vector<batch::Half> plain(like.n * kChannels * values + 1), colors(plain.size());
    for (std::size_t i = 0; i + 1 < plain.size(); ++i) {
      plain[i] = batch::Half(0x3000 + random() % 0x0c00);
      colors[place_of(i, values)] = plain[i];
    }
    const auto directions = random_values<float>(3 * n + 1, random);
    std::vector<float> expected(3 * n + 1), out(3 * n + 1);
    const auto run = [&](Records<const batch::Half> c, std::vector<float>& to) {
      batch::evaluate_rgb(degree, n, c, batch::plain<const float>(directions.data()), batch::plain(to.data()));
    };
    run(batch::plain<const batch::Half>(plain.data()), expected);
    run(batch::interleaved<const batch::Half>(colors.data()), out);
    EXPECT_EQ(out, expected);
  });
}

TEST(BatchInterleavedArrays, AreRefusedWhereThereAreNoColors) {
  std::vector<float> a(3 * 9), b(3 * 9), out(3 * 9);
  const auto colors = batch::interleaved<const float>(a.data());
  const auto plain = batch::plain<const float>(b.data());
  EXPECT_EQ(
      message_of([&] { batch::basis(1, 1, plain, batch::interleaved(out.data())); }),
      "sh::batch::basis: expected interleaved arrays only for coefficients of three channels, of which there are none");
  EXPECT_EQ(message_of([&] { batch::evaluate_rgb(1, 1, plain, colors, batch::plain(out.data())); }),
            "sh::batch::evaluate_rgb: expected interleaved arrays only for coefficients of three channels");
  EXPECT_EQ(message_of([&] { batch::rotate(1, 1, colors, colors, batch::interleaved(out.data())); }),
            "sh::batch::rotate: expected interleaved arrays only for coefficients");
  const std::string both = "expected an interleaved output with interleaved inputs, got one of them";
  EXPECT_EQ(message_of([&] { batch::rotate(1, 1, plain, colors, batch::plain(out.data())); }),
            "sh::batch::rotate: " + both);
  EXPECT_EQ(message_of([&] { batch::product(1, 1, plain, plain, batch::interleaved(out.data())); }),
            "sh::batch::product: " + both);
  EXPECT_EQ(message_of([&] { batch::project(1, 1, plain, colors, out.data()); }),
            "sh::batch::project: expected interleaved arrays only for coefficients of three channels, of which there "
            "are none");
}

}  // namespace
}  // namespace sh::test
