#include "symbolic/proofs/mutations/mutation.hpp"

#include <algorithm>
#include <sstream>

#include "symbolic/number/find_named.hpp"
#include "symbolic/proofs/mutations/changes.hpp"

namespace sh::symbolic {
namespace {

const Mutators& mutators() {
  static const Mutators all = [] {
    Mutators result;
    for (const Mutators& part :
         {basis_mutators(), rotation_mutators(), convention_mutators(), zonal_mutators(), product_mutators()}) {
      result.insert(part.begin(), part.end());
    }
    return result;
  }();
  return all;
}

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

Mutation parsed(const std::string& line) {
  const auto equals = line.find('=');
  Mutation mutation;
  std::istringstream words(line.substr(0, equals));
  std::string word;
  while (words >> word) mutation.entry.push_back(word);
  if (mutation.entry.size() < 2) throw std::invalid_argument("expected FORMULA ENTRY KIND");
  mutation.formula = mutation.entry.front();
  mutation.kind = mutation.entry.back();
  mutation.entry = {mutation.entry.begin() + 1, mutation.entry.end() - 1};
  if (equals != std::string::npos) {
    mutation.equivalent = trimmed(line.substr(equals + 1));
    if (mutation.equivalent.empty()) throw std::invalid_argument("expected a reason after '='");
  }
  static_cast<void>(mutated(mutation));  // refuses unknown formulas and entries
  return mutation;
}

bool holds(const Proof& proof, int degree, const Mutation& mutation) {
  try {
    proof.run(degree);
    return true;
  } catch (const WrongKind& error) {
    throw std::invalid_argument(mutation.to_string() + ": " + error.what());
  } catch (const std::out_of_range&) {
    throw std::invalid_argument(mutation.to_string() + ": there is no such entry");
  } catch (const std::exception&) {  // refuted, or stopped by numbers that no formula of ours gives
    return false;
  }
}

}  // namespace

std::string Mutation::to_string() const {
  std::string text = formula;
  for (const std::string& word : entry) text += " " + word;
  return text + " " + kind;
}

std::vector<Mutation> read_mutations(std::istream& input, const std::string& file) {
  std::vector<Mutation> list;
  std::string line;
  for (int number = 1; std::getline(input, line); ++number) {
    const std::string content = trimmed(line.substr(0, line.find('#')));
    if (content.empty()) continue;
    try {
      list.push_back(parsed(content));
    } catch (const std::logic_error& error) {
      throw std::invalid_argument(file + ":" + std::to_string(number) +
                                  ": expected a mutation such as 'gaunt 1 2 3 sign', got '" + content +
                                  "': " + error.what());
    }
  }
  return list;
}

std::vector<std::string> mutation_names() {
  std::vector<std::string> names;
  for (const auto& [name, mutator] : mutators()) names.push_back(name);
  return names;
}

std::shared_ptr<const Formulas> mutated(const Mutation& mutation) {
  const auto found = mutators().find(mutation.formula);
  if (found == mutators().end()) {
    std::string known;
    for (const std::string& name : mutation_names()) known += " " + name;
    throw std::invalid_argument("expected one of the formulas" + known);
  }
  auto formulas = std::make_shared<Formulas>();
  found->second(*formulas, mutation);
  return formulas;
}

MutationResult judge(const Mutation& mutation, int degree) {
  MutationResult result;
  for (const Proof& proof : all_proofs(mutated(mutation))) {
    if (holds(proof, proof.every_degree ? 0 : std::min(degree, proof.default_degree), mutation)) continue;
    (proof.spot_check ? result.spot_checks : result.proofs).push_back(proof.name);
  }
  return result;
}

}  // namespace sh::symbolic
