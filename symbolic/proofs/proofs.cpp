#include "symbolic/proofs/proofs.hpp"

#include <stdexcept>

#include "symbolic/basis/basis.hpp"
#include "symbolic/proofs/basis_proofs.hpp"
#include "symbolic/proofs/convention_proofs.hpp"
#include "symbolic/proofs/gaunt_proofs.hpp"
#include "symbolic/proofs/proof_range.hpp"
#include "symbolic/proofs/rotation_proofs.hpp"
#include "symbolic/proofs/zonal_proofs.hpp"

namespace sh::symbolic {

std::vector<Proof> all_proofs() {
  std::vector<Proof> all;
  for (const auto& area : {basis_proofs(), rotation_proofs(), convention_proofs(), zonal_proofs(), gaunt_proofs()}) {
    for (const Proof& proof : area) all.push_back(with_range_check(proof));
  }
  return all;
}

void require_proof_degree(int degree) {
  if (degree < 0 || degree > kMaxBasisDegree) {
    throw std::invalid_argument("prove: degree " + std::to_string(degree) + "; it should be 0 to " +
                                std::to_string(kMaxBasisDegree) +
                                " (the basis is derived to there: exponents of a product stay below 128)");
  }
}

}  // namespace sh::symbolic
