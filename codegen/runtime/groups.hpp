// Plain records without blocks: groups of them in registers, from rows to columns and back on the way, or one by one.
//
// Copied by:    shgen write, from codegen/runtime to generated/batch
// Licence:      MIT-0; paste it anywhere.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>

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

// Where a kernel writes the values of one record: in place, or first beside it if they are few. Loops over copies of scalars
// are vectorised, those over copies of One are not.
template <std::size_t Size, class T>
class RecordValues {
 public:
  explicit RecordValues(T* record) noexcept : record_(record) {}
  One<T>* values() noexcept { return kIsCopied ? static_cast<One<T>*>(copy_) : reinterpret_cast<One<T>*>(record_); }
  void keep() const noexcept {
    if constexpr (kIsCopied) {
      for (std::size_t k = 0; k < Size; ++k) record_[k] = copy_[k].get();
    }
  }

 private:
  static constexpr bool kIsCopied = Size < 5;
  T* record_;
  One<T> copy_[kIsCopied ? Size : 1];
};

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

// Calls kernel(in, out) for `count` groups of records of InA and of InB values (0: there is one input), to records of Out
// values.
template <class T, std::size_t Out, std::size_t InA, std::size_t InB = 0, class Kernel>
[[gnu::always_inline]] inline void for_every_group(const T* a, const T* b, std::size_t count, T* to,
                                                   const Kernel& kernel) {
  if constexpr (kGroup<T> != 1) {
    for (std::size_t g = 0; g < count; ++g) {
      Group<T> values[InA + InB];
      prefetch_records<InA>(a + g * kGroup<T> * InA);
      load_group<InA>(a + g * kGroup<T> * InA, static_cast<Group<T>*>(values));
      if constexpr (InB > 0) {
        prefetch_records<InB>(b + g * kGroup<T> * InB);
        load_group<InB>(b + g * kGroup<T> * InB, values + InA);
      }
      const Group<T>* const in[] = {values, values + InA};
      Group<T> out[Out];
      kernel(static_cast<const Group<T>* const*>(in), static_cast<Group<T>*>(out));
      store_group<Out>(static_cast<const Group<T>*>(out), to + g * kGroup<T> * Out);
    }
  }
}

// The values of a record up to which compilers vectorise a loop over records well enough: g++ with shuffles of two registers
// those of degree 1, too.
#if defined(__AVX512F__) && !defined(__clang__)
constexpr std::size_t kVectorised = 8;
#else
constexpr std::size_t kVectorised = 5;
#endif

// The most records that are faster one by one than as a part of a group. The smallest records, of degree 0 and 1, always
// are. As measured (tests/bench/plain_targets.cpp).
template <class T, std::size_t Out, std::size_t In>
constexpr std::size_t kMostSingle = kGroup<T> == 1 || In + Out <= kVectorised ? std::numeric_limits<std::size_t>::max()
                                    : kGroup<T> < 8 || In + Out < 40          ? kGroup<T> - 1
                                                                              : 3;

// n records by groups. What is left over is part of a group that ends with the last record, which computes some again,
// from inputs that must still be there; of a call of few, part of a group in memory of its own.
template <class T, detail::RecordKernel<T> OneByOne, detail::RecordKernel<T> Groups, std::size_t Out, std::size_t InA,
          std::size_t InB = 0>
[[gnu::noinline]] void run_groups(const T* a, const T* b, std::size_t n, T* to) {
  const std::size_t whole = n / kGroup<T>;
  const std::size_t rest = n % kGroup<T>;
  const bool may_overlap = whole > 0 && rest > 2 && a != to && b != to;
  if (whole > 0) Groups(a, b, whole, to);
  if (rest == 0) return;
  const std::size_t first = may_overlap ? n - kGroup<T> : whole * kGroup<T>;
  a += first * InA;
  b += first * InB;
  to += first * Out;
  if (may_overlap) return Groups(a, b, 1, to);
  if (rest <= kMostSingle<T, Out, InA + InB>) return OneByOne(a, b, rest, to);
  T in[kGroup<T> * (InA + InB)];
  T result[kGroup<T> * Out];
  const auto copy = [rest](const T* from, std::size_t size, T* room) {
    std::memcpy(room, from, rest * size * sizeof(T));
    std::memset(room + rest * size, 0, (kGroup<T> - rest) * size * sizeof(T));
  };
  T* const second = static_cast<T*>(in) + kGroup<T> * InA;
  copy(a, InA, in);
  if constexpr (InB > 0) copy(b, InB, second);
  Groups(static_cast<const T*>(in), second, 1, static_cast<T*>(result));
  std::memcpy(to, result, rest * Out * sizeof(T));
}

// n records. A call of few saves no registers for groups.
template <class T, detail::RecordKernel<T> OneByOne, detail::RecordKernel<T> Groups, std::size_t Out, std::size_t InA,
          std::size_t InB = 0>
inline void run_records(const T* a, const T* b, std::size_t n, T* to) {
  if (n <= kMostSingle<T, Out, InA + InB>) return OneByOne(a, b, n, to);
  if constexpr (kGroup<T> != 1) run_groups<T, OneByOne, Groups, Out, InA, InB>(a, b, n, to);
}

}  // namespace sh::batch::SH_BATCH_ISA
