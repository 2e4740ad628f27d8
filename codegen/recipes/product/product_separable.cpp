// Recipe: the product of two functions by quadrature, split by parity in z and by a discrete Fourier transform in phi.
//
// The kernel evaluates both factors on rings of constant z (codegen/recipes/product/ring_quadrature.hpp), multiplies
// them there, and integrates the product against the basis. On a pair of rings +-z, the parts even and odd in z,
//     E_m = sum over even l+m of theta_lm a_lm,   O_m = sum over odd l+m,
// give the coefficients E +- O of a trigonometric polynomial in phi on each ring. The kernel samples the polynomials at
// M angles by parity (codegen/recipes/product/phi_transform.hpp), multiplies the samples like the group Z2 x Z2, and
// applies the transposed maps. M may be smaller than the degrees require: then a few frequencies k = M - q alias to q,
// and the kernel subtracts them. The quadrature is exact for the product of three functions, so the result is exact.
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "codegen/recipes/product/phi_transform.hpp"
#include "codegen/recipes/product/product.hpp"
#include "codegen/recipes/product/ring_factor.hpp"
#include "symbolic/product/gaunt.hpp"

namespace sh::codegen::recipes {
namespace {

using symbolic::Surd;
using Samples = PhiTransform::Samples;
using Coefficients = PhiTransform::Coefficients;
using Parts = std::array<Value, kParts>;

std::string named(const char* letter, int ring, int order, const char* suffix) {
  return letter + std::to_string(ring + 1) + (order < 0 ? "s" : "c") + std::to_string(std::abs(order)) + suffix;
}

class Separable {
 public:
  Separable(Kernel& kernel, const ProductShape& shape, Factors factors, SampleProduct sample_product,
            const SeparablePlan& plan)
      : kernel_(kernel),
        build_(kernel),
        shape_(shape),
        same_(factors == Factors::kSame),
        halves_(sample_product == SampleProduct::kHalves && !same_),
        angles_(plan.angles),
        looped_(plan.looped && plan.rings.pairs > 1),
        quadrature_(plan.rings),
        factors_(kernel, quadrature_, looped_),
        sums_(coefficient_count(shape.result)) {}

  void run() {
    const auto [a, b] = factor_inputs(build_, shape_, same_ ? Factors::kSame : Factors::kTwo);
    for (int ring = 0; ring < quadrature_.count(); ++ring) {
      if (quadrature_.is_pole(ring)) {
        poles(ring, a, b);
      } else if (!looped_ || ring == 0 || quadrature_.is_equator(ring)) {
        ring_or_pair(ring, a, b);
      }
    }
    for (int i = 0; i < coefficient_count(shape_.result); ++i) {
      kernel_.outputs[i].node = build_.node(build_.sum(sums_[i]));
    }
  }

 private:
  // The even and the odd part in z of one order: E, and O as a sum times a constant.
  struct Halves {
    Value even;
    Value odd;
  };

  Value scaled(const Factor& factor, Value value) { return factors_.scaled(build_, factor, value); }

  // scale: a constant that multiplies all products.
  Halves synthesize(const std::vector<Value>& c, int degree, int order, int ring, const ExactReal& scale) {
    const int m = std::abs(order);
    std::vector<Value> even;
    std::vector<std::pair<Factor, Value>> odd;
    for (int l = m; l <= degree; ++l) {
      const Value value = c[coefficient_index(l, order)];
      const Factor factor = factors_.theta(l, m, ring);
      if ((l - m) % 2 == 0) {
        even.push_back(scaled(times(factor, scale), value));
      } else if (!is_zero(factor[0]) && !value.is_zero()) {
        odd.emplace_back(factor, value);
      }
    }
    return {build_.sum(even), scaled_sum(odd, scale)};
  }

  // The largest constant is a common factor. It multiplies the sum when the sum is added to E and subtracted from it.
  Value scaled_sum(const std::vector<std::pair<Factor, Value>>& terms, const ExactReal& scale) {
    if (terms.empty()) return {};
    const auto largest = std::max_element(terms.begin(), terms.end(), [](const auto& x, const auto& y) {
      return smallest_size(x.first) < smallest_size(y.first) * (1 - 1e-9);
    });
    std::vector<Value> values;
    for (auto term = terms.begin(); term != terms.end(); ++term) {
      values.push_back(term == largest ? term->second : scaled(quotient(term->first, largest->first), term->second));
    }
    return scaled(times(largest->first, scale), build_.sum(values));
  }

  void poles(int ring, const std::vector<Value>& a, const std::vector<Value>& b) {
    const Halves of_a = synthesize(a, shape_.a, 0, ring, Surd(1));
    const Halves of_b = same_ ? of_a : synthesize(b, shape_.b, 0, ring, Surd(1));
    const Value north_a = build_.plus(of_a.even, of_a.odd);
    const Value south_a = build_.minus(of_a.even, of_a.odd);
    const Value north = build_.times(north_a, same_ ? north_a : build_.plus(of_b.even, of_b.odd));
    const Value south = build_.times(south_a, same_ ? south_a : build_.minus(of_b.even, of_b.odd));
    collect(0, ring, {build_.plus(north, south), build_.minus(north, south)},
            times({Surd::square_root(4, 2)}, factors_.weight(ring)));
  }

  // c_lm += weight theta_lm (E or O)
  void collect(int order, int ring, const Halves& halves, const Factor& weight) {
    const int m = std::abs(order);
    for (int l = m; l <= shape_.result; ++l) {
      const Value half = (l - m) % 2 == 0 ? halves.even : halves.odd;
      const Value term = scaled(times(weight, factors_.theta(l, m, ring)), half);
      if (term.is_zero()) continue;
      sums_[coefficient_index(l, order)].push_back(weight.size() > 1 ? build_.row_sum(term) : term);
    }
  }

  // The frequencies k = M - q above the result's that sampling cannot tell from q.
  [[nodiscard]] bool aliased(int q) const { return q > 0 && angles_ - q <= shape_.a + shape_.b; }

  // True if the aliased frequency has the same coefficients on both rings.
  [[nodiscard]] bool shared_alias(int q, int rings) const { return rings == 2 && angles_ - q == shape_.a + shape_.b; }

  [[nodiscard]] std::vector<std::pair<int, int>> orders_adding_to(int k) const {
    std::vector<std::pair<int, int>> orders;
    for (int m = std::max(0, k - shape_.b); m <= std::min(k, shape_.a); ++m) orders.emplace_back(m, k - m);
    return orders;
  }

  // The contribution of an aliased frequency in units of S_q: M/16, twice as much for doubled samples, half as much if
  // the square leaves out a factor of two.
  [[nodiscard]] ExactReal alias_factor(int order) const {
    cln::cl_RA factor = cln::cl_RA(angles_) / 16;
    if (halves_) factor = 2 * factor;
    if (same_ && part_of(order) != 0) factor = factor / 2;
    return Surd(factor);
  }

  const PhiTransform& transform(int degree, int rings, bool back) {
    const std::tuple key(degree, rings, back);
    const auto known = transforms_.find(key);
    if (known != transforms_.end()) return known->second;
    PhiShape shape{degree, angles_, rings, back && !halves_, {}, {}, false};
    for (int q = 1; q <= shape_.result; ++q) {
      if (!aliased(q)) continue;
      if (!back) {
        for (const auto& [m, n] : orders_adding_to(angles_ - q)) shape.unscaled.insert(shape.unscaled.end(), {m, n});
        continue;
      }
      const bool once = shared_alias(q, rings);
      for (const int order : {q, -q}) {
        const ExactReal factor = alias_factor(order);
        shape.preferred[order] = {once ? multiply(factor, Surd(2)) : factor, once ? 1 : rings};
      }
    }
    return transforms_.emplace(key, PhiTransform(shape)).first->second;
  }

  // The coefficients of a factor on a pair of rings or on the equator, by ring and order.
  Coefficients rings_of(const std::vector<Value>& c, int degree, int ring, const PhiTransform& phi,
                        const char* letter) {
    const bool pair = !quadrature_.is_equator(ring);
    Coefficients result(pair ? 2 : 1, std::vector<Value>(2 * degree + 1));
    for (int order = -degree; order <= degree; ++order) {
      const auto at = order + degree;
      const Halves halves = synthesize(c, degree, order, ring, phi.scale(order));
      result[0][at] = build_.named(build_.plus(halves.even, halves.odd), named(letter, ring, order, "n"));
      if (!pair) continue;
      result[1][at] = phi.shared(order)
                          ? result[0][at]
                          : build_.named(build_.minus(halves.even, halves.odd), named(letter, ring, order, "s"));
    }
    return result;
  }

  Parts product(const Parts& a, const Parts& b, bool end) {
    if (halves_ && !end) return product_by_halves(a, b);
    Parts result;
    for (int r = 0; r < kParts; ++r) {
      std::vector<Value> terms;
      for (int p = 0; p < kParts; ++p) {
        if (!same_ || p <= (p ^ r)) terms.push_back(build_.times(a[p], b[p ^ r]));
      }
      result[r] = build_.sum(terms);
    }
    return result;
  }

  // The sums and the differences of parts p and p + 2 multiply separately.
  Parts product_by_halves(const Parts& a, const Parts& b) {
    const auto half = [&](bool minus) {
      const auto of = [&](const Parts& f, int p) {
        return minus ? build_.minus(f[p], f[p + 2]) : build_.plus(f[p], f[p + 2]);
      };
      const Value ac = of(a, 0);
      const Value as = of(a, 1);
      const Value bc = of(b, 0);
      const Value bs = of(b, 1);
      const Value cc = build_.times(ac, bc);
      const Value ss = build_.times(as, bs);
      const Value cs = build_.times(ac, bs);
      const Value sc = build_.times(as, bc);
      const Value cosines = build_.plus(cc, ss);
      return std::array{cosines, build_.plus(cs, sc)};
    };
    const std::array plus = half(false);
    const std::array minus = half(true);
    Parts result;
    for (int p = 0; p < 2; ++p) {
      result[p] = build_.plus(plus[p], minus[p]);
      result[p + 2] = build_.minus(plus[p], minus[p]);
    }
    return result;
  }

  // The cosine and sine coefficients of frequency k in the product of two trigonometric polynomials, times 2.
  std::pair<Value, Value> frequency(int k, const std::vector<Value>& a, const std::vector<Value>& b) {
    const auto of = [](const std::vector<Value>& f, int degree, int order) { return f[order + degree]; };
    std::vector<Value> cosines;
    std::vector<Value> sines;
    for (const auto& [m, n] : orders_adding_to(k)) {
      if (same_ && m > n) continue;
      const Value ac = of(a, shape_.a, m);
      const Value bc = of(b, shape_.b, n);
      const Value as = m == 0 ? Value{} : of(a, shape_.a, -m);
      const Value bs = n == 0 ? Value{} : of(b, shape_.b, -n);
      const Value ss = build_.times(as, bs), cc = build_.times(ac, bc);
      Value c = build_.minus(cc, ss);
      Value s = build_.times(as, bc);
      s = same_ && m == n ? build_.plus(s, s) : build_.plus(s, build_.times(ac, bs));
      if (m == 0 || n == 0 || (same_ && m != n)) {
        c = build_.times(Surd(2), c);
        s = build_.times(Surd(2), s);
      }
      cosines.push_back(c);
      sines.push_back(s);
    }
    return {build_.sum(cosines), build_.sum(sines)};
  }

  void ring_or_pair(int ring, const std::vector<Value>& a, const std::vector<Value>& b) {
    const int rings = quadrature_.is_equator(ring) ? 1 : 2;
    const PhiTransform& phi_a = transform(shape_.a, rings, false);
    const PhiTransform& phi_b = transform(shape_.b, rings, false);
    const PhiTransform& phi_c = transform(shape_.result, rings, true);
    const Coefficients on_a = rings_of(a, shape_.a, ring, phi_a, "a");
    const Coefficients on_b = same_ ? on_a : rings_of(b, shape_.b, ring, phi_b, "b");
    const Samples of_a = phi_a.sample(build_, on_a);
    const Samples of_b = same_ ? of_a : phi_b.sample(build_, on_b);
    Samples products = of_a;
    for (std::size_t r = 0; r < products.size(); ++r) {
      for (std::size_t j = 0; j < products[r].size(); ++j) {
        products[r][j] = product(of_a[r][j], of_b[r][j], j == 0 || j + 1 == products[r].size());
      }
    }
    Coefficients sums = phi_c.analyze(build_, products);
    const std::vector<Halves> halves = without_aliases(sums, on_a, on_b, phi_c);
    for (int order = -shape_.result; order <= shape_.result; ++order) {
      // 8 pi / M, half of it for doubled samples; the square leaves out a factor of two in three of the parts.
      cln::cl_RA factor = cln::cl_RA(halves_ ? 4 : 8) / angles_;
      if (same_ && part_of(order) != 0) factor = 2 * factor;
      const ExactReal same_on_all = multiply(Surd(factor) * Surd::square_root(1, 2), phi_c.scale(order));
      collect(order, ring, halves[order + shape_.result], times(factors_.weight(ring), same_on_all));
    }
  }

  // Subtracts the contribution of aliases from the sums over the angles, and splits the sums by parity in z.
  std::vector<Halves> without_aliases(Coefficients& sums, const Coefficients& a, const Coefficients& b,
                                      const PhiTransform& phi) {
    const int rings = static_cast<int>(a.size());
    std::vector<Value> on_both(sums[0].size());
    for (int q = 1; q <= shape_.result; ++q) {
      if (!aliased(q)) continue;
      const bool once = shared_alias(q, rings);
      for (int r = 0; r < (once ? 1 : rings); ++r) {
        const auto [c, s] = frequency(angles_ - q, a[r], b[r]);
        for (const int order : {q, -q}) {
          const ExactReal factor = multiply(alias_factor(order), reciprocal(phi.scale(order)));
          // cos k phi aliases to cos q phi, sin k phi to -sin q phi.
          const Value alias = build_.times(once ? multiply(factor, Surd(2)) : factor, order < 0 ? s : -c);
          Value& sum = once ? on_both[order + shape_.result] : sums[phi.shared(q) ? 0 : r][order + shape_.result];
          sum = build_.plus(sum, alias);
        }
      }
    }
    std::vector<Halves> halves;
    for (int order = -shape_.result; order <= shape_.result; ++order) {
      const int at = order + shape_.result;
      Halves half{sums[0][at], {}};
      if (rings == 2 && !phi.shared(order)) {
        half = {build_.plus(sums[0][at], sums[1][at]), build_.minus(sums[0][at], sums[1][at])};
      }
      half.even = build_.plus(half.even, on_both[at]);
      halves.push_back(half);
    }
    return halves;
  }

  Kernel& kernel_;
  SignedBuilder build_;
  ProductShape shape_;
  bool same_;
  bool halves_;
  int angles_;
  bool looped_;
  RingQuadrature quadrature_;
  RingFactors factors_;
  std::vector<std::vector<Value>> sums_;                           // terms of every coefficient of the result
  std::map<std::tuple<int, int, bool>, PhiTransform> transforms_;  // by degree, number of rings, direction
};

}  // namespace

Kernel product_separable(const ProductShape& shape, Factors factors, SampleProduct sample_product,
                         const SeparablePlan& plan) {
  Kernel kernel = product_frame(shape, factors);
  kernel.citation =
      "quadrature on rings of constant z (Gauss, Radau or Lobatto; M. Abramowitz, I. Stegun, 1964, 25.4), split by "
      "parity; w, z, theta_l_m = Y_lm / cos(m phi) derived exactly; " +
      RingQuadrature(plan.rings).definition();
  Separable(kernel, shape, factors, sample_product, plan).run();
  return kernel;
}

Kernel product_separable(const ProductShape& shape, Factors factors, SampleProduct sample_product, bool looped) {
  SeparablePlan plan = separable_plan(shape, factors, sample_product);
  plan.looped = looped;
  return product_separable(shape, factors, sample_product, plan);
}

}  // namespace sh::codegen::recipes
