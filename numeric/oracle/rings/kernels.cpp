// The inner loops of legendre_rings.hpp on one instruction set, SH_RINGS_ISA; see call.hpp.
#include <algorithm>
#include <array>
#include <tuple>

#include "numeric/oracle/rings/recurrence.hpp"

namespace sh::numeric::rings::SH_RINGS_ISA {
namespace {

// n, n + 2, n + 4, ... in lanes.
Lanes every_other(std::size_t n) {
  alignas(64) double index[kWidth];
  for (std::size_t i = 0; i < kWidth; ++i) index[i] = static_cast<double>(n + 2 * i);
  return Lanes::load_aligned(index);
}

// eps_(m+n,m) of every other n: the root of n (n + 2m) / (4 l^2 - 1), l = m + n.
Lanes eps(std::size_t n, const Lanes& m) {
  const Lanes gap = every_other(n);
  const Lanes l = gap + m;
  return xsimd::sqrt(gap * (gap + (m + m)) / (Lanes(4.0) * l * l - Lanes(1.0)));
}

// p' / p at the pole and the equator, but for alpha / alpha', from P_lm / (z sin^m theta) there with l - m odd: at the
// pole it is a constant of the order times sqrt((2l+1) (l+m)! / (l-m)!), at the equator that changes from l to l + 2 by
// the factor -(l+m+2) / (l-m+1) before it is normalized.
Lanes growth_at_pole(std::size_t k, const Lanes& m) {
  const Lanes one(1.0), two(2.0);
  const Lanes gap = every_other(2 * k + 1);
  const Lanes l = gap + m, sum = l + m;
  return xsimd::sqrt((two * l + Lanes(5.0)) * (sum + one) * (sum + two) /
                     ((two * l + one) * (gap + one) * (gap + two)));
}
Lanes growth_at_equator(std::size_t k, const Lanes& m) {
  const Lanes one(1.0), two(2.0);
  const Lanes gap = every_other(2 * k + 1);
  const Lanes l = gap + m, sum = l + m;
  return -xsimd::sqrt((two * l + Lanes(5.0)) * (sum + two) * (gap + two) /
                      ((two * l + one) * (sum + one) * (gap + one)));
}

void prepare(int order, const Tables& t, bool pole, bool equator) {
  const Lanes m(static_cast<double>(order));
  const Lanes one(1.0);
  for (std::size_t k = 0; k < t.size; k += kWidth) {
    eps(2 * k, m).store_unaligned(t.even + k);
    eps(2 * k + 1, m).store_unaligned(t.odd + k);
  }
  // products_k = eps_(m+2k+2) eps_(m+2k+3), and 1 over them; in the places of a and b.
  const std::size_t size = t.size - kPadding;
  for (std::size_t k = 0; k < size; k += kWidth) {
    const Lanes product = Lanes::load_unaligned(t.even + k + 1) * Lanes::load_unaligned(t.odd + k + 1);
    product.store_unaligned(t.b + k);
    (one / product).store_unaligned(t.a + k);
  }
  // alpha_(k+1) = alpha_(k-1) product_(k-1) / product_k
  double before = t.alpha[0] = 1;
  double here = t.alpha[1] = t.a[0];
  for (std::size_t k = 1; k < size; ++k) {
    const double ahead = before * (t.b[k - 1] * t.a[k]);
    before = here;
    here = t.alpha[k + 1] = ahead;
  }
  t.pole.inverse_before[0] = t.equator.inverse_before[0] = 0;
  for (std::size_t k = 0; k < size; k += kWidth) {
    const Lanes ratio = Lanes::load_unaligned(t.alpha + k) / Lanes::load_unaligned(t.alpha + k + 1);
    const Lanes a = ratio * Lanes::load_unaligned(t.a + k);
    const Lanes odd = Lanes::load_unaligned(t.odd + k), even = Lanes::load_unaligned(t.even + k + 1);
    a.store_unaligned(t.a + k);
    (-(odd * odd + even * even) * a).store_unaligned(t.b + k);
    const auto grow = [&](const Growth& growth, const Lanes& at_anchor) {
      const Lanes g = at_anchor * ratio;
      g.store_unaligned(growth.g + k);
      (one / g).store_unaligned(growth.inverse_before + k + 1);
    };
    if (pole) grow(t.pole, growth_at_pole(k, m));
    if (equator) grow(t.equator, growth_at_equator(k, m));
  }
}

// Degrees of the column.
std::size_t terms(const Column& c) { return static_cast<std::size_t>(c.degree - c.order) + 1; }

void spread(const Column& c, const double* coefficients) {
  const std::size_t count = terms(c);
  const Tables& t = c.tables;
  std::fill(c.terms + c.steps - 1, c.terms + t.size, Terms{});
  const auto set = [&](std::size_t k, bool has_odd, bool has_next) {
    for (std::size_t i = 0; i < 2; ++i) {
      const double* a = coefficients + 4 * k + i;
      const double next = has_next ? t.even[k + 1] * a[4] : 0;
      c.terms[k].even[i] = t.alpha[k] * (t.odd[k] * a[0] + next);
      c.terms[k].odd[i] = has_odd ? t.alpha[k] * a[2] : 0;
    }
  };
  for (std::size_t k = 0; k + 1 < c.steps; ++k) set(k, true, true);
  set(c.steps - 1, 2 * c.steps == count, false);
}

void gather(const Column& c, double* coefficients) {
  const std::size_t count = terms(c);
  const Tables& t = c.tables;
  const auto set = [&](std::size_t k, bool has_odd) {
    for (std::size_t i = 0; i < 2; ++i) {
      double* a = coefficients + 4 * k + i;
      const double before = k > 0 ? t.even[k] * t.alpha[k - 1] * c.terms[k - 1].even[i] : 0;
      a[0] = t.odd[k] * t.alpha[k] * c.terms[k].even[i] + before;
      if (has_odd) a[2] = t.alpha[k] * c.terms[k].odd[i];
    }
  };
  for (std::size_t k = 0; k + 1 < c.steps; ++k) set(k, true);
  set(c.steps - 1, 2 * c.steps == count);
}

// Registers of pairs that a synthesis runs side by side, to hide the latency of the recurrence; as many as there are
// registers of the machine for.
constexpr std::size_t kMostSide = kWidth == 8 ? 4 : 2;

// A register of pairs for each recurrence.
template <class... Recurrences>
class Synthesis {
 public:
  using Places = std::array<std::size_t, sizeof...(Recurrences)>;  // of the first pair of each register

  Synthesis(const Column& column, const Pairs& pairs, const Places& places)
      : recurrences_(Recurrences(column.tables)...),
        pairs_(pairs),
        places_(places),
        terms_(column.terms),
        tail_(column.tail),
        steps_((column.steps + 1) / 2 * 2) {
    each([&](auto v) {
      r_[v] = start<Of<v>>(column, pairs, places[v]);
      for (Lanes& sum : sum_[v]) sum = Lanes(0.0);
    });
  }

  void run() {
    std::size_t k = 0;
    for (; k < steps_ && every([this](const Register& r) { return r.is_below(tail_); }); lift()) {
      for (const std::size_t end = std::min(k + kStride, steps_); k < end; ++k) advance(k);
    }
    for (; k < steps_ && !every([](const Register& r) { return r.is_plain(); }); lift()) {
      Lanes factor[kSide];
      each([&](auto v) { factor[v] = r_[v].factor(tail_); });
      for (const std::size_t end = std::min(k + kStride, steps_); k < end; ++k) {
        Lanes value[kSide];
        each([&](auto v) { value[v] = r_[v].current * factor[v]; });
        add(terms_[k], value, sum_);
        advance(k);
      }
    }
    run_plain(k);
  }

  void store(double* values) const {
    for (std::size_t v = 0; v < kSide; ++v) {
      const Lanes z = Lanes::load_unaligned(pairs_.z + places_[v]);
      alignas(64) double lanes[4][kWidth];
      for (std::size_t i = 0; i < 2; ++i) {
        const Lanes odd = z * sum_[v][2 + i];
        (sum_[v][i] + odd).store_aligned(lanes[i]);
        (sum_[v][i] - odd).store_aligned(lanes[2 + i]);
      }
      double* to = values + 4 * places_[v];
      for (std::size_t p = 0; p < kWidth; ++p) {
        for (std::size_t i = 0; i < 4; ++i) to[4 * p + i] = lanes[i][p];
      }
    }
  }

 private:
  static constexpr std::size_t kSide = sizeof...(Recurrences);
  static_assert(kSide <= kMostSide);
  template <std::size_t V>
  using Of = std::tuple_element_t<V, std::tuple<Recurrences...>>;

  template <class F>
  [[gnu::always_inline]] static void each(const F& f) {
    repeat<kSide>(f);
  }

  // The rest, where all values stand for themselves; two steps at a time, in registers of the machine.
  [[gnu::always_inline]] void run_plain(std::size_t k) {
    const std::tuple<Recurrences...> recurrences = recurrences_;
    const Terms* const terms = terms_;
    const std::size_t steps = steps_;
    Lanes current[kSide], kept[kSide], square[kSide], sum[kSide][4];
    each([&](auto v) {
      current[v] = r_[v].current;
      kept[v] = r_[v].kept;
      square[v] = r_[v].square;
      repeat<4>([&](auto i) { sum[v][i] = sum_[v][i]; });
    });
    const auto now = [&](auto v) -> Lanes& { return Of<v>::kSwaps ? kept[v] : current[v]; };
    const auto other = [&](auto v) -> Lanes& { return Of<v>::kSwaps ? current[v] : kept[v]; };
    for (; k < steps; k += 2) {
      add(terms[k], current, sum);
      each([&](auto v) { std::get<v>(recurrences).next(k, square[v], current[v], kept[v]); });
      Lanes value[kSide];
      each([&](auto v) { value[v] = now(v); });
      add(terms[k + 1], value, sum);
      each([&](auto v) { std::get<v>(recurrences).next(k + 1, square[v], now(v), other(v)); });
    }
    each([&](auto v) { repeat<4>([&](auto i) { sum_[v][i] = sum[v][i]; }); });
  }

  [[gnu::always_inline]] static void add(const Terms& terms, const Lanes* value, Lanes (*sum)[4]) {
    repeat<4>([&](auto i) {
      const Lanes term(terms.of(i));
      each([&](auto v) { sum[v][i] = xsimd::fma(term, value[v], sum[v][i]); });
    });
  }

  template <class Test>
  bool every(const Test& test) const {
    bool all = true;
    for (const Register& r : r_) all = all && test(r);
    return all;
  }
  void lift() {
    for (Register& r : r_) r.lift();
  }
  [[gnu::always_inline]] void advance(std::size_t k) {
    each([&](auto v) { std::get<v>(recurrences_).advance(k, r_[v]); });
  }
  std::tuple<Recurrences...> recurrences_;
  const Pairs& pairs_;
  Places places_;
  const Terms* terms_;
  Tail tail_;
  std::size_t steps_;
  Register r_[kSide];
  Lanes sum_[kSide][4];
};

template <class... Recurrences>
[[gnu::noinline, gnu::flatten]] void synthesize(const Column& column, const Pairs& pairs,
                                                const typename Synthesis<Recurrences...>::Places& places,
                                                double* values) {
  Synthesis<Recurrences...> block(column, pairs, places);
  block.run();
  block.store(values);
}

// Pairs begin .. end by one recurrence, in blocks of equal sizes, or nearly so.
template <class R>
void synthesize_all(const Column& column, const Pairs& pairs, std::size_t begin, std::size_t end, double* values) {
  std::size_t registers = (end - begin) / kWidth;
  std::size_t blocks = (registers + kMostSide - 1) / kMostSide;
  for (std::size_t at = begin; at < end; --blocks) {
    const std::size_t side = (registers + blocks - 1) / blocks;
    const auto place = [at](std::size_t v) { return at + v * kWidth; };
    if constexpr (kMostSide == 4) {
      if (side == 4) synthesize<R, R, R, R>(column, pairs, {at, place(1), place(2), place(3)}, values);
      if (side == 3) synthesize<R, R, R>(column, pairs, {at, place(1), place(2)}, values);
    }
    if (side == 2) synthesize<R, R>(column, pairs, {at, place(1)}, values);
    if (side == 1) synthesize<R>(column, pairs, {at}, values);
    at += side * kWidth;
    registers -= side;
  }
}

void synthesis(const Column& column, const Pairs& pairs, double* values) {
  using Pole = Anchored<&Tables::pole>;
  using Equator = Anchored<&Tables::equator>;
  Pairs rest = pairs;
  if (pairs.plain - pairs.first == kWidth && pairs.count - pairs.equator == kWidth) {
    // Few pairs: neither anchor keeps the machine busy alone.
    synthesize<Pole, Equator>(column, pairs, {pairs.first, pairs.equator}, values);
    rest.first = pairs.plain;
    rest.count = pairs.equator;
  }
  for_recurrences(column, rest, [&](auto recurrence, std::size_t begin, std::size_t end) {
    synthesize_all<decltype(recurrence)>(column, pairs, begin, end, values);
  });
}

// An analysis takes some steps of all pairs after the other, so that its sums over the pairs stay in registers.
constexpr std::size_t kSteps = kWidth == 8 ? 4 : 2;
constexpr std::size_t kPanel = 40;  // registers of pairs that stay in the nearest cache

struct Held {
  Register r;
  Lanes value[4];  // even in z: both components; odd: both, times z
};

class Analysis {
 public:
  explicit Analysis(const Column& column) : column_(column) {}

  // Pairs begin .. end, at most kPanel registers of them.
  void run(const Pairs& pairs, std::size_t begin, std::size_t end, const double* values) {
    count_ = (end - begin) / kWidth;
    Pairs part = pairs;
    part.first = begin;
    part.count = end;
    for_recurrences(column_, part, [&](auto recurrence, std::size_t first, std::size_t last) {
      for (std::size_t at = first; at < last; at += kWidth) {
        Held& held = held_[(at - begin) / kWidth];
        held.r = start<decltype(recurrence)>(column_, pairs, at);
        take(Lanes::load_unaligned(pairs.z + at), values + 4 * at, held.value);
      }
    });
    below_ = 0;
    while (below_ < count_ && held_[below_].r.is_below(column_.tail)) ++below_;
    plain_ = count_;
    while (plain_ > below_ && held_[plain_ - 1].r.is_plain()) --plain_;
    for (std::size_t k = 0; k < column_.steps; k += kSteps) sweep(k, part);
  }

 private:
  static void take(const Lanes& z, const double* from, Lanes* value) {
    alignas(64) double lanes[4][kWidth];
    for (std::size_t p = 0; p < kWidth; ++p) {
      for (std::size_t i = 0; i < 4; ++i) lanes[i][p] = from[4 * p + i];
    }
    for (std::size_t i = 0; i < 2; ++i) {
      const Lanes north = Lanes::load_aligned(lanes[i]), south = Lanes::load_aligned(lanes[2 + i]);
      value[i] = north + south;
      value[2 + i] = (north - south) * z;
    }
  }

  [[gnu::noinline, gnu::flatten]] void sweep(std::size_t k, const Pairs& part) {
    Lanes sum[kSteps][4];  // in registers of the machine
    repeat<kSteps>([&](auto j) { repeat<4>([&](auto i) { sum[j][i] = Lanes(0.0); }); });
    std::size_t first_above = count_, last_mixed = below_, v = 0;
    const auto advance = [&](const auto& recurrence, Register& r) {
      repeat<kSteps>([&](auto j) { recurrence.advance(k + j, r); });
    };
    for_recurrences(column_, part, [&](auto recurrence, std::size_t /*first*/, std::size_t last) {
      const std::size_t end = (last - part.first) / kWidth;
      for (; v < std::min(end, below_); ++v) {
        Register& r = held_[v].r;
        advance(recurrence, r);
        r.lift();
        if (!r.is_below(column_.tail)) first_above = std::min(first_above, v);
      }
      for (; v < std::min(end, plain_); ++v) {
        Register r = held_[v].r;
        const Lanes factor = r.factor(column_.tail);
        repeat<kSteps>([&](auto j) {
          add(r.current * factor, held_[v].value, sum[j]);
          recurrence.advance(k + j, r);
        });
        r.lift();
        if (!r.is_plain()) last_mixed = v + 1;
        held_[v].r = r;
      }
      for (; v < end; ++v) {
        Held& held = held_[v];
        const Lanes v0 = held.value[0], v1 = held.value[1], v2 = held.value[2], v3 = held.value[3];
        Register r = held.r;
        repeat<kSteps>([&](auto j) {
          sum[j][0] = xsimd::fma(v0, r.current, sum[j][0]);
          sum[j][1] = xsimd::fma(v1, r.current, sum[j][1]);
          sum[j][2] = xsimd::fma(v2, r.current, sum[j][2]);
          sum[j][3] = xsimd::fma(v3, r.current, sum[j][3]);
          recurrence.advance(k + j, r);
        });
        held.r.current = r.current;
        held.r.kept = r.kept;
      }
    });
    if (below_ < plain_) plain_ = last_mixed;
    below_ = std::min(below_, first_above);
    finish(sum, k);
  }

  [[gnu::always_inline]] static void add(const Lanes& p, const Lanes* value, Lanes* sum) {
    repeat<4>([&](auto i) { sum[i] = xsimd::fma(value[i], p, sum[i]); });
  }

  // terms += the sums of the lanes.
  [[gnu::always_inline]] void finish(const Lanes (&sum)[kSteps][4], std::size_t k) {
    Lanes rows[4 * kSteps];
    repeat<4 * kSteps>([&](auto row) { rows[row] = sum[row / 4][row % 4]; });
    double* to = column_.terms[k].even;
    repeat<4 * kSteps / kWidth>([&](auto i) {
      constexpr std::size_t kRow = i * kWidth;
      (Lanes::load_unaligned(to + kRow) + xsimd::haddp(rows + kRow)).store_unaligned(to + kRow);
    });
  }

  Column column_;
  std::size_t count_ = 0, below_ = 0,
              plain_ = 0;  // registers: all, the first ones that are below, the last that are plain
  std::array<Held, kPanel> held_;
};

void analysis(const Column& column, const Pairs& pairs, const double* values) {
  std::fill(column.terms, column.terms + column.tables.size, Terms{});
  Analysis panel(column);
  const std::size_t registers = (pairs.count - pairs.first) / kWidth;
  std::size_t panels = (registers + kPanel - 1) / kPanel;
  for (std::size_t at = pairs.first; at < pairs.count; --panels) {
    const std::size_t pairs_of = ((pairs.count - at) / kWidth + panels - 1) / panels * kWidth;
    panel.run(pairs, at, at + pairs_of, values);
    at += pairs_of;
  }
}

}  // namespace

const Kernels kKernels{prepare, spread, synthesis, analysis, gather};

}  // namespace sh::numeric::rings::SH_RINGS_ISA
