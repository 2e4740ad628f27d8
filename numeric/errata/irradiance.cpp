// RH: [RamamoorthiHanrahan01a]; BJ: [BasriJacobs03].
#include "numeric/errata/parts.hpp"

namespace sh::errata {

std::vector<Entry> ramamoorthi() {
  return {
      {.place = {"RH-02", "Eq. 2"},
       .printed = "B(p,n) = rho(p) E(n)",
       .readings = {holds("B is radiosity, flux per area", "cap(rho/Pi*v*z,0) == rho*v"),
                    fails("B is radiance", "cap(rho*v*z,0) == rho*v")},
       .correct = "radiosity B = rho E, exit radiance L = rho E / pi",
       .remark = "Taken for radiance, a white surface would send back pi times the flux that it receives."},
      {.place = {"RH-03", "Eq. 3, basis constants", kTable},
       .printed = "Y_00 = 0.282095; (Y_11; Y_10; Y_1-1) = 0.488603 (x; z; y); (Y_21; Y_2-1; Y_2-2) = 1.092548 (xz; yz; "
                  "xy); Y_20 = 0.315392 (3z^2-1); Y_22 = 0.546274 (x^2-y^2)",
       .readings = {holds(
           "Y(0,0) == sqrt(1/Pi)/2; Y(1,-1) == sqrt(3/Pi)/2*y; Y(1,0) == sqrt(3/Pi)/2*z; Y(1,1) == sqrt(3/Pi)/2*x; "
           "Y(2,-2) == sqrt(15/Pi)/2*x*y; Y(2,-1) == sqrt(15/Pi)/2*y*z; Y(2,0) == sqrt(5/Pi)/4*(3*z^2-1); Y(2,1) == "
           "sqrt(15/Pi)/2*x*z; Y(2,2) == sqrt(15/Pi)/4*(x^2-y^2); sqrt(1/Pi)/2 ~ 0.282095; sqrt(3/Pi)/2 ~ 0.488603; "
           "sqrt(15/Pi)/2 ~ 1.092548; sqrt(5/Pi)/4 ~ 0.315392; sqrt(15/Pi)/4 ~ 0.546274")},
       .remark = "1/(2 sqrt pi), sqrt(3/pi)/2, sqrt(15/pi)/2, sqrt(5/pi)/4, sqrt(15/pi)/4."},
      {.place = {"RH-06", "Eq. 8"},
       .printed =
           "Ahat_1 = 2 pi/3; Ahat_l = 0 for odd l > 1; even l: 2 pi (-1)^{l/2-1}/((l+2)(l-1)) l!/(2^l ((l/2)!)^2)",
       .readings = {holds("k=0..4: 2*Pi*(-1)^(k-1)/((2*k+2)*(2*k-1))*factorial(2*k)/(2^(2*k)*factorial(k)^2) == "
                          "A(2*k); A(2*k+3) == 0 & A(1) == 2*Pi/3")},
       .remark = "l = 0 works too: (-1)^{-1} = -1 gives pi."},
      {.place = {"RH-07", "Eq. 9", kTable},
       .printed = "Ahat_0.. = 3.141593, 2.094395, 0.785398, 0, -0.130900, 0, 0.049087",
       .readings = {holds("A(0) ~ 3.141593; A(1) ~ 2.094395; A(2) ~ 0.785398; A(3) ~ 0; A(4) ~ -0.130900; A(5) ~ 0; "
                          "A(6) ~ 0.049087")}},
      {.place = {"RH-10", "Eqs. 11 to 13, matrix M", kTable},
       .printed = "M = [[c1 L22, c1 L2-2, c1 L21, c2 L11], [., -c1 L22, c1 L2-1, c2 L1-1], [., ., c3 L20, c2 L10], [., "
                  "., ., c4 L00 - c5 L20]]; E(n) = n^T M n, n = (x,y,z,1)",
       .readings = {holds("Pi/4*Y(2,2) == sqrt(15*Pi)/16*(x^2-y^2); Pi/4*Y(2,0) == 3*sqrt(5*Pi)/16*z^2-sqrt(5*Pi)/16; "
                          "Pi*Y(0,0) == sqrt(Pi)/2; Pi/4*Y(2,-2) == 2*sqrt(15*Pi)/16*x*y; Pi/4*Y(2,1) == "
                          "2*sqrt(15*Pi)/16*x*z; Pi/4*Y(2,-1) == 2*sqrt(15*Pi)/16*y*z; 2*Pi/3*Y(1,1) == "
                          "2*sqrt(3*Pi)/6*x; 2*Pi/3*Y(1,-1) == 2*sqrt(3*Pi)/6*y; 2*Pi/3*Y(1,0) == 2*sqrt(3*Pi)/6*z")},
       .remark = "|n| = 1 is not needed for the identity with the polynomials of eq. 3."},
      {.place = {"RH-11", "Eq. 12, constants", kTable},
       .printed = "c1 = 0.429043, c2 = 0.511664, c3 = 0.743125, c4 = 0.886227, c5 = 0.247708",
       .readings = {fails("sqrt(15*Pi)/16 ~ 0.429043; sqrt(3*Pi)/6 ~ 0.511664; 3*sqrt(5*Pi)/16 ~ 0.743125; sqrt(Pi)/2 "
                          "~ 0.886227; sqrt(5*Pi)/16 ~ 0.247708")},
       .correct = "c1 = sqrt(15 pi)/16 = 0.429043, c2 = sqrt(3 pi)/6 = 0.511663, c3 = 3 sqrt(5 pi)/16 = 0.743124, c4 = "
                  "sqrt(pi)/2 = 0.886227, c5 = sqrt(5 pi)/16 = 0.247708",
       .correct_statement = "sqrt(15*Pi)/16 ~ 0.429043; sqrt(3*Pi)/6 ~ 0.511663; 3*sqrt(5*Pi)/16 ~ 0.743124; "
                            "sqrt(Pi)/2 ~ 0.886227; sqrt(5*Pi)/16 ~ 0.247708",
       .remark = "The last digits of c2 and c3: they are products of factors that were already rounded, 2.094395 * "
                 "0.488603 / 2 and 3 * 0.785398 * 0.315392."},
      {.place = {"RH-13", "Error claims", kText},
       .printed = "nine coefficients: average error under 3 %, maximum 9 % for any light, about 1 % typical",
       .readings = {holds("mean absolute and largest error over INT L, in whole percents",
                          "at((3/32-t/2+15/32*t^2),t,(8-sqrt(19))/15) == 0; "
                          "integral(t,0,(8-sqrt(19))/15,(3/32-t/2+15/32*t^2))-integral(t,(8-sqrt(19))/15,(8+sqrt(19))/"
                          "15,(3/32-t/2+15/32*t^2))+integral(t,(8+sqrt(19))/15,1,(3/32-t/2+15/32*t^2)) == "
                          "19*sqrt(19)/2700; 100*19*sqrt(19)/2700 ~ 3; 100*at((3/32-t/2+15/32*t^2),t,0) ~ 9"),
                    fails("the same as bounds: < 3 % and <= 9 %", "19*sqrt(19)/2700 < 3/100; 3/32 <= 9/100"),
                    fails("root mean square in whole percents",
                          "integral(t,0,1,(3/32-t/2+15/32*t^2)^2) == 1/768; 100/sqrt(768) ~ 3"),
                    measured(true, "average error for the worst light", "3", "%"),
                    measured(true, "largest error for the worst light", "9", "%"),
                    measured(true, "average error for typical lights", "1", "%")},
       .correct =
           "one light: largest 3/32 = 9.375 %, mean absolute 19 sqrt(19)/2700 = 3.07 %, rms 1/sqrt(768) = 3.61 %",
       .remark = "Measured for the worst of random sets of lights and for typical skies."},
  };
}

std::vector<Entry> basri_jacobs() {
  return {
      {.place = {"BJ-01", "Energy of the clamped cosine", kText},
       .printed = "three bands hold 99.22 % of the energy of the clamped cosine",
       .readings = {{"share of bands 0 to 2 in INT max(0, z)^2", true,
                     "100*sum((2*l+1)*Pi*integral(c,0,1,c*P(l,0))^2,l,0,2)/(2*Pi/3) ~ 99.22", "99.22", "%"}}},
  };
}

}  // namespace sh::errata
