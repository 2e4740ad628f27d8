// See flat_call.hpp.
#include "numeric/kernels/flat_call.hpp"

#include <stdexcept>

namespace sh::numeric {
namespace {

ArgumentKind kind_of(const Parameter& parameter) {
  if (parameter.count == 0) return ArgumentKind::kValue;
  return parameter.access == Access::kIn ? ArgumentKind::kReadArray : ArgumentKind::kWriteArray;
}

}  // namespace

void require_match(const BoundKernel& kernel, const Signature& signature) {
  bool same = kernel.returns_value == signature.returns_value && kernel.arguments.size() == signature.parameters.size();
  for (std::size_t i = 0; same && i < kernel.arguments.size(); ++i) {
    same = kernel.arguments[i] == kind_of(signature.parameters[i]);
  }
  if (!same) throw std::logic_error(kernel.name() + ": the C++ arguments are not those that its check describes");
}

std::vector<InPlacePair> in_place_pairs(const Signature& signature) {
  std::vector<InPlacePair> pairs;
  const auto& all = signature.parameters;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t k = 0; k < all.size(); ++k) {
      const bool in_and_out = all[i].access == Access::kIn && all[k].access == Access::kOut;
      const bool same_shape = all[i].count == all[k].count && all[i].rows == all[k].rows;
      if (in_and_out && same_shape && all[i].count > 0) pairs.push_back({i, k});
    }
  }
  return pairs;
}

}  // namespace sh::numeric
