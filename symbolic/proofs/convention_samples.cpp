// The conventions that proofs go through.
#include "symbolic/convention/convention.hpp"
#include "symbolic/proofs/identities.hpp"

namespace sh::symbolic {

const std::vector<IndexOrder>& index_orders() {
  static const std::vector<IndexOrder> all{IndexOrder::kAcn, IndexOrder::kZeroFirst, IndexOrder::kCosineSineBands,
                                           IndexOrder::kCosineSineArray, IndexOrder::kFuMa};
  return all;
}

std::vector<Convention> unturned_conventions(int degree) {
  std::vector<Convention> all;
  for (const Preset& preset : presets()) {
    const bool turned = !(preset.convention.axes == SignedPermutation());
    if (!turned && degree <= largest_degree(preset.convention)) all.push_back(preset.convention);
  }
  for (const Normalization normalization :
       {Normalization::kOrthonormal, Normalization::kFourPi, Normalization::kSchmidt, Normalization::kSn3d,
        Normalization::kUnnormalized, Normalization::kPrimitive}) {
    for (int kind = 0; kind < 4; ++kind) {
      Convention c;
      c.normalization = normalization;
      c.condon_shortley = kind % 2 != 0;
      c.complex = kind >= 2;
      c.order = index_orders()[all.size() % index_orders().size()];
      const bool real_only =
          normalization == Normalization::kUnnormalized || normalization == Normalization::kPrimitive;
      if (!c.complex || !real_only) all.push_back(c);
    }
  }
  return all;
}

std::vector<Convention> sample_conventions(int degree) {
  std::vector<Convention> samples;
  for (const Preset& preset : presets()) {
    if (degree > largest_degree(preset.convention)) continue;
    samples.push_back(preset.convention);
    samples.push_back(preset.in_world());
  }
  for (const Normalization normalization :
       {Normalization::kOrthonormal, Normalization::kFourPi, Normalization::kSchmidt, Normalization::kSn3d,
        Normalization::kUnnormalized, Normalization::kPrimitive}) {
    Convention c;
    c.normalization = normalization;
    c.condon_shortley = normalization != Normalization::kSchmidt;
    c.complex = normalization == Normalization::kFourPi || normalization == Normalization::kSchmidt;
    c.order = c.complex ? IndexOrder::kZeroFirst : IndexOrder::kCosineSineBands;
    c.axes = SignedPermutation(c.complex ? "-z,x,y" : "y,-z,x");
    samples.push_back(c);
  }
  return samples;
}

}  // namespace sh::symbolic
