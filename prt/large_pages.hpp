// Arrays on large pages of memory, where the system has them: what streams through them misses fewer addresses.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace sh::prt {

/// Asks for large pages in memory that has not been written yet. Does nothing for less than a few pages.
inline void ask_for_large_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  constexpr std::uintptr_t kPage = std::uintptr_t{2} << 20U;
  const auto address = reinterpret_cast<std::uintptr_t>(memory);
  const auto begin = (address + kPage - 1) / kPage * kPage;
  const auto end = (address + bytes) / kPage * kPage;
  if (begin >= end) return;
  madvise(static_cast<char*>(memory) + (begin - address), end - begin, MADV_HUGEPAGE);  // advice: may fail
#endif
}

/// Items with their default values in place of those of before.
template <class T>
void renew_on_large_pages(std::vector<T>& items, std::size_t count) {
  std::vector<T>().swap(items);
  items.reserve(count);
  ask_for_large_pages(items.data(), count * sizeof(T));
  items.resize(count);
}

}  // namespace sh::prt
