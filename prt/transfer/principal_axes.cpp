#include "prt/transfer/principal_axes.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "prt/chunks.hpp"

namespace sh::prt {

namespace {

constexpr Eigen::Index kMostAxes = 128;
constexpr Eigen::Index kSampled = 512;   // rows that give the axes of long ones
constexpr std::size_t kBlock = 64;       // rows at once
constexpr int kIterations = 6;           // in all dimensions
constexpr double kSmallestPart = 1e-16;  // of the squares of all rows: below the rounding of single precision
constexpr double kRoundingPart = 1e-13;  // error of a plane that holds its rows but for rounding

using FloatRows = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Solver = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>;

// The principal axes of rows at even steps, from the eigenvectors of their products with each other.
void take_axes(const Eigen::Map<const FloatRows>& rows, Reduced& reduced) {
  const Eigen::Index count = std::min(rows.rows(), kSampled);
  DoubleRows sample(count, rows.cols());
  for (Eigen::Index i = 0; i < count; ++i) sample.row(i) = rows.row(i * rows.rows() / count).cast<double>();
  reduced.origin = sample.colwise().mean();
  sample.rowwise() -= reduced.origin;
  const Solver solver(sample * sample.transpose());
  const Eigen::VectorXd& values = solver.eigenvalues();  // ascending
  const double least = kSmallestPart * values.cwiseAbs().sum();
  Eigen::Index axes = 0;
  while (axes < std::min(count, kMostAxes) && values[count - 1 - axes] > least) ++axes;
  reduced.axes.resize(axes, rows.cols());
  for (Eigen::Index k = 0; k < axes; ++k) {
    reduced.axes.row(k) = solver.eigenvectors().col(count - 1 - k).transpose() * sample;
    reduced.axes.row(k).normalize();
  }
}

// Some rows less their mean, each call(block) a few at once.
template <class AnyRows, class Use>
void each_block(const AnyRows& rows, std::span<const std::uint32_t> members, const Eigen::RowVectorXd& mean,
                const Use& use) {
  for (std::size_t first = 0; first < members.size(); first += kBlock) {
    const auto some = members.subspan(first, std::min(kBlock, members.size() - first));
    DoubleRows block(some.size(), rows.cols());
    for (std::size_t i = 0; i < some.size(); ++i) block.row(i) = rows.row(some[i]).template cast<double>() - mean;
    use(block);
  }
}

// Sum of (row - mean)^T (row - mean), the lower triangle.
Eigen::MatrixXd scatter(const DoubleRows& rows, std::span<const std::uint32_t> members,
                        const Eigen::RowVectorXd& mean) {
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(rows.cols(), rows.cols());
  each_block(rows, members, mean,
             [&](const DoubleRows& block) { sum.selfadjointView<Eigen::Lower>().rankUpdate(block.transpose()); });
  return sum;
}

}  // namespace

Reduced reduced(const std::vector<float>& numbers, std::size_t length) {
  const Eigen::Map<const FloatRows> rows(numbers.data(), numbers.size() / length, length);
  Reduced reduced;
  if (rows.cols() <= kMostAxes) {
    reduced.coordinates = rows.cast<double>();
    reduced.axes = DoubleRows::Identity(rows.cols(), rows.cols());
    reduced.origin = Eigen::RowVectorXd::Zero(rows.cols());
    return reduced;
  }
  take_axes(rows, reduced);
  reduced.coordinates.resize(rows.rows(), reduced.axes.rows());
  for_chunks(rows.rows(), [&](std::size_t chunk) {
    const VertexRange range = chunk_range(chunk, rows.rows());
    DoubleRows some = rows.middleRows(range.first, range.size()).cast<double>();
    some.rowwise() -= reduced.origin;
    reduced.coordinates.middleRows(range.first, range.size()).noalias() = some * reduced.axes.transpose();
  });
  return reduced;
}

bool Plane::can_be_split() const { return error > kRoundingPart * energy; }

Plane nearest_plane(const DoubleRows& rows, std::span<const std::uint32_t> members, std::size_t vectors) {
  Plane plane;
  plane.mean = Eigen::RowVectorXd::Zero(rows.cols());
  plane.axes = DoubleRows::Zero(vectors, rows.cols());
  for (const std::uint32_t member : members) {
    plane.mean += rows.row(member) / static_cast<double>(members.size());
    plane.energy += rows.row(member).squaredNorm();
  }
  const Eigen::MatrixXd sum = scatter(rows, members, plane.mean);
  const Solver solver(sum);
  plane.error = sum.trace();
  for (std::size_t k = 0; k < std::min<std::size_t>(vectors, rows.cols()); ++k) {
    const Eigen::Index column = rows.cols() - 1 - k;  // eigenvalues ascend
    if (!(solver.eigenvalues()[column] > kSmallestPart * plane.energy)) break;
    plane.axes.row(k) = solver.eigenvectors().col(column).transpose();
    plane.error -= solver.eigenvalues()[column];
  }
  plane.error = std::max(plane.error, 0.0);
  return plane;
}

Plane in_all_dimensions(const Plane& plane, const Reduced& reduced, const std::vector<float>& numbers,
                        std::span<const std::uint32_t> members) {
  Plane whole = plane;
  whole.mean = reduced.origin + plane.mean * reduced.axes;
  whole.axes = plane.axes * reduced.axes;
  if (reduced.axes.rows() == reduced.axes.cols()) return whole;
  const Eigen::Map<const FloatRows> rows(numbers.data(), numbers.size() / reduced.axes.cols(), reduced.axes.cols());
  whole.mean.setZero();
  for (const std::uint32_t r : members) whole.mean += rows.row(r).cast<double>() / static_cast<double>(members.size());
  for (int iteration = 0; iteration < kIterations && whole.axes.rows() > 0; ++iteration) {
    DoubleRows sum = DoubleRows::Zero(whole.axes.rows(), whole.axes.cols());
    each_block(rows, members, whole.mean,
               [&](const DoubleRows& block) { sum += (whole.axes * block.transpose()) * block; });
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(sum.transpose());
    whole.axes = (qr.householderQ() * Eigen::MatrixXd::Identity(sum.cols(), sum.rows())).transpose();
  }
  return whole;
}

}  // namespace sh::prt
