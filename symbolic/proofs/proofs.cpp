#include "symbolic/proofs/proofs.hpp"

#include <utility>

#include "symbolic/number/derivation.hpp"
#include "symbolic/proofs/catalogue.hpp"

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

std::vector<Proof> all_proofs() { return all_proofs(std::make_shared<const Formulas>()); }

std::vector<Proof> all_proofs(const std::shared_ptr<const Formulas>& formulas) {
  std::vector<Proof> all;
  for (const auto& area : {basis_catalogue(formulas), rotation_catalogue(formulas), convention_catalogue(formulas),
                           zonal_catalogue(formulas), product_catalogue(formulas)}) {
    for (const Proof& proof : area) all.push_back(with_range_check(proof));
  }
  return all;
}

ProofResult run_proof(const Proof& proof, int degree) {
  try {
    return {Outcome::kHolds, std::to_string(proof.run(degree)) + " " + proof.compared};
  } catch (const Refuted& refuted) {
    return {Outcome::kRefuted, refuted.what()};
  } catch (const std::exception& error) {
    return {Outcome::kFailed, error.what()};
  } catch (...) {
    return {Outcome::kFailed, "an error without a message"};
  }
}

}  // namespace sh::symbolic
