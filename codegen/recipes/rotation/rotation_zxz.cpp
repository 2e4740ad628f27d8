// Rotations by turns about z and constant quarter turns; rotations about z.
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "codegen/recipes/rotation/band_matrices.hpp"
#include "codegen/recipes/rotation/euler_turns.hpp"
#include "codegen/recipes/rotation/quarter_turn.hpp"
#include "codegen/recipes/rotation/rotation.hpp"
#include "codegen/recipes/rotation/rotation_parts.hpp"
#include "symbolic/rotation/rotation.hpp"

namespace sh::codegen::recipes {
namespace {

using symbolic::Surd;

// One half of a turn about y in one band; it acts on cosines (parity 0) or sines (parity 1). It is a quarter turn, a
// turn about z of the pairs (m, -m) with l + m = parity modulo 2, and a quarter turn back.
class HalfTilt {
 public:
  HalfTilt(SignedBuilder& build, const Tilt& beta, int degree, const symbolic::Matrix<cln::cl_RA>& turn, int parity)
      : build_(build), beta_(beta), degree_(degree) {
    const int sign = parity == 0 ? 1 : -1;
    for (int m = parity; m <= degree; ++m)
      ((degree + m) % 2 == 0 ? cosine_columns_ : sine_columns_).push_back(sign * m);
    for (int m = 1; m <= degree; ++m) {
      if ((degree + m) % 2 == parity) rows_.push_back(m);
    }
    fixes_row_zero_ = degree % 2 == parity;
    std::vector<int> sine_rows = rows_;
    for (int& m : sine_rows) m = -m;
    cosines_.emplace(degree, turn, rows_, cosine_columns_);
    sines_.emplace(degree, turn, sine_rows, sine_columns_);
  }

  // The squares of scales, by the kind of number (versine, cosine) and by the order that they multiply.
  using Squares = std::map<std::pair<bool, int>, std::multiset<Surd>>;
  void count_scales(Squares& squares) const {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      squares[{fixes_row_zero_, rows_[i]}].insert(cosines_->scale(i) * cosines_->scale(i));
      squares[{false, rows_[i]}].insert(sines_->scale(i) * sines_->scale(i));
    }
  }
  void share_scales(Squares& squares) {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      cosines_->prefer_scale(i, squares[{fixes_row_zero_, rows_[i]}]);
      sines_->prefer_scale(i, squares[{false, rows_[i]}]);
    }
  }

  // v: the band, element l + m.
  void apply(std::vector<Value>& v) const {
    if (rows_.empty()) return;
    std::vector<Value> p = cosines_->forward(build_, gather(v, cosine_columns_));
    std::vector<Value> q = sines_->forward(build_, gather(v, sine_columns_));
    for (std::size_t i = 0; i < rows_.size(); ++i) turn_pair(i, p[i], q[i]);
    std::vector<Value> cosines = cosines_->backward(build_, p);
    if (fixes_row_zero_) {
      // The matrix is orthogonal, so entries without a turn need no quarter turns.
      const std::vector<Value> before = gather(v, cosine_columns_);
      for (std::size_t i = 0; i < cosines.size(); ++i) cosines[i] = build_.sum({before[i], -cosines[i]});
    }
    scatter(v, cosine_columns_, cosines);
    scatter(v, sine_columns_, sines_->backward(build_, q));
  }

 private:
  // Turns (p, q) by m beta and includes both scales of each row. If row 0 is fixed, gives p minus the turned p.
  void turn_pair(std::size_t row, Value& p, Value& q) const {
    const int m = rows_[row];
    const Surd& p_scale = cosines_->scale(row);
    const Surd& q_scale = sines_->scale(row);
    const Value pp =
        fixes_row_zero_ ? times(p_scale * p_scale, beta_.versine.at(m)) : times_cosine(p_scale * p_scale, m);
    const Value pq = times(p_scale * q_scale, beta_.sine.at(m));
    const Value qq = times_cosine(q_scale * q_scale, m);
    const Value p_of_p = build_.times(pp, p);
    const Value p_of_q = build_.times(pq, q);
    const Value q_of_p = build_.times(pq, p);
    const Value q_of_q = build_.times(qq, q);
    const std::string place = "_" + std::to_string(degree_) + "_" + std::to_string(m);
    p = build_.sum({p_of_p, fixes_row_zero_ ? p_of_q : -p_of_q}, "p" + place);
    q = build_.sum({q_of_p, q_of_q}, "q" + place);
  }

  [[nodiscard]] Value times(const Surd& factor, const Multiple& value) const {
    return build_.times(factor * value.factor, {value.node});
  }
  [[nodiscard]] Value times_cosine(const Surd& factor, int m) const {
    const auto known = beta_.cosine.find(m);
    if (known != beta_.cosine.end()) return build_.times(factor, {known->second});
    return build_.sum({{build_.constant(factor)}, -times(factor, beta_.versine.at(m))});
  }

  [[nodiscard]] std::vector<Value> gather(const std::vector<Value>& band, const std::vector<int>& orders) const {
    std::vector<Value> values;
    for (const int m : orders) values.push_back(band[degree_ + m]);
    return values;
  }
  void scatter(std::vector<Value>& band, const std::vector<int>& orders, const std::vector<Value>& values) const {
    for (std::size_t i = 0; i < orders.size(); ++i) band[degree_ + orders[i]] = values[i];
  }

  SignedBuilder& build_;
  const Tilt& beta_;
  int degree_;
  std::vector<int> cosine_columns_;
  std::vector<int> sine_columns_;
  std::vector<int> rows_;
  bool fixes_row_zero_ = false;
  std::optional<QuarterTurnClass> cosines_;
  std::optional<QuarterTurnClass> sines_;
};

// The half turns of every band from `first` on, with scales that let bands share products with cosines and sines.
std::vector<std::array<HalfTilt, 2>> half_tilts(SignedBuilder& build, const Tilt& beta, int first, int degree) {
  std::vector<std::array<HalfTilt, 2>> tilts;
  HalfTilt::Squares squares;
  for (int l = first; l <= degree; ++l) {
    const auto turn = symbolic::rotation_x90(l);
    tilts.push_back({HalfTilt(build, beta, l, turn, 0), HalfTilt(build, beta, l, turn, 1)});
  }
  for (const auto& pair : tilts) {
    for (const HalfTilt& half : pair) half.count_scales(squares);
  }
  for (auto& pair : tilts) {
    for (HalfTilt& half : pair) half.share_scales(squares);
  }
  return tilts;
}

// Bands `first` to degree.
void rotate_bands(Kernel& kernel, SignedBuilder& build, const EulerTurns& turns, const std::vector<NodeId>& c,
                  int first, int degree) {
  const auto tilts = half_tilts(build, turns.beta, first, degree);
  for (int l = first; l <= degree; ++l) {
    std::vector<Value> band = band_of(c, l);
    turn_about_z(build, turns.gamma, l, band, "v");
    for (const HalfTilt& half : tilts[l - first]) half.apply(band);
    turn_about_z(build, turns.alpha, l, band, "y");
    set_band(kernel, build, l, band);
  }
}

using Multiples = Turn (*)(SignedBuilder&, NodeId, NodeId, int);

Kernel rotate_about_z(Multiples multiples, int degree) {
  Kernel kernel = rotation_kernel(degree);
  kernel.title = "Coefficients of a function rotated about z, " + degrees_to(degree);
  kernel.domain = "cosine and sine of the angle, counter-clockwise seen from +z: cos_angle^2 + sin_angle^2 = 1";
  kernel.result =
      "c' with f'(theta, phi) = f(theta, phi - angle), at index l(l+1)+m, orthonormal basis, no Condon-Shortley phase; "
      "may be c itself";
  kernel.citation = "(c_m + i c_-m)' = e^(i m angle) (c_m + i c_-m)";
  kernel.parameters = {parameter(Role::kCosine, "cos_angle"), parameter(Role::kSine, "sin_angle"),
                       kernel.parameters[1]};
  SignedBuilder build(kernel);
  const NodeId cosine = build.input(0, "cos_angle");
  const NodeId sine = build.input(1, "sin_angle");
  const std::vector<NodeId> c = coefficient_inputs(build, 2, degree);
  kernel.outputs[0].node = c[0];
  if (degree == 0) return kernel;
  const Turn turn = multiples(build, cosine, sine, degree);
  for (int l = 1; l <= degree; ++l) {
    std::vector<Value> band = band_of(c, l);
    turn_about_z(build, turn, l, band, "y");
    set_band(kernel, build, l, band);
  }
  return kernel;
}

constexpr const char* kSource =
    "D. Pinchon, P. E. Hoggan, \"Rotation matrices for real spherical harmonics\", J. Phys. A 40, 2007; angles without "
    "a hole at the poles; constants derived exactly";

}  // namespace

Kernel rotate_zxz(int degree) {
  Kernel kernel = rotation_kernel(degree);
  kernel.citation = kSource;
  SignedBuilder build(kernel);
  const std::array<NodeId, 9> r = matrix_inputs(build);
  const std::vector<NodeId> c = coefficient_inputs(build, 9, degree);
  kernel.outputs[0].node = c[0];
  if (degree >= 1) set_band(kernel, build, 1, times(build, band_one(r), band_of(c, 1)));
  if (degree >= 2) rotate_bands(kernel, build, euler_turns(build, r, degree), c, 2, degree);
  return kernel;
}

Kernel rotate_quaternion_zxz(int degree) {
  Kernel kernel = quaternion_kernel(degree);
  kernel.citation = kSource;
  SignedBuilder build(kernel);
  const std::array<NodeId, 4> q = quaternion_inputs(build);
  const std::vector<NodeId> c = coefficient_inputs(build, 4, degree);
  kernel.outputs[0].node = c[0];
  if (degree >= 1) rotate_bands(kernel, build, euler_turns(build, q, degree), c, 1, degree);
  return kernel;
}

Kernel rotate_z_steps(int degree) { return rotate_about_z(turn_by_steps, degree); }
Kernel rotate_z_products(int degree) { return rotate_about_z(turn_by_products, degree); }

}  // namespace sh::codegen::recipes
