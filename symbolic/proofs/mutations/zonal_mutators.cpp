// Entries: a zonal family by name, then the degree l; for a turned function the index l(l+1)+m.
#include "symbolic/proofs/mutations/changes.hpp"

namespace sh::symbolic {
namespace {

template <class Value>
auto at_degree(std::function<Value(int)> Formulas::*function) {
  return [function](Formulas& f, const Mutation& mutation) { spoil_at(f.*function, mutation); };
}

// polynomial: one part in a million more of its first polynomial.
void mutate_zonal(Formulas& f, const Mutation& mutation) {
  static_cast<void>(zonal_family(mutation.entry.at(0)));
  spoil(f.zonal, [name = mutation.entry.at(0), at = number(mutation, 1), kind = mutation.kind](
                     ZonalTerm& term, const ZonalFamily& family, int degree) {
    if (family.name != name || degree != at) return;
    if (kind == "polynomial") {
      change(term.numerator.at(0), "factor");
    } else {
      change(term.factor, kind);
    }
  });
}

void mutate_turned_zonal(Formulas& f, const Mutation& mutation) {
  spoil(f.turned_zonal, [i = number(mutation, 0), kind = mutation.kind](std::vector<TurnedZonal>& entries, int) {
    if (i + 1 >= static_cast<int>(entries.size())) return;
    if (kind == "exchange") {
      std::swap(entries[i].polynomial, entries[i + 1].polynomial);
    } else if (kind == "term") {
      change(entries[i].polynomial, kind);
    } else {
      change(entries[i].factor, kind);
    }
  });
}

void mutate_gaussian(Formulas& f, const Mutation& mutation) {
  if (mutation.kind != "shift") refuse_kind(mutation.kind);
  spoil(f.window_gaussian_exponent, [at = number(mutation, 0)](int& exponent, int degree) {
    if (degree == at) ++exponent;
  });
}

}  // namespace

Mutators zonal_mutators() {
  return {{"zonal", mutate_zonal},
          {"irradiance-factor", at_degree(&Formulas::irradiance_factor)},
          {"irradiance-factor-integral", at_degree(&Formulas::irradiance_factor_integral)},
          {"convolution-factor", at_degree(&Formulas::convolution_factor)},
          {"turned-zonal", mutate_turned_zonal},
          {"window-hann", at_degree(&Formulas::window_hann)},
          {"window-lanczos-sine", at_degree(&Formulas::window_lanczos_sine)},
          {"window-gaussian-exponent", mutate_gaussian},
          {"window-laplacian-penalty", at_degree(&Formulas::window_laplacian_penalty)}};
}

}  // namespace sh::symbolic
