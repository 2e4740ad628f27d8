// Visibility times a prepared light, projected, in stages on rings of constant z.
//
// Copied by:    shgen write, from codegen/runtime to generated/batch
// Licence:      MIT-0; paste it anywhere.
//
// The quadrature is that of sh::transfer_apply (its file explains it), whose values outnumber the registers. Here each
// stage is a function that keeps its values in registers and leaves its results in the nearest cache:
//   1. from the coefficients of the visibility to its orders -2n .. 2n on the n pairs of rings and at the poles
//   2. ring by ring: from orders to 4n samples, times the samples of each channel of the light, to orders -n .. n
//   3. from these orders to the coefficients of the result
// The tables hold orders times their value at phi_0, cos(m phi_0) or sin(m phi_0); what is summed over there needs no
// multiplication. cos(2n phi_j) is 0: that order has no part on the rings, and the light's last two samples correct it.
#include "transfer_rings.hpp"

#include "vectors.hpp"

namespace sh::batch::SH_BATCH_ISA {
namespace {

// A table that the compiler reads again at each use: it would keep its numbers in registers, which are needed.
template <class T>
[[gnu::always_inline]] inline const T* reread(const T* table) {
  asm("" : "+r"(table));
  return table;
}

// What a stream needs next: visibility to read, and lines of results.
struct Upcoming {
  const char* in = nullptr;
  int lines_in = 0;
  char* out = nullptr;
};

template <int N, class T>
class TransferRings {
 public:
  using V = Lanes<T>;
  using Table = detail::Rings<N, T>;

  // visibility(i): coefficient i; samples: of the prepared light.
  template <int Channels, class Visibility>
  static void apply(const Visibility& visibility, const T* samples, V* out, const Upcoming& next) {
    V on_rings[kRings * kOrders];
    V products[Channels * kRings * kResults];
    V poles[2];
    to_rings(visibility, on_rings, poles);
    meet_light<Channels>(on_rings, samples, products, next);
    finish<Channels>(products, poles, visibility(coefficient(2 * N, 2 * N)), visibility(coefficient(2 * N, -2 * N)),
                     samples, out);
  }

 private:
  static constexpr int kRings = 2 * N;
  static constexpr int kOrders = 4 * N + 1;   // of the visibility, -2n .. 2n
  static constexpr int kResults = 2 * N + 1;  // orders of the result, -n .. n
  static constexpr int kHalf = N / 2;         // angles up to pi/4, and one at pi/4 where n is odd
  static constexpr bool kHasMiddle = N % 2 == 1;
  static constexpr int kSamples = 8 * N * N + 4;  // of a channel of the light

  static constexpr int coefficient(int l, int m) { return l * l + l + m; }

  // out = a k, or out += a k; the constant stays in memory.
  template <bool First>
  [[gnu::always_inline]] static void add(V& out, const V& a, T k) {
    if constexpr (First) {
      out = a * V(k);
    } else {
      out = out + a * V(k);
    }
  }
  template <bool First>
  [[gnu::always_inline]] static void add(V& out, const V& a) {
    if constexpr (First) {
      out = a;
    } else {
      out = out + a;
    }
  }
  // The same with a factor that is 1 if so.
  template <bool First, bool IsOne>
  [[gnu::always_inline]] static void add_times(V& out, const V& a, const T* k) {
    if constexpr (IsOne) {
      add<First>(out, a);
    } else {
      add<First>(out, a, *k);
    }
  }

  template <class Visibility>
  [[gnu::noinline, gnu::flatten]] static void to_rings(const Visibility& visibility, V* on_rings, V* poles) {
    repeat<2 * N + 1>([&](auto order) {
      constexpr int kM = decltype(order)::value;
      if constexpr (kM == 0) poles_of(visibility, poles);
      if constexpr (kM < 2 * N) order_to_rings<kM, false>(visibility, on_rings);
      if constexpr (kM > 0) order_to_rings<kM, true>(visibility, on_rings);
    });
  }

  template <int M, bool IsSine, class Visibility>
  static void order_to_rings(const Visibility& visibility, V* on_rings) {
    constexpr int kOrder = IsSine ? -M : M;
    const T* theta = reread(Table::kTheta[IsSine] + Table::place(M, M, 2 * N) * N);
    V halves[2][N];  // even and odd in z
    repeat<2 * N - M + 1>([&](auto above) {
      constexpr int kAbove = decltype(above)::value;
      const V c = visibility(coefficient(M + kAbove, kOrder));
      repeat<N>([&](auto pair) {
        constexpr int kPair = decltype(pair)::value;
        add < kAbove<2>(halves[kAbove % 2][kPair], c, theta[kAbove * N + kPair]);
      });
    });
    repeat<N>([&](auto pair) {
      constexpr int kPair = decltype(pair)::value;
      V* to = on_rings + 2 * kPair * kOrders + 2 * N + kOrder;
      if constexpr (M == 2 * N) {
        to[0] = halves[0][kPair];
        to[kOrders] = halves[0][kPair];
      } else {
        to[0] = halves[0][kPair] + halves[1][kPair];
        to[kOrders] = halves[0][kPair] - halves[1][kPair];
      }
    });
  }

  template <class Visibility>
  static void poles_of(const Visibility& visibility, V* poles) {
    const T* theta = reread(Table::kPole);
    V halves[2];
    repeat<2 * N + 1>([&](auto degree) {
      constexpr int kL = decltype(degree)::value;
      add < kL<2>(halves[kL % 2], visibility(coefficient(kL, 0)), theta[kL]);
    });
    poles[0] = halves[0] + halves[1];
    poles[1] = halves[0] - halves[1];
  }

  template <int Channels>
  [[gnu::noinline, gnu::flatten]] static void meet_light(const V* on_ring, const T* samples, V* products,
                                                         const Upcoming& next) {
    const int lines_in = next.lines_in / kRings + 1;
    constexpr int kLinesOut = Channels * (N + 1) * (N + 1) / kRings + 1;
    for (int ring = 0; ring < kRings; ++ring) {
      for (int k = 0; k < lines_in; ++k) __builtin_prefetch(next.in + (ring * lines_in + k) * detail::kLine, 0, 3);
      for (int k = 0; k < kLinesOut; ++k) __builtin_prefetch(next.out + (ring * kLinesOut + k) * detail::kLine, 1, 2);
      V seen[4 * N];
      sample(on_ring + ring * kOrders, seen);
      for (int channel = 0; channel < Channels; ++channel) {
        project(seen, samples + channel * kSamples + ring * 4 * N, products + (channel * kRings + ring) * kResults);
      }
    }
  }

  // Orders on a ring -> values at phi_j, pi + phi_j, -phi_j, pi - phi_j for each j.
  static void sample(const V* on_ring, V* seen) {
    const T* cosine = reread(Table::kRatio[0]);
    const T* sine = reread(Table::kRatio[1]);
    V even_cosine[N], even_sine[N], odd_cosine[N], odd_sine[N];
    even_orders<false>(on_ring, cosine, even_cosine);
    even_orders<true>(on_ring, sine, even_sine);
    odd_orders<false>(on_ring, cosine, odd_cosine);
    odd_orders<true>(on_ring, sine, odd_sine);
    repeat<N>([&](auto angle) {
      constexpr int kJ = decltype(angle)::value;
      const V a = even_cosine[kJ] + odd_cosine[kJ], b = even_cosine[kJ] - odd_cosine[kJ];
      const V c = even_sine[kJ] + odd_sine[kJ], d = even_sine[kJ] - odd_sine[kJ];
      seen[4 * kJ] = a + c;
      seen[4 * kJ + 1] = b + d;
      seen[4 * kJ + 2] = a - c;
      seen[4 * kJ + 3] = b - d;
    });
  }

  template <bool IsSine>
  static void odd_orders(const V* on_ring, const T* ratio, V* at) {
    repeat<N>([&](auto k) {
      constexpr int kM = 2 * decltype(k)::value + 1;
      const V c = on_ring[2 * N + (IsSine ? -kM : kM)];
      repeat<N>([&](auto angle) {
        constexpr int kJ = decltype(angle)::value;
        add_times<kM == 1, kJ == 0>(at[kJ], c, ratio + kM * N + kJ);
      });
    });
  }

  // Of an even order, angles phi and pi/2 - phi have the same value or opposite ones.
  template <int M, bool IsSine>
  static constexpr bool kIsSymmetric = (M / 2 % 2 == 0) != IsSine;

  template <bool IsSine>
  static void even_orders(const V* on_ring, const T* ratio, V* at) {
    constexpr int kParts = kHalf + (kHasMiddle ? 1 : 0);
    V same[kParts], opposite[kParts];
    repeat<N + 1>([&](auto k) {
      constexpr int kM = 2 * decltype(k)::value;
      if constexpr (IsSine ? kM > 0 : kM < 2 * N) {
        constexpr bool kSame = kIsSymmetric<kM, IsSine>;
        constexpr int kFirst = kSame ? (IsSine ? 2 : 0) : (IsSine ? 4 : 2);
        const V c = on_ring[2 * N + (IsSine ? -kM : kM)];
        repeat<kSame ? kParts : kHalf>([&](auto angle) {
          constexpr int kJ = decltype(angle)::value;
          add_times<kM == kFirst, kM == 0 || kJ == 0>(kSame ? same[kJ] : opposite[kJ], c, ratio + kM * N + kJ);
        });
      }
    });
    repeat<kHalf>([&](auto angle) {
      constexpr int kJ = decltype(angle)::value;
      at[kJ] = same[kJ] + opposite[kJ];
      at[N - 1 - kJ] = same[kJ] - opposite[kJ];
    });
    if constexpr (kHasMiddle) at[kHalf] = same[kHalf];
  }

  // Values times those of a channel of the light -> orders on the ring.
  static void project(const V* seen, const T* light, V* out) {
    const T* cosine = reread(Table::kRatio[0]);
    const T* sine = reread(Table::kRatio[1]);
    V even_cosine[N], even_sine[N], odd_cosine[N], odd_sine[N];
    repeat<N>([&](auto angle) {
      constexpr int kJ = decltype(angle)::value;
      const V at_opposite = seen[4 * kJ + 1] * V(light[4 * kJ + 1]);
      const V at_last = seen[4 * kJ + 3] * V(light[4 * kJ + 3]);
      const V a = seen[4 * kJ] * V(light[4 * kJ]) + at_opposite;
      const V b = seen[4 * kJ + 2] * V(light[4 * kJ + 2]) + at_last;
      const V c = seen[4 * kJ] * V(light[4 * kJ]) - at_opposite;
      const V d = seen[4 * kJ + 2] * V(light[4 * kJ + 2]) - at_last;
      even_cosine[kJ] = a + b;
      even_sine[kJ] = a - b;
      odd_cosine[kJ] = c + d;
      odd_sine[kJ] = c - d;
    });
    project_even<false>(even_cosine, cosine, out);
    project_even<true>(even_sine, sine, out);
    project_odd<false>(odd_cosine, cosine, out);
    project_odd<true>(odd_sine, sine, out);
  }

  template <bool IsSine>
  static void project_odd(const V* at, const T* ratio, V* out) {
    repeat<(N + 1) / 2>([&](auto k) {
      constexpr int kM = 2 * decltype(k)::value + 1;
      V sum;
      repeat<N>([&](auto angle) {
        constexpr int kJ = decltype(angle)::value;
        add_times<kJ == 0, kJ == 0>(sum, at[kJ], ratio + kM * N + kJ);
      });
      out[N + (IsSine ? -kM : kM)] = sum;
    });
  }

  template <bool IsSine>
  static void project_even(const V* at, const T* ratio, V* out) {
    V same[kHalf], opposite[kHalf];
    repeat<kHalf>([&](auto angle) {
      constexpr int kJ = decltype(angle)::value;
      same[kJ] = at[kJ] + at[N - 1 - kJ];
      opposite[kJ] = at[kJ] - at[N - 1 - kJ];
    });
    repeat<N / 2 + 1>([&](auto k) {
      constexpr int kM = 2 * decltype(k)::value;
      if constexpr (!IsSine || kM > 0) {
        constexpr bool kSame = kIsSymmetric<kM, IsSine>;
        V sum;
        repeat<kHalf>([&](auto angle) {
          constexpr int kJ = decltype(angle)::value;
          add_times<kJ == 0, kM == 0 || kJ == 0>(sum, kSame ? same[kJ] : opposite[kJ], ratio + kM * N + kJ);
        });
        if constexpr (kHasMiddle && kSame) add_times<false, kM == 0>(sum, at[kHalf], ratio + kM * N + kHalf);
        out[N + (IsSine ? -kM : kM)] = sum;
      }
    });
  }

  // top_cosine, top_sine: the visibility of order 2n.
  template <int Channels>
  [[gnu::noinline, gnu::flatten]] static void finish(const V* products, const V* poles, const V& top_cosine,
                                                     const V& top_sine, const T* samples, V* out) {
    for (int channel = 0; channel < Channels; ++channel) {
      const T* last = samples + kSamples - 4;
      const V north = poles[0] * V(last[0]), south = poles[1] * V(last[1]);
      const V at_poles[2] = {north + south, north - south};
      repeat<N + 1>([&](auto order) {
        constexpr int kM = decltype(order)::value;
        finish_order<kM, false>(products, out);
        if constexpr (kM > 0) finish_order<kM, true>(products, out);
      });
      const T* theta = reread(Table::kPoleResult);
      repeat<N + 1>([&](auto degree) {
        constexpr int kL = decltype(degree)::value;
        add<false>(out[coefficient(kL, 0)], at_poles[kL % 2], theta[kL]);
      });
      V& cosine = out[coefficient(N, N)];
      V& sine = out[coefficient(N, -N)];
      cosine = cosine + (top_cosine * V(last[2]) - top_sine * V(last[3]));
      sine = sine - (top_cosine * V(last[3]) + top_sine * V(last[2]));
      samples += kSamples;
      products += kRings * kResults;
      out += coefficient(N, N) + 1;
    }
  }

  template <int M, bool IsSine>
  static void finish_order(const V* products, V* out) {
    constexpr int kOrder = IsSine ? -M : M;
    const T* theta = reread(Table::kResult[IsSine] + Table::place(M, M, N) * N);
    V halves[2][N];
    repeat<N>([&](auto pair) {
      constexpr int kPair = decltype(pair)::value;
      const V* from = products + 2 * kPair * kResults + N + kOrder;
      halves[0][kPair] = from[0] + from[kResults];
      halves[1][kPair] = from[0] - from[kResults];
    });
    repeat<N - M + 1>([&](auto above) {
      constexpr int kAbove = decltype(above)::value;
      V sum;
      repeat<N>([&](auto pair) {
        constexpr int kPair = decltype(pair)::value;
        add<kPair == 0>(sum, halves[kAbove % 2][kPair], theta[kAbove * N + kPair]);
      });
      out[coefficient(M + kAbove, kOrder)] = sum;
    });
  }
};

// Coefficients of a register's visibility: one type for any number of channels, so that these share to_rings.
template <class Stored, class T>
struct Visibility {
  const Stored* from;
  Lanes<T> operator()(int i) const { return load_lanes(from + i * kBlock<T>); }
};

}  // namespace

template <int N, int Channels, class Stored, class T>
void apply_on_rings(const Blocks<T>& blocks) {
  for (std::size_t b = 0; b < blocks.count; ++b) {
    const T* from = blocks.in[0] + b * blocks.step[0];
    T* out = blocks.out + b * blocks.out_step;
    for (std::size_t lane = 0; lane < lanes_of(blocks); lane += Lanes<T>::kWidth) {
      TransferRings<N, T>::template apply<Channels>(
          Visibility<Stored, T>{reinterpret_cast<const Stored*>(from) + lane}, blocks.in[1],
          reinterpret_cast<Lanes<T>*>(out + lane),
          {reinterpret_cast<const char*>(from + blocks.step[0]), static_cast<int>(blocks.step[0] / kBlock<T>),
           reinterpret_cast<char*>(out + blocks.out_step)});
    }
  }
}

// The degrees, channels and scalars that drivers use.
#define SH_BATCH_ON_RINGS(degree, stored, scalar)                                 \
  template void apply_on_rings<degree, 1, stored, scalar>(const Blocks<scalar>&); \
  template void apply_on_rings<degree, 3, stored, scalar>(const Blocks<scalar>&)
SH_BATCH_ON_RINGS(2, float, float);
SH_BATCH_ON_RINGS(3, float, float);
SH_BATCH_ON_RINGS(4, float, float);
SH_BATCH_ON_RINGS(5, float, float);
SH_BATCH_ON_RINGS(6, float, float);
SH_BATCH_ON_RINGS(3, double, double);
SH_BATCH_ON_RINGS(4, double, double);
SH_BATCH_ON_RINGS(5, double, double);
SH_BATCH_ON_RINGS(6, double, double);
#if defined(SH_BATCH_CONVERTS_HALVES)
SH_BATCH_ON_RINGS(2, Half, float);
SH_BATCH_ON_RINGS(3, Half, float);
SH_BATCH_ON_RINGS(4, Half, float);
SH_BATCH_ON_RINGS(5, Half, float);
SH_BATCH_ON_RINGS(6, Half, float);
#endif
#undef SH_BATCH_ON_RINGS

}  // namespace sh::batch::SH_BATCH_ISA
