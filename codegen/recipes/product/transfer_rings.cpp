#include "codegen/recipes/product/transfer_rings.hpp"

namespace sh::codegen::recipes {
namespace {

ExactReal product(const ExactReal& a, const ExactReal& b) {
  return is_zero(a) || is_zero(b) ? ExactReal(symbolic::Surd()) : multiply(a, b);
}

}  // namespace

// m phi_j = 2 pi m (2j + 1) / 8n
ExactReal TransferRings::phase(bool is_sine, int m, int j) const {
  return is_sine ? sine(m * (2 * j + 1), 8 * n_) : cosine(m * (2 * j + 1), 8 * n_);
}

ExactReal TransferRings::theta(bool is_sine, int l, int m, int pair) const {
  return product(rings_.theta(l, m, pair), phase(is_sine, m, 0));
}

ExactReal TransferRings::result(bool is_sine, int l, int m, int pair) const {
  return product(multiply(rings_.weight(pair), pi_times(2, 4 * n_)), theta(is_sine, l, m, pair));
}

ExactReal TransferRings::pole_result(int l) const {
  return multiply(multiply(rings_.weight(n_), pi_times(2, 1)), pole(l));
}

ExactReal TransferRings::ratio(bool is_sine, int m, int j) const {
  const ExactReal first = phase(is_sine, m, 0);
  return is_zero(first) ? first : product(phase(is_sine, m, j), reciprocal(first));
}

}  // namespace sh::codegen::recipes
