// Emitted kernels of a convention, printed in a language and run from their text.
#pragma once

#include <functional>
#include <string>

#include "codegen/choose/catalogue.hpp"
#include "codegen/convention/in_convention.hpp"
#include "tests/codegen/convention_meaning.hpp"

namespace sh::codegen::test {

/// A language and a scalar type that it has.
struct Target {
  std::string language;
  print::Scalar scalar;
};

/// Every language with each of its scalars.
std::vector<Target> targets();
std::string name_of(const Target& target);

/// A fault to put into the emitted code, on the way.
struct Mutation {
  std::function<ConventionOptions(ConventionOptions options)> options = {};
  std::function<Kernel(Kernel kernel)> kernel = {};
  std::function<std::string(std::string text)> text = {};
};

/// Emits kernels as `shgen emit FAMILY --degree N --convention C --axes A` does, and runs the printed text.
Call emitted_call(const World& world, const Target& target, const Mutation& mutation = {});

/// The kernel of `shgen emit`; kept, so that every language prints the same one.
const FinishedKernel& emitted_kernel(const std::string& family, int degree, const ConventionOptions& options);

/// The largest deviation that rounding explains.
double tolerance(print::Scalar scalar);

}  // namespace sh::codegen::test
