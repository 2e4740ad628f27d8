// Entries: the indices l(l+1)+m of three functions, the degrees and orders of a 3j symbol, or an output and its term.
#include "symbolic/proofs/mutations/changes.hpp"

namespace sh::symbolic {
namespace {

IndexTriple triple(const Mutation& mutation) {
  return sorted({number(mutation, 0), number(mutation, 1), number(mutation, 2)});
}

// add: an entry of one millionth at a place that has none.
void mutate_gaunt(Formulas& f, const Mutation& mutation) {
  spoil(f.gaunt, [at = triple(mutation), kind = mutation.kind](GauntTensor& tensor, int degree) {
    if (degree_order(at.k).degree > degree) return;
    if (kind == "add") {
      tensor[at] = Surd(cln::cl_RA(1) / 1'000'000);
    } else if (kind == "drop") {
      tensor.erase(at);
    } else {
      change(tensor.at(at), kind);
    }
  });
}

// sign: the rule says the opposite of one entry.
void mutate_gaunt_rule(Formulas& f, const Mutation& mutation) {
  if (mutation.kind != "sign") refuse_kind(mutation.kind);
  spoil(f.gaunt_rule, [at = triple(mutation)](bool& may_differ, int i, int j, int k) {
    if (sorted({i, j, k}) == at) may_differ = !may_differ;
  });
}

// Three degrees: all their symbols; six numbers: one symbol. phase: all symbols without (-1)^(l1-l2-m3); exchange: the
// phase with l2 - l1 + m3, as if the first two momenta were exchanged in it.
void mutate_wigner_3j(Formulas& f, const Mutation& mutation) {
  if (mutation.kind == "phase" || mutation.kind == "cyclic") {
    spoil(f.wigner_3j, [cyclic = mutation.kind == "cyclic"](Surd& value, int l1, int l2, int l3, int, int m2, int m3) {
      const int power = cyclic ? (l1 - l2 - m3) + (l3 - l1 - m2) : l1 - l2 - m3;
      if (power % 2 != 0) value = -value;
    });
    return;
  }
  std::vector<int> at;
  for (std::size_t i = 0; i < mutation.entry.size(); ++i) at.push_back(number(mutation, i));
  spoil(f.wigner_3j, [at, kind = mutation.kind](Surd& value, int l1, int l2, int l3, int m1, int m2, int m3) {
    const std::vector<int> arguments{l1, l2, l3, m1, m2, m3};
    if (std::equal(at.begin(), at.end(), arguments.begin())) change(value, kind);
  });
}

void change_form(std::vector<BilinearForm>& forms, const Mutation& mutation) {
  const auto output = static_cast<std::size_t>(number(mutation, 0));
  if (output >= forms.size()) return;
  BilinearTerm& term = forms[output].terms.at(number(mutation, 1));
  if (mutation.kind == "exchange") {
    std::swap(forms[output].output, forms.at(output + 1).output);
  } else if (mutation.kind == "index") {
    ++term.i;
  } else {
    change(term.factor, mutation.kind);
  }
}

template <class... Arguments>
auto form(std::function<std::vector<BilinearForm>(Arguments...)> Formulas::*function) {
  return [function](Formulas& f, const Mutation& mutation) {
    spoil(f.*function, [mutation](std::vector<BilinearForm>& forms, Arguments...) { change_form(forms, mutation); });
  };
}

// undoubled: the mixed terms of a square only once.
void mutate_square(Formulas& f, const Mutation& mutation) {
  if (mutation.kind == "undoubled") {
    f.square = [product = f.product](int degree, int result) {
      std::vector<BilinearForm> forms = product({degree, degree, result});
      for (BilinearForm& form : forms)
        std::erase_if(form.terms, [](const BilinearTerm& term) { return term.i > term.j; });
      return forms;
    };
    return;
  }
  form (&Formulas::square)(f, mutation);
}

void mutate_transfer_matrix(Formulas& f, const Mutation& mutation) {
  spoil(f.transfer_matrix, [mutation](Matrix<RadicalSum>& m, const std::vector<Surd>&, const ProductShape&) {
    change(m(number(mutation, 0), number(mutation, 1)), mutation.kind);
  });
}

}  // namespace

Mutators product_mutators() {
  return {{"gaunt", mutate_gaunt},
          {"gaunt-rule", mutate_gaunt_rule},
          {"wigner-3j", mutate_wigner_3j},
          {"product", form(&Formulas::product)},
          {"square", mutate_square},
          {"zonal-product", form(&Formulas::zonal_product)},
          {"transfer-matrix", mutate_transfer_matrix}};
}

}  // namespace sh::symbolic
