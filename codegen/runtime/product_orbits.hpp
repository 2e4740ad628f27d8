// One product of two functions with an orbit of (+-x, +-y, +-z) in each SIMD lane.
//
// Copied by:    shgen write, from codegen/runtime to generated/batch
// Licence:      MIT-0; paste it anywhere.
//
// A function is split by its parities into eight classes: 1, y, z, x, and opposite to them, different in all three
// parities, xyz, xz, xy, yz. Its values on an orbit are the sums of classes with signs. They are multiplied there, and
// weighted sums over the orbits are the coefficients of the product, but for rounding (orbits_l<degree>.hpp).
#pragma once

#include <cstring>

#include "vectors.hpp"

namespace sh::batch::SH_BATCH_ISA {

// Lanes in blocks of four: (a0, b0, a1, b1), (a2, b2, a3, b3).
template <int W, int First>
struct Interleave {
  static constexpr int at(int i) { return i / 4 * 4 + First + i % 4 / 2 + i % 2 * W; }
};
// (a0, a1, b0, b1), (a2, a3, b2, b3).
template <int W, int First>
struct Halves {
  static constexpr int at(int i) { return i / 4 * 4 + First + i % 2 + i % 4 / 2 * W; }
};
// The even or odd blocks of four of a, then those of b.
template <int First>
struct Blocks {
  static constexpr int at(int i) { return (i / 4 * 2 + First) * 4 + i % 4; }
};

// Orbits of which half a register is filled, with the antipodes of their points in the other half: odd degrees change
// sign there.
template <class Orbits>
class WithAntipodes {
  struct Tables {
    alignas(64) float values[(Orbits::kDegree + 1) * (Orbits::kDegree + 1) * 2 * Orbits::kOrbits] = {};
    alignas(64) float sums[(Orbits::kRows + Orbits::kOppositeRows) * 4 * 2 * Orbits::kOrbits] = {};
  };
  static constexpr bool odd_degree(int i) {
    int l = 0;
    while ((l + 1) * (l + 1) <= i) ++l;
    return l % 2 != 0;
  }
  static constexpr Tables tables() {
    constexpr int n = Orbits::kOrbits;
    Tables both;
    for (int i = 0; i < (Orbits::kDegree + 1) * (Orbits::kDegree + 1); ++i) {
      for (int q = 0; q < n; ++q) {
        const float y = Orbits::kValues[i * n + q];
        both.values[2 * i * n + q] = y;
        both.values[2 * i * n + n + q] = odd_degree(i) ? -y : y;
      }
    }
    for (int row = 0; row < (Orbits::kRows + Orbits::kOppositeRows) * 4; ++row) {
      for (int q = 0; q < n; ++q) {
        const float weight = Orbits::kSums[row * n + q];
        both.sums[2 * row * n + q] = weight;
        both.sums[2 * row * n + n + q] = odd_degree(Orbits::kSlots[row / 4 * 4 + q % 4]) ? -weight : weight;
      }
    }
    return both;
  }
  static constexpr Tables kTables = tables();

 public:
  static constexpr int kDegree = Orbits::kDegree;
  static constexpr int kOrbits = 2 * Orbits::kOrbits;
  static constexpr int kRows = Orbits::kRows + Orbits::kOppositeRows;
  static constexpr int kOppositeRows = 0;
  static constexpr const int* kSlots = Orbits::kSlots;
  static constexpr const float* kValues = kTables.values;
  static constexpr const float* kSums = kTables.sums;
};

// The coefficients of a product, W orbits at a time.
template <int W, class Orbits>
class OrbitProduct {
  using V = Vector<W>;
  static constexpr int kSize = (Orbits::kDegree + 1) * (Orbits::kDegree + 1);
  static constexpr int kAllRows = Orbits::kRows + Orbits::kOppositeRows;

 public:
  [[gnu::always_inline]] static void run(const float* a, const float* b, float* c) {
    V sums[kAllRows];
    for (int q = 0; q < Orbits::kOrbits; q += W) add_orbits(a, b, q, q == 0, sums);
    store(sums, c);
  }

 private:
  // Class 1, y, z or x (r = 0 to 3) of a function, or the opposite one, at W orbits.
  template <int R, int FirstRow, int Rows>
  [[gnu::always_inline]] static V values(const float* c, int q) {
    V sum{};
    repeat<Rows>([&](auto s) {
      constexpr int i = Orbits::kSlots[4 * (FirstRow + s) + R];
      if constexpr (i >= 0) {
        const V y = load_vector<W>(Orbits::kValues + i * Orbits::kOrbits + q);
        sum = s == 0 ? y * c[i] : sum + y * c[i];
      }
    });
    return sum;
  }

  // The parts of a function that turns by pi leave alone or change the sign of, at the orbit's point (direct) and at
  // its antipode, where odd degrees change sign: those of classes y, z and x, and of xyz.
  [[gnu::always_inline]] static void parts(const float* c, int q, V* direct, V* antipode) {
    repeat<4>([&](auto r) {
      const V one = values<r, 0, Orbits::kRows>(c, q);
      const V opposite = values<r, Orbits::kRows, Orbits::kOppositeRows>(c, q);
      direct[r] = one + opposite;
      antipode[r] = r == 0 ? one - opposite : opposite - one;
    });
  }

  // The parts of a product: turns by pi about the axes form a group of four.
  [[gnu::always_inline]] static void multiply(const V* a, const V* b, V* h) {
    h[0] = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
    h[1] = a[0] * b[1] + a[1] * b[0] + a[2] * b[3] + a[3] * b[2];
    h[2] = a[0] * b[2] + a[2] * b[0] + a[1] * b[3] + a[3] * b[1];
    h[3] = a[0] * b[3] + a[3] * b[0] + a[1] * b[2] + a[2] * b[1];
  }

  // In every block of four lanes: rows become columns.
  [[gnu::always_inline]] static void transpose(V* h) {
    const V a = shuffle<Interleave<W, 0>>(h[0], h[1]);
    const V b = shuffle<Interleave<W, 2>>(h[0], h[1]);
    const V c = shuffle<Interleave<W, 0>>(h[2], h[3]);
    const V d = shuffle<Interleave<W, 2>>(h[2], h[3]);
    h[0] = shuffle<Halves<W, 0>>(a, c);
    h[1] = shuffle<Halves<W, 2>>(a, c);
    h[2] = shuffle<Halves<W, 0>>(b, d);
    h[3] = shuffle<Halves<W, 2>>(b, d);
  }

  // sums[row] += over j of weights times h[j], which holds in every block of four lanes four classes at one orbit.
  template <int FirstRow, int Rows>
  [[gnu::always_inline]] static void add_rows(V* h, int q, bool first, V* sums) {
    transpose(h);
    repeat<Rows>([&](auto s) {
      const float* weights = Orbits::kSums + (FirstRow + s) * 4 * Orbits::kOrbits + q;
      V sum = load_vector<W>(weights) * h[0];
      if (!first) sum += sums[FirstRow + s];
      repeat<3>([&](auto j) { sum += load_vector<W>(weights + (j + 1) * Orbits::kOrbits) * h[j + 1]; });
      sums[FirstRow + s] = sum;
    });
  }

  // Where the table has the antipodes itself.
  [[gnu::always_inline]] static void add_points(const float* a, const float* b, int q, bool first, V* sums) {
    V of_a[4];
    V of_b[4];
    V product[4];
    repeat<4>([&](auto r) {
      of_a[r] = values<r, 0, kAllRows>(a, q);
      of_b[r] = values<r, 0, kAllRows>(b, q);
    });
    multiply(of_a, of_b, product);
    add_rows<0, kAllRows>(product, q, first, sums);
  }

  [[gnu::always_inline]] static void add_orbits(const float* a, const float* b, int q, bool first, V* sums) {
    if constexpr (Orbits::kOppositeRows == 0) return add_points(a, b, q, first, sums);
    V direct_a[4];
    V direct_b[4];
    V antipode_a[4];
    V antipode_b[4];
    parts(a, q, direct_a, antipode_a);
    parts(b, q, direct_b, antipode_b);
    V direct[4];
    V antipode[4];
    multiply(direct_a, direct_b, direct);
    multiply(antipode_a, antipode_b, antipode);
    V classes[4];
    V opposite[4];
    repeat<4>([&](auto r) {
      const V plus = direct[r] + antipode[r];
      const V minus = direct[r] - antipode[r];
      classes[r] = r == 0 ? plus : minus;
      opposite[r] = r == 0 ? minus : plus;
    });
    add_rows<0, Orbits::kRows>(classes, q, first, sums);
    add_rows<Orbits::kRows, Orbits::kOppositeRows>(opposite, q, first, sums);
  }

  // Where coefficient i is after the blocks of four have been added up: row by row, four classes each.
  static constexpr int place(int i) {
    int p = 0;
    while (Orbits::kSlots[p] != i) ++p;
    return p;
  }
  // Lanes of coefficients First, First + 1, ...: those that register R holds from it, the others as they are.
  template <int First, int R>
  struct Gather {
    static constexpr int at(int i) { return place(First + i) / W == R ? W + place(First + i) % W : i; }
  };
  template <int First>
  struct GatherTwo {
    static constexpr int at(int i) { return place(First + i) < 2 * W ? place(First + i) : 0; }
  };

  // Adds up the blocks of four lanes, puts the sums in order and stores them.
  [[gnu::always_inline]] static void store(const V* sums, float* c) {
    constexpr int kBlocks = W / 4;
    constexpr int kRegisters = (kAllRows + kBlocks - 1) / kBlocks;
    V in_rows[kRegisters < 2 ? 2 : kRegisters];
    repeat<kRegisters>([&](auto k) {
      const auto row = [&](int b) { return sums[k * kBlocks + b < kAllRows ? k * kBlocks + b : kAllRows - 1]; };
      V folded = shuffle<Blocks<0>>(row(0), row(1)) + shuffle<Blocks<1>>(row(0), row(1));
      if constexpr (kBlocks == 4) {
        const V more = shuffle<Blocks<0>>(row(2), row(3)) + shuffle<Blocks<1>>(row(2), row(3));
        folded = shuffle<Blocks<0>>(folded, more) + shuffle<Blocks<1>>(folded, more);
      }
      in_rows[k] = folded;
    });
    if constexpr (kRegisters == 1) in_rows[1] = in_rows[0];
    repeat<(kSize + W - 1) / W>([&](auto o) {
      constexpr int first = o * W + W <= kSize ? o * W : kSize - W;
      V out = shuffle<GatherTwo<first>>(in_rows[0], in_rows[1]);
      repeat<(kRegisters > 2 ? kRegisters - 2 : 0)>(
          [&](auto k) { out = shuffle<Gather<first, k + 2>>(out, in_rows[k + 2]); });
      std::memcpy(c + first, &out, sizeof out);
    });
  }
};

}  // namespace sh::batch::SH_BATCH_ISA
