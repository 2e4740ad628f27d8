// The 3j symbols by what defines them, their signs included.
#include <cln/integer.h>

#include <cstdlib>
#include <map>

#include "symbolic/number/derivation.hpp"
#include "symbolic/number/radical_sum.hpp"
#include "symbolic/proofs/identities.hpp"

namespace sh::symbolic {
namespace {

struct Degrees {
  int a = 0;
  int b = 0;
  int c = 0;

  [[nodiscard]] std::string to_string() const {
    return "(" + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + ")";
  }
  [[nodiscard]] bool is_triangle() const { return std::abs(a - b) <= c && c <= a + b; }
};

// <l, m-1| J- |l, m> = sqrt((l+m)(l-m+1))
const Surd& lowering(int l, int m) {
  static std::map<int, Surd> known;
  const int square = (l + m) * (l - m + 1);
  return remembered(known, square, [square] { return Surd::square_root(cln::cl_RA(square)); });
}

// The symbols of three degrees, by m_a and m_b; m_c = -m_a - m_b.
class Symbols {
 public:
  Symbols(const Wigner3j& symbol, const Degrees& l) : l_(l), values_(2 * l.a + 1, 2 * l.b + 1) {
    for (int a = -l.a; a <= l.a; ++a) {
      for (int b = -l.b; b <= l.b; ++b) values_(l.a + a, l.b + b) = symbol(l.a, l.b, l.c, a, b, -a - b);
    }
  }
  // Zero outside.
  [[nodiscard]] Surd operator()(int a, int b) const {
    return std::abs(a) <= l_.a && std::abs(b) <= l_.b ? values_(l_.a + a, l_.b + b) : Surd();
  }

 private:
  Degrees l_;
  Matrix<Surd> values_;
};

// The component of J- (sum of symbols |a b c>) at (a, b, -1 - a - b).
bool is_lowered_to_zero(const Symbols& symbols, const Degrees& l, int a, int b) {
  const int c = -1 - a - b;
  RadicalSum sum;
  if (a < l.a) sum += RadicalSum(lowering(l.a, a + 1) * symbols(a + 1, b));
  if (b < l.b) sum += RadicalSum(lowering(l.b, b + 1) * symbols(a, b + 1));
  if (c < l.c) sum += RadicalSum(lowering(l.c, c + 1) * symbols(a, b));
  return sum.is_zero();
}

int prove_symbols(const Wigner3j& symbol, const Degrees& l) {
  const Symbols symbols(symbol, l);
  cln::cl_RA squares = 0;
  for (int a = -l.a; a <= l.a; ++a) {
    for (int b = -l.b; b <= l.b; ++b) {
      const Surd square = symbols(a, b) * symbols(a, b);
      const bool may_differ = l.is_triangle() && std::abs(a + b) <= l.c;
      if (!square.is_rational() || (!may_differ && !square.is_zero())) {
        throw Refuted("the symbol " + l.to_string() + " cannot have this value");
      }
      squares = squares + square.rational();
      if (std::abs(1 + a + b) <= l.c && !is_lowered_to_zero(symbols, l, a, b)) {
        throw Refuted("the symbols " + l.to_string() + " do not couple to 0");
      }
    }
  }
  if (!l.is_triangle()) return 0;
  if (squares != 1) throw Refuted("the squares of the symbols " + l.to_string() + " do not add up to 1");
  const bool negative = (l.a - l.b + l.c) % 2 != 0;
  if (symbols(l.a, l.c - l.a).is_negative() != negative) throw Refuted("the sign of the symbols " + l.to_string());
  return (2 * l.a + 1) * (2 * l.b + 1);
}

}  // namespace

int prove_wigner_3j(const Wigner3j& symbol, int degree) {
  int count = 0;
  for (int a = 0; a <= degree; ++a) {
    for (int b = 0; b <= degree; ++b) {
      for (int c = 0; c <= degree; ++c) count += prove_symbols(symbol, {a, b, c});
    }
  }
  return count;
}

}  // namespace sh::symbolic
