// BL: [BlancoFlorezBermejo97].
#include "numeric/errata/parts.hpp"

namespace sh::errata {

std::vector<Entry> blanco() {
  return {
      {.place = {"BL-02", "D^l_{m'm}(a,b,g)"},
       .printed = "D^l_{m'm}(a,b,g) = e^{-i m' a} d^l_{m'm}(b) e^{-i m g}",
       .readings = {holds(
           "l=1..3, m=-l..l, n=-l..l: C(l,m,n) == "
           "(cosm(m,cos_a,sin_a)-I*sinm(m,cos_a,sin_a))*db(l,m,n)*(cosm(n,cos_g,sin_g)-I*sinm(n,cos_g,sin_g))")}},
      {.place = {"BL-03", "Eq. 38 symmetries"},
       .printed = "d_{m'm} = (-1)^{m'-m} d_{mm'} = d_{-m,-m'} = (-1)^{m'-m} d_{-m',-m}",
       .readings = {holds("l=0..3, m=-l..l, n=-l..l: d(l,m,n) == (-1)^(m-n)*d(l,n,m); d(l,m,n) == d(l,-n,-m); d(l,m,n) "
                          "== (-1)^(m-n)*d(l,-m,-n)")}},
      {.place = {"BL-04", "Real rotation matrix from d"},
       .printed = "R_{mm'} = sgn(m') Phi_m(a) Phi_m'(g) (d_{|m'||m|} + (-1)^m d_{|m|,-|m'|})/2 - sgn(m) Phi_{-m}(a) "
                  "Phi_{-m'}(g) (d_{|m'||m|} - (-1)^m d_{|m|,-|m'|})/2, sgn(0) = 1",
       .readings = {holds("m is the row, m' the column: D(Rz(a) Ry(b) Rz(g))",
                          "l=0..3, m=-l..l, n=-l..l: D(l,m,n) == "
                          "(csgn(2*n+1)*Phi(m,cos_a,sin_a)*Phi(n,cos_g,sin_g)*(db(l,abs(n),abs(m))+(-1)^m*db(l,abs(m),-"
                          "abs(n)))-csgn(2*m+1)*Phi(-m,cos_a,sin_a)*Phi(-n,cos_g,sin_g)*(db(l,abs(n),abs(m))-(-1)^m*db("
                          "l,abs(m),-abs(n))))/2"),
                    fails("m' is the row, m the column",
                          "l=0..3, m=-l..l, n=-l..l: D(l,n,m) == "
                          "(csgn(2*n+1)*Phi(m,cos_a,sin_a)*Phi(n,cos_g,sin_g)*(db(l,abs(n),abs(m))+(-1)^m*db(l,abs(m),-"
                          "abs(n)))-csgn(2*m+1)*Phi(-m,cos_a,sin_a)*Phi(-n,cos_g,sin_g)*(db(l,abs(n),abs(m))-(-1)^m*db("
                          "l,abs(m),-abs(n))))/2"),
                    fails("the indices of each d exchanged, either way round",
                          "l=0..3, m=-l..l, n=-l..l: D(l,m,n) == "
                          "(csgn(2*n+1)*Phi(m,cos_a,sin_a)*Phi(n,cos_g,sin_g)*(db(l,abs(m),abs(n))+(-1)^m*db(l,abs(n),-"
                          "abs(m)))-csgn(2*m+1)*Phi(-m,cos_a,sin_a)*Phi(-n,cos_g,sin_g)*(db(l,abs(m),abs(n))-(-1)^m*db("
                          "l,abs(n),-abs(m))))/2")},
       .correct = "as printed, row m and column m'",
       .remark = "The text is second-hand, from a public port."},
      {.place = {"BL-05", "Eqs. 48-52 start values"},
       .printed = "d^0_00 = 1; d^1_00 = cos b; d^1_{1,-1} = sin^2(b/2); d^1_{1,0} = -sin(b)/sqrt2; d^1_11 = cos^2(b/2)",
       .readings = {holds(
           "d(0,0,0) == 1; d(1,0,0) == ch^2-sh^2; d(1,1,-1) == sh^2; d(1,1,0) == -2*sh*ch/sqrt(2); d(1,1,1) == ch^2")}},
      {.place = {"BL-06", "Eq. 64"},
       .printed = "d^l_{m'm} = l(2l-1)/sqrt((l^2-m^2)(l^2-m'^2)) { (d^1_00 - mm'/(l(l-1))) d^{l-1}_{m'm} - "
                  "sqrt(((l-1)^2-m^2)((l-1)^2-m'^2))/((l-1)(2l-1)) d^{l-2}_{m'm} }",
       .readings = {holds("l=2..4, m=1-l..l-1, n=1-l..l-1: d(l,m,n) == "
                          "l*(2*l-1)/sqrt((l^2-m^2)*(l^2-n^2))*((d(1,0,0)-m*n/"
                          "(l*(l-1)))*d(l-1,m,n)-sqrt(((l-1)^2-m^2)*((l-1)^2-n^2))/((l-1)*(2*l-1))*d(l-2,m,n))")},
       .remark = "The paper uses it for |m|, |m'| <= l-2; where an order is l-1 the last term has the factor 0."},
      {.place = {"BL-07", "Eq. 65"},
       .printed = "d^l_{ll} = d^1_11 d^{l-1}_{l-1,l-1}",
       .readings = {holds("l=1..4: d(l,l,l) == d(1,1,1)*d(l-1,l-1,l-1); d(l,l,l) == ch^(2*l)")},
       .remark = "That is cos^{2l}(b/2)."},
      {.place = {"BL-08", "Eq. 66"},
       .printed = "d^l_{l-1,l-1} = (l d^1_00 - l + 1) d^{l-1}_{l-1,l-1}",
       .readings = {holds("l=1..4: d(l,l-1,l-1) == (l*d(1,0,0)-l+1)*d(l-1,l-1,l-1)")}},
      {.place = {"BL-09", "Eq. 67"},
       .printed = "d^l_{l,m-1} = -sqrt((l+m)/(l-m+1)) sqrt(d^1_{1,-1}/d^1_11) d^l_{l,m}",
       .readings = {holds("0 <= b < pi",
                          "l=1..4, m=1-l..l: ch*d(l,l,m-1) == -sqrt((l+m)/(l-m+1))*sh*d(l,l,m) & sqrt(sin_h^2/cos_h^2) "
                          "== sin_h/cos_h"),
                    fails("b = pi", "at(at(d(1,1,1),ch,0),sh,1) != 0"),
                    fails("-pi < b < 0", "sqrt((-3/5)^2/(4/5)^2) == (-3/5)/(4/5)")},
       .correct = "cos(b/2) d^l_{l,m-1} = -sqrt((l+m)/(l-m+1)) sin(b/2) d^l_{l,m}",
       .correct_statement = "l=1..4, m=1-l..l: ch*d(l,l,m-1) == -sqrt((l+m)/(l-m+1))*sh*d(l,l,m)",
       .remark = "At b = pi it divides by zero, although Euler angles reach it; below 0 the root has the wrong sign."},
      {.place = {"BL-10", "Eq. 68"},
       .printed =
           "d^l_{l-1,m-1} = -(l d^1_00 - m + 1)/(l d^1_00 - m) sqrt((l+m)/(l-m+1)) sqrt(d^1_{1,-1}/d^1_11) d^l_{l-1,m}",
       .readings = {holds("0 <= b < pi, cos b other than m/l",
                          "l=2..4, m=2-l..l-1: ch*(l*d(1,0,0)-m)*d(l,l-1,m-1) == "
                          "-(l*d(1,0,0)-m+1)*sqrt((l+m)/(l-m+1))*sh*d(l,l-1,m)"),
                    fails("cos b = m/l, as b = pi/2 with m = 0",
                          "l=2..4: at(at(l*d(1,0,0)-0,ch,1/sqrt(2)),sh,1/sqrt(2)) != 0"),
                    fails("b = pi", "at(at(d(1,1,1),ch,0),sh,1) != 0")},
       .correct = "d^l_{l-1,m} = (-1)^{l-m-1} sqrt((2l-1)!/((l+m)!(l-m)!)) (l cos b - m) cos^{l+m-1}(b/2) "
                  "sin^{l-m-1}(b/2), |m| < l",
       .correct_statement = "l=1..4, m=1-l..l-1: d(l,l-1,m) == "
                            "(-1)^(l-m-1)*sqrt(factorial(2*l-1)/"
                            "(factorial(l+m)*factorial(l-m)))*(l*(ch^2-sh^2)-m)*ch^(l+m-1)*sh^(l-m-1)",
       .remark =
           "A 0/0 at the very angle that z-x90-z needs; the closed form has no hole. At b = pi it divides by zero. So "
           "64 to 68 together fail at pi/2 and pi; a public port notes that something is wrong near row l-1."},
  };
}

}  // namespace sh::errata
