// Every family's check, in the order of reports.
#pragma once

#include <vector>

#include "numeric/checks/family_check.hpp"

namespace sh::numeric {

FamilyCheck basis_check();

std::vector<FamilyCheck> all_checks();

// The check of a kernel's family or of the family whose variant it is ("basis" for "basis_accurate"); nullptr if none.
const FamilyCheck* find_check(const std::vector<FamilyCheck>& checks, const std::string& family);

}  // namespace sh::numeric
