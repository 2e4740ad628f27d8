#include "symbolic/proofs/proofs.hpp"

#include <exception>

#include "symbolic/basis/basis.hpp"
#include "symbolic/number/require_degree.hpp"
#include "symbolic/proofs/basis_proofs.hpp"
#include "symbolic/proofs/convention_proofs.hpp"
#include "symbolic/proofs/gaunt_proofs.hpp"
#include "symbolic/proofs/rotation_proofs.hpp"
#include "symbolic/proofs/zonal_proofs.hpp"

namespace sh::symbolic {
namespace {

// The same entry; its run refuses degrees outside its range.
Proof with_range_check(Proof proof) {
  proof.run = [name = proof.name, max = proof.max_degree, limit = proof.limit, run = proof.run](int degree) {
    require_degree("proof " + name, degree, max, limit);
    return run(degree);
  };
  return proof;
}

}  // namespace

std::vector<Proof> all_proofs() {
  std::vector<Proof> all;
  for (const auto& area : {basis_proofs(), rotation_proofs(), convention_proofs(), zonal_proofs(), gaunt_proofs()}) {
    for (const Proof& proof : area) all.push_back(with_range_check(proof));
  }
  return all;
}

ProofResult run_proof(const Proof& proof, int degree) {
  try {
    return proof.run(degree);
  } catch (const std::exception& error) {
    return refuted(std::string("stopped: ") + error.what());
  }
}

void require_proof_degree(int degree) {
  require_degree("prove", degree, kMaxBasisDegree,
                 "the basis is derived to there: exponents of a product stay below 128");
}

}  // namespace sh::symbolic
