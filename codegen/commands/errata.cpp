#include "codegen/commands/errata.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
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
#include "numeric/output/stopwatch.hpp"
#include "symbolic/errata/decide.hpp"

namespace sh::codegen {
namespace {

using errata::Entry;
using errata::Reading;
using errata::Source;
using errata::Verdict;
using symbolic::errata::Decision;
using Json = nlohmann::ordered_json;

constexpr std::size_t kWidth = 118;
constexpr std::size_t kLabelWidth = 10;

constexpr Verdict kVerdicts[] = {Verdict::kCorrect, Verdict::kUnderReading, Verdict::kWrong, Verdict::kDerived};

// "A, B, C"
template <class Names>
std::string listed(const Names& names) {
  return fmt::format("{}", fmt::join(names, ", "));
}

void require_verdict(const std::string& name) {
  std::vector<std::string> known;
  for (const Verdict verdict : kVerdicts) {
    if (to_string(verdict) == name) return;
    known.push_back("'" + to_string(verdict) + "'");
  }
  throw std::invalid_argument("unknown verdict '" + name + "': expected one of: " + listed(known));
}

bool is_named(const Source& source, const Entry& entry, const std::vector<std::string>& only) {
  return only.empty() || std::any_of(only.begin(), only.end(), [&](const std::string& name) {
           return name == source.prefix || name == entry.place.id;
         });
}

void require_known(const std::string& name, const std::vector<Source>& sources) {
  std::vector<std::string> known;
  for (const Source& source : sources) {
    if (source.entries.empty()) continue;
    for (const Entry& entry : source.entries) {
      if (is_named(source, entry, {name})) return;
    }
    known.push_back(source.prefix + " (" + source.entries.front().place.id + " to " + source.entries.back().place.id +
                    ")");
  }
  throw std::invalid_argument("unknown source or entry '" + name + "': expected one of: " + listed(known));
}

// The sources with the chosen entries; none without.
std::vector<Source> chosen(const std::vector<Source>& sources, const ErrataOptions& options) {
  if (!options.verdict.empty()) require_verdict(options.verdict);
  for (const std::string& name : options.only) require_known(name, sources);
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

constexpr const char* kKinds[] = {"equation", "text", "table", "code"};
constexpr const char* kPrints[] = {"read", "lost", "report"};

Json as_json(const Entry& entry, const Decision& decision, double seconds) {
  Json readings = Json::array();
  for (std::size_t i = 0; i < entry.readings.size(); ++i) {
    const Reading& reading = entry.readings[i];
    readings.push_back({{"text", reading.text},
                        {"holds", static_cast<bool>(decision.held[i])},
                        {"statement", reading.statement},
                        {"measured", reading.number}});
  }
  return {{"id", entry.place.id},
          {"where", entry.place.where},
          {"kind", kKinds[static_cast<int>(entry.place.kind)]},
          {"print", kPrints[static_cast<int>(entry.place.print)]},
          {"printed", entry.printed},
          {"stated", to_string(recorded_verdict(entry))},
          {"verdict", to_string(decision.verdict)},
          {"readings", readings},
          {"correct", entry.correct},
          {"correct_is_decided", !entry.correct_statement.empty()},
          {"remark", entry.remark},
          {"contradiction", decision.contradiction},
          {"seconds", seconds}};
}

}  // namespace

bool errata(const std::vector<Source>& sources, const ErrataOptions& options, std::ostream& out,
            std::ostream& progress) {
  if (!options.json.empty()) output::require_writable(options.json);
  Json report = Json::array();
  std::map<Verdict, int> counts;
  std::vector<std::string> contradictions;
  double total = 0;
  const char* gap = "";
  for (const Source& source : chosen(sources, options)) {
    out << std::exchange(gap, "\n") << source.prefix << ": " << source.name << "\n\n";
    Json entries = Json::array();
    for (const Entry& entry : source.entries) {
      const output::Stopwatch stopwatch;
      const Decision decision = symbolic::errata::decide(entry);
      const double seconds = stopwatch.seconds();
      print_entry(out, entry, decision);
      entries.push_back(as_json(entry, decision, seconds));
      total += seconds;
      ++counts[decision.verdict];
      if (!decision.contradiction.empty()) contradictions.push_back(decision.contradiction);
    }
    report.push_back({{"source", source.prefix}, {"name", source.name}, {"entries", entries}});
  }
  if (!options.json.empty()) output::write_file(options.json, report.dump(2) + "\n");
  std::vector<std::string> verdicts;
  int decided = 0;
  for (const auto& [verdict, count] : counts) {
    verdicts.push_back(std::to_string(count) + " " + to_string(verdict));
    decided += count;
  }
  for (const std::string& line : contradictions) progress << "shgen: contradicted: " << line << '\n';
  progress << fmt::format("shgen: {} entries decided in {:.1f} s{}{}\n", decided, total, decided > 0 ? ": " : "",
                          fmt::join(verdicts, "; "));
  return contradictions.empty();
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
