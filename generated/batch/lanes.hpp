// The type that kernels compute with: one register of the instruction set that this translation unit is compiled for.
//
// Copied by:    shgen write, from codegen/runtime to generated/batch
// Licence:      MIT-0; paste it anywhere.
//
// SH_BATCH_ISA names the instruction set and the namespace: baseline, avx2 or avx512. Nothing here may be used under
// two instruction sets by one name, or the linker would mix them.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <type_traits>
#include <utility>
#include <xsimd/xsimd.hpp>

#include "halves.hpp"

namespace sh::batch::SH_BATCH_ISA {

#if defined(__AVX512BW__)
using Isa = xsimd::avx512bw;
#elif defined(__AVX2__)
using Isa = xsimd::fma3<xsimd::avx2>;
#elif defined(__SSE2__)
using Isa = xsimd::sse2;
#else
using Isa = xsimd::default_arch;
#endif

// a b + c, a b - c and c - a b, rounded once where the instruction set has FMA.
#if defined(__AVX512F__)  // xsimd 8 leaves these to the compiler's contraction
inline __m512 multiply_add(__m512 a, __m512 b, __m512 c) noexcept { return _mm512_fmadd_ps(a, b, c); }
inline __m512d multiply_add(__m512d a, __m512d b, __m512d c) noexcept { return _mm512_fmadd_pd(a, b, c); }
inline __m512 multiply_subtract(__m512 a, __m512 b, __m512 c) noexcept { return _mm512_fmsub_ps(a, b, c); }
inline __m512d multiply_subtract(__m512d a, __m512d b, __m512d c) noexcept { return _mm512_fmsub_pd(a, b, c); }
inline __m512 subtract_product(__m512 c, __m512 a, __m512 b) noexcept { return _mm512_fnmadd_ps(a, b, c); }
inline __m512d subtract_product(__m512d c, __m512d a, __m512d b) noexcept { return _mm512_fnmadd_pd(a, b, c); }
#else
template <class Register>
Register multiply_add(const Register& a, const Register& b, const Register& c) noexcept {
  return xsimd::fma(a, b, c);
}
template <class Register>
Register multiply_subtract(const Register& a, const Register& b, const Register& c) noexcept {
  return xsimd::fms(a, b, c);
}
template <class Register>
Register subtract_product(const Register& c, const Register& a, const Register& b) noexcept {
  return xsimd::fnma(a, b, c);
}
#endif

// A product that is not rounded yet. Where the instruction set has FMA, a sum with it is rounded once; the types decide
// that, not the compiler, so that every compiler gives a record the same bits, alone and in a register. V: Lanes, Group or
// One.
template <class V>
class Product {
 public:
  Product(const V& a, const V& b) noexcept : a_(a), b_(b) {}
  operator V() const noexcept { return V::product(a_, b_); }  // NOLINT(google-explicit-constructor): a number

  friend V operator+(const Product& p, const V& c) noexcept { return V::multiply_add(p.a_, p.b_, c); }
  friend V operator+(const V& c, const Product& p) noexcept { return V::multiply_add(p.a_, p.b_, c); }
  friend V operator+(const Product& p, const Product& q) noexcept { return p + V(q); }
  friend V operator-(const Product& p, const V& c) noexcept { return V::multiply_subtract(p.a_, p.b_, c); }
  friend V operator-(const V& c, const Product& p) noexcept { return V::subtract_product(c, p.a_, p.b_); }
  friend V operator-(const Product& p, const Product& q) noexcept { return p - V(q); }

 private:
  V a_, b_;
};

// Where a kernel's constants come from: memory, as the compiler likes it, which takes a load at each use where registers do
// not suffice; registers alone; or factors from instructions at each use, and terms of sums from memory.
enum class Constants { kMemory, kRegisters, kInstructions };

#if defined(__AVX512F__)
#define SH_BATCH_BROADCASTS

// A constant in all lanes by way of a general register: no load, but an instruction on a port of arithmetic.
template <Constants From, class T>
[[gnu::always_inline]] inline auto broadcast(T value) noexcept {
  std::conditional_t<sizeof(T) == sizeof(float), std::int32_t, long long> bits;
  static_assert(sizeof bits == sizeof value);
  std::memcpy(&bits, &value, sizeof bits);
  if constexpr (From == Constants::kRegisters) {
    asm("" : "+r"(bits));
  } else {
    asm volatile("" : "+r"(bits));  // not before the loop: there are too few registers for all constants
  }
  if constexpr (sizeof(T) == sizeof(float)) {
    return _mm512_castsi512_ps(_mm512_set1_epi32(bits));
  } else {
    return _mm512_castsi512_pd(_mm512_set1_epi64(bits));
  }
}
#endif

// Some lanes of one value of a block. A block's value takes 64 bytes, a register perhaps less: successive elements of
// an array of Lanes are 64 bytes apart, and only the first register of each is used, so that an array of Lanes lies on
// a block.
template <class T, Constants From = Constants::kMemory>
class Lanes {
 public:
  using value_type = T;
  using Register = xsimd::batch<T, Isa>;
  static constexpr std::size_t kWidth = Register::size;
  static constexpr std::size_t kParts = detail::kLine / sizeof(Register);  // to cover a block

  Lanes() noexcept {}  // NOLINT(modernize-use-equals-default): Lanes{} must not cost a store
  explicit Lanes(T value) noexcept : Lanes(Register(value)) {}
  Lanes(Register value) noexcept : part_{value.data} {}
  Lanes(const Lanes& other) noexcept : part_{other.part_[0]} {}
  Lanes& operator=(const Lanes& other) noexcept {  // NOLINT(bugprone-unhandled-self-assignment): copies one register
    part_[0] = other.part_[0];
    return *this;
  }

  friend Lanes operator+(const Lanes& a, const Lanes& b) noexcept { return a.term() + b.term(); }
  friend Lanes operator-(const Lanes& a, const Lanes& b) noexcept { return a.term() - b.term(); }
  friend Product<Lanes> operator*(const Lanes& a, const Lanes& b) noexcept { return {a, b}; }
  friend Lanes operator/(const Lanes& a, const Lanes& b) noexcept { return a.get() / b.get(); }
  friend Lanes operator-(const Lanes& a) noexcept { return -a.get(); }
  friend auto operator<(const Lanes& a, const Lanes& b) noexcept { return a.get() < b.get(); }
  friend Lanes sqrt(const Lanes& a) noexcept { return xsimd::sqrt(a.get()); }
  friend Lanes select(const typename Register::batch_bool_type& condition, const Lanes& a, const Lanes& b) noexcept {
    return xsimd::select(condition, a.get(), b.get());
  }

  static Lanes product(const Lanes& a, const Lanes& b) noexcept { return a.factor() * b.factor(); }
  static Lanes multiply_add(const Lanes& a, const Lanes& b, const Lanes& c) noexcept {
    return Register(SH_BATCH_ISA::multiply_add(a.factor(), b.factor(), c.term()));
  }
  static Lanes multiply_subtract(const Lanes& a, const Lanes& b, const Lanes& c) noexcept {
    return Register(SH_BATCH_ISA::multiply_subtract(a.factor(), b.factor(), c.term()));
  }
  static Lanes subtract_product(const Lanes& c, const Lanes& a, const Lanes& b) noexcept {
    return Register(SH_BATCH_ISA::subtract_product(c.term(), a.factor(), b.factor()));
  }

 private:
  [[nodiscard]] [[gnu::always_inline]] Register get() const noexcept { return Register(part_[0]); }

  [[nodiscard]] [[gnu::always_inline]] Register factor() const noexcept {
#if defined(SH_BATCH_BROADCASTS)
    if constexpr (From != Constants::kMemory) {
      const T value = part_[0][0];
      if (__builtin_constant_p(value)) return Register(broadcast<From>(value));
    }
#endif
    return get();
  }
  [[nodiscard]] [[gnu::always_inline]] Register term() const noexcept {
    return From == Constants::kRegisters ? factor() : get();
  }

  typename Register::register_type part_[kParts];  // not of class type: g++ would keep a copy of each in memory
};

#if defined(__F16C__) || defined(__AVX512F__)
#define SH_BATCH_CONVERTS_HALVES
#endif

// The lanes of a register from half precision.
inline Lanes<float> widen_lanes(const Half* from) {
#if defined(__AVX512F__)
  return Lanes<float>::Register(_mm512_cvtph_ps(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(from))));
#elif defined(__F16C__)
  return Lanes<float>::Register(_mm256_cvtph_ps(_mm_loadu_si128(reinterpret_cast<const __m128i*>(from))));
#else
  float wide[Lanes<float>::kWidth];
  widen(from, Lanes<float>::kWidth, static_cast<float*>(wide));
  return Lanes<float>::Register::load_unaligned(static_cast<const float*>(wide));
#endif
}

// The lanes of a register from memory.
template <class T>
[[gnu::always_inline]] inline Lanes<T> load_lanes(const T* from) {
  return Lanes<T>::Register::load_aligned(from);
}
[[gnu::always_inline]] inline Lanes<float> load_lanes(const Half* from) { return widen_lanes(from); }

// Blocks in memory for a kernel: `blocks` of them, those of input j `step[j]` values apart (0: always the same one).
template <class T>
struct Blocks {
  const T* in[detail::kMostInputs] = {};
  std::size_t step[detail::kMostInputs] = {};
  T* out = nullptr;
  std::size_t out_step = 0;
  std::size_t count = 0;
  std::size_t lanes = kBlock<T>;  // in use; the others of the last register are 0
};

// The lanes that a kernel has to compute: whole registers.
template <class T>
[[gnu::always_inline]] inline std::size_t lanes_of(const Blocks<T>& blocks) {
  return Lanes<T>::kWidth == kBlock<T> ? kBlock<T> : blocks.lanes;
}

template <class T>
using BlockKernel = void (*)(const Blocks<T>&);

// `count` whole blocks of records of In values each, to records of Out values.
template <class T, std::size_t Out, std::size_t InA, std::size_t InB = 0>
[[gnu::always_inline]] inline Blocks<T> whole_blocks(const T* a, const T* b, std::size_t count, T* to) {
  Blocks<T> blocks;
  blocks.in[0] = a;
  blocks.in[1] = b;
  blocks.step[0] = InA * kBlock<T>;
  blocks.step[1] = InB * kBlock<T>;
  blocks.out = to;
  blocks.out_step = Out * kBlock<T>;
  blocks.count = count;
  return blocks;
}

// Calls kernel(in, out) for every register of every block; in[j] and out are arrays of Lanes, one a value.
// blocks: a copy, whose members no store of the kernel can change; a loop would load each of them again for every block.
template <int Inputs, Constants From = Constants::kMemory, class T, class Kernel>
[[gnu::always_inline]] inline void for_every_register(const Blocks<T> blocks, const Kernel& kernel) {
  for (std::size_t b = 0; b < blocks.count; ++b) {
    for (std::size_t lane = 0; lane < lanes_of(blocks); lane += Lanes<T>::kWidth) {
      const Lanes<T, From>* in[Inputs];
      for (int j = 0; j < Inputs; ++j) {
        in[j] = reinterpret_cast<const Lanes<T, From>*>(blocks.in[j] + b * blocks.step[j] + lane);
      }
      kernel(in, reinterpret_cast<Lanes<T, From>*>(blocks.out + b * blocks.out_step + lane));
    }
  }
}

// The same where input 0 is one record for all blocks: its Size values stay in registers, as far as those go.
template <int Inputs, int Size, class T, class Kernel>
[[gnu::always_inline]] inline void for_every_register_fixed(const Blocks<T>& blocks, const Kernel& kernel) {
  Lanes<T> fixed[Size];
  for (int k = 0; k < Size; ++k) fixed[k] = reinterpret_cast<const Lanes<T>*>(blocks.in[0])[k];
  for_every_register<Inputs>(blocks, [&](const Lanes<T>* const* in, Lanes<T>* out) {
    const Lanes<T>* with_fixed[Inputs] = {fixed};
    for (int j = 1; j < Inputs; ++j) with_fixed[j] = in[j];
    kernel(with_fixed, out);
  });
}

// body(0), body(1), ..., so that arrays with these indices may live in registers.
template <std::size_t... K, class Body>
[[gnu::always_inline]] inline void unrolled(std::index_sequence<K...> /*count*/, const Body& body) {
  static_cast<void>(std::initializer_list<int>{(body(K), 0)...});  // a fold nests deeper than clang allows
}

// Fetches `lines` lines that a stream will need into the nearest cache, and those far behind them into the second one.
// That takes more lines at a time than the nearest cache can wait for, and the processor's own prefetching lags behind.
// Near: bytes from there to the first of them.
template <std::size_t Near = 10240>
[[gnu::always_inline]] inline void prefetch_stream(const float* from, std::size_t lines) {
  constexpr std::size_t kNear = Near / sizeof(float);
  constexpr std::size_t kFar = 32768 / sizeof(float);
  for (std::size_t k = 0; k < lines; ++k) {
    __builtin_prefetch(from + kNear + k * kBlock<float>, 0, 3);
    __builtin_prefetch(from + kFar + k * kBlock<float>, 0, 2);
  }
}

// What `count` blocks in half precision need after one of them: `lines` of them, and lines of results that take them without
// waiting. Few stay in the nearest cache; what lies past them would only displace them.
[[gnu::always_inline]] inline void prefetch_half_blocks(const float* block, std::size_t count, std::size_t lines,
                                                        const float* out, std::size_t out_step) {
  constexpr std::size_t kAhead = 3;  // blocks
  constexpr std::size_t kFew = 512;  // lines
  if (count * lines <= kFew) return;
  prefetch_stream(block, lines);
  for (std::size_t k = 0; k < out_step; k += kBlock<float>) __builtin_prefetch(out + kAhead * out_step + k, 1, 2);
}

// for_every_register where input 0, Size values a record, is in half precision: `in[0]` and `step[0]` count two of them as one.
template <int Inputs, int Size, class Kernel>
[[gnu::always_inline]] inline void for_every_register_half(const Blocks<float> blocks, const Kernel& kernel) {
  for (std::size_t b = 0; b < blocks.count; ++b) {
    const float* block = blocks.in[0] + b * blocks.step[0];
    const auto* halves = reinterpret_cast<const Half*>(block);
    prefetch_half_blocks(block, blocks.count, (std::size_t(Size) + 1) / 2, blocks.out + b * blocks.out_step,
                         blocks.out_step);
    for (std::size_t lane = 0; lane < kBlock<float>; lane += Lanes<float>::kWidth) {
      Lanes<float> wide[Size];
      unrolled(std::make_index_sequence<std::size_t(Size)>(),
               [&](std::size_t k) { wide[k] = widen_lanes(halves + k * kBlock<float> + lane); });
      const Lanes<float>* in[Inputs] = {wide};
      for (int j = 1; j < Inputs; ++j) {
        in[j] = reinterpret_cast<const Lanes<float>*>(blocks.in[j] + b * blocks.step[j] + lane);
      }
      kernel(in, reinterpret_cast<Lanes<float>*>(blocks.out + b * blocks.out_step + lane));
    }
  }
}

// The scalar products of blocks, Rows rows of Length values a record each, with input 1, Sums rows: row r meets rows
// r Sums / Rows and up of it. The terms are added in their order, so that the bits are those of a plain loop.
// Stored: T, or Half, where `in[0]` and `step[0]` count two values as one.
template <int Rows, int Sums, std::size_t Length, class T, class Stored>
void multiply_blocks(const Blocks<T>& blocks) {
  constexpr std::size_t kSumsOfRow = Sums / Rows;
  constexpr std::size_t kRegisters = kBlock<T> / Lanes<T>::kWidth;
  const T* light = blocks.in[1];
  for (std::size_t b = 0; b < blocks.count; ++b) {
    const T* block = blocks.in[0] + b * blocks.step[0];
    T* out = blocks.out + b * blocks.out_step;
    if constexpr (sizeof(Stored) < sizeof(T))
      prefetch_half_blocks(block, blocks.count, (Rows * Length + 1) / 2, out, blocks.out_step);
    Lanes<T> sums[Sums][kRegisters];
    const auto add = [&](std::size_t k, auto is_first) __attribute__((always_inline)) {
      unrolled(
          std::make_index_sequence<Rows * kRegisters>(), [&](std::size_t i) __attribute__((always_inline)) {
            const std::size_t row = i / kRegisters;
            const std::size_t at = i % kRegisters;
            const std::size_t place = (row * Length + k) * kBlock<T> + at * Lanes<T>::kWidth;
            const Lanes<T> value = load_lanes(reinterpret_cast<const Stored*>(block) + place);
            unrolled(
                std::make_index_sequence<kSumsOfRow>(), [&](std::size_t j) __attribute__((always_inline)) {
                  const std::size_t sum = row * kSumsOfRow + j;
                  const Lanes<T> term = value * Lanes<T>(light[sum * Length + k]);
                  if constexpr (decltype(is_first)::value) {
                    sums[sum][at] = term;
                  } else {
                    sums[sum][at] = sums[sum][at] + term;
                  }
                });
          });
    };
    add(0, std::true_type());
#pragma GCC unroll 4
    for (std::size_t k = 1; k < Length; ++k) add(k, std::false_type());
    unrolled(
        std::make_index_sequence<Sums * kRegisters>(), [&](std::size_t i) __attribute__((always_inline)) {
          const std::size_t at = i % kRegisters * Lanes<T>::kWidth;
          *reinterpret_cast<Lanes<T>*>(out + i / kRegisters * kBlock<T> + at) = sums[i / kRegisters][i % kRegisters];
        });
  }
}

// Adds the scalar products of Parts x kWide plain records, Rows rows of Length >= 4 values each, with Sums rows of `light`: row
// r meets rows r Sums / Rows and up of it. Transposed columns stay in registers while they are added up, in their order, so that
// the bits are those of a plain loop; two parts by turns hide the time of an addition. count: the records of each part that are
// there. far: whether the next records have to be fetched.
template <int Rows, int Sums, std::size_t Length, std::size_t Parts, class Stored, class Count>
[[gnu::always_inline]] inline void add_products(const Stored* records, Count count, const float* light, bool far,
                                                Wide (*sums)[Parts]) {
  constexpr std::size_t kAtOnce = Parts * kWide;  // records
  constexpr std::size_t kSize = Rows * Length;
  constexpr std::size_t kSumsOfRow = Sums / Rows;
  for (std::size_t sum = 0; sum < Sums; ++sum) {
    for (std::size_t part = 0; part < Parts; ++part) sums[sum][part] = -Wide{};  // -0 leaves what is added to it
  }
  // Adds columns first + skipped to first + 3 of each row.
  const auto add = [&](std::size_t first, auto skipped) __attribute__((always_inline)) {
    constexpr std::size_t kSkipped = decltype(skipped)::value;
    constexpr std::size_t kNear = Rows == 1 ? 10240 : 4096;  // measured: longer records leave less room
    if (far) {
      prefetch_stream<kNear>(reinterpret_cast<const float*>(records + first * kAtOnce * Rows),
                             4 * kAtOnce * Rows * sizeof(Stored) / detail::kLine);
    }
    unrolled(
        std::make_index_sequence<Parts * Rows>(), [&](std::size_t k) __attribute__((always_inline)) {
          const std::size_t part = k / Rows;
          const std::size_t row = k % Rows;
          const Tiles columns = load_columns(records + part * kWide * kSize + row * Length + first, kSize, count);
          unrolled(
              std::make_index_sequence<(4 - kSkipped) * kSumsOfRow>(), [&](std::size_t j) __attribute__((
                                                                           always_inline)) {
                const std::size_t column = kSkipped + j / kSumsOfRow;
                const std::size_t sum = row * kSumsOfRow + j % kSumsOfRow;
                sums[sum][part] += columns.v[column] * light[sum * Length + first + column];
              });
        });
  };
  for (std::size_t first = 0; first + 4 <= Length; first += 4) add(first, std::integral_constant<std::size_t, 0>());
  if constexpr (Length % 4 != 0) add(Length - 4, std::integral_constant<std::size_t, 4 - Length % 4>());
}

// The scalar products of n plain records (add_products), a multiple of 2 kWide, with `light`, to plain records.
template <int Rows, int Sums, std::size_t Length, class Stored>
void multiply_pairs(const Stored* records, const float* light, std::size_t n, float* to) {
  constexpr std::size_t kParts = 2;
  constexpr std::size_t kNearest = 32768;  // bytes that stay in the nearest cache
  const bool far = n * Rows * Length * sizeof(Stored) > kNearest;
  for (std::size_t i = 0; i < n; i += kParts * kWide) {
    Wide sums[Sums][kParts];
    add_products<Rows, Sums, Length>(records + i * Rows * Length, std::integral_constant<std::size_t, kWide>(), light,
                                     far, sums);
    for (std::size_t part = 0; part < kParts; ++part) {
      float* out = to + (i + part * kWide) * Sums;
      if constexpr (Sums == 3) {
        store_triples(sums[0][part], sums[1][part], sums[2][part], out);
      } else {
        static_assert(Sums == 1);
        std::memcpy(out, &sums[0][part], sizeof(Wide));
      }
    }
  }
}

// The same of whole blocks with input 1. Stored: float, or Half, which `in[0]` points to then.
template <int Rows, int Sums, std::size_t Length, class Stored>
void multiply_records(const Blocks<float>& blocks) {
  multiply_pairs<Rows, Sums, Length>(reinterpret_cast<const Stored*>(blocks.in[0]), blocks.in[1],
                                     blocks.count * kBlock<float>, blocks.out);
}

// The same for a kernel that adds to Size values: they stay in registers, as far as those go, for all blocks.
template <int Inputs, int Size, class T, class Kernel>
[[gnu::always_inline]] inline void sum_every_register(const Blocks<T>& blocks, const Kernel& kernel) {
  for (std::size_t lane = 0; lane < kBlock<T>; lane += Lanes<T>::kWidth) {
    auto* out = reinterpret_cast<Lanes<T>*>(blocks.out + lane);
    Lanes<T> sum[Size];
    for (int k = 0; k < Size; ++k) sum[k] = out[k];
    for (std::size_t b = 0; b < blocks.count; ++b) {
      const Lanes<T>* in[Inputs];
      for (int j = 0; j < Inputs; ++j) {
        in[j] = reinterpret_cast<const Lanes<T>*>(blocks.in[j] + b * blocks.step[j] + lane);
      }
      kernel(in, sum);
    }
    for (int k = 0; k < Size; ++k) out[k] = sum[k];
  }
}

}  // namespace sh::batch::SH_BATCH_ISA
