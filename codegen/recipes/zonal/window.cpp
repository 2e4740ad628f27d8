// Recipes: windows damp the higher degrees of a projection in place: c_lm = w_l c_lm, w_0 = 1.
//
// The caller computes angles and exponentials from the cut-off w once. A kernel takes one or two of these numbers and
// derives w_l for every degree from them. References: [Sloan08], "Windowing" and the appendix on the Laplacian.
#include "codegen/recipes/parts.hpp"
#include "codegen/recipes/zonal/zonal.hpp"

namespace sh::codegen::recipes {
namespace {

using symbolic::Surd;

constexpr const char* kCitation = "P.-P. Sloan, \"Stupid Spherical Harmonics (SH) Tricks\", GDC 2008";

Kernel described(int degree, const std::vector<std::string>& parameters) {
  Kernel kernel;
  kernel.citation = kCitation;
  const Parameter c = array(Role::kCoefficients, "c", degree);
  for (const std::string& name : parameters) kernel.parameters.push_back(parameter(Role::kParameter, name));
  kernel.parameters.push_back(c);
  kernel.results = {c};
  label_coefficients(kernel, degree);
  return kernel;
}

std::string title(const std::string& name, int degree) {
  return name + " window on coefficients of degree 0 to " + std::to_string(degree) + ", in place";
}

// c_lm = w_l c_lm. w: the factors for l = 1 .. degree; first: the position of c among the inputs.
void apply_window(Kernel& kernel, Builder& build, const std::vector<NodeId>& w, int first) {
  for (int l = 0; l <= static_cast<int>(w.size()); ++l) {
    for (int i = l * l; i < (l + 1) * (l + 1); ++i) {
      const NodeId c = build.input(first + i, numbered("c", i));
      kernel.outputs[i].node = l == 0 ? c : build.mul(w[l - 1], c);
    }
  }
}

// cos(k angle) from cos(angle).
class Cosines {
 public:
  Cosines(Builder& build, NodeId cosine) : build_(build), one_(build.constant(Surd(1), "one")), at_{one_, cosine} {}

  [[nodiscard]] NodeId one() const { return one_; }

  // By three terms: T_k = 2 T_1 T_(k-1) - T_(k-2).
  NodeId at(int k) {
    while (static_cast<int>(at_.size()) <= k) {
      if (twice_ < 0) twice_ = build_.add(at_[1], at_[1], "twice");
      const NodeId raised = build_.mul(twice_, at_.back());
      at_.push_back(build_.sub(raised, at_[at_.size() - 2], numbered("t", static_cast<int>(at_.size()))));
    }
    return at_[k];
  }

 private:
  Builder& build_;
  NodeId one_;
  NodeId twice_ = -1;
  std::vector<NodeId> at_;
};

Kernel described_hann(int degree) {
  Kernel kernel = described(degree, {"cos_pi_over_w"});
  kernel.title = title("Hann", degree);
  kernel.domain = "cos_pi_over_w = cos(pi / w) of the cut-off w, a real number; w >= " + std::to_string(degree) +
                  " so that the window falls with l";
  kernel.result = "c_lm (1 + cos(pi l / w)) / 2 at index l(l+1)+m";
  return kernel;
}

}  // namespace

Kernel window_hann(int degree) {
  Kernel kernel = described_hann(degree);
  Builder build(kernel);
  const NodeId cosine = build.input(0, "t1");
  Cosines t(build, cosine);
  const NodeId half = build.constant(Surd(cln::cl_RA(1) / 2), "k_half");
  const NodeId least = build.mul(half, build.sub(t.one(), cosine), "t_odd");
  std::vector<NodeId> w;
  for (int l = 1; l <= degree; ++l) {
    if (l == 1) {
      w.push_back(build.mul(half, build.add(t.one(), cosine)));
    } else if (l % 2 == 0) {
      w.push_back(build.mul(t.at(l / 2), t.at(l / 2)));
    } else {
      w.push_back(build.add(least, build.mul(t.at(l / 2), t.at(l / 2 + 1))));
    }
    build.name(w.back(), numbered("w", l));
  }
  apply_window(kernel, build, w, 1);
  return kernel;
}

Kernel window_hann_chebyshev(int degree) {
  Kernel kernel = described_hann(degree);
  Builder build(kernel);
  Cosines t(build, build.input(0, "t1"));
  const NodeId half = build.constant(Surd(cln::cl_RA(1) / 2), "k_half");
  std::vector<NodeId> w;
  for (int l = 1; l <= degree; ++l) {
    const NodeId raised = build.add(t.one(), t.at(l));
    w.push_back(build.mul(half, raised, numbered("w", l)));
  }
  apply_window(kernel, build, w, 1);
  return kernel;
}

Kernel window_lanczos(int degree, int power) {
  Kernel kernel = described(degree, {"cos_pi_over_w", "sinc_pi_over_w"});
  const std::string exponent = power == 1 ? "" : "^" + std::to_string(power);
  kernel.title = title("Lanczos (sinc" + exponent + ")", degree);
  kernel.domain =
      "cos_pi_over_w = cos(pi / w) and sinc_pi_over_w = sin(pi / w) / (pi / w) of the cut-off w, a real number; w >= " +
      std::to_string(degree) + " so that the window falls with l; applying it again multiplies the exponent";
  kernel.result = "c_lm (sin(pi l / w) / (pi l / w))" + exponent + " at index l(l+1)+m";
  Builder build(kernel);
  const NodeId cosine = build.input(0, "t1");
  const NodeId sinc = build.input(1, "s1");
  // s_l = sin(pi l / w) / (pi / w): s_(l+1) = 2 cos(pi / w) s_l - s_(l-1)
  const NodeId twice = build.add(cosine, cosine, "twice");
  std::vector<NodeId> s{sinc};
  std::vector<NodeId> w;
  for (int l = 1; l <= degree; ++l) {
    if (l > 1) {
      const NodeId raised = build.mul(twice, s.back());
      s.push_back(l == 2 ? raised : build.sub(raised, s[l - 3]));
      build.name(s.back(), numbered("s", l));
    }
    NodeId factor = s.back();
    if (l > 1) factor = build.mul(build.constant(Surd(cln::cl_RA(1) / l), numbered("k", l)), factor);
    for (int p = power; p > 1; p /= 2) factor = build.mul(factor, factor);
    if (l > 1 || power > 1) build.name(factor, numbered("w", l));
    w.push_back(factor);
  }
  apply_window(kernel, build, w, 2);
  return kernel;
}

Kernel window_gaussian(int degree) {
  Kernel kernel = described(degree, {"g"});
  kernel.title = title("Gaussian", degree);
  kernel.domain = "0 <= g <= 1, g = exp(-1 / (2 w^2)) for a standard deviation of w degrees";
  kernel.result = "c_lm g^(l^2) at index l(l+1)+m";
  Builder build(kernel);
  const NodeId g = build.input(0, "g");
  std::vector<NodeId> w{g};
  NodeId step = g;  // g^(2l-1)
  NodeId square = -1;
  for (int l = 2; l <= degree; ++l) {
    if (square < 0) square = build.mul(g, g, "g2");
    step = build.mul(step, square, numbered("g", 2 * l - 1));
    w.push_back(build.mul(w.back(), step, numbered("w", l)));
  }
  w.resize(degree);
  apply_window(kernel, build, w, 1);
  return kernel;
}

Kernel window_laplacian(int degree) {
  Kernel kernel = described(degree, {"lambda"});
  kernel.title = title("Laplacian-penalty", degree);
  kernel.domain = "lambda >= 0, the weight of the squared Laplacian against the squared error";
  kernel.result = "c_lm / (1 + lambda l^2 (l+1)^2) at index l(l+1)+m";
  Builder build(kernel);
  const NodeId lambda = build.input(0, "lambda");
  const NodeId one = build.constant(Surd(1), "one");
  std::vector<NodeId> w;
  for (int l = 1; l <= degree; ++l) {
    const NodeId k = build.constant(Surd(cln::cl_RA(l * l * (l + 1) * (l + 1))), numbered("k", l));
    const NodeId penalised = build.add(one, build.mul(k, lambda));
    w.push_back(build.div(one, penalised, numbered("w", l)));
  }
  apply_window(kernel, build, w, 1);
  return kernel;
}

}  // namespace sh::codegen::recipes
