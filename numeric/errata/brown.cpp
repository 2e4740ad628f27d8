// B: [Brown04].
#include "numeric/errata/parts.hpp"

namespace sh::errata {

std::vector<Entry> brown() {
  return {
      {.place = {"B-02", "Theta"},
       .printed = "Theta_{lm}(t) = sqrt((2l+1)/(4 pi) (l-m)!/(l+m)!) P_l^m(t)",
       .readings = {fails(
           "3/2*(at((-t^2*cos(t)+2*t*sin(t)+2*cos(t)),t,Pi)-at((-t^2*cos(t)+2*t*sin(t)+2*cos(t)),t,0)) == 1")},
       .correct = "Theta_{lm}(t) = sqrt((2l+1)/(4 pi) (l-m)!/(l+m)!) P_l^m(cos t)",
       .correct_statement = "l=0..6, m=0..l: 2*Pi*(K(l,m))^2*integral(c,-1,1,(1-c^2)^m*diffn(P(l,0),c,m)^2) == 1",
       .remark = "The recursion rules below it do write cos t. With t itself Y_1^0 has the squared norm 3 (pi^2-4)/2, "
                 "as INT t^2 sin t = pi^2-4."},
      {.place = {"B-05", "P_m^m, P_{m+1}^m, P_l^m"},
       .printed = "P_m^m(cos t) = (2m-1) sin t P_{m-1}^{m-1}(cos t); P_{m+1}^m(cos t) = (2m+1) cos t P_m^m(cos t); "
                  "P_l^m(cos t) = ((2l-1) cos t P_{l-1}^m(cos t) - (l+m-1) P_{l-2}^m)/(l-m)",
       .readings = {holds("m=1..10: P(m,m) == (2*m-1)*s*P(m-1,m-1); P(m+1,m) == (2*m+1)*c*P(m,m) & l=2..10, m=0..l-2: "
                          "P(l,m) == ((2*l-1)*c*P(l-1,m)-(l+m-1)*P(l-2,m))/(l-m)")},
       .remark = "Without the Condon-Shortley phase, as the page says; sin t >= 0. The argument missing after the last "
                 "P is cos t."},
      {.place = {"B-08", "Table l <= 2, labels", kTable},
       .printed = "Y_1^1 = sqrt3/(2 sqrt pi) sin p sin t = sqrt3/(2 sqrt pi) y; Y_1^-1 = sqrt3/(2 sqrt pi) cos p sin t "
                  "= sqrt3/(2 sqrt pi) x",
       .readings = {fails("sqrt(3)/(2*sqrt(Pi))*y == Y(1,1); sqrt(3)/(2*sqrt(Pi))*x == Y(1,-1)")},
       .correct = "Y_1^-1 = sqrt3/(2 sqrt pi) y, Y_1^1 = sqrt3/(2 sqrt pi) x",
       .correct_statement = "sqrt(3)/(2*sqrt(Pi))*y == Y(1,-1); sqrt(3)/(2*sqrt(Pi))*x == Y(1,1)",
       .remark = "The two labels are exchanged, in both columns; a comment of a reader notices it."},
      {.place = {"B-09", "Table l <= 2, values (9 rows, two columns)", kTable},
       .printed = "1/(2 sqrt pi); sqrt3/(2 sqrt pi) (y, z, x); sqrt15/(2 sqrt pi) (xy, yz, xz); sqrt5/(4 sqrt pi) "
                  "(3z^2-1); sqrt15/(4 sqrt pi) (x^2-y^2); and the same in cos and sin of p and t",
       .readings = {holds("1/(2*sqrt(Pi)) == Y(0,0); sqrt(3)/(2*sqrt(Pi))*y == Y(1,-1); sqrt(3)/(2*sqrt(Pi))*z == "
                          "Y(1,0); sqrt(3)/(2*sqrt(Pi))*x == Y(1,1); sqrt(15)/(2*sqrt(Pi))*x*y == Y(2,-2); "
                          "sqrt(15)/(2*sqrt(Pi))*y*z == Y(2,-1); sqrt(5)/(4*sqrt(Pi))*(3*z^2-1) == Y(2,0); "
                          "sqrt(15)/(2*sqrt(Pi))*x*z == Y(2,1); sqrt(15)/(4*sqrt(Pi))*(x^2-y^2) == Y(2,2)")}},
      {.place = {"B-10", "Note on [2]", kText},
       .printed =
           "these functions do not agree with those of Ramamoorthi and Hanrahan, which have the convolution baked in",
       .readings = {fails("the constants or polynomials of their eq. 3 differ", "sqrt(5/Pi)/4*(3*z^2-1) != Y(2,0)"),
                    fails("their eq. 3 contains the factors A_l", "sqrt(5/Pi)/4*(3*z^2-1) == Pi/4*Y(2,0)")},
       .correct = "their eq. 3 is this basis, constants rounded to six decimals",
       .correct_statement = "sqrt(5/Pi)/4*(3*z^2-1) == Y(2,0); sqrt(1/Pi)/2 ~ 0.282095; sqrt(3/Pi)/2 ~ 0.488603; "
                            "sqrt(15/Pi)/2 ~ 1.092548; sqrt(5/Pi)/4 ~ 0.315392; sqrt(15/Pi)/4 ~ 0.546274",
       .remark = "The convolution is in the constants c1..c5 of their rendering formula, eq. 12 (RH-10, RH-11)."},
      {.place = {"B-12", "Table l = 3 (7 functions)", kTable},
       .printed = "sqrt35/(4 sqrt(2 pi)) (3x^2-y^2) y; sqrt105/(2 sqrt pi) xyz; sqrt21/(4 sqrt(2 pi)) (5z^2-1) y; "
                  "sqrt7/(4 sqrt pi) (5z^3-3z); sqrt21/(4 sqrt(2 pi)) (5z^2-1) x; sqrt105/(4 sqrt pi) (x^2-y^2) z; "
                  "sqrt35/(4 sqrt(2 pi)) (x^2-3y^2) x; printed in cos and sin of p and t",
       .readings = {holds("sqrt(35)/(4*sqrt(2*Pi))*(3*x^2-y^2)*y == Y(3,-3); sqrt(105)/(2*sqrt(Pi))*x*y*z == Y(3,-2); "
                          "sqrt(21)/(4*sqrt(2*Pi))*(5*z^2-1)*y == Y(3,-1); sqrt(7)/(4*sqrt(Pi))*(5*z^3-3*z) == Y(3,0); "
                          "sqrt(21)/(4*sqrt(2*Pi))*(5*z^2-1)*x == Y(3,1); sqrt(105)/(4*sqrt(Pi))*(x^2-y^2)*z == "
                          "Y(3,2); sqrt(35)/(4*sqrt(2*Pi))*(x^2-3*y^2)*x == Y(3,3)")}},
      {.place = {"B-13", "Table l = 4 (9 functions)", kTable},
       .printed = "3 sqrt35/(4 sqrt pi) (x^2-y^2) xy; 3 sqrt35/(4 sqrt(2 pi)) (3x^2-y^2) yz; 3 sqrt5/(4 sqrt pi) "
                  "(7z^2-1) xy; 3 sqrt5/(4 sqrt(2 pi)) (7z^2-3) yz; 3/(16 sqrt pi) (3-30z^2+35z^4); 3 sqrt5/(4 sqrt(2 "
                  "pi)) (7z^2-3) xz; 3 sqrt5/(8 sqrt pi) (7z^2-1)(x^2-y^2); 3 sqrt35/(4 sqrt(2 pi)) (x^2-3y^2) xz; 3 "
                  "sqrt35/(16 sqrt pi) (y^4-6x^2y^2+x^4); printed in cos and sin of p and t",
       .readings = {holds(
           "3*sqrt(35)/(4*sqrt(Pi))*(x^2-y^2)*x*y == Y(4,-4); 3*sqrt(35)/(4*sqrt(2*Pi))*(3*x^2-y^2)*y*z == Y(4,-3); "
           "3*sqrt(5)/(4*sqrt(Pi))*(7*z^2-1)*x*y == Y(4,-2); 3*sqrt(5)/(4*sqrt(2*Pi))*(7*z^2-3)*y*z == Y(4,-1); "
           "3/(16*sqrt(Pi))*(3-30*z^2+35*z^4) == Y(4,0); 3*sqrt(5)/(4*sqrt(2*Pi))*(7*z^2-3)*x*z == Y(4,1); "
           "3*sqrt(5)/(8*sqrt(Pi))*(7*z^2-1)*(x^2-y^2) == Y(4,2); 3*sqrt(35)/(4*sqrt(2*Pi))*(x^2-3*y^2)*x*z == Y(4,3); "
           "3*sqrt(35)/(16*sqrt(Pi))*(y^4-6*x^2*y^2+x^4) == Y(4,4)")},
       .remark = "The 25 functions called order 4 are degree 4, five bands."},
      {.place = {"B-14", "Irradiance"},
       .printed = "E_l^m = A_l L_l^m, called outgoing radiance",
       .readings = {holds("E is irradiance", "A(0)*sphere(Y(0,0))*Y(0,0) == cap(z,0)"),
                    fails("E is outgoing radiance for albedo 1", "A(0)*sphere(Y(0,0))*Y(0,0) == 1")},
       .correct = "irradiance E_l^m = A_l L_l^m, outgoing radiance = albedo/pi E",
       .remark = "Under L = 1 irradiance is pi and a white surface sends out 1."},
      {.place = {"B-15", "A_n"},
       .printed = "A_n = 2 pi (-1)^{n/2-1}/((n+2)(n-1)) n!/(2^n ((n/2)!)^2) (n even); 2 pi/3 (n = 1); 0 (odd n > 1)",
       .readings = {holds("k=0..4: 2*Pi*(-1)^(k-1)/((2*k+2)*(2*k-1))*factorial(2*k)/(2^(2*k)*factorial(k)^2) == "
                          "A(2*k); A(2*k+3) == 0 & A(1) == 2*Pi/3")},
       .remark = "n = 0 works: (-1)^{-1} = -1 gives pi."},
      {.place = {"B-16", "Values", kTable},
       .printed = "A_0..A_4 = pi, 2 pi/3, pi/4, 0, -pi/24",
       .readings = {holds("A(0) == Pi; A(1) == 2*Pi/3; A(2) == Pi/4; A(3) == 0; A(4) == -Pi/24")}},
      {.place = {"B-17", "Error text", kText},
       .printed = "nine functions: average error at worst 3 %, sample error at worst 9 %, typically 1 % on average",
       .readings = {holds("mean absolute error over INT L dw, one light, whole percents",
                          "at((3/32-t/2+15/32*t^2),t,(8-sqrt(19))/15) == 0; "
                          "integral(t,0,(8-sqrt(19))/15,(3/32-t/2+15/32*t^2))-integral(t,(8-sqrt(19))/15,(8+sqrt(19))/"
                          "15,(3/32-t/2+15/32*t^2))+integral(t,(8+sqrt(19))/15,1,(3/32-t/2+15/32*t^2)) == "
                          "19*sqrt(19)/2700; 100*19*sqrt(19)/2700 ~ 3; 100*at((3/32-t/2+15/32*t^2),t,0) ~ 9"),
                    fails("root mean square error instead",
                          "integral(t,0,1,(3/32-t/2+15/32*t^2)^2) == 1/768; 100/sqrt(768) ~ 3")},
       .correct =
           "one light: largest 3/32 = 9.375 %, mean absolute 19 sqrt(19)/2700 = 3.07 %, rms 1/sqrt(768) = 3.61 %",
       .remark = "One light: the error is 3/32 - t/2 + 15/32 t^2. As bounds both numbers are rounded down. Measured in "
                 "RH-13."},
      {.place = {"B-18", "Rotation, replacement for 8.8-8.14: R, S, T"},
       .printed = "R_{mn} = (S_{m,-n} + (-1)^n S_{mn})/sqrt2 (n > 0), S_{mn} (n = 0), (-T_{mn} + (-1)^n "
                  "T_{m,-n})/sqrt2 (n < 0); S_{mn} = (F_{-m,n} + (-1)^m F_{mn})/sqrt2 (m > 0), F_{mn} (m = 0), (G_{mn} "
                  "- (-1)^m G_{-m,n})/sqrt2 (m < 0); T_{mn} = (G_{-m,n} + (-1)^m G_{mn})/sqrt2 (m > 0), G_{mn} (m = "
                  "0), (-F_{mn} + (-1)^m F_{-m,n})/sqrt2 (m < 0)",
       .readings =
           {holds("F + iG = D(R), Condon-Shortley, D_mn = INT conj Y_m(s) Y_n(R^-1 s) ds: R_{mn} is the matrix of R",
                  "l=1..3, m=1..l, n=1..l: D(l,m,n) == "
                  "((ReC(l,-m,-n)+(-1)^m*ReC(l,m,-n))/sqrt(2)+(-1)^n*(ReC(l,-m,n)+(-1)^m*ReC(l,m,n))/sqrt(2))/sqrt(2); "
                  "D(l,m,-n) == "
                  "(-(ImC(l,-m,-n)+(-1)^m*ImC(l,m,-n))/sqrt(2)+(-1)^n*(ImC(l,-m,n)+(-1)^m*ImC(l,m,n))/sqrt(2))/"
                  "sqrt(2); D(l,m,0) == (ReC(l,-m,0)+(-1)^m*ReC(l,m,0))/sqrt(2) & l=1..3, n=1..l: D(l,0,n) == "
                  "(ReC(l,0,-n)+(-1)^n*ReC(l,0,n))/sqrt(2); D(l,0,-n) == (-ImC(l,0,-n)+(-1)^n*ImC(l,0,n))/sqrt(2); "
                  "D(l,0,0) == ReC(l,0,0) & l=1..3, m=1..l, n=1..l: D(l,-m,n) == "
                  "((ImC(l,-m,-n)-(-1)^m*ImC(l,m,-n))/sqrt(2)+(-1)^n*(ImC(l,-m,n)-(-1)^m*ImC(l,m,n))/sqrt(2))/sqrt(2); "
                  "D(l,-m,-n) == "
                  "(-(-ReC(l,-m,-n)+(-1)^m*ReC(l,m,-n))/sqrt(2)+(-1)^n*(-ReC(l,-m,n)+(-1)^m*ReC(l,m,n))/sqrt(2))/"
                  "sqrt(2); D(l,-m,0) == (ImC(l,-m,0)-(-1)^m*ImC(l,m,0))/sqrt(2)"),
            fails(
                "F + iG = conj D(R)",
                "l=1..3, m=1..l, n=1..l: D(l,m,-n) == "
                "((ImC(l,-m,-n)+(-1)^m*ImC(l,m,-n))/sqrt(2)-(-1)^n*(ImC(l,-m,n)+(-1)^m*ImC(l,m,n))/sqrt(2))/sqrt(2)")},
       .correct = "as printed, F + iG = exp(-i m alpha) d_mn(beta) exp(-i n gamma)",
       .remark =
           "Every entry and sign is right for the D of the paper that it amends; the page does not define F and G."},
      {.place = {"B-19", "Claim R = W D W*", kText},
       .printed = "the equations evaluate R = W D W*, * Hermitian conjugate",
       .readings = {holds("W takes complex coefficients to real ones",
                          "l=1..3, m=1..l, n=1..l: D(l,m,-n) == "
                          "I/2*(C(l,-m,-n)+(-1)^m*C(l,m,-n)-(-1)^n*(C(l,-m,n)+(-1)^m*C(l,m,n)))"),
                    fails("W takes complex functions to real ones, y = W Y",
                          "l=1..3, m=1..l, n=1..l: D(l,m,-n) == "
                          "-I/2*(C(l,-m,-n)+(-1)^m*C(l,m,-n)-(-1)^n*(C(l,-m,n)+(-1)^m*C(l,m,n)))")},
       .correct = "R = conj(W) D W^T for y = W Y",
       .correct_statement =
           "l=1..3, m=1..l, n=1..l: D(l,m,-n) == I/2*(C(l,-m,-n)+(-1)^m*C(l,m,-n)-(-1)^n*(C(l,-m,n)+(-1)^m*C(l,m,n)))",
       .remark = "With y = W Y the product W D W* is the matrix of another rotation, Rz(-alpha) Ry(beta) Rz(-gamma)."},
  };
}

}  // namespace sh::errata
