#include "prt/emit/kernels.hpp"

#include <fmt/format.h>

#include "codegen/bound/stated.hpp"
#include "codegen/choose/catalogue.hpp"
#include "codegen/choose/mask.hpp"

namespace sh::prt {

namespace {

using namespace codegen;

EmittedKernel printed(FinishedKernel kernel, int unmasked, const std::string& language) {
  bound::state_errors(kernel);
  return {kernel.kernel.name, find_language(language).print_kernel(kernel, find_scalar("float")),
          kernel.cost.operations(), unmasked};
}

EmittedKernel emitted(const Family& family, int degree, const std::string& language, const MaskOptions& mask) {
  FinishedKernel full = preferred_kernel(family, degree, Prefer::kSpeed);
  const int unmasked = full.cost.operations();
  if (mask.empty()) return printed(std::move(full), unmasked, language);
  return printed(masked_kernel(family, degree, Prefer::kSpeed, mask), unmasked, language);
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
