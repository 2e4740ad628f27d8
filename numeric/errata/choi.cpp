// CH: [ChoiIvanicGordonRuedenberg99].
#include "numeric/errata/parts.hpp"

namespace sh::errata {

std::vector<Entry> choi() {
  return {
      {.place = {"CH-01", "Eqs. 5.4, 5.5: D^1 from R"},
       .printed = "D_{-1,-1} = (Ryy+Rxx + i(Ryx-Rxy))/2; D_{0,-1} = (Rzx - i Rzy)/sqrt2; D_{1,-1} = (Ryy-Rxx + "
                  "i(Ryx+Rxy))/2; D_{-1,0} = (Rxz + i Ryz)/sqrt2; D_{0,0} = Rzz; D_{1,0} = (-Rxz + i Ryz)/sqrt2; "
                  "D_{m,1} = (-1)^{m+1} conj D_{-m,-1}",
       .readings = {holds(
           "C(1,-1,-1) == (R(-1,-1)+R(1,1)+I*(R(-1,1)-R(1,-1)))/2; C(1,0,-1) == (R(0,1)-I*R(0,-1))/sqrt(2); C(1,1,-1) "
           "== (R(-1,-1)-R(1,1)+I*(R(-1,1)+R(1,-1)))/2; C(1,-1,0) == (R(1,0)+I*R(-1,0))/sqrt(2); C(1,0,0) == R(0,0); "
           "C(1,1,0) == (-R(1,0)+I*R(-1,0))/sqrt(2) & m=-1..1: C(1,m,1) == (-1)^(m+1)*(ReC(1,-m,-1)-I*ImC(1,-m,-1))")},
       .remark = "With the transposed R it belongs to the inverse rotation. A public port sets G_{1,-1} = -G_{0,-1}; "
                 "it is -G_{-1,1}."},
      {.place = {"CH-02", "Eq. 5.8 (symmetry)"},
       .printed = "D_{-m,-n} = (-1)^{m+n} conj D_{m,n}",
       .readings = {holds("l=0..3, m=-l..l, n=-l..l: C(l,-m,-n) == (-1)^(m+n)*(ReC(l,m,n)-I*ImC(l,m,n))")}},
      {.place = {"CH-03", "Eqs. 6.1-6.5 (|n| < l)"},
       .printed = "D^l_{mn} = a D^1_{00} D^{l-1}_{mn} + b_m D^1_{10} D^{l-1}_{m-1,n} + b_{-m} D^1_{-1,0} "
                  "D^{l-1}_{m+1,n}; a = sqrt((l+m)(l-m)/((l+n)(l-n))), b_m = sqrt((l+m)(l+m-1)/(2(l+n)(l-n)))",
       .readings = {holds(
           "l=2..3, m=-l..l, n=1-l..l-1: C(l,m,n) == "
           "sqrt((l+m)*(l-m)/((l+n)*(l-n)))*C(1,0,0)*C(l-1,m,n)+sqrt((l+m)*(l+m-1)/"
           "(2*(l+n)*(l-n)))*C(1,1,0)*C(l-1,m-1,n)+sqrt((l-m)*(l-m-1)/(2*(l+n)*(l-n)))*C(1,-1,0)*C(l-1,m+1,n)")},
       .remark = "A coefficient vanishes wherever its term would leave band l-1."},
      {.place = {"CH-04", "Eqs. 6.6-6.13 (n near +-l)"},
       .printed = "D^l_{mn} = c_n D^1_{01} D^{l-1}_{m,n-1} + d_{m,n} D^1_{11} D^{l-1}_{m-1,n-1} + d_{-m,n} D^1_{-1,1} "
                  "D^{l-1}_{m+1,n-1}, -l+2 <= n <= l; c_n = sqrt(2(l+m)(l-m)/((l+n)(l+n-1))), d_{m,n} = "
                  "sqrt((l+m)(l+m-1)/((l+n)(l+n-1))); the same with n+1, D^1_{.,-1} and -n for -l <= n <= l-2",
       .readings = {holds(
           "l=2..3, m=-l..l, n=2-l..l: C(l,m,n) == "
           "sqrt(2*(l+m)*(l-m)/((l+n)*(l+n-1)))*C(1,0,1)*C(l-1,m,n-1)+sqrt((l+m)*(l+m-1)/"
           "((l+n)*(l+n-1)))*C(1,1,1)*C(l-1,m-1,n-1)+sqrt((l-m)*(l-m-1)/((l+n)*(l+n-1)))*C(1,-1,1)*C(l-1,m+1,n-1) & "
           "l=2..3, m=-l..l, n=-l..l-2: C(l,m,n) == "
           "sqrt(2*(l+m)*(l-m)/((l-n)*(l-n-1)))*C(1,0,-1)*C(l-1,m,n+1)+sqrt((l+m)*(l+m-1)/"
           "((l-n)*(l-n-1)))*C(1,1,-1)*C(l-1,m-1,n+1)+sqrt((l-m)*(l-m-1)/((l-n)*(l-n-1)))*C(1,-1,-1)*C(l-1,m+1,n+1)")}},
      {.place = {"CH-07", "Eq. 8.10 alpha, beta"},
       .printed = "alpha_m = sqrt(1+delta_{m0}) (-1)^{(|m|+m)/2} (as its author corrected it), beta_m = "
                  "sign(m)(1-delta_{m0}) alpha_m",
       .readings = {holds("in 8.11-8.14 with R on the left, repaired as in CH-08 and CH-10",
                          "l=1..3, m=0..l, n=0..l: (1+delta(m,0)*delta(n,0))*D(l,m,n) == "
                          "CHa(m)*CHa(n)*ReC(l,m,n)-CHb(m)*CHb(-n)*ReC(l,m,-n) & l=1..3, m=-l..-1, n=-l..-1: D(l,m,n) "
                          "== CHa(m)*CHa(n)*ReC(l,m,n)+CHb(m)*CHb(-n)*ReC(l,m,-n) & l=1..3, m=0..l, n=-l..-1: D(l,m,n) "
                          "== CHa(m)*CHb(n)*ImC(l,m,n)+CHb(m)*CHa(-n)*ImC(l,m,-n) & l=1..3, m=-l..-1, n=0..l: D(l,m,n) "
                          "== CHa(m)*CHb(n)*ImC(l,m,n)-CHb(m)*CHa(-n)*ImC(l,m,-n)"),
                    fails("in the same with 2R on the left, as its author also suggests",
                          "l=1..3, m=0..l, n=0..l: 2*(1+delta(m,0)*delta(n,0))*D(l,m,n) == "
                          "CHa(m)*CHa(n)*ReC(l,m,n)-CHb(m)*CHb(-n)*ReC(l,m,-n) & l=1..3, m=-l..-1, n=-l..-1: "
                          "2*D(l,m,n) == CHa(m)*CHa(n)*ReC(l,m,n)+CHb(m)*CHb(-n)*ReC(l,m,-n) & l=1..3, m=0..l, "
                          "n=-l..-1: 2*D(l,m,n) == CHa(m)*CHb(n)*ImC(l,m,n)+CHb(m)*CHa(-n)*ImC(l,m,-n) & l=1..3, "
                          "m=-l..-1, n=0..l: 2*D(l,m,n) == CHa(m)*CHb(n)*ImC(l,m,n)-CHb(m)*CHa(-n)*ImC(l,m,-n)")},
       .correct = "as printed, with R and not 2R",
       .remark = "The print of 8.10 is not known to us; the correction is second-hand, from a public port."},
      {.place = {"CH-08", "Eq. 8.11 (m >= 0, n >= 0)"},
       .printed = "R_{mn} = alpha_m alpha_n F_{mn} - beta_m beta_{-n} F_{m,-n}",
       .readings = {fails("R on the left",
                          "l=1..3, m=0..l, n=0..l: D(l,m,n) == CHa(m)*CHa(n)*ReC(l,m,n)-CHb(m)*CHb(-n)*ReC(l,m,-n)"),
                    fails("2R on the left",
                          "l=1..3, m=0..l, n=0..l: 2*D(l,m,n) == CHa(m)*CHa(n)*ReC(l,m,n)-CHb(m)*CHb(-n)*ReC(l,m,-n)")},
       .correct =
           "(1 + delta_{m0} delta_{n0}) R_{mn} = alpha_m alpha_n F_{mn} - beta_m beta_{-n} F_{m,-n}; R_{00} = F_{00}",
       .correct_statement = "l=1..3, m=0..l, n=0..l: (1+delta(m,0)*delta(n,0))*D(l,m,n) == "
                            "CHa(m)*CHa(n)*ReC(l,m,n)-CHb(m)*CHb(-n)*ReC(l,m,-n)",
       .remark = "Only R_{00} comes out doubled with R, and only R_{00} is right with 2R."},
      {.place = {"CH-09", "Eq. 8.12 (m < 0, n < 0)"},
       .printed = "R_{mn} = alpha_m alpha_n F_{mn} + beta_m beta_{-n} F_{m,-n}",
       .readings =
           {holds("R on the left",
                  "l=1..3, m=-l..-1, n=-l..-1: D(l,m,n) == CHa(m)*CHa(n)*ReC(l,m,n)+CHb(m)*CHb(-n)*ReC(l,m,-n)"),
            fails("2R on the left, as its author suggests",
                  "l=1..3, m=-l..-1, n=-l..-1: 2*D(l,m,n) == CHa(m)*CHa(n)*ReC(l,m,n)+CHb(m)*CHb(-n)*ReC(l,m,-n)")},
       .correct = "R_{mn} = alpha_m alpha_n F_{mn} + beta_m beta_{-n} F_{m,-n}"},
      {.place = {"CH-10", "Eq. 8.13 (m >= 0, n < 0)"},
       .printed = "R_{mn} = alpha_m beta_n G_{mn} - beta_m alpha_{-n} G_{m,-n}",
       .readings = {fails("R on the left",
                          "l=1..3, m=0..l, n=-l..-1: D(l,m,n) == CHa(m)*CHb(n)*ImC(l,m,n)-CHb(m)*CHa(-n)*ImC(l,m,-n)"),
                    fails(
                        "2R on the left",
                        "l=1..3, m=0..l, n=-l..-1: 2*D(l,m,n) == CHa(m)*CHb(n)*ImC(l,m,n)-CHb(m)*CHa(-n)*ImC(l,m,-n)")},
       .correct = "R_{mn} = alpha_m beta_n G_{mn} + beta_m alpha_{-n} G_{m,-n}",
       .correct_statement = "l=1..3, m=0..l, n=-l..-1: D(l,m,n) == CHa(m)*CHb(n)*ImC(l,m,n)+CHb(m)*CHa(-n)*ImC(l,m,-n)",
       .remark = "The sign of the second term; with m = 0 it does not matter."},
      {.place = {"CH-11", "Eq. 8.14 (m < 0, n >= 0)"},
       .printed = "R_{mn} = alpha_m beta_n G_{mn} - beta_m alpha_{-n} G_{m,-n}",
       .readings = {holds("R on the left",
                          "l=1..3, m=-l..-1, n=0..l: D(l,m,n) == CHa(m)*CHb(n)*ImC(l,m,n)-CHb(m)*CHa(-n)*ImC(l,m,-n)"),
                    fails(
                        "2R on the left, as its author suggests",
                        "l=1..3, m=-l..-1, n=0..l: 2*D(l,m,n) == CHa(m)*CHb(n)*ImC(l,m,n)-CHb(m)*CHa(-n)*ImC(l,m,-n)")},
       .correct = "R_{mn} = alpha_m beta_n G_{mn} - beta_m alpha_{-n} G_{m,-n}"},
  };
}

}  // namespace sh::errata
