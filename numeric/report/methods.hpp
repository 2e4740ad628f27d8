// Every method of a task: generated kernels, batches, and what others use.
#pragma once

#include <string>
#include <vector>

#include "numeric/report/method.hpp"

namespace sh::numeric {

// In the order of legends. `degree` within the task's range.
std::vector<Method> methods_of(const std::string& task, int degree);

// The worst inputs that a search finds for the generated kernels of the check's family (kernel_search.hpp), T float or
// double; none where there is no kernel.
template <class T>
std::vector<NamedInput> found_inputs(const FamilyCheck& check, int degree);

// What methods_of joins, a file each.
void add_kernel_methods(std::vector<Method>& all, const std::string& task, int degree);
void add_batch_methods(std::vector<Method>& all, const std::string& task, int degree);
void add_table_methods(std::vector<Method>& all, const std::string& task, int degree);
void add_textbook_methods(std::vector<Method>& all, const std::string& task, int degree);

}  // namespace sh::numeric
