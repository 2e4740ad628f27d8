// The kinds of transfer that there are. A new kind is a file of this folder like diffuse.cpp, a line here and one in
// the list of kinds.cpp.
#pragma once
#include <span>
#include <string_view>
#include <vector>

#include "prt/transfer/kind.hpp"

namespace sh::prt {

/// Diffuse surfaces [SloanKautzSnyder02]. Unshadowed (DU): every vertex sees its whole hemisphere. Shadowed (DS): rays
/// decide. Interreflected (DI): what they hit reflects, any number of times.
extern const TransferKind kUnshadowed;
extern const TransferKind kShadowed;
extern const TransferKind kInterreflected;

using TransferKinds = std::span<const TransferKind* const>;

TransferKinds transfer_kinds();

/// The kind with those letters or that word among `kinds`; null where there is none.
const TransferKind* kind_with_letters(std::string_view letters, TransferKinds kinds = transfer_kinds());
const TransferKind* kind_called(std::string_view word, TransferKinds kinds = transfer_kinds());

/// For command lines and messages: the letters or the words of all kinds, in order.
std::vector<std::string_view> kind_letters(TransferKinds kinds = transfer_kinds());
std::vector<std::string_view> kind_words(TransferKinds kinds = transfer_kinds());

}  // namespace sh::prt
