#include "codegen/commands/errata.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <iomanip>
#include <iostream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>
#include <stdexcept>
#include <utility>

#include "codegen/commands/commands.hpp"
#include "numeric/output/atomic_file.hpp"
#include "symbolic/errata/decide.hpp"

namespace sh::codegen {
namespace {

using errata::Entry;
using errata::Kind;
using errata::Print;
using errata::Reading;
using errata::Source;
using errata::Verdict;
using symbolic::errata::Decision;
using Json = nlohmann::ordered_json;

constexpr std::size_t kWidth = 118;
constexpr std::size_t kLabelWidth = 10;

constexpr Verdict kVerdicts[] = {Verdict::kCorrect, Verdict::kUnderReading, Verdict::kWrong, Verdict::kDerived};

struct Outcome {
  symbolic::errata::Decision decision;
  double seconds = 0;
};

Outcome decide_entry(const Entry& entry) {
  const auto start = std::chrono::steady_clock::now();
  Outcome outcome{symbolic::errata::decide(entry), 0};
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return outcome;
}

void require_verdict(const std::string& name) {
  std::string known;
  for (const Verdict verdict : kVerdicts) {
    if (to_string(verdict) == name) return;
    known.append(known.empty() ? "'" : ", '").append(to_string(verdict)).append("'");
  }
  throw std::invalid_argument("unknown verdict '" + name + "': expected one of: " + known);
}

[[noreturn]] void refuse_unknown(const std::string& name, const std::vector<Source>& sources) {
  std::string known;
  for (const Source& source : sources) {
    if (source.entries.empty()) continue;
    known.append(known.empty() ? "" : ", ").append(source.prefix).append(" (");
    known.append(source.entries.front().place.id).append(" to ").append(source.entries.back().place.id).append(")");
  }
  throw std::invalid_argument("unknown source or entry '" + name + "': expected one of: " + known);
}

bool is_named(const Source& source, const Entry& entry, const std::vector<std::string>& only) {
  return only.empty() || std::any_of(only.begin(), only.end(), [&](const std::string& name) {
           return name == source.prefix || name == entry.place.id;
         });
}

void require_known(const std::vector<std::string>& only, const std::vector<Source>& sources) {
  for (const std::string& name : only) {
    const bool known = std::any_of(sources.begin(), sources.end(), [&](const Source& source) {
      return std::any_of(source.entries.begin(), source.entries.end(),
                         [&](const Entry& entry) { return is_named(source, entry, {name}); });
    });
    if (!known) refuse_unknown(name, sources);
  }
}

// The sources with the chosen entries; none without.
std::vector<Source> chosen(const std::vector<Source>& sources, const ErrataOptions& options) {
  if (!options.verdict.empty()) require_verdict(options.verdict);
  require_known(options.only, sources);
  std::vector<Source> result;
  for (const Source& source : sources) {
    Source part{source.prefix, source.name, source.short_name, {}};
    for (const Entry& entry : source.entries) {
      if (!is_named(source, entry, options.only)) continue;
      if (options.verdict.empty() || to_string(recorded_verdict(entry)) == options.verdict)
        part.entries.push_back(entry);
    }
    if (!part.entries.empty()) result.push_back(std::move(part));
  }
  return result;
}

// "       label     text", wrapped between words, continued under the text.
void print_field(std::ostream& out, const std::string& label, const std::string& text) {
  const std::string margin(8, ' ');
  std::string line = margin + label + std::string(kLabelWidth - label.size(), ' ');
  const std::size_t indent = line.size();
  bool empty = true;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = std::min(text.find(' ', start), text.size());
    const std::string word = text.substr(start, end - start);
    if (!empty && line.size() + 1 + word.size() > kWidth) {
      out << line << '\n';
      line.assign(indent, ' ');
      empty = true;
    }
    line += (empty ? "" : " ") + word;
    empty = false;
    start = end + 1;
  }
  out << line << '\n';
}

std::string text_of(const Reading& reading) {
  if (reading.number.empty()) return reading.text;
  return reading.text + ": " + reading.number + (reading.unit.empty() ? "" : " " + reading.unit) +
         (reading.statement.empty() ? " (measured by shcheck report)" : "");
}

void print_entry(std::ostream& out, const Entry& entry, const Decision& decision) {
  const std::string verdict = decision.contradiction.empty() ? to_string(decision.verdict) : "CONTRADICTED";
  out << std::left << std::setw(8) << entry.place.id << std::setw(23) << verdict << entry.place.where << '\n';
  print_field(out, "printed", entry.printed);
  const bool measured = !entry.readings.empty() && !entry.readings.front().number.empty();
  for (std::size_t i = 0; i < entry.readings.size() && (entry.readings.size() > 1 || measured); ++i) {
    print_field(out, decision.held[i] ? "holds" : "fails", text_of(entry.readings[i]));
  }
  if (!entry.correct.empty()) print_field(out, "correct", entry.correct);
  if (!entry.remark.empty()) print_field(out, "note", entry.remark);
  if (!decision.contradiction.empty()) print_field(out, "error", decision.contradiction);
  out << std::flush;  // as they are decided
}

std::string kind_name(Kind kind) {
  switch (kind) {
    case Kind::kEquation:
      return "equation";
    case Kind::kText:
      return "text";
    case Kind::kTable:
      return "table";
    default:
      return "code";
  }
}

std::string print_name(Print print) {
  switch (print) {
    case Print::kRead:
      return "read";
    case Print::kLost:
      return "lost";
    default:
      return "report";
  }
}

Json as_json(const Entry& entry, const Outcome& outcome) {
  Json readings = Json::array();
  for (std::size_t i = 0; i < entry.readings.size(); ++i) {
    const Reading& reading = entry.readings[i];
    readings.push_back({{"text", reading.text},
                        {"holds", static_cast<bool>(outcome.decision.held[i])},
                        {"statement", reading.statement},
                        {"measured", reading.number}});
  }
  return {{"id", entry.place.id},
          {"where", entry.place.where},
          {"kind", kind_name(entry.place.kind)},
          {"print", print_name(entry.place.print)},
          {"printed", entry.printed},
          {"stated", to_string(recorded_verdict(entry))},
          {"verdict", to_string(outcome.decision.verdict)},
          {"readings", readings},
          {"correct", entry.correct},
          {"correct_is_decided", !entry.correct_statement.empty()},
          {"remark", entry.remark},
          {"contradiction", outcome.decision.contradiction},
          {"seconds", outcome.seconds}};
}

class Totals {
 public:
  void add(const Outcome& outcome) {
    ++entries_;
    ++verdicts_[to_string(outcome.decision.verdict)];
    seconds_ += outcome.seconds;
    const std::string& contradiction = outcome.decision.contradiction;
    if (!contradiction.empty()) contradictions_.push_back(contradiction);
  }
  [[nodiscard]] bool consistent() const { return contradictions_.empty(); }
  void print(std::ostream& out) const {
    for (const std::string& line : contradictions_) out << "shgen: contradicted: " << line << '\n';
    out << "shgen: " << entries_ << " entries decided in " << std::fixed << std::setprecision(1) << seconds_ << " s";
    const char* separator = ": ";
    for (const Verdict verdict : kVerdicts) {
      const auto found = verdicts_.find(to_string(verdict));
      if (found == verdicts_.end()) continue;
      out << std::exchange(separator, "; ") << found->second << ' ' << found->first;
    }
    out << '\n';
  }

 private:
  std::size_t entries_ = 0;
  std::map<std::string, std::size_t> verdicts_;
  std::vector<std::string> contradictions_;
  double seconds_ = 0;
};

}  // namespace

bool errata(const std::vector<Source>& sources, const ErrataOptions& options, std::ostream& out,
            std::ostream& progress) {
  Json report = Json::array();
  Totals totals;
  const char* gap = "";
  for (const Source& source : chosen(sources, options)) {
    out << std::exchange(gap, "\n") << source.prefix << ": " << source.name << "\n\n";
    Json entries = Json::array();
    for (const Entry& entry : source.entries) {
      const Outcome outcome = decide_entry(entry);
      print_entry(out, entry, outcome.decision);
      entries.push_back(as_json(entry, outcome));
      totals.add(outcome);
    }
    report.push_back({{"source", source.prefix}, {"name", source.name}, {"entries", entries}});
  }
  if (!options.json.empty()) output::write_file(options.json, report.dump(2) + "\n");
  totals.print(progress);
  return totals.consistent();
}

void add_errata_command(CLI::App& tool, int& exit_code) {
  const auto options = std::make_shared<ErrataOptions>();
  CLI::App* const command = tool.add_subcommand("errata", "Decide the formulas of the sources");
  command->add_option("name", options->only, "Entries (B-08) or sources (B) (default: all)");
  command->add_option("--verdict", options->verdict, "Only entries of this verdict, e.g. wrong");
  command->add_option("--json", options->json, "File to write the results to");
  command->callback([options, &exit_code] {
    exit_code = errata(errata::all_sources(), *options, std::cout, std::cerr) ? kDone : kDifferent;
  });
}

}  // namespace sh::codegen
