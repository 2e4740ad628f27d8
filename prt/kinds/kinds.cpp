#include "prt/kinds/kinds.hpp"

#include <algorithm>
#include <array>

namespace sh::prt {

namespace {

// Those of `prt bake`, then the others of vertices, then those of volumes, then those of media.
constexpr std::array<const TransferKind*, 11> kKinds = {
    &kUnshadowed,  &kShadowed,  &kInterreflected, &kGlossyUnshadowed,       &kGlossyShadowed, &kGlossyInterreflected,
    &kTranslucent, &kThickness, &kNeighborhood,   &kReflectingNeighborhood, &kMedium};
constexpr std::size_t kBaked = 6;
constexpr std::size_t kOfVertices = 8;

}  // namespace

TransferKinds transfer_kinds() { return TransferKinds(kKinds).first(kBaked); }

TransferKinds surface_kinds() { return TransferKinds(kKinds).first(kBaked + 1); }

TransferKinds vertex_kinds() { return TransferKinds(kKinds).first(kOfVertices); }

TransferKinds volume_kinds() { return TransferKinds(kKinds).subspan(kOfVertices, 2); }

TransferKinds medium_kinds() { return TransferKinds(kKinds).last(1); }

TransferKinds file_kinds() { return kKinds; }

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
