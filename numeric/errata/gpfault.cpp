// GP: the page on spherical harmonics of gpfault.net, 2026.
#include "numeric/errata/parts.hpp"

namespace sh::errata {

std::vector<Entry> gpfault() {
  return {
      {.place = {"GP-01", "Function Space, independent vectors", kText},
       .printed = "independent: for no v_i are there a_1..a_n with v_i = a_0 v_0 + ... + a_n v_n",
       .readings = {fails("tx != 1*tx+0*ty+0*tz")},
       .correct = "for no i is v_i = sum over j != i of a_j v_j",
       .correct_statement = "sphere((x-u*y-v*z)^2) == 4*Pi/3*(1+u^2+v^2)",
       .remark = "a_i = 1, the rest 0, always solves the printed equation, so that not even the axes would be "
                 "independent. The coefficients are listed from a_1 and used from a_0."},
      {.place = {"GP-02", "Function Space, independent functions", kText},
       .printed = "no a_0..a_n with f_i = a_0 f_0 + ... + a_n f_n",
       .readings = {fails("x != 1*x+0*y+0*z")},
       .correct = "for no i is f_i = sum over j != i of a_j f_j",
       .correct_statement = "sphere((x-u*y-v*z)^2) == 4*Pi/3*(1+u^2+v^2); 1 == x^2+y^2+z^2",
       .remark = "The slip of GP-01. Shown on x, y, z, which are independent; 1, x^2, y^2, z^2 are not."},
      {.place = {"GP-07", "Function Space, size of a basis", kText},
       .printed = "the basis of a function space is always infinite",
       .readings = {fails("sum(sum(sphere((tx*x+ty*y+tz*z+w)*Y(l,m))*Y(l,m),m,-l,l),l,0,1) != tx*x+ty*y+tz*z+w")},
       .correct = "infinite for all continuous functions on the sphere; (L+1)^2 functions for those of degree <= L",
       .correct_statement = "sum(sum(sphere((tx*x+ty*y+tz*z+w)*Y(l,m))*Y(l,m),m,-l,l),l,0,1) == tx*x+ty*y+tz*z+w & "
                            "n=0..6: sum(2*k+1,k,0,n) == (n+1)^2",
       .remark = "The spaces that the page goes on to use have 4, 9 and 16 dimensions."},
      {.place = {"GP-08", "Spherical harmonics as a basis", kText},
       .printed =
           "every (piecewise) continuous function on the sphere is an infinite weighted sum of spherical harmonics",
       .readings = {holds("in L2: every polynomial is a finite sum, and polynomials are dense",
                          "n=0..6: cap(1,0) - sum(cap(Y(l,0),0)^2,l,0,2*n) < 2*Pi/(2*n+1)"),
                    fails("at every point: the sums for a hemisphere reach 0 or 1 on its edge",
                          "n=0..6: sum(cap(Y(l,0),0)*dir(Y(l,0),1,0,0),l,0,n) == 1")},
       .correct = "convergence in L2",
       .remark =
           "On the edge every partial sum is 1/2. For functions without a jump the series may still diverge at single "
           "points: continuity alone does not suffice, as for Fourier series (a theorem, not computed here)."},
      {.place = {"GP-11", "Code, constants C[0..9] and functions y00 .. y33", kCode},
       .printed =
           "C0; C1 (y,z,x); C2 xy, C2 yz, C3 (3z^2-1), C2 xz, C4 (x^2-y^2); C5 y(3x^2-y^2), C6 xyz, C7 y(5z^2-1), C8 "
           "z(5z^2-3), C7 x(5z^2-1), C9 z(x^2-y^2), C5 x(x^2-3y^2); C = sqrt(1/pi)/2, sqrt(3/pi)/2, sqrt(15/pi)/2, "
           "sqrt(5/pi)/4, sqrt(15/pi)/4, sqrt(70/pi)/8, sqrt(105/pi)/2, sqrt(42/pi)/8, sqrt(7/pi)/4, sqrt(105/pi)/4",
       .readings = {holds(
           "Y(0,0) == sqrt(1/Pi)/2; Y(1,-1) == sqrt(3/Pi)/2*y; Y(1,0) == sqrt(3/Pi)/2*z; Y(1,1) == sqrt(3/Pi)/2*x; "
           "Y(2,-2) == sqrt(15/Pi)/2*x*y; Y(2,-1) == sqrt(15/Pi)/2*y*z; Y(2,0) == sqrt(5/Pi)/4*(3*z^2-1); Y(2,1) == "
           "sqrt(15/Pi)/2*x*z; Y(2,2) == sqrt(15/Pi)/4*(x^2-y^2); Y(3,-3) == sqrt(70/Pi)/8*y*(3*x^2-y^2); Y(3,-2) == "
           "sqrt(105/Pi)/2*x*y*z; Y(3,-1) == sqrt(42/Pi)/8*y*(5*z^2-1); Y(3,0) == sqrt(7/Pi)/4*z*(5*z^2-3); Y(3,1) == "
           "sqrt(42/Pi)/8*x*(5*z^2-1); Y(3,2) == sqrt(105/Pi)/4*z*(x^2-y^2); Y(3,3) == sqrt(70/Pi)/8*x*(x^2-3*y^2)")},
       .remark = "sqrt(70)/8 = sqrt(35/2)/4 and sqrt(42)/8 = sqrt(21/2)/4. y_11 in the code is order -1, y11 order +1. "
                 "Off the unit sphere they are not the solid harmonics."},
      {.place = {"GP-14", "Code testBasisFunctions", kCode},
       .printed = "points in the cube, those outside the ball rejected, the rest normalized; (4 pi / N) sum y_i y_j",
       .readings = {measured(
           true, "inner products of 16 functions by 100,000 samples are very close to 1 and 0: the largest distance",
           "0")},
       .remark = "Measured with seed 1. A point at the origin would divide by zero (probability 0)."},
      {.place = {"GP-15", "The Definition, complex functions"},
       .printed = "Y_l^m = (-1)^m sqrt((2l+1)/(4 pi) (l-m)!/(l+m)!) P_l^m(cos t) e^{imp}",
       .readings =
           {fails(
                "P_l^m of negative order as the page prints it (GP-20)",
                "l=1..4, m=-l..-1: (-1)^m*K(l,m)*factorial(l-m)/factorial(l+m)*P(l,-m)*(cosm(m,cp,sp)+I*sinm(m,cp,sp)) "
                "== polar(Yc(l,m))"),
            fails(
                "P_l^-m = (l-m)!/(l+m)! P_l^m, m > 0",
                "l=1..4, m=-l..-1: (-1)^m*K(l,m)*factorial(l+m)/factorial(l-m)*P(l,-m)*(cosm(m,cp,sp)+I*sinm(m,cp,sp)) "
                "== polar(Yc(l,m))"),
            holds("P_l^m of negative order by Rodrigues' formula",
                  "l=0..4, m=-l..l: (-1)^m*K(l,m)*P(l,m)*(cosm(m,cp,sp)+I*sinm(m,cp,sp)) == polar(Yc(l,m))")},
       .correct = "with P_l^-m = (-1)^m (l-m)!/(l+m)! P_l^m, m > 0",
       .remark =
           "As printed the functions of negative order are not normalized (squared norm 16 for (1,-1)); without the "
           "sign they are, but odd orders have the other sign than the standard Y_l^-m = (-1)^m conj(Y_l^m)."},
      {.place = {"GP-20", "Associated Legendre, m < 0"},
       .printed = "P_l^m = (l-m)!/(l+m)! P_l^-m for m < 0",
       .readings = {fails("l=1..6, m=-l..-1: P(l,m) == factorial(l-m)/factorial(l+m)*P(l,-m)"),
                    fails("m in the fraction without its sign",
                          "l=1..6, m=-l..-1: P(l,m) == factorial(l-abs(m))/factorial(l+abs(m))*P(l,-m)")},
       .correct = "P_l^m = (-1)^m (l+m)!/(l-m)! P_l^-m for m < 0",
       .correct_statement = "l=1..6, m=-l..-1: P(l,m) == (-1)^m*factorial(l+m)/factorial(l-m)*P(l,-m)",
       .remark = "The fraction is upside down and the sign is missing; the sign belongs to Rodrigues' formula "
                 "continued to negative orders, with or without Condon-Shortley phase. Printed: P_1^-1 = 2 P_1^1; "
                 "right: -P_1^1 / 2. The real functions never use it."},
      {.place = {"GP-23", "Legendre table, l <= 4", kTable},
       .printed = "1; c, s; (3c^2-1)/2, 3cs, 3s^2; (5c^3-3c)/2, 3/2(5c^2-1)s, 15cs^2, 15s^3; (35c^4-30c^2+3)/8, "
                  "5/2(7c^3-3c)s, 15/2(7c^2-1)s^2, 105cs^3, 105s^4",
       .readings = {holds("P(0,0) == 1; P(1,0) == c; P(1,1) == s; P(2,0) == (3*c^2-1)/2; P(2,1) == 3*c*s; P(2,2) == "
                          "3*s^2; P(3,0) == (5*c^3-3*c)/2; P(3,1) == 3/2*(5*c^2-1)*s; P(3,2) == 15*c*s^2; P(3,3) == "
                          "15*s^3; P(4,0) == (35*c^4-30*c^2+3)/8; P(4,1) == 5/2*(7*c^3-3*c)*s; P(4,2) == "
                          "15/2*(7*c^2-1)*s^2; P(4,3) == 105*c*s^3; P(4,4) == 105*s^4")},
       .remark = "The text calls the orders positive; they are m >= 0."},
      {.place = {"GP-25", "The Actual Definition"},
       .printed = "sqrt2 K_l^m cos(mp) P_l^m, m > 0; K_l^0 P_l^0; sqrt2 K_l^m sin(-mp) P_l^-m, m < 0",
       .readings = {holds("l=0..6, m=-l..l: K(l,abs(m))*Phi(m,cp,sp)*P(l,abs(m)) == polar(Y(l,m))")},
       .remark = "Quoted from a paper whose own P has the Condon-Shortley phase: with that P every function of odd "
                 "order has the other sign, which the page does not mention."},
      {.place = {"GP-29", "y_2^2, first step"},
       .printed = "sqrt2 sqrt((4+1)/pi (2-|2|)!/(2+|2|)!) = sqrt(5/(48 pi))",
       .readings = {fails("sqrt(2)*sqrt((4+1)/Pi*factorial(0)/factorial(4)) == sqrt(5/(48*Pi))")},
       .correct = "sqrt2 sqrt((4+1)/(4 pi) (2-|2|)!/(2+|2|)!) = sqrt(5/(48 pi))",
       .correct_statement = "sqrt(2)*sqrt((4+1)/(4*Pi)*factorial(0)/factorial(4)) == sqrt(5/(48*Pi))",
       .remark = "The 4 of 4 pi is missing: the left side as printed is twice the right one."},
      {.place = {"GP-30", "y_2^2, remaining steps"},
       .printed = "sqrt(5/(48 pi)) 3 sin^2 t cos 2p = 1/4 sqrt(15/pi) (2 cos^2 p sin^2 t - 1 + cos^2 t) = 1/4 "
                  "sqrt(15/pi) (2x^2+z^2-1) = 1/4 sqrt(15/pi) (x^2-y^2)",
       .readings = {holds("sqrt(5/(48*Pi))*3*s^2*cosm(2,cp,sp) == polar(Y(2,2)); sqrt(15/Pi)/4*(2*cp^2*s^2-1+c^2) == "
                          "polar(Y(2,2)); sqrt(15/Pi)/4*(2*x^2+z^2-1) == Y(2,2); sqrt(15/Pi)/4*(x^2-y^2) == Y(2,2)")}},
      {.place = {"GP-36", "Text on the simpler estimate of the area", kText},
       .printed = "(4/N^2) (1+u^2+v^2)^(-3/2) at the center of the texel is less precise",
       .readings = {holds("as a solid angle: 0.544331 for pi/6, 2x2 texels",
                          "4/2^2*(1+1/4+1/4)^(-3/2) ~ 0.544331; Pi/6 ~ 0.523599"),
                    measured(false, "its error over that of the exact solid angle, projecting a smooth function",
                             "> 1")},
       .correct = "the exact solid angle of a texel; the estimate is as good for projecting",
       .remark = "The formula is the one that the page refers to. For projecting it is not the worse choice: its "
                 "errors cancel part of those of sampling at the center (S-32)."},
      {.place = {"GP-37", "Code calcTexelWeight(x, y)", kCode},
       .printed = "A(a,b) = atan2(ab, sqrt(a^2+b^2+1)); A(x0,y0)-A(x0,y1)-A(x1,y0)+A(x1,y1), x0, x1 = x -+ 1/CUBE_DIM",
       .readings =
           {holds("face coordinates of texel centers in [-1,1]",
                  "n=1..6: sum(2/n,k,0,n-1) == 2 & at(at(diffn(diffn(atan(a*b/sqrt(a^2+b^2+1)),a,1),b,1),a,2),b,2) == "
                  "1/9^(3/2); at(at(diffn(diffn(atan(a*b/sqrt(a^2+b^2+1)),a,1),b,1),a,4),b,8) == 1/81^(3/2); "
                  "at(at(diffn(diffn(atan(a*b/sqrt(a^2+b^2+1)),a,1),b,1),a,1/2),b,1) == 1/(9/4)^(3/2); tan(Pi/6) == "
                  "1/sqrt(3)"),
            fails("in [0,1], as the comments on UV space suggest", "n=1..6: sum(2/n,k,0,n-1) == 1")},
       .correct = "half a texel is 1/CUBE_DIM in [-1,1]",
       .remark = "d^2A/da db = (1+a^2+b^2)^(-3/2), and the windows cover the face once. cubemapFaceCoords is not "
                 "printed; HALF_TEXEL_SIZE is not used here."},
      {.place = {"GP-38", "Text on the sum of the weights", kText},
       .printed = "all weights sum to about 4 pi, which verifies the function",
       .readings = {holds("the sum is 4 pi, in [-1,1] exactly", "6*4*Pi/6 == 4*Pi; tan(Pi/6) == 1/sqrt(3)"),
                    fails("the sum shows that single weights are right",
                          "4*Pi/(6*4^2) <= atan(1/sqrt(3))-2*atan(1/2/sqrt(9/4))+atan(1/4/sqrt(3/2))"),
                    measured(true, "the weights of a cube map of 128 x 128 texels a face", "12.566")},
       .correct = "check single weights: a corner texel, or a quarter of a face, pi/6",
       .remark = "Equal weights for all texels have the same sum. With coordinates in [0,1] every weight is wrong, and "
                 "at CUBE_DIM = 128 the sum is still within 0.1 % of 4 pi."},
      {.place = {"GP-40", "Text on gamma, srgbToLinear", kText},
       .printed = "the input is sRGB; linear = value^2.2",
       .readings = {fails("the sRGB transfer function", "(10/255)^(11/5) == 10/255/(323/25)"),
                    holds("an approximation of it, within 0.009 for all 256 codes",
                          "k=0..10: (k/255)^(11/5)-k/255/(323/25) < 9/1000; k/255/(323/25)-(k/255)^(11/5) < 9/1000 & "
                          "k=11..255: (k/255)^(11/5)-((k/255+11/200)/(211/200))^(12/5) < 9/1000; "
                          "((k/255+11/200)/(211/200))^(12/5)-(k/255)^(11/5) < 9/1000")},
       .correct = "v/12.92 for v <= 0.04045, else ((v+0.055)/1.055)^2.4",
       .remark = "Dark codes are far off in proportion: 10/255 gives 27 % of the right value."},
      {.place = {"GP-43", "Window"},
       .printed = "w(0) = 1, w(l) = (sin(pi l/q)/(pi l/q))^p; tapers to 0 as l grows; p blurs",
       .readings = {holds("0 <= l <= q; p whole: p convolutions with h_l0 = w(l) sqrt((2l+1)/(4 pi))",
                          "l=1..2: sin(Pi*l/3)/(Pi*l/3) > sin(Pi*(l+1)/3)/(Pi*(l+1)/3); sin(Pi*l/3)/(Pi*l/3) >= 0"),
                    fails("every l, with p = 1", "l=1..5: sin(Pi*l/3)/(Pi*l/3) >= 0")},
       .correct = "w(l) for l <= q, 0 beyond",
       .remark = "Beyond q the window is negative for odd p and undefined for fractional p: -0.207 at l = 4 for q = 3, "
                 "p = 1."},
      {.place = {"GP-46", "Convolution on the sphere"},
       .printed = "(f*g)(t) = <f, rho_t g> = INT f(w) rho_t(g(w)) dw, rho_t turns the north pole to t",
       .readings = {fails("any g", "rotz(Y(1,1),ca,sa) == Y(1,1)"),
                    holds("g zonal", "l=1..4: rotz(Y(l,0),ca,sa) == Y(l,0)")},
       .correct = "(f*h)(t) = INT f(w) h(w.t) dw, h zonal",
       .remark = "The rotation is fixed up to a turn about t only; for other g the result lives on SO(3). The notation "
                 "should be (rho_t g)(w)."},
      {.place = {"GP-47", "Convolution theorem"},
       .printed = "(f*h)_l^m = sqrt(4 pi/(2l+1)) f_l^m h_l^0",
       .readings = {holds("n=0..3, l=0..3, m=-l..l: sphere((x*s*cp+y*s*sp+z*c)^n*Y(l,m)) == "
                          "sqrt(4*Pi/(2*l+1))*sphere(z^n*Y(l,0))*polar(Y(l,m))")},
       .remark = "Printed twice, once with h = A."},
      {.place = {"GP-49", "A_0, A_1"},
       .printed = "A_0 = sqrt(pi)/2, A_1 = sqrt(pi/3)",
       .readings = {holds("cap(z*Y(0,0),0) == sqrt(Pi)/2; cap(z*Y(1,0),0) == sqrt(Pi/3)")},
       .remark = "The paper credited with them tabulates sqrt(4 pi/(2l+1)) A_l = pi, 2 pi/3, pi/4 instead."},
      {.place = {"GP-50", "Text after A_0, A_1", kText},
       .printed = "multiplying band 0 by A_0 and band 1 by A_1 would definitely work",
       .readings = {fails("cap(z*Y(0,0),0)*sphere(Y(0,0))*Y(0,0) == cap(z,0)")},
       .correct = "factors sqrt(4 pi/(2l+1)) A_l: pi and 2 pi/3",
       .correct_statement = "A(0)*sphere(Y(0,0))*Y(0,0) == cap(z,0); A(0) == Pi; A(1) == 2*Pi/3",
       .remark =
           "Band 0 would be 3.54 times too dark, band 1 2.05 times. The page uses the right formula two lines later."},
      {.place = {"GP-53", "Code shEvaluateDiffuseL1(p)", kCode},
       .printed = "sh = (1/4, p.y/2, p.z/2, p.x/2)",
       .readings = {holds("sum(sum(A(l)*Y(l,m)*polar(Y(l,m)),m,-l,l),l,0,1) == 1/4+(x*s*cp+y*s*sp+z*c)/2")},
       .remark = "Irradiance, not divided by pi; the radiance of the sample and its solid angle multiply it outside."},
      {.place = {"GP-54", "Text after the code", kText},
       .printed = "evaluation is a dot product with the normal",
       .readings = {fails("the normal n", "sphere((y*ty+z*tz+x*tx)/2) == Pi"),
                    holds("(1, n.y, n.z, n.x)", "sphere(1/4+(y*ty+z*tz+x*tx)/2) == Pi")},
       .correct = "dot(sh, (1, n.y, n.z, n.x))",
       .remark = "For uniform light, whose irradiance is pi; three components drop the 1/4 and give 0."},
  };
}

}  // namespace sh::errata
