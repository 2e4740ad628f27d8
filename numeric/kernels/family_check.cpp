// See family_check.hpp.
#include "numeric/kernels/family_check.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <stdexcept>
#include <utility>

#include "numeric/kernels/inputs.hpp"
#include "numeric/kernels/size_formula.hpp"
#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/rotation_matrices.hpp"

namespace sh::numeric {
namespace {

// Values of the degree alone, each made once.
template <class Value>
class ByDegree {
 public:
  explicit ByDegree(std::function<Value(int degree)> make) : make_(std::move(make)) {}
  const Value& at(int degree) {
    const auto found = values_.find(degree);
    return found != values_.end() ? found->second : values_.emplace(degree, make_(degree)).first->second;
  }

 private:
  std::function<Value(int degree)> make_;
  std::map<int, Value> values_;
};

// A place among the flat inputs where numbers of a role that has a domain begin.
struct InputPlace {
  std::string role;
  std::size_t first = 0;
};

struct Domain {
  std::size_t inputs = 0;
  std::vector<InputPlace> places;
};

Domain domain_of(const Signature& signature) {
  Domain domain;
  for (const Parameter& parameter : signature.parameters) {
    if (!parameter.is_read()) continue;
    const std::string& role = parameter.role;
    const bool inside = role == "direction" && !domain.places.empty() && domain.places.back().role == role &&
                        domain.inputs < domain.places.back().first + 3;
    if (!inside) domain.places.push_back({role, domain.inputs});
    domain.inputs += static_cast<std::size_t>(parameter.values());
  }
  return domain;
}

RealFunction nearest_of(const FamilyRecord& record) {
  if (!record.normalized) return {};
  const auto domains =
      std::make_shared<ByDegree<Domain>>([record](int degree) { return domain_of(record.signature(degree)); });
  return [domains](int degree, const auto* in, auto* out) {
    const Domain& domain = domains->at(degree);
    std::copy_n(in, domain.inputs, out);
    for (const auto& [role, first] : domain.places) {
      if (role == "direction") {
        const auto unit = normalized(in[first], in[first + 1], in[first + 2]);
        std::copy(unit.begin(), unit.end(), out + first);
      }
      if (role == "rotation matrix") nearest_rotation(in + first, out + first);
      if (role == "quaternion") scale_to_unit(4, in + first, out + first);
      if (role == "cosine") scale_to_unit(2, in + first, out + first);
    }
  };
}

// By output, the most that inputs of length 1 can make of it, for a kernel that is linear in them.
std::vector<double> gains(const RealFunction& linear, const Signature& signature, int degree) {
  std::vector<long double> in(signature.input_count());
  std::vector<long double> out(signature.output_count());
  std::vector<double> gains(out.size());
  for (long double& one : in) {
    one = 1;
    linear(degree, in.data(), out.data());
    one = 0;
    for (std::size_t i = 0; i < out.size(); ++i) gains[i] += static_cast<double>(out[i] * out[i]);
  }
  for (double& gain : gains) gain = std::sqrt(gain);
  return gains;
}

}  // namespace

FamilyCheck make_check(const FamilyRecord& record, const ExactFamily& exact) {
  const auto gain = std::make_shared<ByDegree<std::vector<double>>>(
      [record, exact](int degree) { return gains(exact.values, record.signature(degree), degree); });
  const auto sizes = std::make_shared<ByDegree<SizeFormula>>([record, gain](int degree) {
    return SizeFormula(record.sizes, record.signature(degree), degree,
                       [gain, degree](std::size_t output) { return gain->at(degree)[output]; });
  });
  return {.family = record.family,
          .signature = [record](int degree) { return record.signature(degree); },
          .inputs = [record, made = exact.made](
                        int degree) { return inputs_by_role(record.signature(degree), degree, record.lengths, made); },
          .oracle = exact.values,
          .nearest = nearest_of(record),
          .size = [sizes](int degree, const double* in, std::size_t output) { return sizes->at(degree)(in, output); },
          .unit = record.unit};
}

const std::vector<FamilyCheck>& all_checks() {
  static const std::vector<FamilyCheck> kChecks = [] {
    std::vector<FamilyCheck> checks;
    for (const FamilyRecord& record : families_record().families) {
      for (const ExactFamily& exact : exact_families()) {
        if (exact.family == record.family) checks.push_back(make_check(record, exact));
      }
    }
    return checks;
  }();
  return kChecks;
}

const FamilyCheck* find_check(const std::string& family) {
  for (const FamilyCheck& check : all_checks()) {
    if (check.family == without_variant(family)) return &check;
  }
  return nullptr;
}

const FamilyCheck& check_of(const std::string& family) {
  if (const FamilyCheck* const found = find_check(family)) return *found;
  throw std::invalid_argument("expected a family with exact values, got '" + family + "'");
}

}  // namespace sh::numeric
