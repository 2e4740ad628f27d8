#include "prt/basis.hpp"

#include "generated/cpp/basis.hpp"
#include "generated/cpp/project.hpp"
#include "generated/cpp/rotate.hpp"

namespace sh::prt {

template <class T>
void evaluate_basis(int degree, T x, T y, T z, T* out) {
  at_degree(degree, [&](auto known) { sh::basis<known()>(x, y, z, out); });
}
template void evaluate_basis(int degree, float x, float y, float z, float* out);
template void evaluate_basis(int degree, double x, double y, double z, double* out);

template <class T>
void add_basis(int degree, T x, T y, T z, T weight, T* sum) {
  at_degree(degree, [&](auto known) { sh::project<known()>(x, y, z, weight, sum); });
}
template void add_basis(int degree, float x, float y, float z, float weight, float* sum);
template void add_basis(int degree, double x, double y, double z, double weight, double* sum);

template <class T>
void rotate_function(int degree, const Eigen::Matrix3<T>& r, const T* in, T* out) {
  const Eigen::Matrix<T, 3, 3, Eigen::RowMajor> rows = r;
  at_degree(degree, [&](auto known) { sh::rotate<known()>(rows.data(), in, out); });
}
template void rotate_function(int degree, const Eigen::Matrix3f& r, const float* in, float* out);
template void rotate_function(int degree, const Eigen::Matrix3d& r, const double* in, double* out);

}  // namespace sh::prt
