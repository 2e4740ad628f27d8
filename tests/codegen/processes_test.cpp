// Work that processes share: every piece once, whatever their number; errors and deaths are told; none is left behind.
#include "codegen/output/processes.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace sh::codegen {
namespace {

// What the exception of a call says; empty if there is none.
std::string told_by(const std::function<void()>& call) {
  try {
    call();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

// Where no child is left, waiting for one fails.
void expect_no_child() {
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1);
  EXPECT_EQ(errno, ECHILD);
}

TEST(InProcesses, DoesEveryPieceOnce) {
  for (const int processes : {0, 1, 2, 7, 40}) {
    for (const std::size_t count : {0U, 1U, 3U, 25U}) {
      std::vector<std::string> taken(count);
      in_processes(
          count, processes,
          [](std::size_t i) {
            return std::string(100000 * (i % 3), 'a') + std::to_string(i);
          },  // more than a pipe holds
          [&](std::size_t i, const std::string& text) { taken[i] += text; });
      for (std::size_t i = 0; i < count; ++i) {
        EXPECT_TRUE(taken[i] == std::string(100000 * (i % 3), 'a') + std::to_string(i)) << processes << " " << i;
      }
    }
  }
  expect_no_child();
}

TEST(InProcesses, WorksOutsideOfThisProcessUnlessThereIsOne) {
  for (const int processes : {1, 2}) {
    std::string where;
    in_processes(
        1, processes, [](std::size_t) { return std::to_string(getpid()); },
        [&](std::size_t, const std::string& text) { where = text; });
    EXPECT_EQ(where == std::to_string(getpid()), processes == 1);
  }
}

TEST(InProcesses, TellsTheTextOfAnException) {
  for (const int processes : {1, 3}) {
    const auto work = [](std::size_t i) -> std::string {
      if (i == 2) throw std::invalid_argument("piece 2: expected better");
      return "";
    };
    EXPECT_EQ(told_by([&] { in_processes(9, processes, work, [](std::size_t, const std::string&) {}); }),
              "piece 2: expected better");
    expect_no_child();
  }
}

TEST(InProcesses, TellsOfADeath) {
  const auto die = [](std::size_t i) {
    if (i == 1) kill(getpid(), SIGKILL);
    return std::string();
  };
  EXPECT_EQ(told_by([&] { in_processes(5, 2, die, [](std::size_t, const std::string&) {}); }),
            "a process ended too early");
  expect_no_child();
}

TEST(InProcesses, EndsAllWhereTakingAResultFails) {
  const auto long_work = [](std::size_t i) {
    if (i > 0) sleep(3600);
    return std::string();
  };
  const auto refuse = [](std::size_t, const std::string&) { throw std::runtime_error("no more"); };
  EXPECT_EQ(told_by([&] { in_processes(3, 3, long_work, refuse); }), "no more");
  expect_no_child();
}

TEST(InProcesses, HasACore) { EXPECT_GE(core_count(), 1); }

}  // namespace
}  // namespace sh::codegen
