#include "symbolic/proofs.hpp"

#include <algorithm>
#include <stdexcept>

#include "symbolic/basis.hpp"
#include "symbolic/basis_proofs.hpp"
#include "symbolic/convention_proofs.hpp"
#include "symbolic/gaunt_proofs.hpp"
#include "symbolic/rotation_proofs.hpp"
#include "symbolic/zonal_proofs.hpp"

namespace sh::symbolic {

std::vector<Proof> all_proofs() {
  std::vector<Proof> all;
  for (const auto& area : {basis_proofs(), rotation_proofs(), convention_proofs(), zonal_proofs(), gaunt_proofs()}) {
    all.insert(all.end(), area.begin(), area.end());
  }
  return all;
}

int max_proof_degree() { return kMaxBasisDegree; }

int proof_degree(const Proof& proof, int requested) {
  if (requested > max_proof_degree()) {
    throw std::invalid_argument("prove: degree " + std::to_string(requested) + "; it should be 0 to " +
                                std::to_string(max_proof_degree()) +
                                " (the basis is derived to there: exponents of a product stay below 128)");
  }
  return requested < 0 ? proof.default_degree : std::min(requested, proof.max_degree);
}

}  // namespace sh::symbolic
