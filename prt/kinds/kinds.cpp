#include "prt/kinds/kinds.hpp"

#include <algorithm>
#include <array>

namespace sh::prt {

TransferKinds transfer_kinds() {
  static constexpr std::array<const TransferKind*, 6> kKinds = {
      &kUnshadowed, &kShadowed, &kInterreflected, &kGlossyUnshadowed, &kGlossyShadowed, &kGlossyInterreflected};
  return kKinds;
}

const TransferKind* find_kind(KindName name, std::string_view value, TransferKinds kinds) {
  const auto found = std::find_if(kinds.begin(), kinds.end(), [&](const auto* kind) { return kind->*name == value; });
  return found == kinds.end() ? nullptr : *found;
}

std::vector<std::string_view> kind_names(KindName name, TransferKinds kinds) {
  std::vector<std::string_view> all;
  for (const TransferKind* kind : kinds) all.push_back(kind->*name);
  return all;
}

}  // namespace sh::prt
