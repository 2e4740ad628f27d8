// The drivers over many records: every driver against its kernel run record by record, on every instruction set.
#include "generated/batch/batch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

#include "tests/generated/batch_support.hpp"
#include "tests/message_of.hpp"

namespace sh::test {
namespace {

template <class T>
using Table = std::vector<std::vector<T>>;

template <class T>
class BatchDrivers : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(BatchDrivers, Scalars);

template <class T>
std::vector<Table<T>> random_inputs(const Subject<T>& subject, std::size_t n) {
  std::mt19937 random(static_cast<unsigned>(n) + 1);
  std::vector<Table<T>> inputs(subject.in.size());
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < inputs.size(); ++j) inputs[j].push_back(subject.record(j, random));
  }
  return inputs;
}

// Runs the driver with arrays at these places: of the inputs, then of the output.
template <class T>
Table<T> run(const Subject<T>& subject, const std::vector<Table<T>>& inputs, const std::vector<Place>& places) {
  const std::size_t n = inputs[0].size();
  std::vector<Array<T>> arrays;
  std::array<Records<const T>, kMostInputs> in;
  for (std::size_t j = 0; j < inputs.size(); ++j) {
    arrays.emplace_back(places[j], inputs[j], subject.in[j]);
    in[j] = arrays[j].records();
  }
  Array<T> out(places.back(), n, subject.out);
  subject.run(n, in, out.records());
  EXPECT_TRUE(out.guarded()) << subject.name << " degree " << subject.degree << ", " << n << " records";
  return out.read();
}

template <class T>
Table<T> run_kernel(const Subject<T>& subject, const std::vector<Table<T>>& inputs) {
  Table<T> out;
  for (std::size_t i = 0; i < inputs[0].size(); ++i) {
    std::array<const T*, kMostInputs> in{};
    for (std::size_t j = 0; j < inputs.size(); ++j) in[j] = inputs[j][i].data();
    out.emplace_back(subject.out);
    subject.kernel(in, out.back().data());
  }
  return out;
}

// Largest difference in machine epsilons; infinite where a value is not a number.
template <class T>
double difference(const Table<T>& a, const Table<T>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < a[i].size(); ++k) {
      const double d = std::abs(static_cast<double>(a[i][k]) - static_cast<double>(b[i][k]));
      if (!(d <= largest)) largest = std::isnan(d) ? std::numeric_limits<double>::infinity() : d;
    }
  }
  return largest / static_cast<double>(std::numeric_limits<T>::epsilon());
}

TYPED_TEST(BatchDrivers, EqualTheirKernelsForEveryLengthAndWriteNothingElse) {
  using T = TypeParam;
  constexpr std::size_t kBlock = batch::kBlock<T>;
  for (const Subject<T>& subject : subjects<T>()) {
    for (const std::size_t n : {std::size_t{0}, std::size_t{1}, kBlock - 1, kBlock, kBlock + 1, std::size_t{1000}}) {
      const auto inputs = random_inputs(subject, n);
      const auto expected = run_kernel(subject, inputs);
      on_every_set([&] {
        const auto result = run(subject, inputs, std::vector<Place>(inputs.size() + 1));
        EXPECT_LE(difference(result, expected), subject.tolerance) << subject.name << " " << subject.degree << " " << n;
      });
    }
  }
}

TYPED_TEST(BatchDrivers, GiveTheSameBitsInEveryLayoutAndAlignment) {
  using T = TypeParam;
  for (const Subject<T>& subject : subjects<T>()) {
    for (const std::size_t n :
         {std::size_t{1}, std::size_t{3}, std::size_t{6}, 2 * batch::kBlock<T>, 3 * batch::kBlock<T> + 5}) {
      const auto inputs = random_inputs(subject, n);
      on_every_set([&] {
        const auto plain = run(subject, inputs, std::vector<Place>(inputs.size() + 1));
        for (const Place in : {Place{Layout::kPlain, 1}, Place{Layout::kBlocked, 0}, Place{Layout::kBlocked, 3}}) {
          for (const Place out : {Place{Layout::kPlain, 1}, Place{Layout::kBlocked, 0}, Place{Layout::kBlocked, 5}}) {
            std::vector<Place> places(inputs.size(), in);
            places.push_back(out);
            EXPECT_EQ(run(subject, inputs, places), plain) << subject.name << " " << subject.degree;
          }
        }
      });
    }
  }
}

TYPED_TEST(BatchDrivers, GiveARecordTheSameBitsWhereverItStands) {
  using T = TypeParam;
  for (const Subject<T>& subject : subjects<T>()) {
    auto inputs = random_inputs(subject, 101);
    on_every_set([&] {
      const std::vector<Place> places(inputs.size() + 1);
      const auto all = run(subject, inputs, places);
      std::vector<Table<T>> rest = inputs;
      for (Table<T>& table : rest) table.erase(table.begin(), table.begin() + 37);
      EXPECT_EQ(run(subject, rest, places), Table<T>(all.begin() + 37, all.end())) << subject.name;
    });
  }
}

// Runs run(n, first record, out) for all records at once, then for a few at a time, the last ones first, and expects the
// same values: what a call writes past its records would replace those of the call before.
template <class T, class Run>
void expect_same_in_small_calls(std::size_t n, std::size_t size, const std::string& what, const Run& run) {
  std::vector<T> all(n * size);
  run(n, 0, all.data());
  const FencedArray<T> parts(n * size);
  // 37 is whole blocks and 5 records; the others are parts of groups, and groups and parts.
  constexpr std::array<std::size_t, 13> kFew{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 15, 37};
  for (const std::size_t few : kFew) {
    std::fill(parts.begin(), parts.end(), T(0));
    for (std::size_t end = n; end > 0;) {
      const std::size_t first = end - std::min(few, end);
      run(end - first, first, parts.data() + first * size);
      end = first;
    }
    EXPECT_EQ(std::vector<T>(parts.begin(), parts.end()), all) << what << ", " << few << " records at a time";
  }
}

TYPED_TEST(BatchDrivers, GiveTheSameBitsInSmallCallsAtEveryDegree) {
  using T = TypeParam;
  constexpr std::size_t n = 43;
  std::mt19937 random(17);
  std::uniform_real_distribution<T> uniform(-1, 1);
  const FencedArray<T> d(3 * n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::vector<T> direction = subjects<T>().front().record(0, random);
    std::copy(direction.begin(), direction.end(), d.begin() + static_cast<std::ptrdiff_t>(3 * i));
  }
  const FencedArray<T> c(3 * coefficient_count(10) * n);
  for (T& value : c) value = uniform(random);
  const FencedArray<T> rotations(9 * n);
  const auto turns = random_rotations<T>(n, random);
  std::copy(turns.begin(), turns.end(), rotations.begin());
  for (int degree = 0; degree <= 10; ++degree) {
    const auto size = static_cast<std::size_t>(coefficient_count(degree));
    const std::string at = " of degree " + std::to_string(degree);
    const auto directions = [&](std::size_t i) { return batch::plain<const T>(d.data() + 3 * i); };
    const auto coefficients = [&](std::size_t i, std::size_t sets) {
      return batch::plain<const T>(c.end() - sets * size * (n - i));  // the last ones end where memory ends
    };
    on_every_set([&] {
      expect_same_in_small_calls<T>(n, size, "basis" + at, [&](std::size_t count, std::size_t i, T* out) {
        batch::basis(degree, count, directions(i), batch::plain(out));
      });
      expect_same_in_small_calls<T>(n, 4 * size, "gradient" + at, [&](std::size_t count, std::size_t i, T* out) {
        batch::basis_gradient(degree, count, directions(i), batch::plain(out));
      });
      expect_same_in_small_calls<T>(n, 1, "evaluate" + at, [&](std::size_t count, std::size_t i, T* out) {
        batch::evaluate(degree, count, coefficients(i, 1), directions(i), batch::plain(out));
      });
      expect_same_in_small_calls<T>(n, 3, "evaluate_rgb" + at, [&](std::size_t count, std::size_t i, T* out) {
        batch::evaluate_rgb(degree, count, coefficients(i, 3), directions(i), batch::plain(out));
      });
      expect_same_in_small_calls<T>(n, 1, "relight" + at, [&](std::size_t count, std::size_t i, T* out) {
        batch::relight(degree, count, coefficients(i, 1), c.data(), batch::plain(out));
      });
      expect_same_in_small_calls<T>(n, 3, "relight_rgb" + at, [&](std::size_t count, std::size_t i, T* out) {
        batch::relight_rgb(degree, count, coefficients(i, 1), c.data(), batch::plain(out));
      });
      expect_same_in_small_calls<T>(n, 3, "relight_colored" + at, [&](std::size_t count, std::size_t i, T* out) {
        batch::relight_colored(degree, count, coefficients(i, 3), c.data(), batch::plain(out));
      });
      for (const bool is_shared : {false, true}) {
        expect_same_in_small_calls<T>(n, size, "rotate" + at, [&](std::size_t count, std::size_t i, T* out) {
          const Records<const T> r =
              is_shared ? batch::shared(rotations.data()) : batch::plain(rotations.data() + 9 * i);
          batch::rotate(degree, count, r, coefficients(i, 1), batch::plain(out));
        });
        if (degree > 6) continue;
        expect_same_in_small_calls<T>(n, size, "product" + at, [&](std::size_t count, std::size_t i, T* out) {
          const Records<const T> a = is_shared ? batch::shared(c.data()) : batch::plain(c.data() + size * i);
          batch::product(degree, count, a, coefficients(i, 1), batch::plain(out));
        });
      }
    });
  }
}

TYPED_TEST(BatchDrivers, TakeOneRecordForAll) {
  using T = TypeParam;
  for (const Subject<T>& subject : subjects<T>()) {
    for (std::size_t shared = 0; shared < subject.in.size(); ++shared) {
      auto inputs = random_inputs(subject, batch::kBlock<T> + 3);
      std::fill(inputs[shared].begin(), inputs[shared].end(), inputs[shared][0]);
      const auto expected = run_kernel(subject, inputs);
      on_every_set([&] {
        std::vector<Place> places(inputs.size() + 1);
        places[shared].layout = Layout::kShared;
        EXPECT_LE(difference(run(subject, inputs, places), expected), subject.tolerance_shared)
            << subject.name << " " << subject.degree << " input " << shared;
      });
    }
  }
}

TYPED_TEST(BatchDrivers, WriteOverAnInputOfTheSameShape) {
  using T = TypeParam;
  for (const Subject<T>& subject : subjects<T>()) {
    for (std::size_t j = 0; j < subject.in.size(); ++j) {
      if (subject.in[j] != subject.out) continue;
      for (const std::size_t n :
           {std::size_t{2}, std::size_t{3}, std::size_t{7}, batch::kBlock<T> + 1, batch::kBlock<T> + 3}) {
        const auto inputs = random_inputs(subject, n);
        on_every_set([&] {
          for (const Layout layout : {Layout::kPlain, Layout::kBlocked}) {
            const std::vector<Place> places(inputs.size() + 1, Place{layout, 0});
            std::vector<Array<T>> arrays;
            std::array<Records<const T>, kMostInputs> in;
            for (std::size_t i = 0; i < inputs.size(); ++i) {
              arrays.emplace_back(places[i], inputs[i], subject.in[i]);
              in[i] = arrays[i].records();
            }
            subject.run(inputs[0].size(), in, arrays[j].records());
            EXPECT_EQ(arrays[j].read(), run(subject, inputs, places)) << subject.name << " " << subject.degree;
          }
        });
      }
    }
  }
}

TYPED_TEST(BatchDrivers, GiveTheSameBitsPastTheCache) {
  using T = TypeParam;
  const std::size_t n = (std::size_t{32} << 20) / sizeof(T) / coefficient_count(10) + 7;  // 32 MB
  const Subject<T> subject = subjects<T>().front();
  ASSERT_EQ(subject.name, "basis");
  for (const Layout layout : {Layout::kPlain, Layout::kBlocked}) {
    const std::size_t size = coefficient_count(10);
    std::mt19937 random(3);
    std::vector<T> directions(3 * n);
    for (std::size_t i = 0; i < n; ++i) {
      const std::vector<T> d = subject.record(0, random);
      std::copy(d.begin(), d.end(), directions.begin() + static_cast<std::ptrdiff_t>(3 * i));
    }
    Array<T> out({layout, layout == Layout::kPlain ? std::size_t{1} : std::size_t{0}}, n, size);
    batch::basis(10, n, batch::plain(directions.data()), out.records());
    EXPECT_TRUE(out.guarded());
    for (std::size_t i = 0; i < n; i += 1 + n / 50) {
      std::vector<T> alone(size);
      batch::basis(10, 1, batch::plain(directions.data() + 3 * i), batch::plain(alone.data()));
      for (std::size_t k = 0; k < size; ++k) ASSERT_EQ(out.at(i, k), alone[k]) << i;
    }
  }
}

// The first value of a vector at 64 bytes; the vector has to be 64 bytes longer than what is used.
template <class T>
T* aligned(std::vector<T>& values) {
  void* first = values.data();
  std::size_t bytes = values.size() * sizeof(T);
  return static_cast<T*>(std::align(64, 1, first, bytes));
}

// Calls run(first record, records) for all at once and for parts, and expects the same `values` floats a record.
template <class Run>
void expect_as_in_parts(std::size_t n, std::size_t values, const Run& run) {
  constexpr std::size_t kPart = 1024 * batch::kBlock<float>;
  const std::size_t size = batch::blocked_size<float>(n, values);
  std::vector<float> whole(size + batch::kBlock<float>);
  std::vector<float> parts(whole.size());
  run(0, n, aligned(whole));
  for (std::size_t first = 0; first < n; first += kPart) {
    run(first, std::min(kPart, n - first), aligned(parts) + first * values);
  }
  EXPECT_TRUE(std::equal(aligned(whole), aligned(whole) + size, aligned(parts)));
}

// Outputs of more than 24 MB do not take the same way as those that stay in the caches.
TEST(Batch, OutputsThatOutgrowTheCachesHaveTheBitsOfTheirParts) {
  constexpr std::size_t kRows = 2'200'013;
  constexpr std::size_t kVisible = 540'011;
  const std::vector<float> light{0.5F, -0.25F, 2.0F, 1.0F, 3.0F, 0.75F, -1.0F, 0.5F, 0.125F, 1.5F, -2.0F, 0.25F};
  std::vector<float> samples(36);
  for (std::size_t k = 0; k < samples.size(); ++k) samples[k] = 0.01F * static_cast<float>(k);
  std::vector<float> rows(batch::blocked_size<float>(kRows, 4));
  for (std::size_t k = 0; k < rows.size(); ++k) rows[k] = 0.001F * static_cast<float>(k % 1009);
  std::vector<batch::Half> half_room(batch::blocked_size<float>(kVisible, 9) + 32);
  batch::Half* halves = aligned(half_room);
  for (std::size_t k = 0; k + 32 < half_room.size(); ++k) halves[k] = static_cast<batch::Half>(0x3000 + k % 1013);
  on_every_set([&] {
    expect_as_in_parts(kRows, 3, [&](std::size_t first, std::size_t n, float* out) {
      batch::relight_rgb(1, n, batch::plain<const float>(&rows[first * 4]), light.data(), batch::plain(out));
    });
    expect_as_in_parts(kRows, 3, [&](std::size_t first, std::size_t n, float* out) {
      batch::relight_rgb(1, n, batch::plain<const float>(&rows[first * 4]), light.data(), batch::blocked(out));
    });
    expect_as_in_parts(kVisible, 12, [&](std::size_t first, std::size_t n, float* out) {
      batch::transfer_apply_rgb(1, n, batch::blocked<const batch::Half>(&halves[first * 9]), samples.data(),
                                batch::blocked(out));
    });
    expect_as_in_parts(kVisible, 12, [&](std::size_t first, std::size_t n, float* out) {
      batch::transfer_apply_rgb(1, n, batch::blocked<const batch::Half>(&halves[first * 9]), samples.data(),
                                batch::plain(out));
    });
  });
}

TEST(Batch, RefusesWhatItCannotDoInOneLine) {
  std::array<float, 1000> values{};
  const auto plain = batch::plain(values.data());
  EXPECT_EQ(message_of([&] { batch::basis(11, 1, plain, plain); }),
            "sh::batch::basis: expected a degree of 0 to 10, got 11");
  EXPECT_EQ(message_of([&] { batch::basis(-1, 1, plain, plain); }),
            "sh::batch::basis: expected a degree of 0 to 10, got -1");
  EXPECT_EQ(message_of([&] { batch::basis(2, 1, plain, batch::shared(values.data())); }),
            "sh::batch::basis: expected a plain or blocked output, got a shared one");
  EXPECT_EQ(message_of([&] { batch::basis(2, 7, Records<const float>{}, plain); }),
            "sh::batch::basis: expected arrays of 7 records, got a null pointer");
  EXPECT_EQ(message_of([&] { batch::basis(2, 0, Records<const float>{}, Records<float>{}); }), "nothing thrown");
  const auto none = batch::shared(static_cast<const float*>(nullptr));
  EXPECT_EQ(message_of([&] { batch::basis(2, 0, none, Records<float>{}); }), "nothing thrown");
  EXPECT_EQ(message_of([&] { batch::rotate(2, 0, none, plain, Records<float>{}); }), "nothing thrown");
  EXPECT_EQ(message_of([&] { batch::relight(2, 0, Records<const float>{}, nullptr, Records<float>{}); }),
            "nothing thrown");
}

// Where AVX-512 is slow, it may take the kernels of AVX2.
template <class T>
void expect_the_basis_of_avx2() {
  constexpr std::size_t kCount = 37;
  std::vector<T> directions;
  for (std::size_t i = 0; i < kCount; ++i) {
    const T z = T(1) - T(2 * i + 1) / T(kCount);
    const T r = std::sqrt(1 - z * z);
    directions.insert(directions.end(), {r * std::cos(T(2.4) * T(i)), r * std::sin(T(2.4) * T(i)), z});
  }
  for (int degree = 0; degree <= 10; ++degree) {
    const auto size = static_cast<std::size_t>((degree + 1) * (degree + 1));
    std::vector<T> values[2] = {std::vector<T>(kCount * size), std::vector<T>(kCount * size)};
    batch::use_instruction_set(InstructionSet::kAvx2);
    batch::basis(degree, kCount, batch::plain<const T>(directions.data()), batch::plain(values[0].data()));
    batch::use_instruction_set(InstructionSet::kAvx512);
    EXPECT_EQ(batch::instruction_set(), InstructionSet::kAvx512);
    batch::basis(degree, kCount, batch::plain<const T>(directions.data()), batch::plain(values[1].data()));
    EXPECT_EQ(values[0], values[1]) << degree;
  }
}

TEST(Batch, TheBasisHasTheBitsOfAvx2OnAvx512) {
  const InstructionSet before = batch::instruction_set();
  if (!batch::available(InstructionSet::kAvx512)) GTEST_SKIP() << "needs AVX-512";
  expect_the_basis_of_avx2<float>();
  expect_the_basis_of_avx2<double>();
  batch::use_instruction_set(before);
}

TEST(Batch, ChoosesTheWidestInstructionSetUnlessTold) {
  const InstructionSet widest = batch::instruction_set();
  on_every_set([&] { EXPECT_GE(widest, batch::instruction_set()); });
  EXPECT_TRUE(batch::available(InstructionSet::kBaseline));
  EXPECT_EQ(batch::instruction_set(), widest);
}

}  // namespace
}  // namespace sh::test
