// IR: [IvanicRuedenberg96+98].
#include "numeric/errata/parts.hpp"

namespace sh::errata {

std::vector<Entry> ivanic_ruedenberg() {
  return {
      {.place = {"IR-01", "Eq. 5.8 / start"},
       .printed = "R^1 = [[Ryy,Ryz,Ryx],[Rzy,Rzz,Rzx],[Rxy,Rxz,Rxx]], order m = -1, 0, 1 as (y,z,x)",
       .readings = {holds("R turns columns, s' = R s: R^l is D(R) with c' = D(R) c",
                          "m=-1..1, n=-1..1: D(1,m,n) == R(m,n)"),
                    fails("R turns rows, s' = s R: R^l is D(R) with c' = D(R) c",
                          "m=-1..1, n=-1..1: D(1,m,n) == R(n,m)")},
       .correct = "R^1_{mn} = R_{axis(m),axis(n)}, axis(-1,0,1) = y,z,x, R acting on columns",
       .remark = "With the transposed R the recursion gives the matrix of the inverse rotation."},
      {.place = {"IR-04", "Eq. 8.1"},
       .printed = "R^l_{mn} = u U + v V + w W",
       .readings = {holds(
           "l=2..4, n=-l..l: D(l,0,n) == IRu(l,0,n)*IRP(0,0,n,l)+IRv(l,0,n)*(IRP(1,1,n,l)+IRP(-1,-1,n,l)) & l=2..4, "
           "m=1..l, n=-l..l: D(l,m,n) == "
           "IRu(l,m,n)*IRP(0,m,n,l)+IRv(l,m,n)*(sqrt(1+delta(m,1))*IRP(1,m-1,n,l)-(1-delta(m,1))*IRP(-1,1-m,n,l))+IRw("
           "l,m,n)*(IRP(1,m+1,n,l)+IRP(-1,-m-1,n,l)) & l=2..4, m=-l..-1, n=-l..l: D(l,m,n) == "
           "IRu(l,m,n)*IRP(0,m,n,l)+IRv(l,m,n)*((1-delta(m,-1))*IRP(1,m+1,n,l)+sqrt(1+delta(m,-1))*IRP(-1,-m-1,n,l))+"
           "IRw(l,m,n)*(IRP(1,m-1,n,l)-IRP(-1,1-m,n,l))")},
       .remark = "The step from the exact band l-1, at a rotation without special angles."},
      {.place = {"IR-05", "Table 1 (corrected form)", kTable},
       .printed = "u = sqrt((l+m)(l-m)/d), v = 1/2 sqrt((1+d0)(l+|m|-1)(l+|m|)/d)(1-2 d0), w = -1/2 "
                  "sqrt((l-|m|-1)(l-|m|)/d)(1-d0); d = (l+n)(l-n) for |n| < l, 2l(2l-1) for |n| = l; d0 = delta_{m0}",
       .readings = {holds("l=2..5, m=1-l..l-1: sqrt((l+m)*(l-m)/((2*l+1)*(2*l-1))) == sphere(Y(l,m)*z*Y(l-1,m)) & "
                          "l=2..5: -sqrt(2*(l-1)*l/((2*l+1)*(2*l-1)))/2 == sphere(Y(l,0)*x*Y(l-1,1)) & l=2..5, m=2..l: "
                          "sqrt((l+m-1)*(l+m)/((2*l+1)*(2*l-1)))/2 == sphere(Y(l,m)*x*Y(l-1,m-1)) & l=3..5, m=1..l-2: "
                          "-sqrt((l-m-1)*(l-m)/((2*l+1)*(2*l-1)))/2 == sphere(Y(l,m)*x*Y(l-1,m+1))")},
       .remark = "Every coefficient is the integral of Y_lm (y,z,x) Y_{l-1,mu} over that of the column."},
      {.place = {"IR-06", "Table 2, P", kTable},
       .printed = "_iP_{mu,n} = R_{i,0} R^{l-1}_{mu,n} (|n| < l); R_{i,1} R^{l-1}_{mu,l-1} - R_{i,-1} "
                  "R^{l-1}_{mu,-l+1} (n = l); R_{i,1} R^{l-1}_{mu,-l+1} + R_{i,-1} R^{l-1}_{mu,l-1} (n = -l)",
       .readings = {holds("l=2..4: D(l,0,l) == "
                          "sqrt(l/(2*(2*l-1)))*(R(0,1)*D(l-1,0,l-1)-R(0,-1)*D(l-1,0,1-l))-sqrt((l-1)/(2*l-1))/"
                          "2*((R(1,1)*D(l-1,1,l-1)-R(1,-1)*D(l-1,1,1-l))+(R(-1,1)*D(l-1,-1,l-1)-R(-1,-1)*D(l-1,-1,1-l))"
                          "); D(l,0,-l) == "
                          "sqrt(l/(2*(2*l-1)))*(R(0,1)*D(l-1,0,1-l)+R(0,-1)*D(l-1,0,l-1))-sqrt((l-1)/(2*l-1))/"
                          "2*((R(1,1)*D(l-1,1,1-l)+R(1,-1)*D(l-1,1,l-1))+(R(-1,1)*D(l-1,-1,1-l)+R(-1,-1)*D(l-1,-1,l-1))"
                          ") & l=2..4, n=1-l..l-1: D(l,0,n) == "
                          "sqrt(l^2/((l+n)*(l-n)))*R(0,0)*D(l-1,0,n)-sqrt(2*(l-1)*l/((l+n)*(l-n)))/"
                          "2*(R(1,0)*D(l-1,1,n)+R(-1,0)*D(l-1,-1,n))")},
       .remark = "Terms whose mu leaves -l+1..l-1 always meet a coefficient zero."},
      {.place = {"IR-08", "Table 2, V, m >= 0", kTable},
       .printed = "m = 0: _1P_1 + _{-1}P_{-1}; m > 0: _1P_{m-1} sqrt(1+d) - _{-1}P_{-m+1} (1-d), d = delta_{m1}",
       .readings = {holds(
           "l=2..4, n=-l..l: D(l,0,n) == IRu(l,0,n)*IRP(0,0,n,l)+IRv(l,0,n)*(IRP(1,1,n,l)+IRP(-1,-1,n,l)) & l=2..4, "
           "m=1..l, n=-l..l: D(l,m,n) == "
           "IRu(l,m,n)*IRP(0,m,n,l)+IRv(l,m,n)*(sqrt(1+delta(m,1))*IRP(1,m-1,n,l)-(1-delta(m,1))*IRP(-1,1-m,n,l))+IRw("
           "l,m,n)*(IRP(1,m+1,n,l)+IRP(-1,-m-1,n,l))")}},
      {.place = {"IR-09", "Table 2, V, m < 0", kTable},
       .printed = "1998: _1P_{m+1} (1-d) + _{-1}P_{-m-1} sqrt(1-d); 1996: _1P_{m+1} (1+d) + _{-1}P_{-m-1} sqrt(1-d); d "
                  "= delta_{m,-1}",
       .readings = {fails("as corrected in 1998: (1-d), sqrt(1-d)",
                          "l=2..4, m=-l..-1, n=-l..l: D(l,m,n) == "
                          "IRu(l,m,n)*IRP(0,m,n,l)+IRv(l,m,n)*((1-delta(m,-1))*IRP(1,m+1,n,l)+sqrt(1-delta(m,-1))*IRP(-"
                          "1,-m-1,n,l))+IRw(l,m,n)*(IRP(1,m-1,n,l)-IRP(-1,1-m,n,l))"),
                    fails("as in 1996 and in Green's appendix: (1+d), sqrt(1-d)",
                          "l=2..4, m=-l..-1, n=-l..l: D(l,m,n) == "
                          "IRu(l,m,n)*IRP(0,m,n,l)+IRv(l,m,n)*((1+delta(m,-1))*IRP(1,m+1,n,l)+sqrt(1-delta(m,-1))*IRP(-"
                          "1,-m-1,n,l))+IRw(l,m,n)*(IRP(1,m-1,n,l)-IRP(-1,1-m,n,l))")},
       .correct = "V = (1-d) _1P_{m+1} + sqrt(1+d) _{-1}P_{-m-1}, d = delta_{m,-1}",
       .correct_statement = "l=2..4, m=-l..-1, n=-l..l: D(l,m,n) == "
                            "IRu(l,m,n)*IRP(0,m,n,l)+IRv(l,m,n)*((1-delta(m,-1))*IRP(1,m+1,n,l)+sqrt(1+delta(m,-1))*"
                            "IRP(-1,-m-1,n,l))+IRw(l,m,n)*(IRP(1,m-1,n,l)-IRP(-1,1-m,n,l))",
       .remark = "Both go wrong in the row m = -1 only: its single term is sqrt(2) _{-1}P_0. The printed text is "
                 "second-hand, from the errata noted in google/spherical-harmonics."},
  };
}

}  // namespace sh::errata
