// The catalogue of proofs: the identities, the method that decides each of them, and its largest degree.
//
// An identity compares a left side with a right side for every index of a range. identities.hpp declares a function for
// each identity. The function takes the objects that it proves, so a test can give it a spoiled copy. The catalogue
// takes the objects from Formulas (formulas.hpp) and calls these functions.
//
// A proof decides its identity for every index of its range: in all variables, or for all members of a finite set. A
// spot check compares exact values at some rotations, vectors or samples only, and is counted apart.
#pragma once

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace sh::symbolic {

/// The two sides of an identity differ. The message names the first place.
struct Refuted : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The formulas and tables that the kernels come from (formulas.hpp).
struct Formulas;

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
  bool spot_check = false;    ///< true: holds at the compared points only, so it proves nothing
};

enum class Outcome {
  kHolds,
  kRefuted,  ///< the two sides differ
  kFailed,   ///< it could not be decided: an error ended the run
};

struct ProofResult {
  Outcome outcome = Outcome::kFailed;
  std::string detail;  ///< the comparisons ("231 pairs"), the first place where the sides differ, or the error
};

/// Every proof and spot check, in reading order: basis, rotations, conventions, zonal functions, windows, products.
/// Their `run` throws std::invalid_argument, one line with the limit and the reason, for a degree outside
/// 0 .. max_degree. The second form has proofs about other formulas than ours.
std::vector<Proof> all_proofs();
std::vector<Proof> all_proofs(const std::shared_ptr<const Formulas>& formulas);

/// Runs a proof. No exception leaves it, so that the other proofs still run.
ProofResult run_proof(const Proof& proof, int degree);

}  // namespace sh::symbolic
