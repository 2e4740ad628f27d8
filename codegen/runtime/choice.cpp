// Checks the arguments of the drivers and chooses the instruction set.
//
// Copied by:    shgen write, from codegen/runtime to generated/batch
// Licence:      MIT-0; paste it anywhere.
#include "choice.hpp"

#include <stdexcept>
#include <string>

#if defined(__unix__) || defined(__APPLE__)
#include <unistd.h>
#endif

namespace sh::batch {
namespace {

// Larger outputs do not stay in the last cache: three quarters of it, and of 32 MB where the system reports more, which
// may be the sum over the caches of a socket.
std::size_t largest_cached() {
  constexpr std::size_t kMost = std::size_t{24} << 20;
#if defined(_SC_LEVEL3_CACHE_SIZE)
  const long size = sysconf(_SC_LEVEL3_CACHE_SIZE);
  if (size > 0 && static_cast<std::size_t>(size) / 4 * 3 < kMost) return static_cast<std::size_t>(size) / 4 * 3;
#endif
  return kMost;
}

InstructionSet widest() noexcept {
  for (const InstructionSet set : {InstructionSet::kAvx512, InstructionSet::kAvx2}) {
    if (available(set)) return set;
  }
  return InstructionSet::kBaseline;
}

[[noreturn]] void refuse(const char* function, const std::string& why) {
  throw std::invalid_argument(std::string("sh::batch::") + function + ": " + why);
}

}  // namespace

namespace detail {

std::atomic<int> in_use{kNotChosen};

// Sunny Cove, and what is built alike.
#if defined(SH_BATCH_X86)
bool loads_delay_stores = [] {
  __builtin_cpu_init();
  return __builtin_cpu_is("icelake-client") || __builtin_cpu_is("icelake-server") || __builtin_cpu_is("tigerlake");
}();
#else
bool loads_delay_stores = false;
#endif

int chosen() noexcept {
  int place = in_use;
  if (place == kNotChosen) {
    const int best = static_cast<int>(widest());
    if (in_use.compare_exchange_strong(place, best)) place = best;  // unless another thread was first
  }
  return place;
}

void check_degree(const char* function, int degree, int largest) {
  if (degree >= 0 && degree <= largest) return;
  refuse(function, "expected a degree of 0 to " + std::to_string(largest) + ", got " + std::to_string(degree));
}

// The channels that a kernel computes one after the other.
template <class T>
std::size_t channels_of(const char* driver, const Call<T>& call, int inputs, Colors colors) {
  unsigned interleaved = call.out.layout == Layout::kInterleaved ? kOutput : 0;
  for (int j = 0; j < inputs; ++j) {
    if (call.in[j].layout == Layout::kInterleaved) interleaved |= 1U << static_cast<unsigned>(j);
  }
  if ((interleaved & ~colors.arrays) != 0) {
    refuse(driver, std::string("expected interleaved arrays only for ") +
                       (colors.arrays == 0  ? "coefficients of three channels, of which there are none"
                        : colors.in_records ? "coefficients of three channels"
                                            : "coefficients"));
  }
  if (interleaved == 0 || colors.in_records) return 1;
  if ((interleaved & kOutput) == 0 || interleaved == kOutput) {
    refuse(driver, "expected an interleaved output with interleaved inputs, got one of them");
  }
  return 3;
}

template <class T>
void check(const char* driver, Call<T>& call, int inputs, int largest_degree, OutputSize size, Colors colors) {
  check_degree(driver, call.degree, largest_degree);
  if (call.out.layout == Layout::kShared) refuse(driver, "expected a plain or blocked output, got a shared one");
  call.channels = channels_of(driver, call, inputs, colors);
  if (call.n == 0) return;
  bool missing = call.out.data == nullptr;
  for (int j = 0; j < inputs; ++j) missing = missing || (call.in[j].data == nullptr && (j > 0 || call.half == nullptr));
  if (missing) refuse(driver, "expected arrays of " + std::to_string(call.n) + " records, got a null pointer");
  static const auto kLargestCached = static_cast<double>(largest_cached());
  const auto bands = static_cast<std::size_t>(call.degree) + 1;
  const std::size_t record = (size.sets * bands * bands + size.more) * call.channels * sizeof(T);
  call.stream = static_cast<double>(call.n) * static_cast<double>(record) > kLargestCached;
}
template void check(const char*, Call<float>&, int, int, OutputSize, Colors);
template void check(const char*, Call<double>&, int, int, OutputSize, Colors);

}  // namespace detail

bool available(InstructionSet set) noexcept {
#if defined(SH_BATCH_X86)
  if (set == InstructionSet::kAvx2) {
#if defined(__clang__)  // clang 14 does not know the word f16c; every processor with AVX2 and FMA has F16C
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#else
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("f16c");
#endif
  }
  if (set == InstructionSet::kAvx512) {
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
           __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("fma");
  }
#endif
  return set == InstructionSet::kBaseline;
}

InstructionSet instruction_set() noexcept { return static_cast<InstructionSet>(detail::chosen()); }

void use_instruction_set(InstructionSet set) {
  if (!available(set))
    refuse("use_instruction_set", "expected a set with available(set), got one that is not available");
  detail::in_use = static_cast<int>(set);
}

}  // namespace sh::batch
