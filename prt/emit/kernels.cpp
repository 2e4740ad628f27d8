#include "prt/emit/kernels.hpp"

#include <fmt/format.h>

#include <map>
#include <tuple>

#include "codegen/bound/stated.hpp"
#include "codegen/choose/catalogue.hpp"
#include "codegen/choose/mask.hpp"

namespace sh::prt {

namespace {

using namespace codegen;

struct Derived {
  FinishedKernel kernel;
  int unmasked;
};

// Once for each kernel: the search for its largest error takes seconds.
const Derived& derived(const Family& family, int degree, const MaskOptions& mask) {
  static std::map<std::tuple<std::string, int, std::string>, Derived> known;
  const auto key = std::tuple(family.name, degree, mask.arguments());
  if (const auto found = known.find(key); found != known.end()) return found->second;
  FinishedKernel full = preferred_kernel(family, degree, Prefer::kSpeed);
  const int unmasked = full.cost.operations();
  FinishedKernel kernel = mask.empty() ? std::move(full) : masked_kernel(family, degree, Prefer::kSpeed, mask);
  bound::state_errors(kernel);
  return known.emplace(key, Derived{std::move(kernel), unmasked}).first->second;
}

EmittedKernel emitted(const Family& family, int degree, const std::string& language, const MaskOptions& mask) {
  const auto& [kernel, unmasked] = derived(family, degree, mask);
  return {kernel.kernel.name, find_language(language).print_kernel(kernel, find_scalar("float")),
          kernel.cost.operations(), unmasked};
}

MaskOptions mask_of(const Nonzero& nonzero) {
  MaskOptions mask;
  mask.left = fmt::format("{}", fmt::join(nonzero.left, ","));
  mask.right = fmt::format("{}", fmt::join(nonzero.right, ","));
  return mask;
}

}  // namespace

EmittedKernel emitted_kernel(const std::string& family, int degree, const std::string& language,
                             const Nonzero& nonzero) {
  return emitted(find_family(family), degree, language, mask_of(nonzero));
}

EmittedKernel emitted_product(int degree, const std::string& language, const Nonzero& nonzero) {
  return emitted(rectangular_product_family(2 * degree, degree, degree), degree, language, mask_of(nonzero));
}

EmittedKernel emitted_rotation(int degree, const std::string& language) {
  MaskOptions even;
  even.left = "mirror-y";
  return emitted(find_family("rotate"), degree, language, even);
}

}  // namespace sh::prt
