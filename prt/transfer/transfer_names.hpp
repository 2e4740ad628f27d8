// The words for kinds of transfer: short ones in a transfer file's header, long ones in scenes and on command lines.
#pragma once
#include <array>
#include <string_view>

#include "prt/transfer/transfer.hpp"

namespace sh::prt {

struct TransferName {
  TransferKind kind;
  std::string_view file;  // as Sloan, Kautz and Snyder 2002 write
  std::string_view scene;
};
inline constexpr std::array<TransferName, 3> kTransferNames = {
    {{TransferKind::kUnshadowed, "DU", "unshadowed"},
     {TransferKind::kShadowed, "DS", "shadowed"},
     {TransferKind::kInterreflected, "DI", "interreflected"}}};

constexpr const TransferName& name_of(TransferKind kind) { return kTransferNames[static_cast<std::size_t>(kind)]; }

/// The kind with the word `scene`, which must be one of the table's.
constexpr TransferKind kind_called(std::string_view scene) {
  for (const TransferName& name : kTransferNames) {
    if (name.scene == scene) {
      return name.kind;
    }
  }
  return TransferKind::kShadowed;
}

}  // namespace sh::prt
