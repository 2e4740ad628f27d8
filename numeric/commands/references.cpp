// shcheck eval, legendre, gaunt, cap: reference values, one each.
#include <charconv>
#include <memory>

#include "numeric/commands/commands.hpp"
#include "numeric/oracle/gaunt.hpp"
#include "numeric/reference/decimal.hpp"
#include "numeric/reference/reference.hpp"

namespace sh::numeric {
namespace {

constexpr const char* kDigits = "significant decimals, 1 to 10000";

void add_eval_command(Command& tool) {
  struct Options {
    int degree = 0, order = 0, digits = 0;
    std::string direction;
    bool gradient = false;
  };
  const auto options = std::make_shared<Options>();
  auto command = tool.command("eval", "print a reference value of Y_lm, orthonormal, without Condon-Shortley phase");
  command.option("--degree", options->degree, "l, 0 to 10000").required();
  command.option("--order", options->order, "m, -l to l").required();
  command.option("--direction", options->direction, "x,y,z: decimals, taken exactly; of any length but zero")
      .required();
  command.option("--digits", options->digits, kDigits).required();
  command.option("--gradient", options->gradient,
                 "d/dx, d/dy, d/dz of the homogeneous form r^l Y_lm at x,y,z scaled to length 1, a line each");
  command.run([options] {
    const auto& [degree, order, digits, text, gradient] = *options;
    const auto direction = split_numbers<3>("--direction", text, "three numbers x,y,z");
    if (!gradient) {
      print(reference_value(degree, order, direction, digits) + "\n");
    } else {
      const auto [x, y, z] = reference_gradient(degree, order, direction, digits);
      print(x + "\n" + y + "\n" + z + "\n");
    }
    return kDone;
  });
}

// Options of a colatitude that has two names.
struct ColatitudeOptions {
  int degree = 0, order = 0, digits = 0;
  std::string first, second;
};

Colatitude colatitude(const ColatitudeOptions& options, const Colatitude& first, const Colatitude& second) {
  if (options.first.empty() == options.second.empty()) {
    throw std::invalid_argument("expected one of " + first.name + " and " + second.name + ", got " +
                                (options.first.empty() ? "neither" : "both"));
  }
  return options.first.empty() ? Colatitude{second.kind, second.name, options.second}
                               : Colatitude{first.kind, first.name, options.first};
}

void add_legendre_command(Command& tool) {
  const auto options = std::make_shared<ColatitudeOptions>();
  auto command = tool.command(
      "legendre", "print a reference value of the orthonormal P_lm (Y_l0 = P_l0), without Condon-Shortley phase");
  command.option("--degree", options->degree, "l, 0 to 10000").required();
  command.option("--order", options->order, "m, 0 to l").required();
  command.option("--z", options->first, "cos theta: a decimal, taken exactly, -1 to 1");
  command.option("--theta", options->second, "radians: a decimal, taken exactly, 0 to pi");
  command.option("--digits", options->digits, kDigits).required();
  command.run([options] {
    const auto at =
        colatitude(*options, {Colatitude::Kind::kCosine, "--z", ""}, {Colatitude::Kind::kAngle, "--theta", ""});
    print(legendre_reference(options->degree, options->order, at, options->digits) + "\n");
    return kDone;
  });
}

void add_cap_command(Command& tool) {
  const auto options = std::make_shared<ColatitudeOptions>();
  auto command =
      tool.command("cap", "print the coefficient of Y_l0 of the function that is 1 in a cap about +z, 0 outside");
  command.option("--degree", options->degree, "l, 0 to 10000").required();
  command.option("--angle", options->first, "half-angle in radians: a decimal, taken exactly, 0 to pi");
  command.option("--one-minus-cos", options->second,
                 "1 - cos(half-angle): a decimal, taken exactly, 0 to 2; 1 is a hemisphere");
  command.option("--digits", options->digits, kDigits).required();
  command.run([options] {
    const auto half_angle = colatitude(*options, {Colatitude::Kind::kAngle, "--angle", ""},
                                       {Colatitude::Kind::kOneMinusCos, "--one-minus-cos", ""});
    print(cap_reference(options->degree, half_angle, options->digits) + "\n");
    return kDone;
  });
}

Triple triple(const std::string& option, const std::string& text) {
  const auto parts = split_numbers<3>(option, text, "three integers");
  Triple numbers{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string& part = parts[i];
    const char* const end = part.data() + part.size();
    const auto [stop, error] = std::from_chars(part.data() + (part.starts_with('+') ? 1 : 0), end, numbers[i]);
    if (error != std::errc() || stop != end || std::abs(numbers[i]) > kMaxWignerDegree + 1) {
      throw std::invalid_argument(option + ": expected an integer up to " + std::to_string(kMaxWignerDegree) +
                                  ", got '" + part + "'");
    }
  }
  return numbers;
}

void add_gaunt_command(Command& tool) {
  struct Options {
    std::string degrees, orders;
    int digits = 0;
    bool complex = false;
  };
  const auto options = std::make_shared<Options>();
  auto command = tool.command(
      "gaunt", "print the integral of three spherical harmonics over the sphere: a line exactly, a line in decimal");
  command.option("--degrees", options->degrees, "a,b,c: 0 to 10000 each").required();
  command.option("--orders", options->orders, "m,n,p, each at most its degree").required();
  command.option("--digits", options->digits, kDigits).required();
  command.option("--complex", options->complex,
                 "of the complex basis with Condon-Shortley phase, none conjugated, instead of the real one");
  command.run([options] {
    const Triple degrees = triple("--degrees", options->degrees);
    const Triple orders = triple("--orders", options->orders);
    require_wigner("gaunt", degrees, orders);
    require_range("digits", options->digits, 1, kMaxReferenceDigits);
    const Surd exact = options->complex ? complex_gaunt_exact(degrees, orders) : gaunt_exact(degrees, orders);
    const Computation value{[&](int /*decimals*/) { return exact.value<MpfrAny>(); }};
    print(exact.text() + "\n" + (exact.is_zero() ? "0" : correct_digits(options->digits, value)) + "\n");
    return kDone;
  });
}

}  // namespace

void add_reference_commands(Command& tool) {
  add_eval_command(tool);
  add_legendre_command(tool);
  add_rotation_command(tool);
  add_gaunt_command(tool);
  add_cap_command(tool);
}

}  // namespace sh::numeric
