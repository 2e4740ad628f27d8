// A small change refutes every proof about conventions.
#include <gtest/gtest.h>

#include "tests/symbolic/spoiled.hpp"

namespace sh::symbolic {
namespace {

using test::expect_refuted;
using test::millionth;
using test::negate;
using test::nudge;
using RadicalMatrix = Matrix<RadicalSum>;

TEST(ConventionProofs, UnitarityCatchesAnEntryAndASign) {
  expect_refuted(real_from_complex(2, true), prove_unitary,
                 {[](RadicalMatrix& w) { nudge(w(1, 1)); }, [](RadicalMatrix& w) { negate(w(1, 1)); }});
}

TEST(ConventionProofs, ComplexRotationCatchesAMissingPhaseAndAConjugate) {
  using Bands = std::vector<RadicalMatrix>;
  expect_refuted(Bands{real_from_complex(0, true), real_from_complex(1, true), real_from_complex(2, true)},
                 prove_complex_rotation,
                 {[](Bands& w) { w[1] = real_from_complex(1, false); },
                  [](Bands& w) { w[2] = w[2].mapped([](const RadicalSum& entry) { return entry.conjugate(); }); }});
}

TEST(ConventionProofs, AxesCatchAnEntryASignOfReflectionsAndTheInverse) {
  expect_refuted(
      AxesBand(axes_band), [](const AxesBand& band) { return prove_axes(band, 2) + prove_axes(band, 1); },
      {[](AxesBand& band) {
         band = [](const SignedPermutation& axes, int degree) {
           auto off = axes_band(axes, degree);
           off(0, 1) = off(0, 1) + millionth();
           return off;
         };
       },
       [](AxesBand& band) {  // a reflection without its sign
         band = [](const SignedPermutation& axes, int degree) {
           const int sign = axes.determinant() < 0 && degree == 1 ? -1 : 1;
           return axes_band(axes, degree).mapped([=](const cln::cl_RA& entry) -> cln::cl_RA { return sign * entry; });
         };
       },
       [](AxesBand& band) {
         band = [](const SignedPermutation& axes, int degree) { return axes_band(axes.inverse(), degree); };
       }});
}

TEST(ConventionProofs, BasisChangeCatchesAnEntryAnotherConventionAndAWrongInverse) {
  struct BasisChange {
    Convention convention = find_preset("threejs").in_world();
    RadicalMatrix change = basis_change(convention, 2);
    RadicalMatrix inverse = basis_change_inverse(convention, 2);
  };
  expect_refuted(
      BasisChange(), [](const BasisChange& b) { prove_basis_change(b.convention, 2, b.change, b.inverse); },
      {[](BasisChange& b) { nudge(b.change(2, 2)); }, [](BasisChange& b) { b.convention.condon_shortley = true; },
       [](BasisChange& b) { b.inverse = b.change; }});
}

TEST(ConventionProofs, RoundTripCatchesAnEntryAnotherOrderAndAnotherConvention) {
  const Convention other = find_preset("ambix").convention;
  const ConventionMap there = convention_map({}, other, 2);
  expect_refuted(
      convention_map(other, {}, 2), [&](const ConventionMap& back) { prove_there_and_back(there, back); },
      {[](ConventionMap& back) { nudge(back.forward[2](1, 1)); },
       [](ConventionMap& back) { back.to_order = IndexOrder::kZeroFirst; },
       [&](ConventionMap& back) { back = convention_map(other, find_preset("directxmath").convention, 2); }});
}

TEST(ConventionProofs, CompositionCatchesAnEntryAndAnExchangedConvention) {
  struct Maps {
    Convention b = find_preset("scipy").convention;
    Convention c = find_preset("unreal").in_world();
    ConventionMap first = convention_map({}, b, 2);
    ConventionMap second = convention_map(b, c, 2);
    ConventionMap direct = convention_map({}, c, 2);
  };
  expect_refuted(Maps(), [](const Maps& maps) { prove_through(maps.first, maps.second, maps.direct); },
                 {[](Maps& maps) { maps.second = convention_map(maps.b, {}, 2); },
                  [](Maps& maps) { nudge(maps.direct.forward[1](0, 2)); }});
}

}  // namespace
}  // namespace sh::symbolic
