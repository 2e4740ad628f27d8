// The tasks that methods are compared at.
#pragma once

#include <string>
#include <vector>

namespace sh::numeric {

struct Task {
  std::string id;          // "rotate", for command lines and JSON
  std::string title;       // "Rotation"
  std::string what;        // a sentence: what goes in and comes out
  std::string error;       // what the error is of, with its scale
  std::vector<int> quick;  // degrees of the quick report
  std::vector<int> full;
  int lowest;  // degrees at which there is something to measure
  int highest;
  bool relative = false;  // errors are compared in units of the check's size, not absolutely
};

const std::vector<Task>& all_tasks();

// Throws std::invalid_argument, one line that lists the tasks, for another id. `option` is named in it.
const Task& find_task(const std::string& option, const std::string& id);

}  // namespace sh::numeric
