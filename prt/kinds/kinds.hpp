// The kinds of transfer. A new kind needs a file like diffuse.cpp in this folder, a line here and a line in the list of
// kinds.cpp.
#pragma once
#include <span>
#include <string_view>
#include <vector>

#include "prt/transfer/kind.hpp"

namespace sh::prt {

/// Diffuse surfaces [SloanKautzSnyder02]. Unshadowed (DU): every vertex sees its whole hemisphere. Shadowed (DS): rays
/// find the visible part. Interreflected (DI): light also bounces between the surfaces, any number of times.
extern const TransferKind kUnshadowed;
extern const TransferKind kShadowed;
extern const TransferKind kInterreflected;

using TransferKinds = std::span<const TransferKind* const>;

TransferKinds transfer_kinds();

/// The kind in `kinds` with these letters or this word; null if there is none.
const TransferKind* kind_with_letters(std::string_view letters, TransferKinds kinds = transfer_kinds());
const TransferKind* kind_called(std::string_view word, TransferKinds kinds = transfer_kinds());

/// The letters or the words of all kinds, in order, for command lines and messages.
std::vector<std::string_view> kind_letters(TransferKinds kinds = transfer_kinds());
std::vector<std::string_view> kind_words(TransferKinds kinds = transfer_kinds());

}  // namespace sh::prt
