// The bytes of a checkpoint (prt/FILES.md states them): its start, and its checksums made good after a change.
#pragma once
#include <string>
#include <string_view>

namespace sh::fuzz {

/// The prologue and the key.
std::string checkpoint_front(std::string_view key);

/// Records, or a whole checkpoint, with all checksums right as far as they lie inside.
std::string checkpoint_with_checksums(std::string bytes);

/// A checkpoint of the bake that run_checkpoint() continues.
std::string checkpoint_with_front(std::string_view records);

}  // namespace sh::fuzz
