#include "symbolic/errata/vocabulary.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <utility>

#include "symbolic/errata/definitions.hpp"

namespace sh::symbolic::errata {
namespace {

using GiNaC::ex;
using GiNaC::exvector;

constexpr const char* kIndices[] = {"i", "j", "k", "l", "m", "n", "q"};
constexpr const char* kVariables[] = {"x",  "y",  "z", "c", "s", "cp", "sp", "ca", "sa", "cb", "sb", "cg", "sg",
                                      "ch", "sh", "a", "b", "t", "u",  "v",  "w",  "r",  "tx", "ty", "tz", "rho"};

bool is_index(const ex& e) {
  return std::any_of(std::begin(kIndices), std::end(kIndices),
                     [&](const char* name) { return e.is_equal(symbol(name)); });
}
bool has_index(const ex& e) { return std::any_of(e.preorder_begin(), e.preorder_end(), is_index); }

int integer(const ex& e) {
  if (!e.info(GiNaC::info_flags::integer)) throw std::invalid_argument("expected an integer index");
  return GiNaC::ex_to<GiNaC::numeric>(e).to_int();
}
unsigned axis_of(const ex& index) { return static_cast<unsigned>((integer(index) + 2) % 3); }

ex associated_legendre(const exvector& a) { return legendre(integer(a[0]), integer(a[1])); }
ex real_basis(const exvector& a) { return real_harmonic(integer(a[0]), integer(a[1])); }
ex complex_basis(const exvector& a) { return complex_harmonic(integer(a[0]), integer(a[1])); }
ex cosm(const exvector& a) { return multiple(integer(a[0]), a[1], a[2], false); }
ex sinm(const exvector& a) { return multiple(integer(a[0]), a[1], a[2], true); }
ex cap(const exvector& a) { return cap_integral(a[0], a[1]); }
ex at(const exvector& a) { return a[0].subs(a[1] == a[2]); }
ex dir(const exvector& a) { return direction(a[0], a[1], a[2], a[3]); }
ex integral(const exvector& a) { return polynomial_integral(a[0], a[1], a[2], a[3]); }
ex diffn(const exvector& a) {
  return a[0].diff(GiNaC::ex_to<GiNaC::symbol>(a[1]), static_cast<unsigned>(integer(a[2])));
}
ex sum(const exvector& a) {
  ex total = 0;
  for (int k = integer(a[2]); k <= integer(a[3]); ++k) total += a[0].subs(a[1] == k);
  return total;
}
ex prod(const exvector& a) {
  ex total = 1;
  for (int k = integer(a[2]); k <= integer(a[3]); ++k) total *= a[0].subs(a[1] == k);
  return total;
}
ex delta(const exvector& a) { return integer(a[0]) == integer(a[1]) ? 1 : 0; }
ex odd(const exvector& a) { return GiNaC::doublefactorial(integer(a[0])); }
ex turned(const exvector& a) { return turned_by(a[0], sample_rotation()); }
ex turned_back(const exvector& a) { return turned_by(a[0], sample_rotation().transpose()); }
ex rotation_entry(const exvector& a) { return sample_rotation()(axis_of(a[0]), axis_of(a[1])); }
ex real_entry(const exvector& a) { return real_rotation(integer(a[0]), integer(a[1]), integer(a[2])); }
ex complex_entry(const exvector& a) { return complex_rotation(integer(a[0]), integer(a[1]), integer(a[2])); }
ex real_part_of_entry(const exvector& a) { return complex_entry(a).real_part(); }
ex imaginary_part_of_entry(const exvector& a) { return complex_entry(a).imag_part(); }
ex small_d(const exvector& a) { return wigner_small_d(integer(a[0]), integer(a[1]), integer(a[2])); }

ex ivanic_ruedenberg_p(const exvector& a) {
  const int n = integer(a[2]);
  const int l = integer(a[3]);
  const auto r = [&](int j) { return rotation_entry({a[0], j}); };
  const auto below = [&](int column) { return real_entry({l - 1, a[1], column}); };
  if (n == l) return r(1) * below(l - 1) - r(-1) * below(1 - l);
  if (n == -l) return r(1) * below(1 - l) + r(-1) * below(l - 1);
  return r(0) * below(n);
}

ex green_legendre(const exvector& a) {
  const int l = integer(a[0]);
  const int m = integer(a[1]);
  const ex& x = symbol("c");
  ex pmm = 1;
  for (int i = 1; i <= m; ++i) pmm *= -(2 * i - 1) * symbol("s");
  if (l == m) return pmm;
  ex pmmp1 = x * (2 * m + 1) * pmm;
  if (l == m + 1) return pmmp1;
  ex pll = 0;
  for (int ll = m + 2; ll <= l; ++ll) {
    pll = ((2 * ll - 1) * x * pmmp1 - (ll + m - 1) * pmm) / (ll - m);
    pmm = pmmp1;
    pmmp1 = pll.expand();
  }
  return pll;
}

// Words whose meaning other words give. A parameter is a symbol; k stands for a function on the sphere.
struct Definition {
  const char* name;
  std::vector<const char*> parameters;
  const char* meaning;
};
const std::array<Definition, 18>& definitions() {
  static const std::array<Definition, 18> kDefinitions{{
      {"polar", {"k"}, "dir(k,s*cp,s*sp,c)"},
      {"sphere", {"k"}, "cap(k,-1)"},
      {"octa", {"k"}, "dir(k,1,0,0)+dir(k,-1,0,0)+dir(k,0,1,0)+dir(k,0,-1,0)+dir(k,0,0,1)+dir(k,0,0,-1)"},
      {"rotx", {"k", "c", "s"}, "dir(k,x,c*y-s*z,s*y+c*z)"},
      {"roty", {"k", "c", "s"}, "dir(k,c*x+s*z,y,c*z-s*x)"},
      {"rotz", {"k", "c", "s"}, "dir(k,c*x-s*y,s*x+c*y,z)"},
      {"db", {"l", "m", "n"}, "at(at(d(l,m,n),ch,cos_h),sh,sin_h)"},
      {"K", {"l", "m"}, "sqrt((2*l+1)/(4*Pi)*factorial(l-m)/factorial(l+m))"},
      {"Phi", {"m", "c", "s"}, "sqrt(2-delta(m,0))*((1+csgn(2*m+1))*cosm(m,c,s)+(1-csgn(2*m+1))*sinm(-m,c,s))/2"},
      {"A", {"l"}, "sqrt(4*Pi/(2*l+1))*cap(z*Y(l,0),0)"},
      {"lambert", {"n"}, "sum((2*l+1)/2*integral(c,0,1,c*P(l,0))*P(l,0),l,0,n)"},
      {"IRd", {"l", "n"}, "(l+n)*(l-n)+2*l*(2*l-1)*delta(abs(n),l)"},
      {"IRu", {"l", "m", "n"}, "sqrt((l+m)*(l-m)/IRd(l,n))"},
      {"IRv", {"l", "m", "n"}, "(1-2*delta(m,0))/2*sqrt((1+delta(m,0))*(l+abs(m)-1)*(l+abs(m))/IRd(l,n))"},
      {"IRw", {"l", "m", "n"}, "-(1-delta(m,0))/2*sqrt((l-abs(m)-1)*(l-abs(m))/IRd(l,n))"},
      {"CHa", {"m"}, "sqrt(1+delta(m,0))*(-1)^((abs(m)+m)/2)"},
      {"CHb", {"m"}, "csgn(m)*(-1)^((abs(m)+m)/2)"},
      {"greenLight",
       {"l", "m"},
       "2*Pi*(integral(c,4/5,1,(5*c-4)*P(l,0))*dir(Y(l,m),0,0,1)"
       "+integral(c,3/4,1,(4*c-3)*P(l,0))*dir(Y(l,m),cos(5/2),sin(5/2),0))"},
  }};
  return kDefinitions;
}

template <std::size_t I>
ex defined(const exvector& a) {
  const Definition& word = definitions()[I];
  static const ex meaning = GiNaC::parser(symbols())(word.meaning);
  GiNaC::exmap values;
  for (std::size_t i = 0; i < a.size(); ++i) values[symbol(word.parameters[i])] = a[i];
  return meaning.subs(values);
}

// A function of GiNaC that stands unevaluated while an index has no value. Sums and products bind one of their own.
template <ex (*Word)(const exvector&)>
struct Registered {
  static ex eval(const exvector& arguments) {
    const auto first = arguments.begin() + (Word == sum || Word == prod ? 2 : 0);
    const bool waits = std::any_of(first, arguments.end(), has_index);
    return waits ? ex(GiNaC::function(serial, arguments).hold()) : Word(arguments);
  }
  static unsigned enter(const char* name, unsigned count) {
    return serial = GiNaC::function::register_new(GiNaC::function_options(name, count).eval_func(eval));
  }
  static inline unsigned serial = 0;
};

// Before main, because GiNaC's parser knows the functions that are registered when it is first used.
const std::array kRegistered{
    Registered<associated_legendre>::enter("P", 2),
    Registered<real_basis>::enter("Y", 2),
    Registered<complex_basis>::enter("Yc", 2),
    Registered<cosm>::enter("cosm", 3),
    Registered<sinm>::enter("sinm", 3),
    Registered<cap>::enter("cap", 2),
    Registered<at>::enter("at", 3),
    Registered<dir>::enter("dir", 4),
    Registered<integral>::enter("integral", 4),
    Registered<diffn>::enter("diffn", 3),
    Registered<sum>::enter("sum", 4),
    Registered<prod>::enter("prod", 4),
    Registered<delta>::enter("delta", 2),
    Registered<odd>::enter("odd", 1),
    Registered<turned>::enter("turned", 1),
    Registered<rotation_entry>::enter("R", 2),
    Registered<turned_back>::enter("turned_back", 1),
    Registered<real_entry>::enter("D", 3),
    Registered<complex_entry>::enter("C", 3),
    Registered<real_part_of_entry>::enter("ReC", 3),
    Registered<imaginary_part_of_entry>::enter("ImC", 3),
    Registered<small_d>::enter("d", 3),
    Registered<ivanic_ruedenberg_p>::enter("IRP", 4),
    Registered<green_legendre>::enter("greenP", 2),
};

template <std::size_t... I>
std::array<unsigned, sizeof...(I)> enter_definitions(std::index_sequence<I...> /*places*/) {
  return {Registered<defined<I>>::enter(definitions()[I].name,
                                        static_cast<unsigned>(definitions()[I].parameters.size()))...};
}
const auto kDefined = enter_definitions(std::make_index_sequence<18>());

GiNaC::symtab make_symbols() {
  GiNaC::symtab table;
  for (const char* const name : kIndices) table[name] = GiNaC::realsymbol(name);
  for (const char* const name : kVariables) table[name] = GiNaC::realsymbol(name);
  table["cos_h"] = half_cosine(1);
  table["sin_h"] = half_sine(1);
  for (const auto& [letter, angle] : {std::pair{"a", 0}, std::pair{"b", 1}, std::pair{"g", 2}}) {
    table[std::string("cos_") + letter] = whole_cosine(angle);
    table[std::string("sin_") + letter] = whole_sine(angle);
  }
  return table;
}

}  // namespace

const GiNaC::symtab& symbols() {
  static const GiNaC::symtab table = make_symbols();
  return table;
}

const ex& symbol(const char* name) { return symbols().at(name); }

}  // namespace sh::symbolic::errata
