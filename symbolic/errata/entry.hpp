// An entry of the errata: one formula, table, claim or code fragment of a source, with a decision for every reading.
//
// A verdict is never written down alone: it follows from what the entry's decisions return, and has to be the one that
// the entry states. A decision is exact: an identity of polynomials, an exact integral, rational or surd arithmetic,
// or the arithmetic of a code fragment carried out on exact numbers.
#pragma once

#include <string>
#include <vector>

namespace sh::symbolic::errata {

enum class Kind { kEquation, kText, kTable, kCode };

/// How the text came to us.
enum class Print {
  kRead,    ///< read in the source
  kLost,    ///< lost in the text extraction: what the paper needs there is derived
  kReport,  ///< from the literature about the source, and from code written after it
};

/// One way to understand what is printed.
struct Reading {
  std::string text;           ///< the formula or claim in this reading, ASCII mathematics
  bool (*holds)() = nullptr;  ///< decides it exactly
};

enum class Verdict {
  kCorrect,       ///< right as printed
  kUnderReading,  ///< right in one reading or scope, wrong in another
  kWrong,         ///< no reading is right; `correct` is
  kDefinition,    ///< nothing to decide: a definition, a choice, a theorem restated
  kDerived,       ///< lost; `correct` is derived and decided
  kUndecided,     ///< not decidable from what there is; `remark` says why
};

struct Entry {
  std::string id;     ///< "G-24"; the prefix names the source
  std::string where;  ///< "Recurrence rule 1", "Eq. 7", "Code P(l,m,x)"
  Kind kind = Kind::kEquation;
  Print print = Print::kRead;
  std::string printed;  ///< transcribed in ASCII mathematics; what is known of it when lost
  Verdict verdict = Verdict::kUndecided;
  std::vector<Reading> readings;      ///< of the printed text; none for definitions, lost and undecided entries
  std::string correct;                ///< the formula to use, one line; empty when that is what is printed
  bool (*correct_holds)() = nullptr;  ///< decides `correct`; required for wrong and derived entries
  std::string remark;                 ///< why, one or two sentences
};

/// "correct", "correct under reading", "wrong", "definition", "lost, derived", "undecided".
std::string to_string(Verdict verdict);

/// What the decisions of the entry amount to. Throws std::logic_error, naming the entry, when they do not fit together:
/// a definition with readings, a wrong or lost formula without a decided correct one, an undecided one without remark.
Verdict decide(const Entry& entry);

}  // namespace sh::symbolic::errata
