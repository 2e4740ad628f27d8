#include "prt/commands/mpi_ranks.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <stdexcept>

#ifdef SHFORGE_MPI
#include <mpi.h>

#include <chrono>
#include <exception>
#include <thread>

#include "numeric/output/log.hpp"
#include "prt/commands/commands.hpp"
#endif

namespace sh::prt {

namespace {

// Whether a launcher of Open MPI, of MPICH and its like, or of Slurm with PMIx started this process.
bool is_launched() {
  constexpr std::array kNames = {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK"};
  return std::any_of(kNames.begin(), kNames.end(), [](const char* name) { return std::getenv(name) != nullptr; });
}

#ifdef SHFORGE_MPI

void broadcast(double* values, std::size_t size, std::size_t root) {
  MPI_Bcast(values, static_cast<int>(size), MPI_DOUBLE, static_cast<int>(root), MPI_COMM_WORLD);
}

Ranks join() {
  int level = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &level);
  int index = 0;
  int count = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &index);
  MPI_Comm_size(MPI_COMM_WORLD, &count);
  if (level < MPI_THREAD_SERIALIZED)
    throw std::runtime_error("merge: this MPI allows no threads; expected one that does");
  return {static_cast<std::size_t>(index), static_cast<std::size_t>(count), broadcast};
}

// The first process has the same error in most cases, and is given the time to say so.
[[noreturn]] void end_all(const Ranks& ranks, output::LogFormat format, const std::exception_ptr& error) {
  if (!ranks.is_first()) std::this_thread::sleep_for(std::chrono::seconds(2));
  output::set_log_format(format);
  MPI_Abort(MPI_COMM_WORLD, tell_error(error));
  std::abort();
}

#endif

}  // namespace

#ifdef SHFORGE_MPI

void run_as_ranks(const std::function<void(const Ranks& ranks)>& run) {
  if (!is_launched()) return run({});
  const output::LogFormat format = output::log_format();
  Ranks ranks;
  try {
    ranks = join();
    if (!ranks.is_first()) output::set_log_format(output::LogFormat::kNone);
    run(ranks);
  } catch (const std::exception&) {
    end_all(ranks, format, std::current_exception());
  }
  MPI_Finalize();
}

#else

void run_as_ranks(const std::function<void(const Ranks& ranks)>& run) {
  if (is_launched()) {
    throw std::runtime_error(
        "merge: started by MPI, which this build does not have; expected one process, or a build with SHFORGE_MPI");
  }
  run({});
}

#endif

}  // namespace sh::prt
