// The words for kinds of transfer and for samplers: those for kinds are short in a transfer file's header, long in
// scenes and on command lines.
#pragma once
#include <array>
#include <optional>
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

/// In the order of Sampler.
inline constexpr std::array<std::string_view, 5> kSamplerNames = {"fibonacci", "stratified", "sobol", "random",
                                                                  "cosine"};

constexpr std::string_view name_of(Sampler sampler) { return kSamplerNames[static_cast<std::size_t>(sampler)]; }

/// The sampler with that name, if there is one.
constexpr std::optional<Sampler> sampler_called(std::string_view name) {
  for (std::size_t i = 0; i < kSamplerNames.size(); ++i) {
    if (kSamplerNames[i] == name) {
      return static_cast<Sampler>(i);
    }
  }
  return std::nullopt;
}

}  // namespace sh::prt
