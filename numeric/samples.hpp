// The exact values that kernels of one family and degree are measured against, at every input of the family's check.
//
// Two errors are told apart (README.md): total, against the true function at the point x' of the domain that the
// rounded input x stands for; and rounding, against the kernel's own formula in exact arithmetic at x itself. The own
// formula comes from running the kernel on Wide: it is f(x') + K(x) - K(x'), f the oracle, K the kernel on Wide. The
// difference cancels what K does not have exactly, its rounded constants, and leaves what the formula makes of an input
// slightly outside its domain. A kernel with a wrong formula fails both: K(x') is no part of the result but as a
// difference. Where every input is in the domain, x = x', the two errors are one.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "numeric/bind.hpp"
#include "numeric/checks/family_check.hpp"
#include "numeric/wide.hpp"

namespace sh::numeric {

// T: float or double.
template <class T>
struct Samples {
  Signature signature;
  std::vector<std::string> names;  // (n)
  std::vector<T> inputs;           // (n, input_count), rounded
  std::vector<Wide> in_domain;     // (n, input_count), x'; empty where x' = x
  std::vector<Wide> exact;         // (n, output_count), f(x')
  std::vector<double> sizes;       // (n, output_count), what errors are compared with

  [[nodiscard]] std::size_t count() const { return names.size(); }
  [[nodiscard]] const T* input(std::size_t i) const {
    return inputs.data() + i * static_cast<std::size_t>(signature.input_count());
  }
};

template <class T>
Samples<T> make_samples(const FamilyCheck& check, int degree);

// (n, output_count): the own formula of a kernel at every input.
template <class T>
std::vector<Wide> own_formula(const BoundKernel& kernel, const Samples<T>& samples);

}  // namespace sh::numeric
