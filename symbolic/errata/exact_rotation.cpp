#include "symbolic/errata/exact_rotation.hpp"

#include "symbolic/errata/exact_tools.hpp"
#include "symbolic/rotation/quaternion_rotation.hpp"
#include "symbolic/rotation/rotation_axis.hpp"

namespace sh::symbolic::errata {
namespace {

using Rational = cln::cl_RA;

template <class F>
Matrix<RadicalSum> each_entry(const Matrix<RadicalSum>& m, const F& f) {
  Matrix<RadicalSum> result(m.rows(), m.columns());
  for (int i = 0; i < m.rows(); ++i) {
    for (int j = 0; j < m.columns(); ++j) result(i, j) = f(m(i, j));
  }
  return result;
}

Matrix<RadicalSum> real_band(const QuaternionRotation& band, const Quaternion<Rational>& q) {
  const Matrix<Surd> surds = surd_entries(band.degree, evaluate(band, q));
  Matrix<RadicalSum> result(surds.rows(), surds.columns());
  for (int i = 0; i < surds.rows(); ++i) {
    for (int j = 0; j < surds.columns(); ++j) result(i, j) = RadicalSum(surds(i, j));
  }
  return result;
}

Matrix<RadicalSum> complex_band(int l, const std::array<CosSin<Rational>, 3>& half) {
  Matrix<RadicalSum> result(2 * l + 1, 2 * l + 1);
  for (int m = -l; m <= l; ++m) {
    for (int n = -l; n <= l; ++n) {
      const RadicalSum d = wigner_value(l, m, n, half[1]);
      result(l + m, l + n) = unit_power(half[0], -2 * m) * d * unit_power(half[2], -2 * n);
    }
  }
  return result;
}

ExactRotation make_rotation(const std::array<CosSin<Rational>, 3>& half, const std::vector<QuaternionRotation>& bands) {
  ExactRotation result;
  result.half_angles = half;
  const Quaternion<Rational> q = quaternion_from_euler<Rational>("zyz", EulerFrame::kIntrinsic, half);
  result.matrix = matrix_from_quaternion<Rational>(q);
  for (const QuaternionRotation& band : bands) {
    result.real.push_back(real_band(band, q));
    result.complex.push_back(complex_band(band.degree, half));
  }
  return result;
}

CosSin<Rational> point(int cosine, int sine, int hypotenuse) {
  return {ratio(cosine, hypotenuse), ratio(sine, hypotenuse)};
}

std::vector<ExactRotation> make_samples() {
  std::vector<QuaternionRotation> bands;
  for (int l = 0; l <= kHighestBand; ++l) bands.push_back(quaternion_rotation(l));
  return {make_rotation({point(4, 3, 5), point(12, 5, 13), point(-15, 8, 17)}, bands),
          make_rotation({point(5, -12, 13), point(3, 4, 5), point(24, 7, 25)}, bands)};
}

}  // namespace

const std::vector<ExactRotation>& sample_rotations() {
  static const std::vector<ExactRotation> samples = make_samples();
  return samples;
}

CosSin<Rational> doubled(const CosSin<Rational>& half) {
  return {half.cosine * half.cosine - half.sine * half.sine, 2 * half.cosine * half.sine};
}

RadicalSum unit_power(const CosSin<Rational>& angle, int power) {
  const RadicalSum sine = scaled(power < 0 ? -angle.sine : angle.sine, RadicalSum::imaginary_unit());
  const RadicalSum base = RadicalSum(angle.cosine) + sine;
  RadicalSum result(Rational(1));
  for (int k = power < 0 ? -power : power; k > 0; --k) result = result * base;
  return result;
}

RadicalSum wigner_value(int degree, int row, int column, const CosSin<Rational>& half) {
  const WignerEntry entry = wigner_d(degree, row, column);
  const std::array<Rational, 2> at{half.cosine, half.sine};
  return scaled(entry.polynomial.evaluate(at), RadicalSum(entry.factor));
}

Matrix<RadicalSum> conjugate(const Matrix<RadicalSum>& m) {
  return each_entry(m, [](const RadicalSum& e) { return e.conjugate(); });
}

Matrix<RadicalSum> real_part(const Matrix<RadicalSum>& m) {
  return each_entry(m, [](const RadicalSum& e) { return scaled(ratio(1, 2), e + e.conjugate()); });
}

Matrix<RadicalSum> imaginary_part(const Matrix<RadicalSum>& m) {
  const RadicalSum half_i = scaled(ratio(1, 2), RadicalSum::imaginary_unit());
  return each_entry(m, [&](const RadicalSum& e) { return half_i * (e.conjugate() - e); });
}

}  // namespace sh::symbolic::errata
