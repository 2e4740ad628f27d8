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
std::vector<std::vector<cln::cl_R>> matrix_of(const std::vector<recipes::TurnRound>& rounds) {
  std::vector<std::vector<cln::cl_R>> matrix(recipes::kLanes, std::vector<cln::cl_R>(recipes::kLanes, 0));
  for (const recipes::TurnRound& round : rounds) {
    for (std::size_t lane = 0; lane < matrix.size(); ++lane) {
      cln::cl_R& entry = matrix[lane][round.column[lane]];
      entry = entry + number(round.entry[lane]);
    }
  }
  return matrix;
}

TEST(LaneTables, QuarterTurnsBackAndForthAreTheIdentity) {
  for (const auto& [first, last] : {std::pair(0, 3), std::pair(4, 4), std::pair(5, 5), std::pair(6, 6)}) {
    const recipes::LaneTurns turns = recipes::lane_turns(first, last);
    const auto there = matrix_of(turns.quarter);
    const auto back = matrix_of(turns.back);
    for (std::size_t i = 0; i < there.size(); ++i) {
      for (std::size_t j = 0; j < there.size(); ++j) {
        cln::cl_R sum = i == j && static_cast<int>(i) < turns.lanes() ? -1 : 0;
        for (std::size_t k = 0; k < there.size(); ++k) sum = sum + back[i][k] * there[k][j];
        EXPECT_TRUE(is_small(sum)) << first << ": " << i << " " << j;
      }
    }
  }
}

}  // namespace
}  // namespace sh::codegen
