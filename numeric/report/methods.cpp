// See methods.hpp.
#include "numeric/report/methods.hpp"

namespace sh::numeric {

const char* to_string(Mode mode) {
  switch (mode) {
    case Mode::kOne:
      return "one";
    case Mode::kPrepared:
      return "prepared";
    case Mode::kBatch:
      return "batch";
  }
  return "";
}

std::vector<Method> methods_of(const std::string& task, int degree) {
  std::vector<Method> all;
  add_kernel_methods(all, task, degree);
  add_batch_methods(all, task, degree);
  add_table_methods(all, task, degree);
  add_textbook_methods(all, task, degree);
  return all;
}

}  // namespace sh::numeric
