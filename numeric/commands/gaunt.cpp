// shcheck gaunt: one Gaunt coefficient, exactly and in decimal.
#include "numeric/oracle/gaunt.hpp"

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>

#include "numeric/commands/commands.hpp"
#include "numeric/commands/split_numbers.hpp"
#include "numeric/reference/correct_digits.hpp"

namespace sh::numeric {
namespace {

struct Options {
  std::string degrees;
  std::string orders;
  int digits = 0;
  bool complex = false;
};

Triple triple(const std::string& option, const std::string& text) {
  const auto parts = split_numbers<3>(option, text, "three integers");
  Triple numbers{};
  for (std::size_t i = 0; i < 3; ++i) {
    char* end = nullptr;
    const long value = std::strtol(parts[i].c_str(), &end, 10);
    const bool whole = !parts[i].empty() && *end == '\0' && parts[i].find_first_not_of("+-0123456789") == parts[i].npos;
    if (!whole || value < -kMaxWignerDegree - 1L || value > kMaxWignerDegree + 1L) {
      throw std::invalid_argument(option + ": '" + parts[i] + "' is not an integer up to " +
                                  std::to_string(kMaxWignerDegree));
    }
    numbers[i] = static_cast<int>(value);
  }
  return numbers;
}

void run(const Options& options) {
  const Triple degrees = triple("--degrees", options.degrees);
  const Triple orders = triple("--orders", options.orders);
  require_wigner("gaunt", degrees, orders);
  require_range("digits", options.digits, 1, kMaxReferenceDigits);
  const Surd exact = options.complex ? complex_gaunt_exact(degrees, orders) : gaunt_exact(degrees, orders);
  const std::string decimal =
      exact.is_zero() ? "0"
                      : correct_digits(options.digits, {[&](int /*decimals*/) { return exact.value<MpfrAny>(); }});
  print(exact.text() + "\n" + decimal + "\n");
}

}  // namespace

void add_gaunt_command(CLI::App& tool, int& /*exit_code*/) {
  const auto options = std::make_shared<Options>();
  auto* command = tool.add_subcommand(
      "gaunt", "print the integral of three spherical harmonics over the sphere: a line exactly, a line in decimal");
  command->add_option("--degrees", options->degrees, "a,b,c: 0 to 10000 each")->required();
  command->add_option("--orders", options->orders, "m,n,p, each at most its degree")->required();
  command->add_option("--digits", options->digits, "significant decimals, 1 to 10000")->required();
  command->add_flag("--complex", options->complex,
                    "of the complex basis with Condon-Shortley phase, none conjugated, instead of the real one");
  command->callback([options] { run(*options); });
}

}  // namespace sh::numeric
