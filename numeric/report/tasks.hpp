// The tasks at which methods are compared.
#pragma once

#include <string>
#include <vector>

#include "numeric/kernels/family_check.hpp"

namespace sh::numeric {

struct Task {
  std::string id;          ///< "rotate", for command lines and JSON
  std::string title;       ///< "Rotation"
  std::string what;        ///< a sentence: input and output
  std::string error;       ///< the subject of the error, with its scale
  std::vector<int> quick;  ///< degrees of the quick report
  std::vector<int> full;   ///< of the full one; the last is the highest degree that has a method
  std::string beyond;      ///< where to go for a higher degree
  bool relative = false;   ///< errors are compared in units of the check's size, not absolutely
};

const std::vector<Task>& all_tasks();

/// Throws std::invalid_argument, one line that names `option` and lists the tasks, for another id.
const Task& find_task(const std::string& option, const std::string& id);

/// The check of kernels/family_check.hpp with inputs of one scale, so that absolute errors compare: gradients at |d| = 1,
/// samples of weight 1.
FamilyCheck task_check(const std::string& family);

}  // namespace sh::numeric
