// G: [Green03], transfer, interreflection, skies and lights.
#include "numeric/errata/parts.hpp"

namespace sh::errata {

std::vector<Entry> green_lighting() {
  return {
      {.place = {"G-73", "Note on albedo", kText},
       .printed = "albedo = emitted radiance / irradiance; for diffuse surfaces pi rho; rho in [0, 1]",
       .readings = {fails("radiance / irradiance = rho", "rho*cap(z,0) == rho"),
                    fails("radiance / irradiance = pi rho", "Pi*rho*cap(z,0) == rho"),
                    fails("rho is the BRDF: pi rho is the reflected share, at most 1 for rho in [0, 1]",
                          "cap(z,0) <= 1")},
       .correct = "albedo = radiosity / irradiance = pi f_r = rho; radiance / irradiance = f_r = rho/pi",
       .correct_statement = "rho/Pi*cap(z,0) == rho",
       .remark = "The rho of the equation above is the albedo itself, so pi rho is not."},
      {.place = {"G-74", "M_DU"},
       .printed = "M_DU(s) = max(N.s, 0)",
       .readings = {holds("kernel, rho/pi stays in front", "rho/Pi*cap(z,0) == rho"),
                    fails("rho, not rho/pi, in front (as the code multiplies by 'albedo')", "rho*cap(z,0) == rho"),
                    fails("its product with the light is the exit radiance", "cap(z,0) == rho")},
       .correct = "L_DU = (rho/pi) INT L M_DU",
       .remark = "The text calls M_DU the transfer function itself."},
      {.place = {"G-75", "Code, unshadowed transfer", kCode},
       .printed = "for H = s.N > 0: result[j] += albedo * Hs * coeff[j]; coeff = result * area / n_samples",
       .readings = {holds("albedo = rho/pi, area = 4 pi", "Pi*(rho/Pi*cap(z,0)) == rho*cap(z,0)"),
                    fails("albedo = rho, area = 4 pi", "Pi*(rho*cap(z,0)) == rho*cap(z,0)")},
       .correct = "T_j = (rho/pi) (4 pi/N) sum max(s.N, 0) y_j(s)",
       .remark = "H is declared and Hs used, area is not defined in the fragment: it does not compile. The later "
                 "fragment divides kd by pi; with rho the result is pi times too bright."},
      {.place = {"G-78", "Code, shadowed transfer", kCode},
       .printed = "as the unshadowed code, only where self_shadow(pos, s) is false",
       .readings = {holds("albedo = rho/pi, area = 4 pi", "Pi*(rho/Pi*cap(z,3/5)) == rho*cap(z,3/5)"),
                    fails("albedo = rho, area = 4 pi", "Pi*(rho*cap(z,3/5)) == rho*cap(z,3/5)")},
       .correct = "T_j = (rho/pi) (4 pi/N) sum V(s) max(s.N, 0) y_j(s)",
       .remark = "For a round opening about the normal. The same 1/pi."},
      {.place = {"G-80", "Four steps of interreflection", kText},
       .printed = "(b) interpolate the transfer at the hit, (c) times the cosine, summed, divided by the number of "
                  "samples and the Monte Carlo weighting term, (d) bounces added to the direct part",
       .readings = {holds("times 4 pi / N and the rho/pi of the receiver: an enclosure of radiance 1 gives rho",
                          "4*Pi*(cap(z,0)/(4*Pi))*rho/Pi == rho"),
                    fails("times 4 pi / N, nothing of the receiver", "4*Pi*(cap(z,0)/(4*Pi)) == rho"),
                    fails("divided by 4 pi N, times rho/pi", "cap(z,0)/(4*Pi)/(4*Pi)*rho/Pi == rho")},
       .correct = "T_b(x) = (rho/pi) (4 pi/N) sum (1-V) max(N.s, 0) T_(b-1)(x')",
       .remark = "Step (c) does not name the reflectance of the receiver; the code has it."},
      {.place = {"G-81", "Code self_transfer_sh", kCode},
       .printed = "albedo = kd/pi; sh = u v0 + v v1 + w v2, w = 1-(u+v); buffer[b][i] += albedo Hs sh; times 4 pi/n; "
                  "buffers added",
       .readings = {holds("hit = u V0 + v V1 + (1-u-v) V2: a linear transfer is gathered at the hit, over two bounces",
                          "u*a+v*(a+b)+(1-u-v)*(a+t) == a+b*v+t*(1-u-v)"),
                    fails("hit = (1-u-v) V0 + u V1 + v V2, as many ray tracers count",
                          "u*a+v*(a+b)+(1-u-v)*(a+t) == a+b*u+t*v")},
       .correct = "sh = sum of the corners' transfers with the weights that make the hit point",
       .remark = "Needs a direct pass with rho/pi (G-75). It does not test that the hit faces the receiver, as the "
                 "text asks. One brace too many after the scaling, one missing at the end, fptr for face_ptr, k and i "
                 "out of scope."},
      {.place = {"G-84", "4-coefficient claim", kText},
       .printed = "two bands approximate the cosine well, at the work of three parallel lights and ambient",
       .readings = {holds("to a quarter of the peak",
                          "lambert(1) == 1/4+c/2; at(lambert(1),c,0) <= 1/4; at(lambert(1),c,1) >= 1-1/4; "
                          "at(lambert(1),c,-1) >= -1/4"),
                    fails("to a tenth of the peak, as three bands do", "at(lambert(1),c,0) <= 1/10")},
       .correct = "max(t, 0) = 1/4 + t/2 to 1/4 with two bands (affine in the normal), to 3/32 with three",
       .correct_statement = "lambert(2) == 3/32+c/2+15/32*c^2"},
      {.place = {"G-87", "CIE overcast sky", kEquation, kLost},
       .printed = "luminance from L_Z at the zenith and beta, the angle from the zenith",
       .correct = "L = L_Z (1 + 2 cos beta) / 3",
       .correct_statement =
           "at((1+2*z)/3,z,1) == 1; at((1+2*z)/3,z,0) == 1/3; cap((1+2*z)/3*z,0) == 7*Pi/9; cap((1+2*z)/3*Y(0,0),0) == "
           "2*sqrt(Pi)/3; cap((1+2*z)/3*Y(1,0),0) == 7*sqrt(3*Pi)/18; cap((1+2*z)/3*Y(2,0),0) == sqrt(5*Pi)/12; "
           "cap((1+2*z)/3*Y(3,0),0) == -sqrt(7*Pi)/24; cap((1+2*z)/3*Y(4,0),0) == -sqrt(Pi)/24",
       .remark = "Horizon to zenith 1/3; horizontal irradiance 7 pi L_Z / 9; zonal coefficients over L_Z: 2 "
                 "sqrt(pi)/3, 7 sqrt(3 pi)/18, sqrt(5 pi)/12, -sqrt(7 pi)/24, -sqrt(pi)/24. The captions say "
                 "illuminance: it is luminance."},
      {.place = {"G-88", "CIE clear sky", kEquation, kLost},
       .printed = "luminance from L_Z, theta, the sun's S and alpha, and gamma, the angle between sun and P",
       .correct =
           "L = L_Z (0.91 + 10 exp(-3 gamma) + 0.45 cos^2 gamma) (1 - exp(-0.32/cos theta)) / ((0.91 + 10 exp(-3 S) + "
           "0.45 cos^2 S) (1 - exp(-0.32))), cos gamma = cos S cos theta + sin S sin theta cos alpha",
       .correct_statement = "1-10*exp(-3*Pi/2) ~ 0.91",
       .remark = "0.91 = 1 - 10 exp(-3 pi/2) in two digits makes 90 degrees from the sun the unit. 10, -3, 0.45 and "
                 "-0.32 are measurements, here as in Radiance's skybright.cal. gamma is not a planar angle but that of "
                 "a great circle."},
      {.place = {"G-90", "Code hdr_lightsource (angular map)", kCode},
       .printed = "r = acos(dz) / (pi sqrt(dx^2+dy^2)); (u,v) = (dx,dy) r; pixel = int(u size + size) >> 1, same for "
                  "v; image[y size + x]",
       .readings = {holds("exact numbers, off the z axis: distance angle/pi, the texel that holds (u,v)",
                          "acos(1/2)/(Pi*sqrt(3/4))*sqrt(3/4) == 1/3; acos(-1/2)/(Pi*sqrt(3/4))*sqrt(3/4) == 2/3"),
                    fails("exact numbers, +z and -z too", "dir(x^2+y^2,0,0,1) != 0"),
                    fails("single precision, near -z: the texel is in the image", "n=1..8: (1*n+n)/2 <= n-1")},
       .correct = "as printed, (u,v) = (0,0) at +z, indices at most size-1",
       .remark = "0/0 at dx = dy = 0; at the rim u rounds to 1 and the index is size; |dz| above 1 by rounding gives "
                 "NaN. Whether +v is up in the image is not said."},
      {.place = {"G-92", "Circular light, function and coefficients", kEquation, kLost},
       .printed = "1 where theta < t, and its projection by symbolic integration",
       .correct = "f = 1 for theta < t, else 0; c_l0 = sqrt(pi/(2l+1)) (P_(l-1)(c) - P_(l+1)(c)), c = cos t, P_-1 = 1; "
                  "c_lm = 0 for m != 0",
       .correct_statement =
           "cap(Y(0,0),c) == sqrt(Pi)*(1-c) & l=1..6: cap(Y(l,0),c) == sqrt(Pi/(2*l+1))*(P(l-1,0)-P(l+1,0))",
       .remark = "c_00 = sqrt(pi) (1-c), c_10 = sqrt(3 pi)/2 (1-c^2), c_20 = sqrt(5 pi)/2 (c-c^3), c_30 = sqrt(7 pi)/8 "
                 "(1-c^2) (5c^2-1)."},
      {.place = {"G-93", "Code synth_light(cutoff)", kCode},
       .printed = "sh[0] = 3.544907702 - 1.772453851 (t3 (1 + c) + t9 (1 - c)); sh[2] = 1.534990062 s^2 (t3 - t9); "
                  "sh[6] = 1.98166365 (c - c^3) (t3 - t9); sh[12] = (2.930920062 (1 - c^4) - 3.517104075 s^2) (t3 - "
                  "t9); c = cos(cutoff), s^2 = 1 - c^2, t3 = [cutoff < pi], t9 = [cutoff < 0]",
       .readings = {holds(
           "cap(Y(0,0),c) == 2*sqrt(Pi)-sqrt(Pi)-sqrt(Pi)*c; cap(Y(1,0),c) == sqrt(3*Pi)/2*s^2; cap(Y(2,0),c) == "
           "-sqrt(5*Pi)/2*c^3+sqrt(5*Pi)/2*c; cap(Y(3,0),c) == 5*sqrt(7*Pi)/8*(1-c^4)-6*sqrt(7*Pi)/8*s^2; 2*sqrt(Pi) ~ "
           "3.544907702; sqrt(Pi) ~ 1.772453851; sqrt(3*Pi)/2 ~ 1.534990062; sqrt(5*Pi)/2 ~ 1.98166365; 5*sqrt(7*Pi)/8 "
           "~ 2.930920062; 6*sqrt(7*Pi)/8 ~ 3.517104075")},
       .remark = "Small angles lose digits in 1 - cos(cutoff). Below 0 all terms cancel; from pi on only 2 sqrt(pi) is "
                 "left."},
      {.place = {"G-94", "Proxy shadow", kText},
       .printed = "light times the complement of a cap, 'by circular convolution' or by a transfer matrix about z "
                  "between two rotations",
       .readings = {fails("sphere(z*z*Y(0,0)) == sqrt(4*Pi)*sphere(z*Y(0,0))*sphere(z*Y(0,0))")},
       .correct = "c = D(R) M D(R^-1) a, M_ij = INT h y_i y_j, h_l0 = 2 sqrt(pi) delta_l0 - cap_l",
       .correct_statement = "l=0..2, m=-l..l: sum(sum(sphere((1-z)*Y(l,m)*Y(n,q))*sphere((1+x)*Y(n,q)),q,-n,n),n,0,1) "
                            "== sphere((1-z)*(1+x)*Y(l,m))",
       .remark = "A product couples bands by Gaunt coefficients; a convolution multiplies each band by a number. The "
                 "transfer matrix and the two rotations are right."},
  };
}

}  // namespace sh::errata
