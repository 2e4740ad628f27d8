// Entries: a normalization or an index order by name, then degree l and orders.
#include "symbolic/convention/convention.hpp"
#include "symbolic/number/find_named.hpp"
#include "symbolic/proofs/mutations/changes.hpp"

namespace sh::symbolic {
namespace {

template <class Value>
struct Named {
  std::string name;
  Value value;
};

Normalization normalization(const std::string& name) {
  static const std::vector<Named<Normalization>> all{{"orthonormal", Normalization::kOrthonormal},
                                                     {"four-pi", Normalization::kFourPi},
                                                     {"schmidt", Normalization::kSchmidt},
                                                     {"sn3d", Normalization::kSn3d},
                                                     {"unnormalized", Normalization::kUnnormalized},
                                                     {"primitive", Normalization::kPrimitive},
                                                     {"fuma", Normalization::kFuMa}};
  return find_named(all, name, "normalization").value;
}

IndexOrder index_order(const std::string& name) {
  static const std::vector<Named<IndexOrder>> all{{"acn", IndexOrder::kAcn},
                                                  {"zero-first", IndexOrder::kZeroFirst},
                                                  {"cosine-sine-bands", IndexOrder::kCosineSineBands},
                                                  {"cosine-sine-array", IndexOrder::kCosineSineArray},
                                                  {"fuma", IndexOrder::kFuMa}};
  return find_named(all, name, "index order").value;
}

// The size of one function of a normalization, in the factor and in the function written out.
void mutate_convention_factor(Formulas& f, const Mutation& mutation) {
  const auto applies = [of = normalization(mutation.entry.at(0)), l = number(mutation, 1), m = number(mutation, 2)](
                           const Convention& c, int degree, int order) {
    return c.normalization == of && degree == l && order == m;
  };
  spoil(f.convention_factor, [=, kind = mutation.kind](Surd& factor, const Convention& c, int degree, int order) {
    if (applies(c, degree, order)) change(factor, kind);
  });
  spoil(f.convention_function,
        [=, kind = mutation.kind](ConventionFunction& function, const Convention& c, int degree, int order) {
          if (applies(c, degree, order)) change(function.factor, kind);
        });
}

// drop: no phase; sign: the phase at the other sign of m.
void mutate_phase(Formulas& f, const Mutation& mutation) {
  const auto changes = [kind = mutation.kind](const Convention& c, int order) {
    if (!c.condon_shortley || order % 2 == 0) return false;
    if (kind == "drop") return order > 0 || !c.complex;
    if (kind == "exchange") return c.complex;
    refuse_kind(kind);
  };
  spoil(f.convention_factor, [=](Surd& factor, const Convention& c, int, int order) {
    if (changes(c, order)) factor = -factor;
  });
  spoil(f.convention_function, [=](ConventionFunction& function, const Convention& c, int, int order) {
    if (changes(c, order)) function.factor = -function.factor;
  });
}

// The polynomials of one function; conjugate: the imaginary part of every complex one.
void mutate_convention_function(Formulas& f, const Mutation& mutation) {
  if (mutation.kind == "conjugate") {
    spoil(f.convention_function, [](ConventionFunction& function, const Convention&, int, int) {
      function.im = cln::cl_RA(-1) * function.im;
    });
    return;
  }
  spoil(f.convention_function, [l = number(mutation, 0), m = number(mutation, 1), kind = mutation.kind](
                                   ConventionFunction& function, const Convention&, int degree, int order) {
    if (degree == l && order == m) change(function.re, kind);
  });
}

// A_l and A_l^-1: one entry, or the whole matrix everywhere.
auto basis_change(std::function<Matrix<RadicalSum>(const Convention&, int)> Formulas::*function) {
  return [function](Formulas& f, const Mutation& mutation) {
    spoil(f.*function, [mutation](Matrix<RadicalSum>& a, const Convention&, int degree) {
      if (mutation.kind == "transpose") {
        a = a.transposed();
      } else if (mutation.kind == "conjugate") {
        a = a.mapped([](const RadicalSum& entry) { return entry.conjugate(); });
      } else if (degree == number(mutation, 0)) {
        change_band(a, number(mutation, 1), number(mutation, 2), mutation.kind);
      }
    });
  };
}

using Bands = std::vector<Matrix<RadicalSum>>;

Bands transposed(Bands bands) {
  for (Matrix<RadicalSum>& band : bands) band = band.transposed();
  return bands;
}

// The maps that one and the same mistake in c' = A^-T c gives everywhere. They compose, and each undoes its inverse.
ConventionMap with_mistake(const ConventionMap& from_ours, const std::string& kind) {
  ConventionMap map = from_ours;
  if (kind == "inverse" || kind == "inverse-transpose") std::swap(map.forward, map.backward);
  if (kind == "transpose" || kind == "inverse-transpose") {
    map.forward = transposed(map.forward);
    map.backward = transposed(map.backward);
  }
  return map;
}

// transpose, inverse, inverse-transpose: what c' = A^-T c leaves out everywhere; or an entry (l, m, n) of every map;
// order: the arrays keep the order that they come in; acn: every function at place l(l+1)+m.
void mutate_convention_map(Formulas& f, const Mutation& mutation) {
  if (mutation.kind == "order") {
    spoil(f.convention_map,
          [](ConventionMap& map, const Convention& from, const Convention&, int) { map.to_order = from.order; });
    return;
  }
  if (mutation.entry.at(0) == "everywhere") {
    f.convention_map = [original = f.convention_map, kind = mutation.kind](const Convention& from, const Convention& to,
                                                                           int degree) {
      if (kind != "transpose" && kind != "inverse" && kind != "inverse-transpose") refuse_kind(kind);
      ConventionMap source = with_mistake(original({}, from, degree), kind);
      std::swap(source.forward, source.backward);
      std::swap(source.from_order, source.to_order);
      return compose(with_mistake(original({}, to, degree), kind), source);
    };
    return;
  }
  spoil(f.convention_map, [mutation](ConventionMap& map, const Convention&, const Convention&, int degree) {
    const int l = number(mutation, 0);
    if (l > degree) return;
    change_band(map.forward[l], number(mutation, 1), number(mutation, 2), mutation.kind);
  });
}

// The factor A_l / pi; drop: nothing is folded in.
void mutate_folded(Formulas& f, const Mutation& mutation) {
  spoil(f.folded_factor, [at = number(mutation, 0), kind = mutation.kind](Surd& factor, Folded folded, int degree) {
    if (folded == Folded::kNothing || degree != at) return;
    if (kind == "unfolded") {
      factor = Surd(1);
    } else {
      change(factor, kind);
    }
  });
}

// A_l / pi everywhere in the maps: twice, or not at all.
void mutate_folding(Formulas& f, const Mutation& mutation) {
  const int power = mutation.kind == "twice" ? 1 : mutation.kind == "drop" ? -1 : 0;
  if (power == 0) refuse_kind(mutation.kind);
  f.convention_map = [original = f.convention_map, power](const Convention& from, const Convention& to, int degree) {
    ConventionMap map = original(from, to, degree);
    for (int l = 0; l <= degree && map.folds; ++l) {
      const RadicalSum ratio(symbolic::folded_factor(to.folded, l) / symbolic::folded_factor(from.folded, l));
      const RadicalSum up = power > 0 ? ratio : ratio.inverse();
      const RadicalSum down = up.inverse();
      map.forward[l] = map.forward[l].mapped([&](const RadicalSum& entry) { return up * entry; });
      map.backward[l] = map.backward[l].mapped([&](const RadicalSum& entry) { return down * entry; });
    }
    return map;
  };
}

// exchange: the places of orders m and -m; shift: all places of a band.
void mutate_storage_position(Formulas& f, const Mutation& mutation) {
  spoil(f.storage_position,
        [original = f.storage_position, of = index_order(mutation.entry.at(0)), at = number(mutation, 1),
         kind = mutation.kind](int& place, IndexOrder order, int largest, int degree, int m) {
          if (order != of || degree != at) return;
          if (kind == "exchange") {
            place = original(order, largest, degree, -m);
          } else if (kind == "shift") {
            ++place;
          } else {
            refuse_kind(kind);
          }
        });
}

void mutate_storage_size(Formulas& f, const Mutation& mutation) {
  if (mutation.kind != "shift") refuse_kind(mutation.kind);
  spoil(f.storage_size, [of = index_order(mutation.entry.at(0))](int& size, IndexOrder order, int) {
    if (order == of) ++size;
  });
}

// W: one entry, the whole matrix, or the phase exchanged.
void mutate_real_from_complex(Formulas& f, const Mutation& mutation) {
  if (mutation.kind == "phase") {
    f.real_from_complex = [original = f.real_from_complex](int degree, bool phase) { return original(degree, !phase); };
    return;
  }
  spoil(f.real_from_complex, [mutation](Matrix<RadicalSum>& w, int degree, bool) {
    if (mutation.kind == "conjugate") {
      w = w.mapped([](const RadicalSum& entry) { return entry.conjugate(); });
    } else if (mutation.kind == "transpose") {
      w = w.transposed();
    } else if (degree == number(mutation, 0)) {
      change_band(w, number(mutation, 1), number(mutation, 2), mutation.kind);
    }
  });
}

// D_l(P): one entry, the inverse, or reflections without their sign.
void mutate_axes_band(Formulas& f, const Mutation& mutation) {
  if (mutation.kind == "inverse") {
    f.axes_band = [original = f.axes_band](const SignedPermutation& axes, int degree) {
      return original(axes.inverse(), degree);
    };
    return;
  }
  spoil(f.axes_band, [mutation](Matrix<cln::cl_RA>& band, const SignedPermutation& axes, int degree) {
    if (mutation.kind == "reflection") {
      const int sign = degree % 2 == 0 ? 1 : axes.determinant();
      band = band.mapped([sign](const cln::cl_RA& entry) -> cln::cl_RA { return sign * entry; });
    } else if (degree == number(mutation, 0)) {
      change_band(band, number(mutation, 1), number(mutation, 2), mutation.kind);
    }
  });
}

}  // namespace

Mutators convention_mutators() {
  return {{"convention-factor", mutate_convention_factor},
          {"convention-phase", mutate_phase},
          {"convention-function", mutate_convention_function},
          {"basis-change", basis_change(&Formulas::basis_change)},
          {"basis-change-inverse", basis_change(&Formulas::basis_change_inverse)},
          {"convention-map", mutate_convention_map},
          {"folded-factor", mutate_folded},
          {"folding", mutate_folding},
          {"storage-position", mutate_storage_position},
          {"storage-size", mutate_storage_size},
          {"real-from-complex", mutate_real_from_complex},
          {"axes-band", mutate_axes_band}};
}

}  // namespace sh::symbolic
