#include "codegen/recipes/euler_turns.hpp"

#include <string>

#include "symbolic/matrix.hpp"

namespace sh::codegen::recipes {
namespace {

using symbolic::Surd;
using symbolic::to_size;

// Where sin^2(beta) is below this, alpha is 0 and gamma takes the whole turn about z. Above it the square and its root
// keep all their digits in float, also where subnormal numbers count as zero; in double the tilt that is dropped is
// below 2^-51.
constexpr int kPoleExponent = -102;

// The first multiples that are doubled: alpha's second one is accurate already, and gamma's second one pays for the
// balanced form only where higher ones are made from it.
constexpr int kDoubledAlpha = 8;
constexpr int kDoubledGamma = 2;

std::string named(const char* function, int k, char angle) {
  return std::string(function) + "_" + (k == 1 ? "" : std::to_string(k)) + angle;
}

NodeId number(Builder& build, int value) {
  constexpr std::array<const char*, 3> kNames{"zero", "one", "two"};
  return build.constant(Surd(value), kNames.at(to_size(value)));
}

// Multiples of an angle about z from its first, or first and second, multiple.
class TurnBuilder {
 public:
  TurnBuilder(Builder& build, char angle, NodeId cosine, NodeId sine) : build_(build), angle_(angle) {
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

  // Powers of two from `doubled` on by doubling, which costs an operation more than a step and errs less.
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

  Builder& build_;
  char angle_;
  Turn turn_;
};

// Odd k: cos k b = cos b (2 cos (k-1)b - 2 cos (k-3)b + ... +- 1), sin k b = sin b (2 cos (k-1)b + ... + 1).
// Even k: sin = 2 s c, versine = 2 s^2 of half the angle.
Tilt tilt_multiples(Builder& build, NodeId cosine, NodeId sine, NodeId square, int most) {
  Tilt tilt{{{1, cosine}}, {{1, {Surd(1), sine}}}, {}};
  NodeId lower = -1;
  NodeId upper = -1;
  for (int k = 2; k <= most; ++k) {
    if (k % 2 == 0) {
      const Multiple half = tilt.sine.at(k / 2);
      const NodeId half_square = k == 2 ? square : build.mul(half.node, half.node);
      const NodeId product = build.mul(half.node, tilt.cosine.at(k / 2));
      tilt.sine[k] = {Surd(2) * half.factor, product};
      tilt.versine[k] = {Surd(2) * half.factor * half.factor, half_square};
      if (k == most) break;
      const NodeId versine = scaled(build, tilt.versine[k].factor, {half_square}).node;
      tilt.cosine[k] = build.sub(number(build, 1), versine, named("cos", k, 'b'));
      if (k == 2) {  // 2 cos 2b -+ 1
        lower = build.sub(tilt.cosine[k], versine);
        upper = build.add(lower, number(build, 2));
        continue;
      }
      const NodeId twice = build.add(tilt.cosine[k], tilt.cosine[k]);
      lower = build.sub(twice, lower);
      upper = build.add(twice, upper);
    } else {
      tilt.cosine[k] = build.mul(cosine, lower, named("cos", k, 'b'));
      tilt.sine[k] = {Surd(1), build.mul(sine, upper, named("sin", k, 'b'))};
    }
  }
  return tilt;
}

}  // namespace

EulerTurns euler_turns(Builder& build, const std::array<NodeId, 9>& r, int most) {
  const auto at = [&r](int row, int column) { return r[to_size(3 * row + column)]; };
  const NodeId one = number(build, 1);
  const NodeId tiny = build.constant(Surd(cln::expt(cln::cl_RA(2), kPoleExponent)), "tiny");
  const NodeId xx = build.mul(at(0, 2), at(0, 2));
  const NodeId yy = build.mul(at(1, 2), at(1, 2));
  const NodeId square = build.add(xx, yy, "sin2_b");
  const NodeId x = build.select(square, tiny, one, at(0, 2), "x");
  const NodeId y = build.select(square, tiny, number(build, 0), at(1, 2), "y");
  const NodeId length = build.select(square, tiny, one, square);
  const NodeId twice_inverse = build.div(number(build, 2), length, "inv2");
  const NodeId half = build.constant(Surd(cln::cl_RA(1) / 2), "half");
  const NodeId inverse = build.sqrt(build.mul(half, twice_inverse), "inv");
  const NodeId cos_a = build.mul(x, inverse);
  TurnBuilder alpha(build, 'a', cos_a, build.mul(y, inverse));
  const NodeId doubled = build.mul(y, twice_inverse);
  const NodeId versine = build.mul(doubled, y);
  alpha.start_from_double(versine, build.mul(doubled, x), most);
  const Turn turned = alpha.complete(most, kDoubledAlpha);

  const NodeId sin_b = build.mul(square, inverse, "sin_b");
  const NodeId cc = build.mul(at(1, 1), turned.cosine.at(1));
  const NodeId cs = build.mul(at(0, 1), turned.sine.at(1));
  const NodeId cos_g = build.sub(cc, cs);
  const NodeId sc = build.mul(at(1, 0), turned.cosine.at(1));
  const NodeId ss = build.mul(at(0, 0), turned.sine.at(1));
  TurnBuilder gamma(build, 'g', cos_g, build.sub(sc, ss));
  return {turned, tilt_multiples(build, at(2, 2), sin_b, square, most), gamma.complete(most, most == 2 ? most + 1 : kDoubledGamma)};
}

void turn_about_z(Builder& build, const Turn& turn, int degree, std::vector<Signed>& band, const std::string& name) {
  for (int m = 1; m <= degree; ++m) {
    Signed& c = band[to_size(degree + m)];
    Signed& s = band[to_size(degree - m)];
    const Signed cosine{turn.cosine.at(m)};
    const Signed sine{turn.sine.at(m)};
    const Signed cc = product(build, cosine, c);
    const Signed ss = product(build, sine, s);
    const Signed sc = product(build, sine, c);
    const Signed cs = product(build, cosine, s);
    const std::string place = name + "_" + std::to_string(degree) + "_" + std::to_string(m);
    c = sum(build, {cc, -ss}, place + "c");
    s = sum(build, {sc, cs}, place + "s");
  }
}

}  // namespace sh::codegen::recipes
