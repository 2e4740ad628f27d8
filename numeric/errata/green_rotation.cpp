// G: [Green03], products and rotation.
#include "numeric/errata/parts.hpp"

namespace sh::errata {

std::vector<Entry> green_rotation() {
  return {
      {.place = {"G-53", "Eq. 7"},
       .printed = "INT_S L~(s) t~(s) ds = sum_(i=0)^(n^2) L_i t_i",
       .readings = {fails(
           "sphere(Y(0,0))^2+sum(sphere((1+x*y)*Y(1,m))^2,m,-1,1)+sphere((1+x*y)*Y(2,-2))^2 == sphere(1)")},
       .correct = "sum_(i=0)^(n^2-1) L_i t_i",
       .correct_statement = "sphere(Y(0,0))^2+sum(sphere((1+x*y)*Y(1,m))^2,m,-1,1) == sphere(1)",
       .remark = "One term too many."},
      {.place = {"G-54", "Eq. 8, triple product matrix"},
       .printed = "M_ij = INT_S b(s) y_i(s) y_j(s) ds",
       .readings = {holds("l=0..2, m=-l..l: sum(sum(sphere((1+x)*Y(l,m)*Y(n,q))*sphere((z+2*y)*Y(n,q)),q,-n,n),n,0,1) "
                          "== sphere((1+x)*(z+2*y)*Y(l,m))")},
       .remark = "Symmetric."},
      {.place = {"G-55", "Eq. 9"},
       .printed = "c_i = sum_(j=1)^(n^2) M_ij a_i",
       .readings = {fails("a_i, as the order of the subscripts in the text says, 1-based",
                          "l=0..1, m=-l..l: sum(sum(sphere((1+z)*Y(l,m)*Y(n,q)),q,-n,n),n,0,1)*sphere((2+x)*Y(l,m)) == "
                          "sphere((1+z)*(2+x)*Y(l,m))"),
                    fails("a_j with i = l(l+1)+m, as the paper defines it",
                          "l=0..1, m=-l..l: "
                          "sum(sum(sphere((1+z)*Y(l,m)*Y(n,q))*sphere((2+x)*Y(n,q)),q,-n,n),n,1,1)+sphere((1+z)*Y(l,m)*"
                          "Y(2,-2))*sphere((2+x)*Y(2,-2)) == sphere((1+z)*(2+x)*Y(l,m))"),
                    holds("a_j with i = l(l+1)+m+1",
                          "l=0..1, m=-l..l: sum(sum(sphere((1+z)*Y(l,m)*Y(n,q))*sphere((2+x)*Y(n,q)),q,-n,n),n,0,1) == "
                          "sphere((1+z)*(2+x)*Y(l,m))")},
       .correct = "c_i = sum_(j=0)^(n^2-1) M_ij a_j, i = l(l+1)+m",
       .remark = "With a_i the sum would only scale each coefficient of the light."},
      {.place = {"G-56", "Text after Eq. 9", kText},
       .printed = "multiplying by M gives exactly the projection of the light times the mask",
       .readings = {holds("the light has n bands only",
                          "l=0..1, m=-l..l: sum(sum(sphere((1+z)*Y(l,m)*Y(n,q))*sphere((2+x)*Y(n,q)),q,-n,n),n,0,1) == "
                          "sphere((1+z)*(2+x)*Y(l,m))"),
                    fails("any light, M n^2 by n^2",
                          "l=0..1, m=-l..l: sum(sum(sphere((1+z)*Y(l,m)*Y(n,q))*sphere((z^2)*Y(n,q)),q,-n,n),n,0,1) == "
                          "sphere((1+z)*z^2*Y(l,m))")},
       .correct = "exact when the light is band-limited to the columns that are kept",
       .remark = "Bands of the light from n on feed lower bands of the product."},
      {.place = {"G-60", "Rotation matrix by integration"},
       .printed = "M_ij = INT_S y_i(R s) y_j(s) ds maps unrotated to rotated coefficients",
       .readings =
           {holds("R on y_i; rotated f is f(R^-1 s)",
                  "l=1..2, m=-l..l, n=-l..l: sphere(turned(Y(l,m))*Y(l,n)) == sphere(turned_back(Y(l,n))*Y(l,m))"),
            fails("R on y_i; rotated f is f(R s)",
                  "l=1..2, m=-l..l, n=-l..l: sphere(turned(Y(l,m))*Y(l,n)) == sphere(turned(Y(l,n))*Y(l,m))"),
            fails("R on y_j; rotated f is f(R^-1 s)",
                  "l=1..2, m=-l..l, n=-l..l: sphere(Y(l,m)*turned(Y(l,n))) == sphere(turned_back(Y(l,n))*Y(l,m))")},
       .correct = "M_ij = INT y_i(R s) y_j(s) ds for (R f)(s) = f(R^-1 s)",
       .remark = "The place of R did not survive well and 'rotated' is not defined; the paper's rotational invariance "
                 "uses f(R s), which takes the transpose."},
      {.place = {"G-61", "Rotation about z by integration"},
       .printed = "M_ij = INT_0^pi INT_0^2pi y_i(theta, phi+alpha) y_j(theta, phi) sin(theta) dphi dtheta",
       .readings =
           {holds("alpha in y_i: the rotation by +alpha",
                  "l=1..2, m=-l..l, n=-l..l: sphere(rotz(Y(l,m),ca,sa)*Y(l,n)) == sphere(Y(l,m)*rotz(Y(l,n),ca,-sa))"),
            fails("alpha in y_j: the rotation by +alpha",
                  "l=1..2, m=-l..l, n=-l..l: sphere(Y(l,m)*rotz(Y(l,n),ca,sa)) == sphere(Y(l,m)*rotz(Y(l,n),ca,-sa))"),
            fails("limits exchanged, theta to 2 pi and phi to pi: M_00 = 1", "1/(4*Pi)*Pi*(cos(0)-cos(2*Pi)) == 1")},
       .correct = "band 1 in the order y, z, x: [[c,0,s],[0,1,0],[-s,0,c]]",
       .remark = "The extracted glyphs do not say which factor carries alpha, nor which limits belong to which angle."},
      {.place = {"G-63", "ZYZ text", kText},
       .printed = "ZYZ needs only two rotations; about y: 90 degrees about x, then about z, then -90 about x",
       .readings = {holds("two kinds of rotation; each about fixed axes, Ry(b) = Rx(-90) Rz(b) Rx(90)",
                          "rotx(rotz(rotx(tx*x+ty*y+tz*z,0,-1),cb,sb),0,1) == roty(tx*x+ty*y+tz*z,cb,sb)"),
                    fails("each about the turned axes, Ry(b) = Rx(90) Rz(b) Rx(-90)",
                          "rotx(rotz(rotx(tx*x+ty*y+tz*z,0,1),cb,sb),0,-1) == roty(tx*x+ty*y+tz*z,cb,sb)"),
                    fails("two rotations, about z and y, reach every orientation", "R(0,-1)*R(-1,0) == 0")},
       .correct = "Ry(b) = Rx(-90) Rz(b) Rx(90)",
       .remark = "Two rotations do for functions that are symmetric about z. Rx(90) Rz(b) Rx(-90) is Ry(-b)."},
      {.place = {"G-64", "Constant matrices of the rotations by +-90 degrees about x", kTable, kLost},
       .printed = "arrays of constants for three bands",
       .correct = "X(90): 1; [[0,-1,0],[1,0,0],[0,0,1]]; rows (0,0,0,-1,0), (0,-1,0,0,0), (0,0,-1/2,0,-sqrt3/2), "
                  "(1,0,0,0,0), (0,0,-sqrt3/2,0,1/2); X(-90) is the transpose",
       .correct_statement =
           "rotx(Y(1,-1),0,1) == -Y(1,0); rotx(Y(1,0),0,1) == Y(1,-1); rotx(Y(1,1),0,1) == Y(1,1); rotx(Y(2,-2),0,1) "
           "== -Y(2,1); rotx(Y(2,-1),0,1) == -Y(2,-1); rotx(Y(2,0),0,1) == -Y(2,0)/2-sqrt(3)/2*Y(2,2); "
           "rotx(Y(2,1),0,1) == Y(2,-2); rotx(Y(2,2),0,1) == -sqrt(3)/2*Y(2,0)+Y(2,2)/2",
       .remark = "With Condon-Shortley signs entry (m,n) takes the factor (-1)^(m+n)."},
      {.place = {"G-65", "Product of five matrices"},
       .printed = "R_SH(alpha,beta,gamma) = Z_gamma X_-90 Z_beta X_+90 Z_alpha",
       .readings = {holds("columns; ZYZ about fixed axes, alpha first",
                          "rotz(rotx(rotz(rotx(rotz(tx*x+ty*y+tz*z,cg,sg),0,-1),cb,sb),0,1),ca,sa) == "
                          "rotz(roty(rotz(tx*x+ty*y+tz*z,cg,sg),cb,sb),ca,sa)"),
                    fails("columns; ZYZ about turned axes, alpha first",
                          "rotz(rotx(rotz(rotx(rotz(tx*x+ty*y+tz*z,cg,sg),0,-1),cb,sb),0,1),ca,sa) == "
                          "rotz(roty(rotz(tx*x+ty*y+tz*z,ca,sa),cb,sb),cg,sg)")},
       .correct = "D(Rz(gamma) Ry(beta) Rz(alpha)) on columns",
       .remark = "For row vectors the angle beta changes sign. The identities for the angles (G-69) use another order "
                 "than this product."},
      {.place = {"G-68", "ZYZ angles from a 3x3 matrix", kEquation, kLost},
       .printed = "identities for the cosines and sines of alpha, beta, gamma",
       .correct = "cos b = R_ZZ, sin b = sqrt(1 - R_ZZ^2), cos a = R_XZ/sin b, sin a = R_YZ/sin b, cos g = -R_ZX/sin "
                  "b, sin g = R_ZY/sin b for R = Rz(a) Ry(b) Rz(g) on columns",
       .correct_statement = "R(0,0) == cos_b; sqrt(1-R(0,0)^2) == sin_b; R(1,0)/sin_b == cos_a; R(-1,0)/sin_b == "
                            "sin_a; -R(0,1)/sin_b == cos_g; R(0,-1)/sin_b == sin_g",
       .remark = "Row vectors take the transpose of R. sqrt(1 - R_ZZ^2) loses half the digits near b = 0 and pi: use "
                 "sqrt(R_XZ^2 + R_YZ^2). Nothing is left at sin b = 0, as the paper says."},
      {.place = {"G-69", "Special case sin beta = 0"},
       .printed = "cos alpha = R_YY, sin alpha = -R_YX, cos gamma = 1, sin gamma = 0 (gamma printed as lambda)",
       .readings = {holds("rows, Rz(a) Ry(b) Rz(g), beta = 0",
                          "diffn(rotz(y,ca,-sa),y,1) == ca; -diffn(rotz(y,ca,-sa),x,1) == sa"),
                    holds("rows, Rz(a) Ry(b) Rz(g), beta = pi",
                          "diffn(rotz(roty(y,-1,0),ca,-sa),y,1) == ca; -diffn(rotz(roty(y,-1,0),ca,-sa),x,1) == sa"),
                    fails("columns, Rz(a) Ry(b) Rz(g), beta = 0",
                          "diffn(rotz(y,ca,sa),y,1) == ca; -diffn(rotz(y,ca,sa),x,1) == sa"),
                    holds("columns, Rz(a) Ry(b) Rz(g), beta = pi",
                          "diffn(roty(rotz(y,ca,sa),-1,0),y,1) == ca; -diffn(roty(rotz(y,ca,sa),-1,0),x,1) == sa"),
                    fails("rows, Rz(g) Ry(b) Rz(a), beta = pi",
                          "diffn(roty(rotz(y,ca,-sa),-1,0),y,1) == ca; -diffn(roty(rotz(y,ca,-sa),-1,0),x,1) == sa")},
       .correct = "cos a = R_YY, sin a = -R_YX, gamma = 0 where R maps row vectors, R = (Rz(a) Ry(b) Rz(g))^T",
       .remark = "Only one matrix is shown for sin beta = 0, though cos beta may be 1 or -1."},
      {.place = {"G-97", "Appendix 1, tables of u, v, w and U, V, W, P", kTable, kReport},
       .printed = "V for m < 0 (d = delta_(m,-1)): P(1,m+1) (1+d) + P(-1,-m-1) sqrt(1-d); the rest is lost",
       .readings = {fails("l=2..4, m=-l..-1, n=-l..l: D(l,m,n) == "
                          "IRu(l,m,n)*IRP(0,m,n,l)+IRv(l,m,n)*((1+delta(m,-1))*IRP(1,m+1,n,l)+sqrt(1-delta(m,-1))*IRP(-"
                          "1,-m-1,n,l))+IRw(l,m,n)*(IRP(1,m-1,n,l)-IRP(-1,1-m,n,l))")},
       .correct = "V for m < 0: P(1,m+1) (1-d) + P(-1,-m-1) sqrt(1+d)",
       .correct_statement = "l=2..4, m=-l..-1, n=-l..l: D(l,m,n) == "
                            "IRu(l,m,n)*IRP(0,m,n,l)+IRv(l,m,n)*((1-delta(m,-1))*IRP(1,m+1,n,l)+sqrt(1+delta(m,-1))*"
                            "IRP(-1,-m-1,n,l))+IRw(l,m,n)*(IRP(1,m-1,n,l)-IRP(-1,1-m,n,l))",
       .remark = "Known from a remark in google/spherical-harmonics, whose authors read the page. In band 2 row -1 is "
                 "wrong and no other; the error spreads from there. Tables: u^2 = (l+m)(l-m)/d', v = (1-2 delta_m0)/2 "
                 "sqrt((1+delta_m0)(l+|m|-1)(l+|m|)/d'), w = -(1-delta_m0)/2 sqrt((l-|m|-1)(l-|m|)/d'), d' = "
                 "(l+n)(l-n) or 2l(2l-1) for |n| = l; U = P(0,m)."},
  };
}

}  // namespace sh::errata
