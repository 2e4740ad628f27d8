// G: [Green03], Legendre functions and real spherical harmonics.
#include "numeric/errata/parts.hpp"

namespace sh::errata {

std::vector<Entry> green_basis() {
  return {
      {.place = {"G-19", "Associated Legendre polynomials, text", kText},
       .printed = "associated Legendre polynomials return real numbers, ordinary ones complex numbers",
       .readings = {fails("l=1..6: imag_part(P(l,0)) != 0")},
       .correct = "P_l = P_l^0, real on [-1,1]",
       .correct_statement =
           "l=0..6: imag_part(P(l,0)) == 0; greenP(l,0) == P(l,0); imag_part(cosm(1,cp,sp)+I*sinm(1,cp,sp)) == sp",
       .remark = "What is complex is exp(i m phi) in the complex Y_l^m."},
      {.place = {"G-21", "Text, orthogonality of P_l^m", kText},
       .printed = "inside a band orthogonal with respect to a constant, between bands with a different constant",
       .readings = {holds("between bands, same m: INT P_l^m P_k^m dx = 2/(2l+1) (l+m)!/(l-m)! delta_lk",
                          "m=0..4, l=m..5, k=m..5: integral(c,-1,1,diffn(P(l,0),c,m)*diffn(P(k,0),c,m)*(1-c^2)^m) == "
                          "delta(l,k)*2/(2*l+1)*factorial(l+m)/factorial(l-m)"),
                    fails(
                        "inside a band, m != n: INT P_l^m P_l^n dx = 0",
                        "l=2..6, n=0..l-2: integral(c,-1,1,diffn(P(l,0),c,n)*diffn(P(l,0),c,n+2)*(1-c^2)^(n+1)) == 0"),
                    holds("inside a band: INT P_l^m P_l^n / (1-x^2) dx = (l+m)!/(m (l-m)!) delta_mn",
                          "l=2..6, n=0..l-2: integral(c,-1,1,diffn(P(l,0),c,n)*diffn(P(l,0),c,n+2)*(1-c^2)^n) == 0; "
                          "integral(c,-1,1,diffn(P(l,0),c,n+1)*diffn(P(l,0),c,n+1)*(1-c^2)^n) == "
                          "factorial(l+n+1)/((n+1)*factorial(l-n-1))")},
       .correct = "inside a band the weight is 1/(1-x^2)",
       .remark = "Without the weight INT P_2^0 P_2^2 dx = -4/5."},
      {.place = {"G-22", "Text, triangular grid", kText},
       .printed = "n(n+1) coefficients for n bands of 0 <= m <= l",
       .readings = {fails("n=1..8: sum(l+1,l,0,n-1) == n*(n+1)")},
       .correct = "n(n+1)/2",
       .correct_statement = "n=1..8: sum(l+1,l,0,n-1) == n*(n+1)/2",
       .remark = "Fig. 4 shows six for three bands. The spherical harmonics are n^2."},
      {.place = {"G-23", "Text before the recurrences", kText},
       .printed = "the usual definition uses derivatives of imaginary numbers and cancellations of alternating sign",
       .readings = {fails("l=1..6, n=0..l: imag_part(diffn((c^2-1)^l,c,n)) != 0")},
       .correct = "P_l^m = (-1)^m (1-x^2)^(m/2) D^m P_l, P_l = D^l (x^2-1)^l / (2^l l!)",
       .correct_statement = "l=0..8, m=0..l: "
                            "(1-c^2)*diffn(P(l,0),c,m+2)-2*(m+1)*c*diffn(P(l,0),c,m+1)+(l*(l+1)-m*(m+1))*diffn(P(l,0),"
                            "c,m) == 0; at(P(l,0),c,1) == 1",
       .remark = "The polynomial that is differentiated is real. The cancellations are there."},
      {.place = {"G-24", "Recurrence rule 1"},
       .printed = "(l-m) P_l^m = x (2l-1) P_(l-1)^m - (l+m-1) P_(l-2)^m",
       .readings = {holds("l=2..10, m=0..l: (l-m)*P(l,m) == c*(2*l-1)*P(l-1,m)-(l+m-1)*P(l-2,m)")}},
      {.place = {"G-25", "Recurrence rule 2"},
       .printed = "P_m^m = (-1)^m (2m-1)!! (1-x^2)^(m/2), x!! the product of the odd integers up to x, P_0^0 = 1",
       .readings = {holds("with the Condon-Shortley phase, P_l^m = (-1)^m (1-x^2)^(m/2) D^m P_l",
                          "m=0..10: (-1)^m*P(m,m) == (-1)^m*odd(2*m-1)*s^m"),
                    fails("without it", "m=0..10: P(m,m) == (-1)^m*odd(2*m-1)*s^m")},
       .correct = "P_m^m = (2m-1)!! (1-x^2)^(m/2) without the phase",
       .correct_statement = "m=0..10: P(m,m) == odd(2*m-1)*s^m",
       .remark = "Every function of odd m changes sign against a basis without the phase: y_1^1 points along -x. The "
                 "coefficients of the paper's example (G-47) have this sign."},
      {.place = {"G-26", "Recurrence rule 3"},
       .printed = "P_(m+1)^m = x (2m+1) P_m^m",
       .readings = {holds("m=0..10: P(m+1,m) == c*(2*m+1)*P(m,m)")}},
      {.place = {"G-27", "Text after rule 3", kText},
       .printed = "rule 1 has less roundoff error than iterating rule 3",
       .readings = {fails("rule 3 can be iterated, P_(l+1)^m = x (2m+1) P_l^m",
                          "m=0..4, l=m..6: P(l+1,m) == c*(2*m+1)*P(l,m)"),
                    fails("rule 3 can be iterated, P_(l+1)^m = x (2l+1) P_l^m",
                          "m=0..4, l=m..6: P(l+1,m) == c*(2*l+1)*P(l,m)")},
       .correct = "rule 3 once, then rule 1",
       .correct_statement = "m=0..6: P(m+1,m) == c*(2*m+1)*P(m,m) & m=0..4, l=m+2..8: (l-m)*P(l,m) == "
                            "c*(2*l-1)*P(l-1,m)-(l+m-1)*P(l-2,m)",
       .remark =
           "There is nothing to compare: rule 3 leads from P_m^m to P_(m+1)^m and no further, whatever the rounding."},
      {.place = {"G-28", "Code P(l,m,x)", kCode},
       .printed = "pmm = prod_(i=1)^m -(2i-1) sqrt((1-x)(1+x)), then rule 3, then rule 1",
       .readings = {holds("0 <= m <= l, with the Condon-Shortley phase",
                          "l=0..8, m=0..l: greenP(l,m) == (-1)^m*P(l,m)"),
                    fails("0 <= m <= l, without it", "l=0..8, m=0..l: greenP(l,m) == P(l,m)"),
                    fails("-l <= m < 0", "l=1..6, m=-l..-1: greenP(l,m) == (-1)^m*P(l,m)")},
       .remark = "The range of m is not checked; SH asks for m >= 0 only."},
      {.place = {"G-30", "Eq. 6, real spherical harmonics", kEquation, kReport},
       .printed = "y_l^m = sqrt2 K_l^m cos(m p) P_l^m(cos t) for m > 0, K_l^0 P_l^0(cos t), sqrt2 K_l^m sin(-m p) "
                  "P_l^-m(cos t) for m < 0",
       .readings = {fails("band 1 is (y, z, x) sqrt(3/(4 pi)) and so on without signs, P with the phase",
                          "l=0..6, m=-l..l: K(l,abs(m))*Phi(m,cp,sp)*(-1)^m*P(l,abs(m)) == polar(Y(l,m))"),
                    holds("the same, P without the phase",
                          "l=0..6, m=-l..l: K(l,abs(m))*Phi(m,cp,sp)*P(l,abs(m)) == polar(Y(l,m))")},
       .correct =
           "P_l^m = (1-x^2)^(m/2) D^m P_l gives the basis without Condon-Shortley phase; rule 2 gives (-1)^m times it",
       .remark = "Lost in the text; this is how gpfault's article quotes it."},
      {.place = {"G-32", "Text after Eq. 6", kText},
       .printed = "y_l^m(theta, phi), l in R^+, -l <= m <= l",
       .readings = {fails("l any positive real number: the functions stay finite at both poles",
                          "prod((k-1/2)*(k+3/2)/(k+1)^2,k,0,60) == 0"),
                    fails("l any positive integer: the functions are complete",
                          "sum(sphere(Y(l,0))*Y(l,0),l,1,8) == 1")},
       .correct = "l in {0, 1, 2, ...}, m in {-l, ..., l}",
       .correct_statement =
           "l=0..6: sum(prod((q-l)*(q+l+1)/(q+1)^2,q,0,k-1)*((1-c)/2)^k,k,0,l) == P(l,0); sphere(Y(0,0))*Y(0,0) == 1",
       .remark = "The paragraph above it says so in words, but for calling 0 positive."},
      {.place = {"G-34", "Code K(l,m)", kCode},
       .printed = "sqrt((2l+1) (l-m)! / (4 pi (l+m)!))",
       .readings =
           {holds("called with m >= 0, as SH does",
                  "l=0..6, m=0..l: 2*Pi*(K(l,m))^2*integral(c,-1,1,(1-c^2)^m*diffn(P(l,0),c,m)^2) == 1"),
            fails("called with any m",
                  "l=0..6, m=-l..l: 2*Pi*(K(l,m))^2*integral(c,-1,1,(1-c^2)^abs(m)*diffn(P(l,0),c,abs(m))^2) == 1")},
       .correct = "K with |m|",
       .correct_statement =
           "l=0..6, m=-l..l: 2*Pi*(K(l,abs(m)))^2*integral(c,-1,1,(1-c^2)^abs(m)*diffn(P(l,0),c,abs(m))^2) == 1",
       .remark = "For m < 0 it is too large by (l+|m|)!/(l-|m|)!."},
      {.place = {"G-35", "Code SH(l,m,theta,phi)", kCode},
       .printed = "m = 0: K(l,0) P(l,0,cos t); m > 0: sqrt2 K(l,m) cos(m p) P(l,m,cos t); m < 0: sqrt2 K(l,-m) sin(-m "
                  "p) P(l,-m,cos t)",
       .readings = {holds("with the Condon-Shortley phase: (-1)^m times the basis without it",
                          "l=0..6, m=-l..l: K(l,abs(m))*Phi(m,cp,sp)*greenP(l,abs(m)) == (-1)^m*polar(Y(l,m))"),
                    fails("the basis without the phase",
                          "l=0..6, m=-l..l: K(l,abs(m))*Phi(m,cp,sp)*greenP(l,abs(m)) == polar(Y(l,m))")},
       .correct = "(-1)^m SH(l,m,theta,phi) without Condon-Shortley phase"},
      {.place = {"G-36", "Note on the table of factorials", kText},
       .printed = "never more than 33 entries are needed",
       .readings = {holds("degree at most 16", "l=0..16, m=0..l: l+m+1 <= 33"),
                    fails("degree at most 17", "l=0..17, m=0..l: l+m+1 <= 33")},
       .correct = "2l+1 entries 0! .. (2l)! for degree l",
       .remark = "K looks up (l+m)!."},
      {.place = {"G-37", "Fig. 5, text", kText},
       .printed = "l = 1 functions point along the x, y or z axis; linear combinations of just these approximate the "
                  "cosine term very well",
       .readings = {holds("bands 0 and 1 hold 7/8 of the energy of max(0, cos), error at most 1/4",
                          "lambert(1) == 1/4+c/2; sum((2*l+1)*Pi*integral(c,0,1,c*P(l,0))^2,l,0,1)/(2*Pi/3) >= 7/8"),
                    fails("band 1 alone does", "sum((2*l+1)*Pi*integral(c,0,1,c*P(l,0))^2,l,1,1)/(2*Pi/3) >= 7/8"),
                    fails("y_1^m of SH points to +y, +z, +x",
                          "sqrt(2)*sqrt(3/(8*Pi))*sp*greenP(1,1) == polar(Y(1,-1)); "
                          "sqrt(2)*sqrt(3/(8*Pi))*cp*greenP(1,1) == polar(Y(1,1))"),
                    holds("y_1^m of SH points to -y, +z, -x",
                          "sqrt(2)*sqrt(3/(8*Pi))*sp*greenP(1,1) == -polar(Y(1,-1)); "
                          "sqrt(2)*sqrt(3/(8*Pi))*cp*greenP(1,1) == -polar(Y(1,1))")},
       .correct = "max(0, t) ~ 1/4 + t/2",
       .remark = "Band 1 alone holds 1/2 of the energy."},
  };
}

}  // namespace sh::errata
