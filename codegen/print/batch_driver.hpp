// The parts of batched drivers: the kernels of a family as functions from records to records (batch.hpp), and their
// files.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "codegen/measure/measure.hpp"
#include "codegen/print/batch.hpp"

namespace sh::codegen::print {

/// The largest degrees of drivers that add up parts, and that use prepared functions (errors of the polynomial grow).
inline constexpr int kLargestByParts = 5;
inline constexpr int kLargestPrepared = 6;

/// A record that a driver takes, and the places of the kernel's arguments in it.
struct Record {
  std::string name;
  std::vector<std::string> arguments;  // of the kernel, from `in[j]`
  int size = 0;
  bool shared = false;         // scalars that serve all records
  std::string size_text = {};  // for every degree; empty: a number or a multiple of bands^2
};

/// A kernel as a driver sees it.
struct RecordSignature {
  std::vector<Record> inputs;
  std::string out;  // name
  int out_size = 0;
  bool sums = false;
  bool returns = false;
};

/// The records of a kernel.
RecordSignature signature_of(const Kernel& kernel);

/// Whether records of `size` values at the kernel's degree are the coefficients of so many channels.
bool are_coefficients(int size, const Kernel& kernel, int channels);

/// "sh::rotate<Degree>(in[0], in[1], out);". Several results have bands^2 values each and follow each other.
std::string call_of(const Kernel& kernel);
/// The same of any function of sh; count: bands^2 in code.
std::string call_of(const Kernel& kernel, const std::string& function, const std::string& count);

/// The size of a record in terms of Degree, in code: "4 * ((Degree + 1) * (Degree + 1))".
std::string size_in_degree(int size, const Kernel& kernel);

/// A driver and the families that it runs.
struct Driver {
  std::string name;  // of the driver and of the family whose kernels it runs
  BatchDriver spec;
  std::span<const FinishedKernel> kernels;  // to the largest degree of the driver
  int further = 0;                          // the largest degree of the family, if the driver does not reach it
  const std::vector<FinishedKernel>* prepare = nullptr;
  const std::vector<FinishedKernel>* prepared = nullptr;
  const std::vector<FinishedKernel>* parts = nullptr;
  const std::vector<FinishedKernel>* finish = nullptr;
  [[nodiscard]] bool prepares() const { return prepare != nullptr && prepared != nullptr; }
  [[nodiscard]] bool adds_parts() const { return parts != nullptr && finish != nullptr; }
  [[nodiscard]] const Kernel& last() const { return kernels.back().kernel; }
  [[nodiscard]] bool has_few() const { return !spec.groups && !spec.single.empty(); }  // SingleKernels
  /// Whether it has kernels of groups.
  [[nodiscard]] bool has_records() const {
    return spec.groups || (spec.grouped >= 0 && !spec.scalar_products && !signature_of(last()).sums);
  }
};

/// The largest degree to which the kernels of a driver add nothing: every compiler rounds them alike. -1: there is none.
int last_without_sums(const Driver& driver);

/// The drivers of all families that have one.
std::vector<Driver> drivers_of(const std::vector<WrittenFamily>& families);

/// The name of the table of a driver's kernels that are called directly.
std::string table_of_direct(const Driver& driver, const std::string& scalar);

/// generated/batch/<driver>.cpp: the driver's kernels by degree, compiled once for each instruction set.
std::string kernels_file(const Driver& driver);

/// once.hpp and once.cpp: functions that a driver runs once a call, the same on every instruction set.
std::string once_header(const std::vector<Driver>& drivers);
std::string once_file(const std::vector<Driver>& drivers);

/// Degrees whose products have tables of orbits.
inline constexpr int kFirstOrbitDegree = 3;
inline constexpr int kLastOrbitDegree = 6;
/// The last degrees that are rotated in 16 lanes and in pairs of 8 lanes.
inline constexpr int kLastTurnDegree = 6;
inline constexpr int kLastPairDegree = 7;

/// The first degree of transfer that is applied in stages on rings.
inline constexpr int kFirstRingDegree = 2;
/// batch/rings.hpp: the constants of these stages, from the first degree on to `largest`.
std::string rings_file(int largest);

/// Relative path -> text: orbits of products, triples of the Gaunt tensor, turns of bands.
std::map<std::string, std::string> lane_tables();

}  // namespace sh::codegen::print
