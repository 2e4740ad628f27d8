// Entries: degree l, then orders m and n of a row and a column; for tables of vectors, components from 0.
#include "symbolic/proofs/mutations/changes.hpp"

namespace sh::symbolic {
namespace {

// The band of the degree, at the row and the column that the entry names; "transpose" needs the degree only.
template <class Number>
void change_band_of(Matrix<Number>& band, const Mutation& mutation, int degree) {
  if (degree != number(mutation, 0)) return;
  const bool whole = mutation.kind == "transpose";
  change_band(band, whole ? 0 : number(mutation, 1), whole ? 0 : number(mutation, 2), mutation.kind);
}

template <class Number, class... More>
auto band(std::function<Matrix<Number>(int, More...)> Formulas::*function) {
  return [function](Formulas& f, const Mutation& mutation) {
    spoil(f.*function,
          [mutation](Matrix<Number>& band, int degree, More...) { change_band_of(band, mutation, degree); });
  };
}

void mutate_rotation(Formulas& f, const Mutation& mutation) {
  spoil(f.rotation,
        [mutation](QuaternionRotation& band, int degree) { change_band_of(band.entries, mutation, degree); });
}

void mutate_recursion(Formulas& f, const Mutation& mutation) {
  const auto change_bands = [mutation](auto& bands, int, const auto&) {
    for (std::size_t l = 0; l < bands.size(); ++l) change_band_of(bands[l], mutation, static_cast<int>(l));
  };
  spoil(f.recursion, change_bands);
  spoil(f.recursion_at, change_bands);
}

// One of the two: "plus" or "minus"; "exchange": both.
void mutate_x90(Formulas& f, const Mutation& mutation) {
  if (mutation.kind == "exchange") {
    f.x90 = [original = f.x90](int degree, bool positive) { return original(degree, !positive); };
    return;
  }
  spoil(f.x90, [mutation, plus = mutation.entry.back() == "plus"](Matrix<cln::cl_RA>& band, int degree, bool positive) {
    if (positive == plus) change_band_of(band, mutation, degree);
  });
}

void mutate_surd_entries(Formulas& f, const Mutation& mutation) {
  spoil(f.surd_entries, [mutation](Matrix<Surd>& band, int degree, const Matrix<cln::cl_RA>&) {
    change_band_of(band, mutation, degree);
  });
}

void mutate_quaternion_matrix(Formulas& f, const Mutation& mutation) {
  spoil(f.quaternion_matrix, [mutation](Matrix<Polynomial>& m) {
    if (mutation.kind == "transpose") {
      m = m.transposed();
    } else {
      change(m(number(mutation, 0), number(mutation, 1)), mutation.kind);
    }
  });
}

void mutate_quaternion_product(Formulas& f, const Mutation& mutation) {
  if (mutation.kind == "exchange") {
    f.quaternion_product = [original = f.quaternion_product](const auto& a, const auto& b) { return original(b, a); };
    return;
  }
  spoil(f.quaternion_product, [at = number(mutation, 0), kind = mutation.kind](
                                  Quaternion<Polynomial>& q, const auto&, const auto&) { change(q.at(at), kind); });
}

// Coupling number(mutation, 2) of order number(mutation, 1).
void mutate_couplings(Formulas& f, const Mutation& mutation) {
  spoil(f.couplings, [l = number(mutation, 0), m = number(mutation, 1), i = number(mutation, 2), kind = mutation.kind](
                         std::vector<std::vector<Coupling>>& table, int degree) {
    if (degree != l) return;
    Coupling& coupling = table.at(l + m).at(i);
    if (kind == "exchange") {
      coupling.below = -coupling.below;
    } else if (kind == "axis") {
      coupling.axis = (coupling.axis + 1) % 3;
    } else {
      change(coupling.weight, kind);
    }
  });
}

void mutate_column_scale(Formulas& f, const Mutation& mutation) {
  spoil(f.column_scale, [l = number(mutation, 0), n = number(mutation, 1), kind = mutation.kind](
                            cln::cl_RA& scale, int degree, int column) {
    if (degree == l && column == n) change(scale, kind);
  });
}

// An angle: 0, 1, 2 for alpha, beta, gamma; exchange: cosine and sine.
void mutate_zyz_angles(Formulas& f, const Mutation& mutation) {
  spoil(f.zyz_angles, [at = number(mutation, 0), kind = mutation.kind](ZyzAngles<Polynomial>& angles, const auto&,
                                                                       const auto&, const auto&) {
    CosSin<Polynomial>& angle = at == 0 ? angles.alpha : at == 1 ? angles.beta : angles.gamma;
    if (kind == "exchange") {
      std::swap(angle.cosine, angle.sine);
    } else {
      change(angle.sine, kind);
    }
  });
}

// A component of the quaternion; exchange: with the next one; frame: intrinsic and extrinsic orders exchanged.
void mutate_euler(Formulas& f, const Mutation& mutation) {
  if (mutation.kind == "frame") {
    f.euler = [original = f.euler](std::string_view order, EulerFrame frame, const auto& halves) {
      const bool intrinsic = frame == EulerFrame::kIntrinsic;
      return original(order, intrinsic ? EulerFrame::kExtrinsic : EulerFrame::kIntrinsic, halves);
    };
    return;
  }
  spoil(f.euler, [at = number(mutation, 0), kind = mutation.kind](Quaternion<Polynomial>& q, const auto&, const auto&,
                                                                  const auto&) {
    if (kind == "exchange") {
      std::swap(q.at(at), q.at((at + 1) % 4));
    } else {
      change(q.at(at), kind);
    }
  });
}

void mutate_axis_angle(Formulas& f, const Mutation& mutation) {
  spoil(f.axis_angle, [mutation](Matrix<Polynomial>& m, const auto&, const auto&, const auto&) {
    if (mutation.kind == "transpose") {
      m = m.transposed();
    } else {
      change(m(number(mutation, 0), number(mutation, 1)), mutation.kind);
    }
  });
}

}  // namespace

Mutators rotation_mutators() {
  return {{"quaternion-matrix", mutate_quaternion_matrix},
          {"quaternion-product", mutate_quaternion_product},
          {"rotation", mutate_rotation},
          {"recursion", mutate_recursion},
          {"couplings", mutate_couplings},
          {"column-scale", mutate_column_scale},
          {"about-z", band(&Formulas::about_z)},
          {"about-y", band(&Formulas::about_y)},
          {"x90", mutate_x90},
          {"surd-entries", mutate_surd_entries},
          {"zyz-angles", mutate_zyz_angles},
          {"euler", mutate_euler},
          {"axis-angle", mutate_axis_angle}};
}

}  // namespace sh::symbolic
