// The parts of the catalogue of proofs, one for each subject.
//
// Default degrees reach every degree that `shgen emit` offers: 20; rotations by a matrix or a quaternion 10, products 12.
#pragma once

#include <memory>
#include <vector>

#include "symbolic/proofs/formulas.hpp"
#include "symbolic/proofs/proofs.hpp"

namespace sh::symbolic {

using SharedFormulas = std::shared_ptr<const Formulas>;

std::vector<Proof> basis_catalogue(const SharedFormulas& f);
std::vector<Proof> rotation_catalogue(const SharedFormulas& f);
std::vector<Proof> convention_catalogue(const SharedFormulas& f);
std::vector<Proof> zonal_catalogue(const SharedFormulas& f);
std::vector<Proof> product_catalogue(const SharedFormulas& f);

/// The sum of prove(l) over the bands 0..degree.
template <class Prove>
int for_each_band(int degree, const Prove& prove) {
  int count = 0;
  for (int l = 0; l <= degree; ++l) count += prove(l);
  return count;
}

/// The values of `of` at the degrees 0..degree.
template <class Of>
auto values_to(int degree, const Of& of) {
  std::vector<decltype(of(0))> values;
  for (int l = 0; l <= degree; ++l) values.push_back(of(l));
  return values;
}

}  // namespace sh::symbolic
