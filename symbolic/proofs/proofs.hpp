// The catalogue of proofs: the identities, the method that decides each of them, and its largest degree.
//
// An identity compares a left side with a right side for every index of a range. identities.hpp declares a function for
// each identity. The function takes the objects that it proves, so a test can give it a spoiled copy. The catalogue
// derives the objects and calls these functions.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace sh::symbolic {

/// The two sides of an identity differ. The message names the first place.
struct Refuted : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// An entry of the catalogue.
struct Proof {
  std::string name;         ///< short and unique: "orthonormality"
  std::string statement;    ///< the identity, one line of plain text
  std::string method;       ///< the way to decide it: "exact integration of every pair"
  int default_degree = 10;  ///< the degree of a run without options
  int max_degree = 20;      ///< the largest degree that the method supports
  std::string limit;        ///< the reason for max_degree, one line
  std::string compared;     ///< the things that `run` counts: "pairs"
  /// Derives the objects to a degree, compares both sides and returns the number of comparisons. Throws Refuted.
  std::function<int(int degree)> run;
  bool every_degree = false;  ///< true: the identity does not depend on the degree
};

/// The outcome of a proof.
struct ProofResult {
  bool proved = false;
  std::string detail;  ///< the comparisons ("231 pairs"), or the first place where the sides differ
};

/// Every proof, in reading order: basis, rotations, conventions, zonal functions, Gaunt tensors. Their `run` throws
/// std::invalid_argument, one line with the limit and the reason, for a degree outside 0 .. max_degree.
std::vector<Proof> all_proofs();

/// Runs a proof. Every exception refutes it, and its message becomes the detail, so that the other proofs still run.
ProofResult run_proof(const Proof& proof, int degree);

}  // namespace sh::symbolic
