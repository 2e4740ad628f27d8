#include <algorithm>
#include <stdexcept>

#include "symbolic/convention/convention.hpp"
#include "symbolic/rotation/rotation_recursion.hpp"

namespace sh::symbolic {
namespace {

std::vector<std::string> split_at_commas(std::string_view text) {
  std::vector<std::string> words(1);
  for (const char c : text) {
    if (c == ',') {
      words.emplace_back();
    } else if (c != ' ' && c != '+') {
      words.back() += c;
    }
  }
  return words;
}

}  // namespace

SignedPermutation::SignedPermutation(std::string_view text) {
  const std::vector<std::string> words = split_at_commas(text);
  std::array<bool, 3> seen{};
  bool valid = words.size() == 3;
  for (std::size_t row = 0; valid && row < 3; ++row) {
    const std::string& word = words[row];
    const bool negative = word.size() == 2 && word[0] == '-';
    const char letter = word.empty() ? '?' : word.back();
    valid = (word.size() == 1 || negative) && letter >= 'x' && letter <= 'z';
    if (!valid) break;
    axes_[row] = letter - 'x';
    signs_[row] = negative ? -1 : 1;
    seen[axes_[row]] = true;
  }
  if (!valid || !std::all_of(seen.begin(), seen.end(), [](bool s) { return s; })) {
    throw std::invalid_argument("axes '" + std::string(text) +
                                "'; they should name x, y, z once each, with signs, such as x,z,-y");
  }
}

int SignedPermutation::determinant() const {
  const int inversions = (axes_[0] > axes_[1]) + (axes_[0] > axes_[2]) + (axes_[1] > axes_[2]);
  return (inversions % 2 == 0 ? 1 : -1) * signs_[0] * signs_[1] * signs_[2];
}

Matrix<cln::cl_RA> SignedPermutation::matrix() const {
  Matrix<cln::cl_RA> p(3, 3);
  for (int row = 0; row < 3; ++row) p(row, axis(row)) = sign(row);
  return p;
}

SignedPermutation SignedPermutation::inverse() const {
  SignedPermutation result;
  for (int row = 0; row < 3; ++row) {
    const auto to = static_cast<std::size_t>(axis(row));
    result.axes_[to] = row;
    result.signs_[to] = sign(row);
  }
  return result;
}

std::string SignedPermutation::to_string() const {
  std::string text;
  for (int row = 0; row < 3; ++row) {
    if (row > 0) text += ',';
    if (sign(row) < 0) text += '-';
    text += static_cast<char>('x' + axis(row));
  }
  return text;
}

SignedPermutation operator*(const SignedPermutation& a, const SignedPermutation& b) {
  SignedPermutation result;
  for (std::size_t row = 0; row < 3; ++row) {
    const auto middle = static_cast<std::size_t>(a.axes_[row]);
    result.axes_[row] = b.axes_[middle];
    result.signs_[row] = a.signs_[row] * b.signs_[middle];
  }
  return result;
}

std::vector<SignedPermutation> all_signed_permutations() {
  std::vector<SignedPermutation> all;
  std::string letters = "xyz";
  do {
    for (unsigned signs = 0; signs < 8; ++signs) {
      std::string text;
      for (unsigned row = 0; row < 3; ++row) {
        text += row > 0 ? "," : "";
        text += ((signs >> row) & 1U) != 0 ? "-" : "";
        text += letters[row];
      }
      all.emplace_back(text);
    }
  } while (std::next_permutation(letters.begin(), letters.end()));
  return all;
}

Matrix<cln::cl_RA> axes_band(const SignedPermutation& axes, int degree) {
  if (axes == SignedPermutation()) return Matrix<cln::cl_RA>::identity(2 * degree + 1, 1);
  const int determinant = axes.determinant();
  const auto times = [](const Matrix<cln::cl_RA>& m, int sign) {
    return m.mapped([sign](const cln::cl_RA& entry) -> cln::cl_RA { return sign * entry; });
  };
  const auto bands = rotation_bands<cln::cl_RA>(degree, times(axes.matrix(), determinant), 1);
  return times(bands.back(), degree % 2 == 0 ? 1 : determinant);
}

}  // namespace sh::symbolic
