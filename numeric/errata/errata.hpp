// The errata of the sources: every formula, table, claim and code fragment that a reader would copy, with its verdict.
//
// The list is plain data. `shgen errata` decides a reading exactly from its `statement` (symbolic/errata/decide.hpp);
// `shcheck report` measures it against its `number` (numeric/report/source_claims.hpp). The list stores each verdict
// once, as the `holds` of a reading; both tools must come to the same verdict.
#pragma once

#include <string>
#include <vector>

namespace sh::errata {

enum class Kind { kEquation, kText, kTable, kCode };

/// How we know the text.
enum class Print {
  kRead,    ///< read in the source
  kLost,    ///< the text extraction lost it: we derive the formula that the paper needs there
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

/// The passage of the source.
struct Place {
  std::string id;     ///< "G-24"; the prefix names the source
  std::string where;  ///< "Recurrence rule 1", "Eq. 7", "Code P(l,m,x)"
  Kind kind = Kind::kEquation;
  Print print = Print::kRead;
};

struct Entry {
  Place place;
  std::string printed = {};            ///< transcribed in ASCII mathematics; if lost, all that we know of it
  std::vector<Reading> readings = {};  ///< of the printed text; none when it is lost
  std::string correct = {};            ///< the formula to use, one line; empty if the print is right
  std::string correct_statement = {};  ///< decides `correct`; required for wrong and lost formulas
  std::string remark = {};             ///< why, one or two sentences
};

enum class Verdict {
  kCorrect,       ///< every reading holds
  kUnderReading,  ///< one reading or scope holds, another fails
  kWrong,         ///< no reading holds; `correct` does
  kDerived,       ///< lost; `correct` is derived and decided
};

/// "correct", "correct under reading", "wrong", "lost, derived".
std::string to_string(Verdict verdict);

/// The verdict that follows from `held`, one value for each reading; a lost text has no reading.
Verdict verdict_of(const std::vector<bool>& held);

/// The verdict that the entry's readings record.
Verdict recorded_verdict(const Entry& entry);

struct Source {
  std::string prefix;      ///< of its entries: "G"
  std::string name;        ///< author, title, year
  std::string short_name;  ///< author, year
  std::vector<Entry> entries;
};

/// The four sources, then the papers that they cite.
std::vector<Source> all_sources();

}  // namespace sh::errata
