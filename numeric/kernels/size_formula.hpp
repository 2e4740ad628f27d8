// The size that the error of an output is compared with, as the record of the families writes it: a sum of products.
//
//   "|weight| Y(l) + |sum[i]|"
//
// A formula belongs to one result. l: the band of an output, L: the kernel's degree, i: the place of an output in its
// result, k: its channel. Factors, separated by blanks:
//   0.5          a number
//   l            the band
//   |X|          the length of the input X, of a scalar its magnitude; |X|^l and |X|^(l-1): powers of it
//   |X[i]| |X[l]| |X[k]|   the magnitude of one element; of channel k the length
//   Y(l) Y(L)    sqrt((2l+1) / 4 pi), the largest value of a band; Y(0..L): the root of the sum of their squares
//   A(l)         the magnitude of the clamped cosine's factor
//   cap(l)       the largest coefficient of band l that a cap of this area has, at l = 0 the coefficient itself
//   gain         the most that an output gets from inputs of length 1, for linear kernels
// X is a parameter by name, or all parameters of a role.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "numeric/kernels/signature.hpp"

namespace sh::numeric {

class SizeFormula {
 public:
  /// One text a result, the last one for all further results; gain(output): empty where no formula asks for it. Throws
  /// std::invalid_argument, one line, for a text that is no formula or names no input.
  SizeFormula(const std::vector<std::string>& texts, const Signature& signature, int degree,
              std::function<double(std::size_t output)> gain = {});

  /// At the flat inputs, for an output by its place among the flat outputs.
  double operator()(const double* in, std::size_t output) const;

 private:
  struct Output;
  using Factor = std::function<double(const double* in, const Output& output)>;
  using Sum = std::vector<std::vector<Factor>>;
  struct Result {
    std::size_t end = 0;  // of its outputs among the flat ones
    std::size_t values = 1, channels = 1;
    bool zonal = false;
    Sum sum;
  };

  static Factor factor(const std::string& text, const Signature& signature, int degree,
                       const std::function<double(std::size_t)>& gain);
  static Sum parsed(const std::string& text, const Signature& signature, int degree,
                    const std::function<double(std::size_t)>& gain);

  std::vector<Result> results_;
};

/// The places of a parameter, or of all parameters of a role, among the flat inputs: first and count. They follow each
/// other. Count 0: there is none.
struct InputPlaces {
  std::size_t first = 0, count = 0;
};
InputPlaces places_of(const Signature& signature, const std::string& name_or_role);

}  // namespace sh::numeric
