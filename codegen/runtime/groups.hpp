// Plain records without blocks: groups of them in registers, from rows to columns and back on the way, or one by one.
//
// Copied by:    shgen write, from codegen/runtime to generated/batch
// Licence:      MIT-0; paste it anywhere.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <type_traits>

#include "drive.hpp"
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
inline Four multiply_add(const Four& a, const Four& b, const Four& c) noexcept { return _mm_fmadd_ps(a, b, c); }
inline Wide multiply_add(const Wide& a, const Wide& b, const Wide& c) noexcept { return _mm256_fmadd_ps(a, b, c); }
inline Doubles multiply_add(const Doubles& a, const Doubles& b, const Doubles& c) noexcept {
  return _mm256_fmadd_pd(a, b, c);
}
#else
inline Wide multiply_add(const Wide& a, const Wide& b, const Wide& c) noexcept { return a * b + c; }
inline Doubles multiply_add(const Doubles& a, const Doubles& b, const Doubles& c) noexcept { return a * b + c; }
#endif

inline float square_root(float a) noexcept { return std::sqrt(a); }
inline double square_root(double a) noexcept { return std::sqrt(a); }
template <class Register>
Register square_root(const Register& a) noexcept {
#if defined(__AVX2__)
  if constexpr (std::is_same_v<Register, Four>) return _mm_sqrt_ps(a);
  if constexpr (std::is_same_v<Register, Wide>) return _mm256_sqrt_ps(a);
  if constexpr (std::is_same_v<Register, Doubles>) return _mm256_sqrt_pd(a);
#endif
  Register root = a;
  for (std::size_t i = 0; i < sizeof a / sizeof a[0]; ++i) root[i] = std::sqrt(a[i]);
  return root;
}

// A value of one record or of a group: a scalar or a register of them.
template <class T, class Register>
class Packed {
 public:
  using value_type = T;
  using Condition = decltype(Register{} < Register{});  // bool, or a lane of ones where it holds

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
  friend Packed operator/(const Packed& a, const Packed& b) noexcept { return of(a.value_ / b.value_); }
  friend Packed operator-(const Packed& a) noexcept { return of(-a.value_); }
  friend auto operator<(const Packed& a, const Packed& b) noexcept { return a.value_ < b.value_; }
  friend Packed sqrt(const Packed& a) noexcept { return of(square_root(a.value_)); }
  friend Packed select(const Condition& condition, const Packed& a, const Packed& b) noexcept {
    return of(condition ? a.value_ : b.value_);
  }

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

// The channels of a value of one interleaved record, and a lane that serves nobody.
template <class T>
struct ColorRegister {
  using type = Four;
};
template <>
struct ColorRegister<double> {
  using type = Doubles;
};
template <class T>
using Color = Packed<T, typename ColorRegister<T>::type>;
template <class T>
constexpr bool kHoldsColors = sizeof(Color<T>) > 3 * sizeof(T);

// Whether compilers vectorise a loop over records well enough: those of a few values, of degree 0; with shuffles of two
// registers those of degree 1, too.
#if defined(__AVX512F__)
constexpr std::size_t kVectorised = 12;
#else
constexpr std::size_t kVectorised = 5;
#endif
template <std::size_t Out, std::size_t In>
constexpr bool kIsVectorised = In + Out <= kVectorised;

// Rows of an input of which one record serves all others.
struct Shared : InOrder {};

// Values from one record of an input to the next.
template <class Rows, std::size_t Size>
constexpr std::size_t kStep = std::is_same_v<Rows, Shared> ? 0 : Size;

// The values of one record after the other, channel by channel: in place or, of interleaved records, beside it.
template <std::size_t Size, class T, class Rows>
class RecordInputs {
 public:
  explicit RecordInputs(const T* records) noexcept : records_(records) {}
  [[gnu::always_inline]] const One<T>* at(std::size_t i) noexcept {
    const T* const record = records_ + i * kStep<Rows, Size>;
    if constexpr (kIsCopied) {
      unrolled(
          std::make_index_sequence<Size>(), [&](std::size_t k) __attribute__((always_inline)) {
            copy_[Rows()(k)] = One<T>::of(record[k]);
          });
    }
    return kIsCopied ? static_cast<const One<T>*>(copy_) : reinterpret_cast<const One<T>*>(record);
  }

 private:
  static constexpr bool kIsCopied = !std::is_base_of_v<InOrder, Rows>;
  const T* records_;
  One<T> copy_[kIsCopied ? Size : 1];
};

// Where a kernel writes the values of one record: in place, or first beside it if the loop over records is to be vectorised.
// Loops over copies of scalars are, those over copies of One are not. Larger records would be gathered: loops that keep their
// order are not vectorised.
template <std::size_t Out, std::size_t In, class T>
class RecordValues {
 public:
  explicit RecordValues(T* record) noexcept : record_(record) {}
  One<T>* values() noexcept {
    return kIsVectorised<Out, In> ? static_cast<One<T>*>(copy_) : reinterpret_cast<One<T>*>(record_);
  }
  [[gnu::always_inline]] void keep() const noexcept {
    if constexpr (kIsVectorised<Out, In>) {
      for (std::size_t k = 0; k < Out; ++k) record_[k] = copy_[k].get();
    } else {
      keep_order();
    }
  }

 private:
  T* record_;
  One<T> copy_[kIsVectorised<Out, In> ? Out : 1];
};

// The records that are there in a group: all, as a type, or `count` of them.
template <class T>
using All = std::integral_constant<std::size_t, kGroup<T>>;

template <class T>
[[gnu::always_inline]] inline auto load_triples(const T* records, All<T> /*count*/) {
  return load_triples(records);
}

// The columns of a group of records of Size values. Count: All<T>, or std::size_t.
template <std::size_t Size, class Rows, class T, class Count>
[[gnu::always_inline]] inline void load_group(const T* records, Count count, Group<T>* columns) {
  if constexpr (std::is_same_v<Rows, Shared>) {
    for (std::size_t k = 0; k < Size; ++k) columns[k] = Group<T>(records[k]);
  } else if constexpr (Size == 1) {
    columns[0] = Group<T>::of(load_column(records, count));
  } else if constexpr (Size == 3) {
    const auto triple = load_triples(records, count);
    columns[0] = Group<T>::of(triple.x);
    columns[1] = Group<T>::of(triple.y);
    columns[2] = Group<T>::of(triple.z);
  } else {
    static_assert(Size >= 4);
    const auto load = [&](std::size_t first, std::size_t skipped) __attribute__((always_inline)) {
      const auto tile = load_columns(records + first, Size, count);
#pragma GCC unroll 4
      for (std::size_t k = skipped; k < 4; ++k) columns[Rows()(first + k)] = Group<T>::of(tile.v[k]);
    };
    unrolled(
        std::make_index_sequence<Size / 4>(), [&](std::size_t i) __attribute__((always_inline)) { load(4 * i, 0); });
    if constexpr (Size % 4 != 0) load(Size - 4, 4 - Size % 4);
  }
}

// Columns First .. Size of a group -> `count` records; the one before First is written beside it if it is still missing.
template <std::size_t First, std::size_t Size, class T>
[[gnu::always_inline]] inline void store_columns(const Group<T>* columns, const T* alone, std::size_t count,
                                                 T* records) {
  const auto from = [columns](std::size_t first) {
    return [ columns, first ](std::size_t k) __attribute__((always_inline)) { return columns[first + k].get(); };
  };
  if constexpr (First + kRow<T> <= Size) {
    join_slab<1>(from(First), alone, records + First, Size, count);
    store_columns<First + kRow<T>, Size>(columns, static_cast<const T*>(nullptr), count, records);
  } else if constexpr (First < Size) {  // the last four, some of them again
    constexpr std::size_t kLast = Size - 4;
    if constexpr (sizeof(T) == sizeof(float)) {
      join_columns(columns[kLast].get(), columns[kLast + 1].get(), columns[kLast + 2].get(), columns[kLast + 3].get(),
                   records + kLast, Size, count);
    } else {
      join_slab<1>(from(kLast), alone, records + kLast, Size, count);
    }
  }
}

template <std::size_t Size, class T, class Count>
[[gnu::always_inline]] inline void store_group(const Group<T>* columns, Count count, T* records) {
  using Register = typename GroupRegister<T>::type;
  constexpr bool kAll = std::is_same_v<Count, All<T>>;
  if constexpr (kAll && Size == 1) {
    const Register column = columns[0].get();
    std::memcpy(records, &column, sizeof column);
  } else if constexpr (kAll && Size == 3 && sizeof(T) == sizeof(float)) {
    store_triples(columns[0].get(), columns[1].get(), columns[2].get(), records);
#if defined(__AVX2__)
  } else if constexpr (Size == 1) {
    store_first(records, columns[0].get(), int(count));
  } else if constexpr (Size == 3 && sizeof(T) == sizeof(float)) {
    store_triples(columns[0].get(), columns[1].get(), columns[2].get(), records, count);
#endif
  } else if constexpr (Size < 4) {
    unrolled(
        std::make_index_sequence<kGroup<T>>(), [&](std::size_t i) __attribute__((always_inline)) {
          if (i >= count) return;
          for (std::size_t k = 0; k < Size; ++k) records[i * Size + k] = columns[k].get()[i];
        });
  } else if constexpr (Size > kRow<T> && Size % kRow<T> == 1) {  // rows are whole but for their first value
    T first[kGroup<T>];
    const Register column = columns[0].get();
    std::memcpy(first, &column, sizeof first);
    store_columns<1, Size>(columns, static_cast<const T*>(first), count, records);
  } else {
    store_columns<0, Size>(columns, static_cast<const T*>(nullptr), count, records);
  }
}

// The hardware's prefetching misses records that are read side by side, where they are not in a cache.
template <std::size_t Size, class T>
[[gnu::always_inline]] inline void prefetch_records(const T* records) {
  constexpr std::size_t kAhead = 8192;
  constexpr std::size_t kBytes = kGroup<T> * Size * sizeof(T);
  if constexpr (Size > 3) {
#pragma GCC unroll 1
    for (std::size_t at = 0; at < kBytes; at += detail::kLine) {
      __builtin_prefetch(reinterpret_cast<const char*>(records) + kAhead + at);
    }
  }
}

// Whether a group may lack records.
#if defined(__AVX2__)
constexpr bool kTakesParts = true;
#else
constexpr bool kTakesParts = false;
#endif

// The most records that are faster one by one than as a part of a group, as measured (tests/bench/plain_targets.cpp): all at
// degree 0; of eight lanes three where records are short, or have three outputs, and where clang stores many values, unless there
// is much to turn on both sides.
template <class T, std::size_t Out, std::size_t In>
constexpr std::size_t most_single() {
  if (kGroup<T> == 1 || In + Out <= 5) return std::numeric_limits<std::size_t>::max();
  if (!kTakesParts) return kGroup<T> - 1;
  if (kGroup<T> < 8) return In + Out < 20 ? 2 : 1;
  if (In > 3 && Out > 3) return 2;
#if defined(__clang__)
  if (Out >= 9 && In + Out < 40) return 3;
#endif
  return In + Out < (Out == 3 ? 35 : 20) ? 3 : 2;
}
template <class T, std::size_t Out, std::size_t In>
constexpr std::size_t kMostSingle = most_single<T, Out, In>();

// Whether g++ keeps so many columns in memory that two records are faster one by one where loads delay stores, as measured.
template <class T, std::size_t Out, std::size_t In>
#if defined(__clang__)
constexpr bool kHasSlowPairs = false;
#else
constexpr bool kHasSlowPairs = kTakesParts && sizeof(T) == sizeof(double) && In + Out > 50;
#endif

// The most plain records of two inputs that groups are faster for than registers of blocks: all, since blocks have to be turned
// first. Where there are no groups, short records go one by one, and of others those that single_records() tells.
template <class T>
constexpr std::size_t grouped_records(int degree, std::size_t of_sixteen) {
  const bool all = kGroup<T> > 1 || degree <= 1;
  return all ? std::numeric_limits<std::size_t>::max() : single_records<T>(of_sixteen);
}

// Calls kernel(in, out) for a group of records of InA and of InB values (0: there is one input), to records of Out values.
// Rows: the columns of the values of the first input; shared: its columns if it is shared.
template <class T, class Rows, std::size_t Out, std::size_t InA, std::size_t InB, class Count, class Kernel>
[[gnu::always_inline]] inline void run_group(const Group<T>* shared, const T* a, const T* b, Count count, T* to,
                                             const Kernel& kernel) {
  constexpr std::size_t kFirst = kStep<Rows, InA>;
  Group<T> values[kFirst + InB];
  if constexpr (kFirst > 0) load_group<InA, Rows>(a, count, static_cast<Group<T>*>(values));
  if constexpr (InB > 0) load_group<InB, InOrder>(b, count, values + kFirst);
  const Group<T>* const in[] = {kFirst > 0 ? static_cast<const Group<T>*>(values) : shared, values + kFirst};
  Group<T> out[Out];
  kernel(static_cast<const Group<T>* const*>(in), static_cast<Group<T>*>(out));
  store_group<Out>(static_cast<const Group<T>*>(out), count, to);
}

// The columns of a first input that is shared, once for all groups.
template <std::size_t InA, class Rows, class T>
struct SharedColumns {
  static constexpr std::size_t kSize = std::is_same_v<Rows, Shared> ? InA : 1;
  explicit SharedColumns(const T* a) noexcept {
    if constexpr (std::is_same_v<Rows, Shared>) load_group<InA, Rows>(a, All<T>(), static_cast<Group<T>*>(columns));
  }
  Group<T> columns[kSize];
};

// The same for `count` whole groups.
template <class T, class Rows, std::size_t Out, std::size_t InA, std::size_t InB = 0, class Kernel>
[[gnu::always_inline]] inline void for_every_group(const T* a, const T* b, std::size_t count, T* to,
                                                   const Kernel& kernel) {
  constexpr std::size_t kFirst = kStep<Rows, InA>;
  if constexpr (kMostSingle<T, Out, InA + InB> < kGroup<T>) {
    const SharedColumns<InA, Rows, T> shared(a);
    for (std::size_t i = 0; i < count * kGroup<T>; i += kGroup<T>) {
      if constexpr (kFirst > 0) prefetch_records<InA>(a + i * InA);
      if constexpr (InB > 0) prefetch_records<InB>(b + i * InB);
      run_group<T, Rows, Out, InA, InB>(shared.columns, a + i * kFirst, b + i * InB, All<T>(), to + i * Out, kernel);
    }
  }
}

// Calls kernel(in, out) for a part of a group: `count` records, more than kMostSingle.
template <class T, class Rows, std::size_t Out, std::size_t InA, std::size_t InB = 0, class Kernel>
[[gnu::always_inline]] inline void for_part_of_group(const T* a, const T* b, std::size_t count, T* to,
                                                     const Kernel& kernel) {
  constexpr std::size_t kFewer = kMostSingle<T, Out, InA + InB>;
  if constexpr (kFewer < kGroup<T> - 1) {
    if (count <= kFewer || count >= kGroup<T>) __builtin_unreachable();
    const SharedColumns<InA, Rows, T> shared(a);
    run_group<T, Rows, Out, InA, InB>(shared.columns, a, b, count, to, kernel);
  }
}

// n records by groups. Those that are left over are part of a group that ends with the last record, which computes some
// again, from inputs that must still be there, or part of a group of their own.
template <class T, class Rows, detail::RecordKernel<T> OneByOne, detail::RecordKernel<T> Groups,
          detail::RecordKernel<T> Part, std::size_t Out, std::size_t InA, std::size_t InB = 0>
[[gnu::noinline]] void run_groups(const T* a, const T* b, std::size_t n, T* to) {
  const std::size_t whole = n / kGroup<T>;
  const std::size_t rest = n % kGroup<T>;
  const bool may_overlap = rest > 2 && a != to && b != to;
  Groups(a, b, whole, to);
  if (rest == 0) return;
  const std::size_t first = may_overlap ? n - kGroup<T> : whole * kGroup<T>;
  a += first * kStep<Rows, InA>;
  b += first * InB;
  to += first * Out;
  if (may_overlap) return Groups(a, b, 1, to);
  if (rest <= kMostSingle<T, Out, InA + InB>) return OneByOne(a, b, rest, to);
  Part(a, b, rest, to);
}

// n records. A call of few saves no registers for groups.
template <class T, class Rows, detail::RecordKernel<T> OneByOne, detail::RecordKernel<T> Groups,
          detail::RecordKernel<T> Part, std::size_t Out, std::size_t InA, std::size_t InB = 0>
inline void run_records(const T* a, const T* b, std::size_t n, T* to) {
  if (n <= kMostSingle<T, Out, InA + InB>) return OneByOne(a, b, n, to);
  if constexpr (kHasSlowPairs<T, Out, InA + InB>) {
    if (n == 2 && detail::loads_delay_stores) return OneByOne(a, b, n, to);
  }
  if constexpr (kMostSingle<T, Out, InA + InB> < kGroup<T>) {
    if (n < kGroup<T>) return Part(a, b, n, to);
    if (!kIsVectorised<Out, kStep<Rows, InA> + InB> || n < 2 * kGroup<T>) {
      return run_groups<T, Rows, OneByOne, Groups, Part, Out, InA, InB>(a, b, n, to);
    }
    OneByOne(a, b, n, to);
  }
}

// The most records whose scalar products are faster one by one than as a part of a group, as measured.
#if defined(__AVX2__)
constexpr std::size_t kMostProducts = 2;
#else
constexpr std::size_t kMostProducts = kBlock<float> - 1;
#endif

// The scalar products of plain records with `light` (add_products), blocks first, then groups that may lack records, until at
// most kMostProducts are left: the number of those that are done.
template <int Rows, int Sums, std::size_t Length>
[[gnu::noinline]] std::size_t multiply_few(const float* records, const float* light, std::size_t n, float* to) {
  std::size_t first = n / kBlock<float> * kBlock<float>;
  if (first > 0) multiply_pairs<Rows, Sums, Length>(records, light, first, to);
#if defined(__AVX2__)
  for (; first < n && n - first > kMostProducts; first += kWide) {
    const std::size_t count = n - first < kWide ? n - first : kWide;
    Wide sums[Sums][1];
    add_products<Rows, Sums, Length>(records + first * Rows * Length, count, light, false, sums);
    if constexpr (Sums == 3) {
      store_triples(sums[0][0], sums[1][0], sums[2][0], to + first * Sums, count);
    } else {
      store_first(to + first, sums[0][0], int(count));
    }
  }
#endif
  return first;
}

// Calls kernel(in, out) for n plain records, one after the other; in[j] and out are arrays of One. is_shared: there is one `a`
// for all.
template <std::size_t Out, std::size_t InA, std::size_t InB, class T, class Kernel>
[[gnu::always_inline]] inline void for_every_record(const T* a, bool is_shared, const T* b, std::size_t n, T* to,
                                                    const Kernel& kernel) {
  const std::size_t step = is_shared ? 0 : InA;
  for (std::size_t i = 0; i < n; ++i) {
    const One<T>* const in[] = {reinterpret_cast<const One<T>*>(a + i * step),
                                reinterpret_cast<const One<T>*>(b + i * InB)};
    kernel(static_cast<const One<T>* const*>(in), reinterpret_cast<One<T>*>(to + i * Out));
    keep_order();
  }
}

// Adds to Size values what kernel(in, out) adds to `out` for n plain records, by groups: terms are rounded, added up in the order of
// the records, then added to what is there. is_shared: there is one `a` for all.
template <std::size_t Size, std::size_t InA, std::size_t InB, class T, class Kernel>
[[gnu::noinline]] void sum_groups(const T* a, bool is_shared, const T* b, std::size_t n, T* to, const Kernel& kernel) {
  T repeated[kGroup<T> * InA];
  for (std::size_t k = 0; is_shared && k < kGroup<T> * InA; ++k) repeated[k] = a[k % InA];
  const auto from_zero = [&](const Group<T>* const* in, Group<T>* out) __attribute__((always_inline)) {
    for (std::size_t k = 0; k < Size; ++k) out[k] = Group<T>(T(0));
    kernel(in, out);
  };
  T sum[Size] = {};
  for (std::size_t first = 0; first < n; first += kGroup<T>) {
    const std::size_t count = n - first < kGroup<T> ? n - first : kGroup<T>;
    T rows[kGroup<T> * Size];
    run_group<T, InOrder, Size, InA, InB>(nullptr, is_shared ? repeated : a + first * InA, b + first * InB, count,
                                          static_cast<T*>(rows), from_zero);
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t k = 0; k < Size; ++k) sum[k] += rows[i * Size + k];
    }
  }
  for (std::size_t k = 0; k < Size; ++k) to[k] += sum[k];
}

// The same one by one, where terms are not rounded beside their sum. Grouped: whether more than a few go by groups.
template <bool Grouped, std::size_t Size, std::size_t InA, std::size_t InB, class T, class Kernel>
[[gnu::always_inline]] inline void sum_records(const T* a, bool is_shared, const T* b, std::size_t n, T* to,
                                               const Kernel& kernel) {
  if constexpr (Grouped && kTakesParts) {
    constexpr std::size_t kMost = 4;  // one by one, as measured
    if (n > kMost) return sum_groups<Size, InA, InB>(a, is_shared, b, n, to, kernel);
  }
  const std::size_t step = is_shared ? 0 : InA;
  One<T> sum[Size];
  for (std::size_t k = 0; k < Size; ++k) sum[k] = One<T>(T(0));
  for (std::size_t i = 0; i < n; ++i) {
    const One<T>* const in[] = {reinterpret_cast<const One<T>*>(a + i * step),
                                reinterpret_cast<const One<T>*>(b + i * InB)};
    kernel(static_cast<const One<T>* const*>(in), static_cast<One<T>*>(sum));
  }
  for (std::size_t k = 0; k < Size; ++k) to[k] += sum[k].get();
}

// Calls kernel(in, out) for n interleaved records `b` of Size values a channel, where `a`, of InA values, serves all: in
// registers that hold the channels of a value. to may be b.
template <std::size_t InA, std::size_t Size, class T, class Kernel>
[[gnu::always_inline]] inline void for_every_color(const T* a, const T* b, std::size_t n, T* to, const Kernel& kernel) {
  using Register = typename ColorRegister<T>::type;
  constexpr std::size_t kLast = Size - 1;  // the lane that serves nobody would lie behind the record
  Color<T> shared[InA];
  for (std::size_t k = 0; k < InA; ++k) shared[k] = Color<T>(a[k]);
  for (std::size_t i = 0; i < n; ++i) {
    const T* const from = b + i * 3 * Size;
    T* const record = to + i * 3 * Size;
    Color<T> values[Size];
    Color<T> out[Size];
    unrolled(
        std::make_index_sequence<kLast>(), [&](std::size_t k) __attribute__((always_inline)) {
          Register value;
          std::memcpy(&value, from + 3 * k, sizeof value);
          values[k] = Color<T>::of(value);
        });
    values[kLast] = Color<T>::of(Register{from[3 * kLast], from[3 * kLast + 1], from[3 * kLast + 2], T(0)});
    const Color<T>* const in[] = {shared, values};
    kernel(static_cast<const Color<T>* const*>(in), static_cast<Color<T>*>(out));
    unrolled(
        std::make_index_sequence<kLast>(), [&](std::size_t k) __attribute__((always_inline)) {
          const Register value = out[k].get();
          std::memcpy(record + 3 * k, &value, sizeof value);
        });
    for (std::size_t c = 0; c < 3; ++c) record[3 * kLast + c] = out[kLast].get()[c];
  }
}

}  // namespace sh::batch::SH_BATCH_ISA
