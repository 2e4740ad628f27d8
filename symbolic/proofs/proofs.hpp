// A proof: one identity, the method that decides it, how far it reaches, and the function that runs it.
//
// Every area offers a function prove_...(object, ...) -> ProofResult that takes the object it proves, so that a test
// can hand it a spoiled copy and see it refuted, and a list xyz_proofs() of catalogue entries that derive the object
// and prove it up to a degree. all_proofs() joins the lists; `shgen prove` runs them.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace sh::symbolic {

/// The outcome of one proof.
struct ProofResult {
  bool proved = false;
  std::string detail;  ///< proved: what was checked ("231 pairs"); refuted: the first counterexample
};

inline ProofResult proved(std::string what) { return {true, std::move(what)}; }
inline ProofResult refuted(std::string counterexample) { return {false, std::move(counterexample)}; }

/// An entry of the catalogue.
struct Proof {
  std::string name;         ///< short and unique: "orthonormality"
  std::string statement;    ///< the identity, one line of plain text
  std::string method;       ///< how it is decided: "exact integration of every pair"
  int default_degree = 10;  ///< run by default to this degree
  int max_degree = 20;      ///< largest degree it supports
  std::string limit;        ///< why not further, one line
  /// Derives the object to a degree in 0 .. max_degree and proves it.
  std::function<ProofResult(int degree)> run;
  bool every_degree = false;  ///< the identity does not depend on the degree
};

/// Every proof of every area, in reading order: basis, rotations, conventions, zonal functions, Gaunt tensors. Their
/// `run` throws std::invalid_argument with one line, limit and reason, for a degree outside 0 .. max_degree.
std::vector<Proof> all_proofs();

/// Runs the proof; when it throws, it counts as refuted, with the error as the detail, so that the others still run.
ProofResult run_proof(const Proof& proof, int degree);

/// Throws std::invalid_argument, with the limit and the reason, unless 0 <= degree <= kMaxBasisDegree. Each proof goes
/// as far as its own max_degree.
void require_proof_degree(int degree);

}  // namespace sh::symbolic
