// G: [Green03], Monte Carlo integration, projection and reconstruction.
#include "numeric/errata/parts.hpp"

namespace sh::errata {

std::vector<Entry> green_sampling() {
  return {
      {.place = {"G-02", "Illumination Calculations, Eq. 2"},
       .printed = "L(x,wo) = L_e(x,wo) + INT_S f_r(x, wi->wo) L(x',wi) G(x,x') V(x,x') dwi",
       .readings = {holds("G = cos(theta_i), the cosine at x", "cap(z,0)/Pi == 1"),
                    fails("G = cos(theta_i) cos(theta') / |x-x'|^2, the factor between two points",
                          "cap(z/r^2,0)/Pi == 1")},
       .correct = "L(x,wo) = L_e(x,wo) + INT f_r(x, wi->wo) L(x'(x,wi), -wi) cos(theta_i) dwi",
       .remark =
           "In a closed sphere of radiance 1, which has to return the albedo. The two-point factor belongs to dA', not "
           "dwi. V says no more than that x' is the first point hit; in L(x',wi), wi is the direction of travel."},
      {.place = {"G-04", "Monte Carlo Integration, die", kText},
       .printed = "p_i = 1/6; P(x) is the probability of a value less than x, P(4) = 2/3",
       .readings = {fails("sum(1/6,k,1,3) == 2/3")},
       .correct = "P(x) = Pr(X <= x), P(4) = 2/3",
       .correct_statement = "sum(1/6,k,1,4) == 2/3",
       .remark = "Wording and number contradict each other: Pr(X < 4) = 1/2."},
      {.place = {"G-09", "Monte Carlo Integration, estimator", kText},
       .printed = "each sample of f is scaled by the PDF, summed, divided by N (the equation itself is lost)",
       .readings = {fails("scaled by: multiplied by p", "integral(x,0,2,(2-x)*(x/2)*(x/2)) == integral(x,0,2,2-x)"),
                    holds("scaled by: divided by p", "integral(x,0,2,(2-x)/(x/2)*(x/2)) == integral(x,0,2,2-x)")},
       .correct = "INT f dx ~= (1/N) sum_i f(x_i) / p(x_i)",
       .remark = "The sentences that follow in the paper (likely samples weigh less, w = 1/p) mean division."},
      {.place = {"G-10", "Monte Carlo Integration, zero variance", kText},
       .printed = "a single sample is enough when p(x) = f(x)",
       .readings = {fails("p = f itself, for the paper's 2 - x on [0,2]", "integral(x,0,2,2-x) == 1"),
                    holds("p proportional to f >= 0", "integral(x,0,2,(2-x)/integral(x,0,2,2-x)) == 1")},
       .correct = "p = f / INT f",
       .remark = "A density integrates to 1; f need not."},
      {.place = {"G-12", "Monte Carlo Integration, uniform case", kText},
       .printed = "sum the samples, divide by the number of samples times w(x)",
       .readings = {fails("(sum f) / (N w)", "octa(z^2)/(6*4*Pi) == sphere(z^2)"),
                    holds("(sum f) / N * w", "octa(z^2)/6*4*Pi == sphere(z^2)")},
       .correct = "INT f ~= (w/N) sum_i f(x_i), w = 4 pi on the sphere",
       .remark = "The first is wrong by w^2 = 16 pi^2; the code multiplies."},
      {.place = {"G-13", "Eq. 4"},
       .printed = "(2 arccos(sqrt(1 - xi_x)), 2 pi xi_y) -> (theta, phi)",
       .readings = {holds("2*sqrt(1-u)^2 - 1 == 1 - 2*u; cap(1,1-2*u)/(4*Pi) == u")},
       .correct = "theta = arccos(1 - 2 xi_x), phi = 2 pi xi_y",
       .remark =
           "The short form has the same value with two roundings less. The minus signs are displaced in the text."},
      {.place = {"G-14", "Text after Eq. 4", kText},
       .printed = "the weighting function is the constant 1/area of the sphere, w = 4 pi",
       .readings = {fails("w = 1/area", "1/sphere(1)*octa(z^2)/6 == sphere(z^2)"),
                    holds("p = 1/area, w = 1/p", "sphere(1)*octa(z^2)/6 == sphere(z^2)")},
       .correct = "p = 1/(4 pi), w = 4 pi",
       .remark = "The number is right; what is called the weighting function is the density."},
      {.place = {"G-15", "Stratified sampling", kText},
       .printed = "the sum of the variances of the cells is never higher than the variance of random samples over the "
                  "whole range",
       .readings =
           {fails("the variances of f inside the cells, summed",
                  "n=2..4: sum(n*integral(x,k/n,(k+1)/n,(n*x-k)^2)-(n*integral(x,k/n,(k+1)/n,n*x-k))^2,k,0,n-1) <= "
                  "sum(integral(x,k/n,(k+1)/n,(n*x-k)^2),k,0,n-1) - sum(integral(x,k/n,(k+1)/n,n*x-k),k,0,n-1)^2"),
            holds("the variances of the cells' shares of the estimate, summed",
                  "n=2..4: sum(n*integral(x,k/n,(k+1)/n,(n*x-k)^2)-(n*integral(x,k/n,(k+1)/n,n*x-k))^2,k,0,n-1)/n <= "
                  "sum(integral(x,k/n,(k+1)/n,(n*x-k)^2),k,0,n-1) - sum(integral(x,k/n,(k+1)/n,n*x-k),k,0,n-1)^2; "
                  "sum(n*integral(x,k/n,(k+1)/n,(x^2)^2)-(n*integral(x,k/n,(k+1)/n,x^2))^2,k,0,n-1)/n <= "
                  "integral(x,0,1,x^4)-integral(x,0,1,x^2)^2"),
            measured(true, "its error over that of as many independent samples, 10,000 samples of the example light",
                     "<= 1")},
       .correct = "(1/K) sum_k Var_k(f) <= Var(f) for K equal cells",
       .remark = "Law of total variance: what is missing is the variance of the cells' means, a sum of squares. Raw "
                 "variances may add up to K times the whole, as for f = frac(K x)."},
      {.place = {"G-17", "Orthogonal Basis Functions, projection", kText},
       .printed = "c_i = INT f B_i dx, f ~ sum_i c_i B_i, shown with linear (hat) functions",
       .readings = {fails(
                        "B_i hat functions, as pictured",
                        "integral(x,0,1,(u*(1-x)+v*x)*(1-x))*(1-x)+integral(x,0,1,(u*(1-x)+v*x)*x)*x == (u*(1-x)+v*x)"),
                    holds("B_i orthonormal", "n=0..4: sum((2*l+1)/2*integral(c,-1,1,c^n*P(l,0))*P(l,0),l,0,n) == c^n")},
       .correct = "c = G^-1 <f,B>, G_ij = <B_i,B_j>",
       .correct_statement = "integral(x,0,1,(u*(1-x)+v*x)*(4*(1-x)-2*x))*(1-x)+integral(x,0,1,(u*(1-x)+v*x)*(4*x-2*(1-"
                            "x)))*x == (u*(1-x)+v*x)",
       .remark = "Hats overlap: f of their span does not come back. For orthonormal functions G = 1."},
      {.place = {"G-40", "Text, infinite series", kText},
       .printed = "the sum of the infinite series is f",
       .readings = {holds("in the mean square", "n=0..6: cap(1,0) - sum(cap(Y(l,0),0)^2,l,0,2*n) < 2*Pi/(2*n+1)"),
                    fails("at every point", "n=0..6: sum(cap(Y(l,0),0)*dir(Y(l,0),1,0,0),l,0,n) == 1")},
       .correct = "convergence in L2",
       .remark = "Both for the hemisphere: the energy of the rest falls like 1/degree, while the value at the edge "
                 "stays 1/2. For every f of L2 the first is the completeness of spherical harmonics, a theorem."},
      {.place = {"G-46", "Code SH_project_polar_function", kCode},
       .printed = "result[n] += fn(theta,phi) coeff[n] over all samples, then result[n] *= 4 pi / n_samples",
       .readings = {holds("result comes cleared", "(0+octa(z^2*Y(0,0)))*4*Pi/6 == sphere(z^2*Y(0,0))"),
                    fails("result comes with anything in it", "(u+octa(z^2*Y(0,0)))*4*Pi/6 == sphere(z^2*Y(0,0))")},
       .correct = "c_n = (4 pi/N) sum_j f(x_j) y_n(x_j), result cleared first",
       .remark =
           "The comment says divide by the weight, the code multiplies; the i of the second loop is not declared."},
      {.place = {"G-47", "Coefficients of the example light", kTable},
       .printed = ".39925; -.21075 .28687 .28277; -.31530 -.00040 .13159 .00098 -.09359; -.00072 .12290 .30458 -.16427 "
                  "-.00062 -.09126 (15 numbers, 16 are announced)",
       .readings = {fails("c_0 to c_14 in order", "-greenLight(3,-3) > -3/1000; -greenLight(3,-3) < 2/1000"),
                    fails("c_3^-3 is the one that is not printed", "greenLight(2,2) < -9/100")},
       .correct = ".39880; -.21052 .28653 .28182; -.31499 0 .13138 0 .09318; -.24961 0 .12336 .30388 -.16513 0 "
                  "-.09224, with Condon-Shortley phase",
       .correct_statement = "greenLight(2,2) ~ 0.09318; -greenLight(3,-3) ~ -0.24961",
       .remark = "c_3^-3 is missing and the sign of c_2^2 is wrong; the others agree to 0.002, the noise of 10,000 "
                 "samples. Their signs show that the paper computed with the Condon-Shortley phase; without it every "
                 "coefficient of odd m changes sign."},
      {.place = {"G-48", "Reconstruction of the example"},
       .printed = "f~(s) = c_1 y_1(s) + c_2 y_2(s) + ... = sum_(i=1)^(n^2) c_i y_i(s)",
       .readings = {fails("i = l(l+1)+m, as the paper defines it",
                          "sum(sphere((1+z)*Y(1,m))*Y(1,m),m,-1,1)+sphere((1+z)*Y(2,-2))*Y(2,-2) == 1+z"),
                    holds("i = l(l+1)+m+1",
                          "sphere((1+z)*Y(0,0))*Y(0,0)+sum(sphere((1+z)*Y(1,m))*Y(1,m),m,-1,1) == 1+z")},
       .correct = "sum_(i=0)^(n^2-1) c_i y_i(s), i = l(l+1)+m",
       .remark = "With the paper's own index band 0 is left out and one function of band n is taken in."},
      {.place = {"G-99", "Coefficients of the example light, one by one", kTable},
       .printed = ".39925; -.21075 .28687 .28277; -.31530 -.00040 .13159 .00098 -.09359; -.00072 .12290 .30458 -.16427 "
                  "-.00062 -.09126 (15 numbers, 16 are announced)",
       .readings = {measured(true, "c_0^0", "0.39925"), measured(true, "c_1^-1", "-0.21075"),
                    measured(true, "c_1^0", "0.28687"), measured(true, "c_1^1", "0.28277"),
                    measured(true, "c_2^-2", "-0.31530"), measured(true, "c_2^-1", "-0.00040"),
                    measured(true, "c_2^0", "0.13159"), measured(true, "c_2^1", "0.00098"),
                    measured(false, "c_2^2", "-0.09359"), measured(true, "c_3^-2", "-0.00072"),
                    measured(true, "c_3^-1", "0.12290"), measured(true, "c_3^0", "0.30458"),
                    measured(true, "c_3^1", "-0.16427"), measured(true, "c_3^2", "-0.00062"),
                    measured(true, "c_3^3", "-0.09126"),
                    measured(true, "noise of the 14 with a right sign, over that of 10,000 stratified samples", "1")},
       .correct = "c_2^2 = 0.09318",
       .remark = "Read with c_3^-3 as the one that is missing (G-47)."},
  };
}

}  // namespace sh::errata
