// The generated kernels of an emitted run time.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace sh::prt {

/// A kernel with its mask: the text of its file in a language, the name of its function, and its operations.
struct EmittedKernel {
  std::string function;
  std::string text;
  int operations = 0;
  int unmasked = 0;  // of the same function for all coefficients
};

/// Entries by l(l+1)+m that are not zero, of both factors of a kernel; empty: all.
struct Nonzero {
  std::vector<std::uint32_t> left;
  std::vector<std::uint32_t> right;
};

/// The kernel of `family` at `degree`, in the language of `shgen emit --lang`.
EmittedKernel emitted_kernel(const std::string& family, int degree, const std::string& language,
                             const Nonzero& nonzero = {});

/// The product of a function of twice the degree and one of the degree, on the bands of the second.
EmittedKernel emitted_product(int degree, const std::string& language, const Nonzero& nonzero);

/// The rotation of a function that is even in y.
EmittedKernel emitted_rotation(int degree, const std::string& language);

}  // namespace sh::prt
