// The errata of the sources: every formula, table, claim and code fragment that a reader would copy, with its verdict.
//
// One list of plain data. A reading is decided exactly from its `statement` (symbolic/errata/decide.hpp, shown by
// `shgen errata`) or measured against its `number` (numeric/report/source_claims.hpp, shown by `shcheck report`). The
// verdict is stored once, as the `holds` of each reading; both tools have to come to it.
#pragma once

#include <string>
#include <vector>

namespace sh::errata {

enum class Kind { kEquation, kText, kTable, kCode };

/// How the text came to us.
enum class Print {
  kRead,    ///< read in the source
  kLost,    ///< lost in the text extraction: the formula that the paper needs there is derived
  kReport,  ///< from the literature about the source, and from code written after it
};

/// One way to understand the printed text.
struct Reading {
  std::string text;       ///< the formula or claim in this reading, ASCII mathematics
  bool holds = false;     ///< the verdict on it
  std::string statement;  ///< in the words of symbolic/errata/vocabulary.hpp; empty: measured only
  std::string number;     ///< the printed number of a measured claim, without its unit; empty: decided only
  std::string unit;       ///< of the number: "%" or ""
};

struct Entry {
  std::string id;     ///< "G-24"; the prefix names the source
  std::string where;  ///< "Recurrence rule 1", "Eq. 7", "Code P(l,m,x)"
  Kind kind = Kind::kEquation;
  Print print = Print::kRead;
  std::string printed = {};            ///< transcribed in ASCII mathematics; what is known of it when lost
  std::vector<Reading> readings = {};  ///< of the printed text; none when it is lost
  std::string correct = {};            ///< the formula to use, one line; empty when that is what is printed
  std::string correct_statement = {};  ///< decides `correct`; required for wrong and lost formulas
  std::string remark = {};             ///< why, one or two sentences
};

enum class Verdict {
  kCorrect,       ///< every reading holds
  kUnderReading,  ///< right in one reading or scope, wrong in another
  kWrong,         ///< no reading holds; `correct` does
  kDerived,       ///< lost; `correct` is derived and decided
};

/// "correct", "correct under reading", "wrong", "lost, derived".
std::string to_string(Verdict verdict);

/// The verdict on an entry whose readings hold as `held` says: one value a reading, none for a lost text.
Verdict verdict_of(const std::vector<bool>& held);

/// The verdict that the entry's readings record.
Verdict recorded_verdict(const Entry& entry);

struct Source {
  std::string prefix;      ///< of its entries: "G"
  std::string name;        ///< author, title, year
  std::string short_name;  ///< author, year
  std::vector<Entry> entries;
};

/// The four sources, then the papers that they point to.
std::vector<Source> all_sources();

}  // namespace sh::errata
