#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

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
  HalfTilt(Builder& build, const Tilt& beta, int degree, const symbolic::Matrix<cln::cl_RA>& turn, int parity)
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
  void apply(std::vector<Signed>& v) const {
    if (rows_.empty()) return;
    std::vector<Signed> p = cosines_->forward(build_, gather(v, cosine_columns_));
    std::vector<Signed> q = sines_->forward(build_, gather(v, sine_columns_));
    for (std::size_t i = 0; i < rows_.size(); ++i) turn_pair(i, p[i], q[i]);
    std::vector<Signed> cosines = cosines_->backward(build_, p);
    if (fixes_row_zero_) {
      // The matrix is orthogonal, so entries without a turn need no quarter turns.
      const std::vector<Signed> before = gather(v, cosine_columns_);
      for (std::size_t i = 0; i < cosines.size(); ++i) cosines[i] = sum(build_, {before[i], -cosines[i]});
    }
    scatter(v, cosine_columns_, cosines);
    scatter(v, sine_columns_, sines_->backward(build_, q));
  }

 private:
  // Turns (p, q) by m beta and includes both scales of each row. If row 0 is fixed, gives p minus the turned p.
  void turn_pair(std::size_t row, Signed& p, Signed& q) const {
    const int m = rows_[row];
    const Surd& p_scale = cosines_->scale(row);
    const Surd& q_scale = sines_->scale(row);
    const Signed pp =
        fixes_row_zero_ ? times(p_scale * p_scale, beta_.versine.at(m)) : times_cosine(p_scale * p_scale, m);
    const Signed pq = times(p_scale * q_scale, beta_.sine.at(m));
    const Signed qq = times_cosine(q_scale * q_scale, m);
    const Signed p_of_p = product(build_, pp, p);
    const Signed p_of_q = product(build_, pq, q);
    const Signed q_of_p = product(build_, pq, p);
    const Signed q_of_q = product(build_, qq, q);
    const std::string place = "_" + std::to_string(degree_) + "_" + std::to_string(m);
    p = sum(build_, {p_of_p, fixes_row_zero_ ? p_of_q : -p_of_q}, "p" + place);
    q = sum(build_, {q_of_p, q_of_q}, "q" + place);
  }

  [[nodiscard]] Signed times(const Surd& factor, const Multiple& value) const {
    return scaled(build_, factor * value.factor, {value.node});
  }
  [[nodiscard]] Signed times_cosine(const Surd& factor, int m) const {
    const auto known = beta_.cosine.find(m);
    if (known != beta_.cosine.end()) return scaled(build_, factor, {known->second});
    return sum(build_, {{build_.constant(factor)}, -times(factor, beta_.versine.at(m))});
  }

  [[nodiscard]] std::vector<Signed> gather(const std::vector<Signed>& band, const std::vector<int>& orders) const {
    std::vector<Signed> values;
    for (const int m : orders) values.push_back(band[symbolic::to_size(degree_ + m)]);
    return values;
  }
  void scatter(std::vector<Signed>& band, const std::vector<int>& orders, const std::vector<Signed>& values) const {
    for (std::size_t i = 0; i < orders.size(); ++i) band[symbolic::to_size(degree_ + orders[i])] = values[i];
  }

  Builder& build_;
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
std::vector<std::array<HalfTilt, 2>> half_tilts(Builder& build, const Tilt& beta, int first, int degree) {
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
void rotate_bands(Kernel& kernel, Builder& build, const EulerTurns& turns, const RotationInputs& in, int first,
                  int degree) {
  const auto tilts = half_tilts(build, turns.beta, first, degree);
  for (int l = first; l <= degree; ++l) {
    std::vector<Signed> band = in.band(l);
    turn_about_z(build, turns.gamma, l, band, "v");
    for (const HalfTilt& half : tilts[symbolic::to_size(l - first)]) half.apply(band);
    turn_about_z(build, turns.alpha, l, band, "y");
    set_band(kernel, build, l, band);
  }
}

constexpr const char* kSource =
    "D. Pinchon, P. E. Hoggan, \"Rotation matrices for real spherical harmonics\", J. Phys. A 40, 2007; angles without "
    "a hole at the poles; constants derived exactly";

}  // namespace

Kernel rotate_zxz(int degree) {
  Kernel kernel = rotation_kernel(degree);
  kernel.citation = kSource;
  Builder build(kernel);
  const RotationInputs in = rotation_inputs(build, degree);
  copy_band_zero(kernel, in);
  if (degree >= 1) rotate_band_one(kernel, build, in);
  if (degree >= 2) rotate_bands(kernel, build, euler_turns(build, in.r, degree), in, 2, degree);
  return kernel;
}

Kernel rotate_quaternion_zxz(int degree) {
  Kernel kernel = quaternion_kernel(degree);
  kernel.citation = kSource;
  Builder build(kernel);
  const std::array<NodeId, 4> q = quaternion_inputs(build);
  RotationInputs in;
  in.c = coefficient_inputs(build, 4, degree);
  copy_band_zero(kernel, in);
  if (degree >= 1) rotate_bands(kernel, build, euler_turns(build, q, degree), in, 1, degree);
  return kernel;
}

}  // namespace sh::codegen::recipes
