// Spoiled copies of what a proof compares: each of them has to refute the proof.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <vector>

#include "symbolic/proofs/identities.hpp"

namespace sh::symbolic::test {

inline cln::cl_RA millionth() { return cln::cl_RA(1) / 1'000'000; }

// One part in a million more. A polynomial: in its last term.
inline void nudge(cln::cl_RA& number) { number = number * (1 + millionth()); }
inline void nudge(Surd& number) { number = Surd(1 + millionth()) * number; }
inline void nudge(RadicalSum& number) { number = RadicalSum(1 + millionth()) * number; }
inline void nudge(Polynomial& p) {
  const auto [monomial, coefficient] = *p.terms().rbegin();
  p.add_term(monomial, coefficient * millionth());
}

template <class Number>
void negate(Number& number) {
  number = -number;
}
inline void negate(Polynomial& p) { p = cln::cl_RA(-1) * p; }

template <class Object>
using Change = std::function<void(Object& object)>;

/// The proof holds for `good`, and each change refutes it.
template <class Object, class Prove>
void expect_refuted(const Object& good, const Prove& prove, const std::vector<Change<Object>>& changes) {
  EXPECT_NO_THROW(prove(good));
  for (std::size_t i = 0; i < changes.size(); ++i) {
    Object spoiled = good;
    changes[i](spoiled);
    EXPECT_THROW(prove(spoiled), Refuted) << "change " << i;
  }
}

}  // namespace sh::symbolic::test
