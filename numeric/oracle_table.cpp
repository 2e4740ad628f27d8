// See oracle_table.hpp.
#include "numeric/oracle_table.hpp"

#include "numeric/basis.hpp"
#include "numeric/real.hpp"

namespace sh::numeric {
namespace {

void append(std::vector<ExactValue>& all, const std::vector<Mpfr100>& values) {
  for (const auto& value : values) {
    const auto high = static_cast<double>(value);
    all.emplace_back(high, static_cast<double>(Mpfr100(value - high)));
  }
}

}  // namespace

template <class T>
OracleTable<T> make_oracle_table(int degree, const std::vector<Direction>& directions) {
  OracleTable<T> table;
  table.degree = degree;
  const auto count = static_cast<std::size_t>(coefficient_count(degree));
  table.own_polynomial.reserve(directions.size() * count);
  table.true_function.reserve(directions.size() * count);
  std::vector<Mpfr100> values(count);
  for (const auto& d : directions) {
    const std::array<T, 3> input = {static_cast<T>(d.x), static_cast<T>(d.y), static_cast<T>(d.z)};
    const Mpfr100 x = input[0];
    const Mpfr100 y = input[1];
    const Mpfr100 z = input[2];
    basis_z_form(degree, x, y, z, values.data());
    append(table.own_polynomial, values);
    const auto unit = normalised(x, y, z);
    basis(degree, unit[0], unit[1], unit[2], values.data());
    append(table.true_function, values);
    table.inputs.push_back(input);
  }
  return table;
}

template OracleTable<float> make_oracle_table<float>(int, const std::vector<Direction>&);
template OracleTable<double> make_oracle_table<double>(int, const std::vector<Direction>&);

}  // namespace sh::numeric
