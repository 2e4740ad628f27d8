#include "codegen/recipes/rotation/euler_turns.hpp"

#include <string>
#include <utility>

#include "symbolic/number/matrix.hpp"

namespace sh::codegen::recipes {
namespace {

using symbolic::Surd;

// If sin^2(beta) is below this, gamma (for a quaternion alpha) is 0 and the other takes the whole turn about z. Above it,
// the square and its root keep all their digits in float, even if the machine flushes subnormal numbers to zero. In double
// the dropped tilt is below 2^-51.
constexpr int kPoleExponent = -102;

// The first multiples that are doubled: of the angle of (x, y), whose second multiple is already accurate, and of the other,
// where the balanced form of the second multiple is worth its operations only if higher multiples use it.
constexpr int kDoubledFirst = 8;
constexpr int kDoubledOther = 2;

std::string named(const char* function, int k, const std::string& angle) {
  return std::string(function) + "_" + (k == 1 ? "" : std::to_string(k)) + angle;
}

NodeId number(SignedBuilder& build, int value) {
  constexpr std::array<const char*, 3> kNames{"zero", "one", "two"};
  return build.constant(Surd(value), kNames.at(value));
}

// The multiples of an angle about z, from the first multiple or from the first two.
class TurnBuilder {
 public:
  TurnBuilder(SignedBuilder& build, std::string angle, NodeId cosine, NodeId sine)
      : build_(build), angle_(std::move(angle)) {
    turn_.cosine[0] = number(build, 1);
    turn_.sine[0] = number(build, 0);
    set(1, cosine, sine);
  }

  // cos 2a = 1 - versine, and cos 3a = cos a (2 cos 2a - 1), sin 3a = sin a (2 cos 2a + 1).
  void start_from_double(NodeId versine, NodeId sine, int most) {
    const NodeId cosine = build_.sub(number(build_, 1), versine);
    set(2, cosine, sine);
    if (most < 3) return;
    const NodeId lower = build_.sub(cosine, versine);
    const NodeId upper = build_.add(lower, number(build_, 2));
    const NodeId triple_cosine = build_.mul(turn_.cosine[1], lower);
    set(3, triple_cosine, build_.mul(turn_.sine[1], upper));
  }

  // (c^2 - s^2, 2 s c)
  void double_from(int half) {
    const NodeId c = turn_.cosine.at(half);
    const NodeId s = turn_.sine.at(half);
    const NodeId cc = build_.mul(c, c);
    const NodeId ss = build_.mul(s, s);
    const NodeId cosine = build_.sub(cc, ss);
    const NodeId twice = build_.add(s, s);
    set(2 * half, cosine, build_.mul(twice, c));
  }

  // e_k = 2 cos a e_(k-1) - e_(k-2)
  void step_to(int k) {
    const NodeId twice = build_.add(turn_.cosine[1], turn_.cosine[1]);
    const NodeId c = build_.mul(twice, turn_.cosine.at(k - 1));
    const NodeId cosine = build_.sub(c, turn_.cosine.at(k - 2));
    const NodeId s = build_.mul(twice, turn_.sine.at(k - 1));
    set(k, cosine, build_.sub(s, turn_.sine.at(k - 2)));
  }

  // e_i e_j
  void multiply(int i, int j) {
    const NodeId cc = build_.mul(turn_.cosine.at(i), turn_.cosine.at(j));
    const NodeId ss = build_.mul(turn_.sine.at(i), turn_.sine.at(j));
    const NodeId sc = build_.mul(turn_.sine.at(i), turn_.cosine.at(j));
    const NodeId cs = build_.mul(turn_.cosine.at(i), turn_.sine.at(j));
    const NodeId cosine = build_.sub(cc, ss);
    set(i + j, cosine, build_.add(sc, cs));
  }

  // From `doubled` on, powers of two use doubling: it needs one more operation than a step and has a smaller error.
  Turn complete(int most, int doubled) {
    for (int k = static_cast<int>(turn_.cosine.size()); k <= most; ++k) {
      const bool power_of_two = (k & (k - 1)) == 0;
      if (power_of_two && k >= doubled) {
        double_from(k / 2);
      } else {
        step_to(k);
      }
    }
    return turn_;
  }

 private:
  void set(int k, NodeId cosine, NodeId sine) {
    build_.name(cosine, named("cos", k, angle_));
    build_.name(sine, named("sin", k, angle_));
    turn_.cosine[k] = cosine;
    turn_.sine[k] = sine;
  }

  SignedBuilder& build_;
  std::string angle_;
  Turn turn_;
};

// Odd k: cos k b = cos b (2 cos (k-1)b - 2 cos (k-3)b + ... +- 1), sin k b = sin b (2 cos (k-1)b + ... + 1).
// Even k: sin = 2 s c, versine = 2 s^2 of half the angle. square: sin^2 b. The factor of the sine is 1 or -1.
Tilt tilt_multiples(SignedBuilder& build, NodeId cosine, const Multiple& sine, const Multiple& square, int most) {
  Tilt tilt{{{1, cosine}}, {{1, sine}}, {}};
  NodeId lower = -1;
  NodeId upper = -1;
  for (int k = 2; k <= most; ++k) {
    if (k % 2 == 0) {
      const Multiple half = tilt.sine.at(k / 2);
      const Multiple half_square =
          k == 2 ? square : Multiple{half.factor * half.factor, build.mul(half.node, half.node)};
      const NodeId product = build.mul(half.node, tilt.cosine.at(k / 2));
      tilt.sine[k] = {Surd(2) * half.factor, product};
      tilt.versine[k] = {Surd(2) * half_square.factor, half_square.node};
      if (k == most) break;
      const NodeId versine = build.times(tilt.versine[k].factor, {half_square.node}).node;
      tilt.cosine[k] = build.sub(number(build, 1), versine, named("cos", k, "b"));
      if (k == 2) {  // 2 cos 2b -+ 1
        lower = build.sub(tilt.cosine[k], versine);
        upper = build.add(lower, number(build, 2));
        continue;
      }
      const NodeId twice = build.add(tilt.cosine[k], tilt.cosine[k]);
      lower = build.sub(twice, lower);
      upper = build.add(twice, upper);
    } else {
      tilt.cosine[k] = build.mul(cosine, lower, named("cos", k, "b"));
      tilt.sine[k] = {sine.factor, build.mul(sine.node, upper, named("sin", k, "b"))};
    }
  }
  return tilt;
}

struct Inverse {
  NodeId square;  // 1 / square
  NodeId root;    // 1 / sqrt(square)
};

Inverse inverse_of(SignedBuilder& build, NodeId square) {
  const NodeId inverse = build.div(number(build, 1), square, "inv_sq");
  return {inverse, build.sqrt(inverse, "inv")};
}

// Multiples of the angle of (x, y); inverse: of x^2 + y^2.
Turn turn_of(SignedBuilder& build, const std::string& angle, NodeId x, NodeId y, const Inverse& inverse, int most) {
  const NodeId cosine = build.mul(x, inverse.root);
  TurnBuilder turn(build, angle, cosine, build.mul(y, inverse.root));
  if (most < 2) return turn.complete(most, kDoubledFirst);
  const NodeId twice = build.add(inverse.square, inverse.square);
  const NodeId doubled = build.mul(y, twice);
  const NodeId versine = build.mul(doubled, y);
  turn.start_from_double(versine, build.mul(doubled, x), most);
  return turn.complete(most, kDoubledFirst);
}

NodeId tiny_number(SignedBuilder& build) {
  return build.constant(Surd(cln::expt(cln::cl_RA(2), kPoleExponent)), "tiny");
}

}  // namespace

// With beta = -b, (r20, r21) = sin b (cos gamma, -sin gamma): the angle of that is ng, minus gamma. So the turn about z that
// comes first needs no other angle, and alpha follows from gamma.
EulerTurns euler_turns(SignedBuilder& build, const std::array<NodeId, 9>& r, int most) {
  const auto at = [&r](int row, int column) { return r[3 * row + column]; };
  const NodeId xx = build.mul(at(2, 0), at(2, 0));
  const NodeId yy = build.mul(at(2, 1), at(2, 1));
  const NodeId square = build.add(xx, yy, "sin2_b");
  const NodeId tiny = tiny_number(build);
  const NodeId x = build.select(square, tiny, number(build, 1), at(2, 0), "x");
  const NodeId y = build.select(square, tiny, number(build, 0), at(2, 1), "y");
  const Inverse inverse = inverse_of(build, build.select(square, tiny, number(build, 1), square));
  Turn gamma = turn_of(build, "ng", x, y, inverse, most);
  gamma.backwards = true;
  const NodeId sin_b = build.mul(square, inverse.root, "sin_b");
  const NodeId cc = build.mul(at(1, 1), gamma.cosine.at(1));
  const NodeId cs = build.mul(at(1, 0), gamma.sine.at(1));
  const NodeId sc = build.mul(at(0, 1), gamma.cosine.at(1));
  const NodeId ss = build.mul(at(0, 0), gamma.sine.at(1));
  const NodeId cos_a = build.sub(cc, cs);
  TurnBuilder alpha(build, "a", cos_a, build.sub(ss, sc));
  return {alpha.complete(most, most == 2 ? most + 1 : kDoubledOther),
          tilt_multiples(build, at(2, 2), {Surd(-1), sin_b}, {Surd(1), square}, most), gamma};
}

EulerTurns euler_turns(SignedBuilder& build, const std::array<NodeId, 4>& q, int most) {
  const auto& [w, x, y, z] = q;
  const NodeId ww = build.mul(w, w);
  const NodeId zz = build.mul(z, z);
  const NodeId xx = build.mul(x, x);
  const NodeId yy = build.mul(y, y);
  const NodeId aa = build.add(ww, zz, "aa");
  const NodeId bb = build.add(xx, yy, "bb");
  const NodeId tiny = tiny_number(build);
  const NodeId one = number(build, 1);
  const NodeId zero = number(build, 0);
  const NodeId a_re = build.select(aa, tiny, one, w, "a_re");
  const NodeId a_im = build.select(aa, tiny, zero, z, "a_im");
  const NodeId b_re = build.select(bb, tiny, one, y, "b_re");
  const NodeId b_im = build.select(bb, tiny, zero, x, "b_im");  // of conj(b)
  const NodeId a_square = build.select(aa, tiny, one, aa);
  const NodeId b_square = build.select(bb, tiny, one, bb);
  const Inverse inverse = inverse_of(build, build.mul(a_square, b_square));
  const NodeId rr = build.mul(a_re, b_re);
  const NodeId ii = build.mul(a_im, b_im);
  const NodeId ir = build.mul(a_im, b_re);
  const NodeId ri = build.mul(a_re, b_im);
  const NodeId alpha_re = build.add(rr, ii);
  const Turn alpha = turn_of(build, "a", alpha_re, build.sub(ir, ri), inverse, most);
  const NodeId gamma_re = build.sub(rr, ii);
  const Turn gamma = turn_of(build, "g", gamma_re, build.add(ir, ri), inverse, most);
  const NodeId square = build.mul(aa, bb);
  const NodeId half_sine = build.mul(square, inverse.root);
  const NodeId sin_b = build.add(half_sine, half_sine, "sin_b");
  return {alpha, tilt_multiples(build, build.sub(aa, bb, "cos_b"), {Surd(1), sin_b}, {Surd(4), square}, most), gamma};
}

Turn turn_by_steps(SignedBuilder& build, NodeId cosine, NodeId sine, int most) {
  return TurnBuilder(build, "a", cosine, sine).complete(most, most + 1);
}

Turn turn_by_products(SignedBuilder& build, NodeId cosine, NodeId sine, int most) {
  TurnBuilder turn(build, "a", cosine, sine);
  for (int k = 2; k <= most; ++k) {
    if (k % 2 == 0) {
      turn.double_from(k / 2);
    } else {
      turn.multiply(k / 2, k - k / 2);
    }
  }
  return turn.complete(most, most + 1);
}

void turn_about_z(SignedBuilder& build, const Turn& turn, int degree, std::vector<Value>& band,
                  const std::string& name) {
  for (int m = 1; m <= degree; ++m) {
    Value& c = band[degree + m];
    Value& s = band[degree - m];
    const Value cosine{turn.cosine.at(m)};
    const Value sine{turn.sine.at(m), turn.backwards};
    const Value cc = build.times(cosine, c);
    const Value ss = build.times(sine, s);
    const Value sc = build.times(sine, c);
    const Value cs = build.times(cosine, s);
    const std::string place = name + "_" + std::to_string(degree) + "_" + std::to_string(m);
    c = build.sum({cc, -ss}, place + "c");
    s = build.sum({sc, cs}, place + "s");
  }
}

}  // namespace sh::codegen::recipes
