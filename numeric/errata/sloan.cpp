// S: [SloanKautzSnyder02].
#include "numeric/errata/parts.hpp"

namespace sh::errata {

std::vector<Entry> sloan() {
  return {
      {.place = {"S-08", "Eq. 4"},
       .printed = "g(s) = f(Q(s)) => g~(s) = f~(Q(s)); no aliasing when samples are collected at a rotated set",
       .readings =
           {holds("exact integration",
                  "l=0..2, m=-l..l: sphere(turned((x+2*z)^4)*Y(l,m)) == sum(sphere((x+2*z)^4*Y(l,n))*D(l,n,m),n,-l,l)"),
            fails("sums over finitely many samples",
                  "l=0..2, m=-l..l: octa(turned((x+2*z)^4)*Y(l,m)) == sum(octa((x+2*z)^4*Y(l,n))*D(l,n,m),n,-l,l)")},
       .correct = "samples: only when the rule integrates f y_i exactly",
       .remark = "Second reading: six samples on the axes."},
      {.place = {"S-13", "Text after Eq. 7", kText},
       .printed = "the product's order n projection involves coefficients of the two factors up to order 2n-1",
       .readings = {fails("both factors arbitrary", "sphere(Y(8,0)^2*Y(0,0)) == 0"),
                    holds(
                        "one factor of order n; the product of two such has order 2n-1",
                        "m=-2..2, i=-2..2, j=-6..6: sphere(Y(2,m)*Y(2,i)*Y(6,j)) == 0 & sphere(Y(2,0)^2*Y(4,0)) != 0")},
       .correct = "a is needed to degree 2(n-1) when b has n bands",
       .remark = "Arbitrarily high bands of both factors together reach band 0: the square of y_8,0 does."},
      {.place = {"S-17", "4.1, T_DU and H"},
       .printed =
           "T_DU = (rho/pi) INT L H ds, H = max(N.s,0), M^DU = H; T_DU is the inner product of the coefficient vectors",
       .readings = {holds("rho/pi times the inner product", "rho/Pi*cap(z,0) == rho"),
                    fails("the inner product alone", "cap(z,0) == rho")},
       .correct = "(rho/pi) sum_i L_i H_i",
       .remark = "M holds neither rho nor 1/pi here."},
      {.place = {"S-18", "4.1, second-order projection", kText},
       .printed = "a second-order projection has 9 coefficients; n-th order has n^2, fifth order 25",
       .readings = {fails("order is the number of bands", "2^2 == 9"),
                    fails("order is the degree", "n=1..5: (n+1)^2 == n^2")},
       .correct = "9 coefficients are third order: 3 bands, degree 2",
       .correct_statement = "3^2 == 9; 5^2 == 25; sum(2*l+1,l,0,2) == 9",
       .remark = "Second-order means degree 2 here, also where the projection of M^DS is discussed."},
      {.place = {"S-24", "5, direction bins", kText},
       .printed = "an icosahedron, 1->2 bisection into equal areas, 6 to 8 levels, 512 to 2048 bins",
       .readings = {fails("20*2^6 == 512; 20*2^8 == 2048")},
       .correct = "an octahedron: 8 * 2^6 = 512, 8 * 2^8 = 2048",
       .correct_statement = "8*2^6 == 512; 8*2^8 == 2048",
       .remark = "An icosahedron gives 1280 to 5120. Bisection at midpoints has equal areas in the first step only; "
                 "later the point has to be chosen for it. That 1->4 has unequal areas is right."},
      {.place = {"S-25", "5, shadow pass, diffuse"},
       .printed = "(M_p)_i^0 += (rho_p/pi) V_p(s_d) H_N(s_d) y_i(s_d)",
       .readings = {fails("the sum as it is", "rho/Pi*octa(z^2*Y(0,0))/2 == rho/Pi*cap(z^2*Y(0,0),0)"),
                    holds("times 4 pi/N_d", "4*Pi/6*rho/Pi*octa(z^2*Y(0,0))/2 == rho/Pi*cap(z^2*Y(0,0),0)")},
       .correct = "+= (4 pi/N_d) (rho_p/pi) V H y_i",
       .remark = "With the visibility V = z. Here M holds rho/pi, in eq. 10 it does not."},
      {.place = {"S-26", "5, shadow pass, glossy"},
       .printed = "(M_p)_ij^0 += V_p(s_d) y_j(s_d) y_i(s_d)",
       .readings =
           {fails("the sum as it is",
                  "l=0..1, m=-l..l, k=0..1, i=-k..k: octa((3+z)/4*Y(l,m)*Y(k,i)) == sphere((3+z)/4*Y(l,m)*Y(k,i))"),
            holds("times 4 pi/N_d",
                  "l=0..1, m=-l..l, k=0..1, i=-k..k: 4*Pi/6*octa((3+z)/4*Y(l,m)*Y(k,i)) == "
                  "sphere((3+z)/4*Y(l,m)*Y(k,i))")},
       .correct = "+= (4 pi/N_d) V y_j y_i"},
      {.place = {"S-27", "5, interreflection, diffuse"},
       .printed = "(M_p)_i^b += (rho_p/pi) (1-V_p(s_d)) (M_q)_i^{b-1} H_N(s_d)",
       .readings = {fails("the sum as it is", "rho/Pi*octa(t*z^2)/2 == rho/Pi*cap(t*z^2,0)"),
                    holds("times 4 pi/N_d", "4*Pi/6*rho/Pi*octa(t*z^2)/2 == rho/Pi*cap(t*z^2,0)")},
       .correct = "+= (4 pi/N_d) (rho_p/pi) (1-V) M_q H",
       .remark = "M_q is exit radiance and holds rho_q/pi already."},
      {.place = {"S-28", "5, interreflection, glossy"},
       .printed = "(M_p)_ij^b += (1-V) (sum_k alpha_k (G*_rq)_k (M_q^{b-1})_kj y_k(reflect(-s_d, N_q))) y_i(s_d)",
       .readings = {holds("alpha_k (G*)_k by the band of k",
                          "sphere((1+2*(x*s*cp+y*s*sp+z*c)+(x*s*cp+y*s*sp+z*c)^2)*Y(1,1)) == "
                          "sqrt(4*Pi/3)*sphere((1+2*z+z^2)*Y(1,0))*polar(Y(1,1))"),
                    fails("(G*)_k the k-th coefficient",
                          "sphere((1+2*(x*s*cp+y*s*sp+z*c)+(x*s*cp+y*s*sp+z*c)^2)*Y(1,1)) == "
                          "sqrt(4*Pi/3)*sphere((1+2*z+z^2)*Y(1,1))*polar(Y(1,1))")},
       .correct = "+= (4 pi/N_d) (1-V) (sum_k alpha_l G*_l^0 (M_q)_kj y_k(reflect(-s_d, N_q))) y_i, l the band of k",
       .remark = "reflect(v, N) = 2 (N.v) N - v. The k-th coefficient of a zonal kernel vanishes for m != 0. The "
                 "weight 4 pi/N_d is missing here too."},
      {.place = {"S-30", "Eq. 12"},
       .printed = "sum_{i=1}^{n^2} alpha_i G*_i (sum_{j=1}^{n^2} (M_p)_ij (L_p)_j) y_i(R)",
       .readings = {holds("alpha_i G*_i by the band of i",
                          "sphere((1+2*(x*s*cp+y*s*sp+z*c)+(x*s*cp+y*s*sp+z*c)^2)*Y(1,1)) == "
                          "sqrt(4*Pi/3)*sphere((1+2*z+z^2)*Y(1,0))*polar(Y(1,1))"),
                    fails("G*_i the i-th coefficient",
                          "sphere((1+2*(x*s*cp+y*s*sp+z*c)+(x*s*cp+y*s*sp+z*c)^2)*Y(1,1)) == "
                          "sqrt(4*Pi/3)*sphere((1+2*z+z^2)*Y(1,1))*polar(Y(1,1))")},
       .correct = "sum_i alpha_l G*_l^0 (M L)_i y_i(R), l the band of i",
       .remark = "The convolution of M L with G*, eq. 6."},
      {.place = {"S-31", "6.2, weighted basis textures", kEquation, kLost},
       .printed = "B_l^m(s) = y_l^m(s) ds(s), ds the differential solid angle; its formula is not given",
       .correct =
           "ds = (4/N^2) (1+u^2+v^2)^(-3/2) at (u,v) in [-1,1]^2; exactly: differences of atan(ab/sqrt(1+a^2+b^2))",
       .correct_statement = "at(at(diffn(diffn(atan(a*b/sqrt(a^2+b^2+1)),a,1),b,1),a,2),b,2) == 1/9^(3/2); "
                            "at(at(diffn(diffn(atan(a*b/sqrt(a^2+b^2+1)),a,1),b,1),a,4),b,8) == 1/81^(3/2); "
                            "at(at(diffn(diffn(atan(a*b/sqrt(a^2+b^2+1)),a,1),b,1),a,1/2),b,1) == 1/(9/4)^(3/2); "
                            "tan(Pi/6) == 1/sqrt(3); 6*4*Pi/6 == 4*Pi",
       .remark = "From the derivative of s = (u,v,1)/|(u,v,1)|; the six faces have 4 pi."},
      {.place = {"S-32", "6.2, error for band-limited signals", kText},
       .printed = "6th order, squared error: 6x4x4 images 0.3 % on average, 1 % at worst; 6x8x8 0.003 % and 0.02 %",
       .readings = {measured(true, "six 4 x 4 images, average squared error", "0.3", "%"),
                    measured(true, "six 4 x 4 images, worst-case squared error", "1", "%"),
                    measured(true, "six 8 x 8 images, average squared error", "0.003", "%"),
                    measured(true, "six 8 x 8 images, worst-case squared error", "0.02", "%")},
       .remark = "Measured with ds at the center of the texel. With the exact areas 0.26/0.94 and 0.0058/0.018 %: not "
                 "better for the larger images."},
      {.place = {"S-33", "6.2, error for bilinear reconstruction", kText},
       .printed = "6x8x8 0.7 % and 2 %; 6x16x16 0.2 % and 0.5 %; 6x32x32 0.05 % and 0.1 %",
       .readings = {measured(true, "six 8 x 8 images read bilinearly, average squared error", "0.7", "%"),
                    measured(true, "six 8 x 8 images read bilinearly, worst-case squared error", "2", "%"),
                    measured(false, "six 16 x 16 images read bilinearly, average squared error", "0.2", "%"),
                    measured(false, "six 16 x 16 images read bilinearly, worst-case squared error", "0.5", "%"),
                    measured(false, "six 32 x 32 images read bilinearly, average squared error", "0.05", "%"),
                    measured(false, "six 32 x 32 images read bilinearly, worst-case squared error", "0.1", "%")},
       .correct = "0.7 and 2 %, 0.2 and 0.5 %, 0.05 and 0.1 % are those of 8, 11 and 16 texels",
       .remark = "What is compared is not said fully. The squared distance of the images, read between their texels, "
                 "from a signal of 6 bands gives all six printed numbers for 8, 11 and 16 texels, as if not the edge "
                 "but the number of texels had doubled; with twice the edge it falls by 12."},
      {.place = {"S-35", "7, direct shadowing"},
       .printed = "(M_p)_i^0 += A(p -> p + D s_d) y_i(s_d)",
       .readings = {fails("the sum as it is", "octa(Y(0,0))*2*sqrt(Pi) == 1"),
                    holds("times 4 pi/N_d, the phase function 1/(4 pi) and the albedo",
                          "4*Pi/6*1/(4*Pi)*octa(Y(0,0))*2*sqrt(Pi) == 1")},
       .correct = "+= (4 pi/N_d) phase albedo A y_i",
       .remark = "A perfect isotropic scatterer in uniform light must return radiance 1. A is the transmittance."},
  };
}

}  // namespace sh::errata
