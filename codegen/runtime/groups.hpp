// Plain records without blocks: groups of them in registers, from rows to columns and back on the way, or one by one.
//
// Copied by:    shgen write, from codegen/runtime to generated/batch
// Licence:      MIT-0; paste it anywhere.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstring>

#include "lanes.hpp"

namespace sh::batch::SH_BATCH_ISA {

// Records in a group: the lanes of the registers that tiles have. Two are not worth it: one by one then.
template <class T>
constexpr std::size_t kGroup = kTaken<T> > 2 ? kTaken<T> : 1;

template <class T>
struct GroupRegister {
  using type = Wide;
};
template <>
struct GroupRegister<double> {
  using type = Doubles;
};

inline float multiply_add(float a, float b, float c) noexcept {
#if defined(__FMA__)
  return std::fma(a, b, c);
#else
  return a * b + c;
#endif
}
inline double multiply_add(double a, double b, double c) noexcept {
#if defined(__FMA__)
  return std::fma(a, b, c);
#else
  return a * b + c;
#endif
}
#if defined(__FMA__)
inline Wide multiply_add(const Wide& a, const Wide& b, const Wide& c) noexcept { return _mm256_fmadd_ps(a, b, c); }
inline Doubles multiply_add(const Doubles& a, const Doubles& b, const Doubles& c) noexcept {
  return _mm256_fmadd_pd(a, b, c);
}
#else
inline Wide multiply_add(const Wide& a, const Wide& b, const Wide& c) noexcept { return a * b + c; }
inline Doubles multiply_add(const Doubles& a, const Doubles& b, const Doubles& c) noexcept { return a * b + c; }
#endif

// A value of one record or of a group: a scalar or a register of them.
template <class T, class Register>
class Packed {
 public:
  using value_type = T;

  Packed() noexcept {}  // NOLINT(modernize-use-equals-default): Packed{} must not cost a store
  explicit Packed(T value) noexcept : value_(value - Register{}) {}
  static Packed of(const Register& value) noexcept {
    Packed packed;
    packed.value_ = value;
    return packed;
  }
  [[nodiscard]] const Register& get() const noexcept { return value_; }

  friend Packed operator+(const Packed& a, const Packed& b) noexcept { return of(a.value_ + b.value_); }
  friend Packed operator-(const Packed& a, const Packed& b) noexcept { return of(a.value_ - b.value_); }
  friend Product<Packed> operator*(const Packed& a, const Packed& b) noexcept { return {a, b}; }
  friend Packed operator-(const Packed& a) noexcept { return of(-a.value_); }

  static Packed product(const Packed& a, const Packed& b) noexcept { return of(a.value_ * b.value_); }
  static Packed multiply_add(const Packed& a, const Packed& b, const Packed& c) noexcept {
    return of(SH_BATCH_ISA::multiply_add(a.value_, b.value_, c.value_));
  }
  static Packed multiply_subtract(const Packed& a, const Packed& b, const Packed& c) noexcept {
    return multiply_add(a, b, -c);
  }
  static Packed subtract_product(const Packed& c, const Packed& a, const Packed& b) noexcept {
    return multiply_add(-a, b, c);
  }

 private:
  Register value_;
};
template <class T>
using One = Packed<T, T>;
template <class T>
using Group = Packed<T, typename GroupRegister<T>::type>;

// The columns of a group of records of Size values.
template <std::size_t Size, class T>
[[gnu::always_inline]] inline void load_group(const T* records, Group<T>* columns) {
  using Register = typename GroupRegister<T>::type;
  if constexpr (Size == 1) {
    Register column;
    std::memcpy(&column, records, sizeof column);
    columns[0] = Group<T>::of(column);
  } else if constexpr (Size == 3) {
    const auto triple = load_triples(records);
    columns[0] = Group<T>::of(triple.x);
    columns[1] = Group<T>::of(triple.y);
    columns[2] = Group<T>::of(triple.z);
  } else {
    static_assert(Size >= 4);
    const auto load = [&](std::size_t first, std::size_t skipped) __attribute__((always_inline)) {
      const auto tile = load_columns(records + first, Size);
#pragma GCC unroll 4
      for (std::size_t k = skipped; k < 4; ++k) columns[first + k] = Group<T>::of(tile.v[k]);
    };
    unrolled(
        std::make_index_sequence<Size / 4>(), [&](std::size_t i) __attribute__((always_inline)) { load(4 * i, 0); });
    if constexpr (Size % 4 != 0) load(Size - 4, 4 - Size % 4);
  }
}

// Columns First .. Size of a group -> records; the one before First is written beside it if it is still missing.
template <std::size_t First, std::size_t Size, class T>
[[gnu::always_inline]] inline void store_columns(const Group<T>* columns, const T* alone, T* records) {
  const auto from = [columns](std::size_t first) {
    return [ columns, first ](std::size_t k) __attribute__((always_inline)) { return columns[first + k].get(); };
  };
  if constexpr (First + kRow<T> <= Size) {
    join_slab<1>(from(First), alone, records + First, Size);
    store_columns<First + kRow<T>, Size>(columns, static_cast<const T*>(nullptr), records);
  } else if constexpr (First < Size) {  // the last four, some of them again
    constexpr std::size_t kLast = Size - 4;
    if constexpr (sizeof(T) == sizeof(float)) {
      join_columns(columns[kLast].get(), columns[kLast + 1].get(), columns[kLast + 2].get(), columns[kLast + 3].get(),
                   records + kLast, Size);
    } else {
      join_slab<1>(from(kLast), alone, records + kLast, Size);
    }
  }
}

template <std::size_t Size, class T>
[[gnu::always_inline]] inline void store_group(const Group<T>* columns, T* records) {
  using Register = typename GroupRegister<T>::type;
  if constexpr (Size == 1) {
    const Register column = columns[0].get();
    std::memcpy(records, &column, sizeof column);
  } else if constexpr (Size == 3 && sizeof(T) == sizeof(float)) {
    store_triples(columns[0].get(), columns[1].get(), columns[2].get(), records);
  } else if constexpr (Size < 4) {
    for (std::size_t k = 0; k < Size; ++k) {
      const Register column = columns[k].get();
      for (std::size_t i = 0; i < kGroup<T>; ++i) records[i * Size + k] = column[i];
    }
  } else if constexpr (Size > kRow<T> && Size % kRow<T> == 1) {  // rows are whole but for their first value
    T first[kGroup<T>];
    const Register column = columns[0].get();
    std::memcpy(first, &column, sizeof first);
    store_columns<1, Size>(columns, static_cast<const T*>(first), records);
  } else {
    store_columns<0, Size>(columns, static_cast<const T*>(nullptr), records);
  }
}

// The hardware's prefetching misses records that are read side by side, where they are not in a cache.
template <std::size_t Size, class T>
[[gnu::always_inline]] inline void prefetch_records(const T* records) {
  constexpr std::size_t kAhead = 2048;
  constexpr std::size_t kBytes = kGroup<T> * Size * sizeof(T);
  if constexpr (Size > 3) {
#pragma GCC unroll 1
    for (std::size_t at = 0; at < kBytes; at += detail::kLine) {
      __builtin_prefetch(reinterpret_cast<const char*>(records) + kAhead + at);
    }
  }
}

// Calls kernel(in, out) for `count` groups of records of In values each, to records of Out values.
template <class T, std::size_t Out, std::size_t... In, class Kernel>
[[gnu::always_inline]] inline void for_every_group(const T* const* from, std::size_t count, T* to,
                                                   const Kernel& kernel) {
  if constexpr (kGroup < T >> 1) {
    for (std::size_t g = 0; g < count; ++g) {
      Group<T> values[(In + ...)];
      const Group<T>* in[sizeof...(In)];
      std::size_t j = 0;
      std::size_t at = 0;
      const auto load = [&](auto size) __attribute__((always_inline)) {
        constexpr std::size_t kSize = decltype(size)::value;
        prefetch_records<kSize>(from[j] + g * kGroup<T> * kSize);
        load_group<kSize>(from[j] + g * kGroup<T> * kSize, values + at);
        in[j++] = values + at;
        at += kSize;
      };
      (load(std::integral_constant<std::size_t, In>()), ...);
      Group<T> out[Out];
      kernel(static_cast<const Group<T>* const*>(in), static_cast<Group<T>*>(out));
      store_group<Out>(static_cast<const Group<T>*>(out), to + g * kGroup<T> * Out);
    }
  }
}

// n records: by groups. What is left over is part of a group that ends with the last record, which computes some again,
// from inputs that must still be there; of a call of few, part of a group in memory of its own. One or two are faster one
// by one, and more where there is no whole group and they are small. As measured (tests/bench/plain_targets.cpp).
template <class T, std::size_t Out, std::size_t... In>
inline void run_records(const T* const* from, std::size_t n, T* to, detail::RecordKernel<T> one_by_one,
                        detail::RecordKernel<T> groups) {
  constexpr std::size_t kSizes[] = {In...};
  constexpr std::size_t kInputs = sizeof...(In);
  constexpr bool kIsSmall = kGroup<T> < 8 || (In + ...) + Out < 28;
  constexpr std::size_t kMostSingle = kIsSmall ? kGroup<T> - 1 : 3;
  if (kGroup<T> == 1 || n <= kMostSingle) return one_by_one(from, n, to);
  const std::size_t whole = n / kGroup<T>;
  const std::size_t rest = n % kGroup<T>;
  const T* behind[kInputs];
  const auto move = [&](std::size_t first) {
    for (std::size_t j = 0; j < kInputs; ++j) behind[j] = from[j] + first * kSizes[j];
    return to + first * Out;
  };
  bool may_overlap = whole > 0 && rest > 2;
  for (std::size_t j = 0; j < kInputs; ++j) may_overlap = may_overlap && from[j] != to;
  if (whole > 0) groups(from, whole, to);
  if (rest == 0) return;
  if (may_overlap) {
    T* const out = move(n - kGroup<T>);
    return groups(behind, 1, out);
  }
  T* const out = move(whole * kGroup<T>);
  if (rest <= kMostSingle) return one_by_one(behind, rest, out);
  T in[kGroup<T> * (In + ...)];
  T result[kGroup<T> * Out];
  T* room = static_cast<T*>(in);
  for (std::size_t j = 0; j < kInputs; ++j) {
    const std::size_t size = kGroup<T> * kSizes[j];
    std::memset(room, 0, size * sizeof(T));
    std::memcpy(room, behind[j], rest * kSizes[j] * sizeof(T));
    behind[j] = room;
    room += size;
  }
  groups(behind, 1, static_cast<T*>(result));
  std::memcpy(out, result, rest * Out * sizeof(T));
}

}  // namespace sh::batch::SH_BATCH_ISA
