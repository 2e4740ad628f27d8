// Entries: degree l and order m; then an axis 0..2, a second order, or the number of a second derivative.
#include "symbolic/proofs/mutations/changes.hpp"

namespace sh::symbolic {
namespace {

// One part of one function.
template <class Part>
auto part_of_function(Part BasisFunction::*part) {
  return [part](Formulas& f, const Mutation& mutation) {
    const auto spoiled = [part, l = number(mutation, 0), m = number(mutation, 1), kind = mutation.kind](
                             BasisFunction& y, int degree, int order) {
      const bool is_empty = [&] {  // the reduced form alone has no homogeneous one
        if constexpr (std::is_same_v<Part, Polynomial>) return (y.*part).is_zero();
        return false;
      }();
      if (degree == l && order == m && !is_empty) change(y.*part, kind);
    };
    spoil(f.basis, spoiled);
    spoil(f.reduced_basis, spoiled);
  };
}

// The functions of order m and -m exchanged.
void exchange_functions(Formulas& f, const Mutation& mutation) {
  if (mutation.kind != "exchange") refuse_kind(mutation.kind);
  for (auto* function : {&f.basis, &f.reduced_basis}) {
    spoil(*function, [original = *function, l = number(mutation, 0), m = number(mutation, 1)](BasisFunction& y,
                                                                                              int degree, int order) {
      if (degree != l || std::abs(order) != m) return;
      y = original(degree, -order);
      y.order = order;
    });
  }
}

void mutate_factor(Formulas& f, const Mutation& mutation) {
  spoil(f.factor,
        [l = number(mutation, 0), m = number(mutation, 1), kind = mutation.kind](Surd& k, int degree, int order) {
          if (degree == l && order == m) change(k, kind);
        });
}

void mutate_factor_ratio(Formulas& f, const Mutation& mutation) {
  spoil(f.factor_ratio, [l = number(mutation, 0), m = number(mutation, 1), n = number(mutation, 2),
                         kind = mutation.kind](Surd& ratio, int degree, int row, int column) {
    if (degree == l && row == m && column == n) change(ratio, kind);
  });
}

// radial: plus the form times s, which the cross product with s does not see; exchange: with the next component.
template <class Derivatives>
auto derivatives(std::function<Derivatives(const BasisFunction&, BasisForm)> Formulas::*function, BasisForm form) {
  return [=](Formulas& f, const Mutation& mutation) {
    spoil(f.*function, [=, l = number(mutation, 0), m = number(mutation, 1), i = number(mutation, 2),
                        kind = mutation.kind](Derivatives& d, const BasisFunction& y, BasisForm of) {
      if (of != form || y.degree != l || y.order != m) return;
      const auto k = static_cast<std::size_t>(i);
      if (kind == "radial") {
        for (int axis = 0; axis < 3; ++axis) d.at(axis) += Polynomial::variable(axis) * form_polynomial(y, form);
      } else if (kind == "exchange") {
        std::swap(d.at(k), d.at((k + 1) % d.size()));
      } else {
        change(d.at(k), kind);
      }
    });
  };
}

// The term number(mutation, 3) of the derivative along an axis.
void mutate_ladder(Formulas& f, const Mutation& mutation) {
  spoil(f.ladder,
        [l = number(mutation, 0), m = number(mutation, 1), axis = number(mutation, 2), term = number(mutation, 3),
         kind = mutation.kind](std::vector<LadderTerm>& terms, int degree, int order, int along) {
          if (degree != l || order != m || along != axis) return;
          if (kind == "exchange") {
            terms.at(term).order = -terms.at(term).order;
          } else {
            change(terms.at(term).coefficient, kind);
          }
        });
}

}  // namespace

Mutators basis_mutators() {
  return {{"basis", exchange_functions},
          {"basis.factor", part_of_function(&BasisFunction::factor)},
          {"basis.axial", part_of_function(&BasisFunction::axial)},
          {"basis.azimuthal", part_of_function(&BasisFunction::azimuthal)},
          {"basis.homogeneous", part_of_function(&BasisFunction::homogeneous)},
          {"factor", mutate_factor},
          {"factor-ratio", mutate_factor_ratio},
          {"gradient", derivatives(&Formulas::gradient, BasisForm::kHomogeneous)},
          {"gradient.reduced", derivatives(&Formulas::gradient, BasisForm::kReduced)},
          {"hessian", derivatives(&Formulas::hessian, BasisForm::kHomogeneous)},
          {"hessian.reduced", derivatives(&Formulas::hessian, BasisForm::kReduced)},
          {"ladder", mutate_ladder}};
}

}  // namespace sh::symbolic
