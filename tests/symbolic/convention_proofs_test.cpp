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

Folded unity_folded() { return find_preset("unity").convention.folded; }

TEST(ConventionProofs, UnitarityCatchesAnEntryAndASign) {
  expect_refuted(real_from_complex(2, true), [](const RadicalMatrix& w) { prove_unitary(w, true); },
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

TEST(ConventionProofs, UnitarityIsNotEnoughWithoutTheFunctions) {
  expect_refuted(real_from_complex(3, true), [](const RadicalMatrix& w) { prove_unitary(w, true); },
                 {[](RadicalMatrix& w) { w = real_from_complex(3, false); },
                  [](RadicalMatrix& w) { w = w.mapped([](const RadicalSum& entry) { return entry.conjugate(); }); }});
}

// Complex functions in other axes: A is neither symmetric nor orthogonal, so every omission shows.
TEST(ConventionProofs, SameFunctionCatchesEveryOmissionInTheInverseTranspose) {
  for (const Normalization normalization : {Normalization::kOrthonormal, Normalization::kSn3d}) {
    Convention other{.normalization = normalization, .condon_shortley = true, .complex = true};
    other.axes = SignedPermutation("y,z,x");
    const auto transposed = [](ConventionMap& map) {
      for (auto* bands : {&map.forward, &map.backward}) {
        for (RadicalMatrix& band : *bands) band = band.transposed();
      }
    };
    const auto not_inverted = [](ConventionMap& map) { std::swap(map.forward, map.backward); };
    expect_refuted(convention_map({}, other, 2), [&](const ConventionMap& map) { prove_same_function(other, map); },
                   {transposed, not_inverted,
                    [&](ConventionMap& map) {
                      transposed(map);
                      not_inverted(map);
                    },
                    [](ConventionMap& map) { nudge(map.forward[2](2, 2)); },
                    [](ConventionMap& map) { map.to_order = IndexOrder::kZeroFirst; }});
  }
}

TEST(ConventionProofs, SameFunctionCatchesAFoldedCosineThatIsLeftOutOrAppliedTwice) {
  const Convention unity = find_preset("unity").convention;
  const auto times = [](int power) {
    return [power](ConventionMap& map) {
      for (int l = 0; l <= 2; ++l) {
        const RadicalSum fold(power > 0 ? folded_factor(unity_folded(), l)
                                        : folded_factor(unity_folded(), l).inverse());
        map.forward[l] = map.forward[l].mapped([&](const RadicalSum& entry) { return fold * entry; });
      }
    };
  };
  expect_refuted(convention_map({}, unity, 2), [&](const ConventionMap& map) { prove_same_function(unity, map); },
                 {times(1), times(-1)});
}

// Sizes that both the functions and the maps have wrong cancel; the integrals of the definition do not.
TEST(ConventionProofs, DefinitionsCatchASizeASignAndAPhase) {
  const auto spoiled = [](void (*spoil)(const Convention& c, int order, ConventionFunction& f)) {
    return [spoil](WrittenFunction& written) {
      written = [spoil](const Convention& c, int degree, int order) {
        ConventionFunction f = convention_function(c, degree, order);
        spoil(c, order, f);
        return f;
      };
    };
  };
  expect_refuted(WrittenFunction(convention_function),
                 [](const WrittenFunction& written) { prove_definitions(unturned_conventions(3), 3, written); },
                 {spoiled([](const Convention& c, int, ConventionFunction& f) {
                    if (c.normalization == Normalization::kSn3d) nudge(f.factor);
                  }),
                  spoiled([](const Convention& c, int, ConventionFunction& f) {
                    if (c.normalization == Normalization::kPrimitive) f.factor = Surd(2) * f.factor;
                  }),
                  spoiled([](const Convention& c, int order, ConventionFunction& f) {
                    if (c.condon_shortley && c.complex && order % 2 != 0) negate(f.factor);
                  }),
                  spoiled([](const Convention&, int, ConventionFunction& f) { f.im = cln::cl_RA(-1) * f.im; }),
                  spoiled([](const Convention&, int order, ConventionFunction& f) {
                    if (order == 2) nudge(f.re);
                  })});
}

TEST(ConventionProofs, IndexOrdersCatchExchangedSignsAndAMissingHole) {
  expect_refuted(
      Storage(), [](const Storage& storage) { prove_index_orders(3, storage); },
      {[](Storage& storage) {
         storage.position = [](IndexOrder order, int largest, int degree, int m) {
           return storage_position(order, largest, degree, order == IndexOrder::kZeroFirst ? -m : m);
         };
       },
       [](Storage& storage) { storage.size = [](IndexOrder, int largest) { return coefficient_count(largest); }; }});
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
