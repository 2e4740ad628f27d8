#include "codegen/bound/stated.hpp"

#include "codegen/measure/search.hpp"

namespace sh::codegen::bound {
namespace {

template <class T>
void state(FinishedKernel& finished, MeasuredError& error, const char* format) {
  error.proved = bound(finished.kernel, finished.domain, find_format(format));
  search_more<T>(error, finished.kernel, finished.domain, {error.proved->worst}, search_evaluations(finished.kernel));
}

}  // namespace

void state_errors(FinishedKernel& finished) {
  state<float>(finished, finished.in_float, "float");
  state<double>(finished, finished.in_double, "double");
}

}  // namespace sh::codegen::bound
