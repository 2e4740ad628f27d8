#include "prt/kinds/kinds.hpp"

#include <algorithm>
#include <array>

namespace sh::prt {

namespace {

constexpr std::array<const TransferKind*, 3> kKinds = {&kUnshadowed, &kShadowed, &kInterreflected};

using Name = std::string_view TransferKind::*;

const TransferKind* find(TransferKinds kinds, Name name, std::string_view value) {
  const auto found = std::find_if(kinds.begin(), kinds.end(), [&](const auto* kind) { return kind->*name == value; });
  return found == kinds.end() ? nullptr : *found;
}

std::vector<std::string_view> names(TransferKinds kinds, Name name) {
  std::vector<std::string_view> all;
  for (const TransferKind* kind : kinds) all.push_back(kind->*name);
  return all;
}

}  // namespace

TransferKinds transfer_kinds() { return kKinds; }

const TransferKind* kind_with_letters(std::string_view letters, TransferKinds kinds) {
  return find(kinds, &TransferKind::letters, letters);
}

const TransferKind* kind_called(std::string_view word, TransferKinds kinds) {
  return find(kinds, &TransferKind::word, word);
}

std::vector<std::string_view> kind_letters(TransferKinds kinds) { return names(kinds, &TransferKind::letters); }

std::vector<std::string_view> kind_words(TransferKinds kinds) { return names(kinds, &TransferKind::word); }

}  // namespace sh::prt
