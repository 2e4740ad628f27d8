// One fuzzer: SHFORGE_FUZZ_RUN is its entry function, SHFORGE_FUZZ_MEND what makes checksums good after each mutation.
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

#include "tests/fuzz/checkpoint_bytes.hpp"
#include "tests/fuzz/entry.hpp"
#include "tests/prt/transfer_bytes.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  sh::fuzz::SHFORGE_FUZZ_RUN({reinterpret_cast<const char*>(data), size});
  return 0;
}

#ifdef SHFORGE_FUZZ_MEND
namespace {

using namespace sh::fuzz;

std::string transfer_with_checksums(std::string bytes) { return sh::prt::test::with_checksums(std::move(bytes), true); }

}  // namespace

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

// One input in sixteen keeps its wrong checksums.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  const std::size_t changed = LLVMFuzzerMutate(data, size, most);
  if (seed % 16 == 0) return changed;
  const std::string mended = SHFORGE_FUZZ_MEND({reinterpret_cast<const char*>(data), changed});
  std::memcpy(data, mended.data(), mended.size());
  return mended.size();
}
#endif
