// The tables of kernels with SIMD inside one call equal the Gaunt tensor and the definition of a rotation exactly.
#include "codegen/recipes/lane_tables.hpp"

#include <cln/real.h>
#include <gtest/gtest.h>

#include "codegen/recipes/product/orbits.hpp"
#include "numeric/oracle/index.hpp"
#include "symbolic/number/matrix.hpp"
#include "symbolic/product/gaunt.hpp"

namespace sh::codegen {
namespace {

using recipes::ClassRow;
using recipes::OrbitQuadrature;
using symbolic::gaunt;

constexpr int kDigits = 40;

cln::cl_R number(const ExactReal& value) { return is_zero(value) ? cln::cl_R(0) : evaluate(value, kDigits); }

bool is_small(const cln::cl_R& value) { return cln::abs(value) < cln::expt(cln::cl_RA(10), -30); }

// Class of every coefficient: 0 to 3, and the opposite one 7 - that.
std::vector<int> classes(const OrbitQuadrature& orbits) {
  std::vector<int> result((orbits.degree() + 1) * (orbits.degree() + 1), -1);
  for (const bool opposite : {false, true}) {
    for (const ClassRow& row : orbits.rows(opposite)) {
      for (std::size_t r = 0; r < row.size(); ++r) {
        if (row[r] < 0) continue;
        EXPECT_EQ(result[row[r]], -1) << "coefficient " << row[r] << " twice";
        result[row[r]] = opposite ? 7 - static_cast<int>(r) : static_cast<int>(r);
      }
    }
  }
  return result;
}

TEST(LaneTables, SumsOverOrbitsAreTheGauntTensor) {
  for (const int degree : {1, 2, 3, 4}) {
    const OrbitQuadrature orbits(degree);
    const std::vector<int> of = classes(orbits);
    const int size = static_cast<int>(of.size());
    std::vector<std::vector<cln::cl_R>> y(size);
    std::vector<cln::cl_R> weight;
    for (int q = 0; q < orbits.count(); ++q) {
      weight.push_back(number(orbits.weight(q)));
      for (int i = 0; i < size; ++i) y[i].push_back(number(orbits.value(i, q)));
    }
    for (int i = 0; i < size; ++i) {
      ASSERT_GE(of[i], 0) << i;
      for (int j = 0; j <= i; ++j) {
        for (int k = 0; k < size; ++k) {
          // In all other cases the signs on the orbit cancel.
          if (!symbolic::gaunt_may_differ_from_zero(i, j, k)) continue;
          cln::cl_R sum = 0;
          for (std::size_t q = 0; q < weight.size(); ++q) {
            sum = sum + weight[q] * y[i][q] * y[j][q] * y[k][q];
          }
          EXPECT_TRUE(is_small(sum - number(gaunt(i, j, k)))) << degree << ": " << i << " " << j << " " << k;
        }
      }
    }
  }
}

TEST(LaneTables, OppositeClassesDifferUnderTheInversion) {
  const OrbitQuadrature orbits(6);
  for (const bool opposite : {false, true}) {
    for (const ClassRow& row : orbits.rows(opposite)) {
      for (std::size_t r = 0; r < row.size(); ++r) {
        int l = 0;
        while (numeric::coefficient_count(l) <= row[r]) ++l;
        const bool odd = opposite == (r == 0);  // x, y, z and xyz
        if (row[r] < 0) continue;
        EXPECT_EQ(l % 2 != 0, odd) << row[r];
      }
    }
  }
}

TEST(LaneTables, TermsInLanesAreTheGauntTensor) {
  const recipes::LaneTriples table = recipes::lane_triples();
  constexpr int kCount = 9;
  for (int i = 0; i < kCount; ++i) {
    for (int j = 0; j < kCount; ++j) {
      std::array<cln::cl_R, recipes::kLanes> c;
      for (const auto& scale : table.scales) {
        if (scale.e == i) c[j] = c[j] + number(scale.g[j]);
        if (scale.e == j) c[i] = c[i] + number(scale.g[i]);
      }
      for (const auto& round : table.rounds) {
        for (std::size_t lane = 0; lane < c.size(); ++lane) {
          if (round.i[lane] == i && round.j[lane] == j) c[lane] = c[lane] + number(round.g[lane]);
        }
      }
      for (int k = 0; k < kCount; ++k) {
        const cln::cl_R sum = c[k] + c[table.more[k]];
        EXPECT_TRUE(is_small(sum - number(gaunt(i, j, k)))) << i << " " << j << " " << k;
      }
    }
  }
}

// The matrix that the rounds represent.
template <std::size_t Lanes>
std::vector<std::vector<cln::cl_R>> matrix_of(const std::vector<recipes::TurnRound<Lanes>>& rounds) {
  std::vector<std::vector<cln::cl_R>> matrix(Lanes, std::vector<cln::cl_R>(Lanes, 0));
  for (const recipes::TurnRound<Lanes>& round : rounds) {
    for (std::size_t lane = 0; lane < Lanes; ++lane) {
      cln::cl_R& entry = matrix[lane][round.column[lane]];
      entry = entry + number(round.entry[lane]);
    }
  }
  return matrix;
}

TEST(LaneTables, SwapsOfYAndZAreTheirOwnInverse) {
  for (const auto& [first, last] : {std::pair(0, 3), std::pair(4, 4), std::pair(5, 5), std::pair(6, 6)}) {
    const recipes::LaneTurns turns = recipes::lane_turns(first, last);
    const auto swap = matrix_of(turns.swap);
    for (std::size_t i = 0; i < swap.size(); ++i) {
      for (std::size_t j = 0; j < swap.size(); ++j) {
        cln::cl_R sum = i == j && static_cast<int>(i) < turns.lanes() ? -1 : 0;
        for (std::size_t k = 0; k < swap.size(); ++k) sum = sum + swap[i][k] * swap[k][j];
        EXPECT_TRUE(is_small(sum)) << first << ": " << i << " " << j;
      }
    }
  }
}

// By hand. Band 1: y and z change places, x stays. Band 2: xy and xz change places, yz stays; 2zz - xx - yy and xx - yy mix.
TEST(LaneTables, ASwapMovesTheFunctionsOfBandOneAndTwo) {
  const auto one = recipes::swap_matrix(1);
  const auto two = recipes::swap_matrix(2);
  const auto entry = [](const auto& matrix, int i, int j) { return number(matrix(i, j)); };
  EXPECT_TRUE(is_small(entry(one, 0, 1) - 1) && is_small(entry(one, 1, 0) - 1) && is_small(entry(one, 2, 2) - 1));
  EXPECT_TRUE(is_small(entry(two, 0, 3) - 1) && is_small(entry(two, 3, 0) - 1) && is_small(entry(two, 1, 1) - 1));
  EXPECT_TRUE(is_small(2 * entry(two, 2, 2) + 1) && is_small(2 * entry(two, 4, 4) - 1));
  EXPECT_TRUE(is_small(4 * entry(two, 2, 4) * entry(two, 2, 4) - 3) && entry(two, 2, 4) < 0);
}

// Rows of pairs, read back: cosine rows from columns l + |m| even, sine rows from columns l + |m| odd.
TEST(LaneTables, PairsHoldTheRowsOfASwap) {
  for (const std::vector<int>& bands : {std::vector{3, 2}, {4}, {5}, {6}, {7}}) {
    const recipes::LanePairs pairs = recipes::lane_pairs(bands);
    const std::array rows{matrix_of(pairs.sines), matrix_of(pairs.cosines)};
    for (std::size_t b = 0; b < bands.size(); ++b) {
      const int l = bands[b];
      const auto start = static_cast<int>(b) * pairs.lanes();
      const auto swap = recipes::swap_matrix(l);
      for (int i = -l; i <= l; ++i) {
        const bool is_cosine = i >= 0;
        std::vector<cln::cl_R> found(2 * l + 1, 0);
        for (int j = -l; j <= l; ++j) {
          const bool is_even = (l + std::abs(j)) % 2 == 0;
          if (is_even == is_cosine)
            found[l + j] = rows.at(is_cosine ? 1 : 0)[start + std::abs(i)][start + (j < 0 ? -j - 1 : j)];
        }
        for (int j = -l; j <= l; ++j) {
          EXPECT_TRUE(is_small(found[l + j] - number(swap(l + i, l + j)))) << l << ": " << i << " " << j;
        }
      }
    }
  }
  EXPECT_THROW(static_cast<void>(recipes::lane_pairs({8})), std::logic_error);
  EXPECT_THROW(static_cast<void>(recipes::lane_pairs({3, 4})), std::logic_error);
}

}  // namespace
}  // namespace sh::codegen
