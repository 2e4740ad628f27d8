#include "tests/prt/tool.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

std::string command_line(const Arguments& arguments) {
  std::string line = quoted(std::string(SHFORGE_BIN_DIR) + "/prt");
  for (const std::string& argument : arguments) line += ' ' + quoted(argument);
  return line;
}

pid_t start_shell(const std::string& text) {
  const pid_t child = fork();
  if (child == 0) {
    execl("/bin/sh", "sh", "-c", text.c_str(), static_cast<char*>(nullptr));
    _exit(127);
  }
  return child;
}

int wait_for(pid_t child) {
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

Finished run_prt(const Arguments& arguments, const std::string& before, const std::string& redirect) {
  const TemporaryFolder folder;
  const std::string out = redirect.empty() ? folder.file("out") : redirect;
  const std::string text = (before.empty() ? "" : before + "; ") + "exec " + command_line(arguments) + " > " +
                           quoted(out) + " 2> " + quoted(folder.file("err"));
  const int status = wait_for(start_shell(text));
  return {status, redirect.empty() ? read_all(out) : std::string(), read_all(folder.file("err"))};
}

Arguments joined(Arguments first, const Arguments& more) {
  first.insert(first.end(), more.begin(), more.end());
  return first;
}

Finished succeeded(const Arguments& arguments) {
  Finished run = run_prt(arguments);
  EXPECT_EQ(run.status, 0) << run.err;
  return run;
}

nlohmann::json printed(const Arguments& arguments) { return nlohmann::json::parse(succeeded(arguments).out); }

void expect_refused(const Arguments& arguments, const std::string& reason, const std::string& before, int status) {
  const Finished run = run_prt(arguments, before);
  EXPECT_EQ(run.status, status) << run.err;
  EXPECT_EQ(run.err.rfind("prt: ", 0), 0U) << run.err;
  EXPECT_NE(run.err.find(reason), std::string::npos) << run.err;
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  EXPECT_EQ(run.out, "");
}

Finished signal_prt(const Arguments& arguments, int signal, const std::function<bool()>& when) {
  const TemporaryFolder folder;
  const pid_t child = start_shell("exec " + command_line(arguments) + " > /dev/null 2> " + quoted(folder.file("err")));
  siginfo_t info = {};
  const auto runs = [&] {
    return waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == 0;
  };
  while (runs()) {
    if (when()) {
      kill(child, signal);
      break;
    }
    std::this_thread::sleep_for(std::chrono::microseconds(100));
  }
  const int status = wait_for(child);
  return {status, {}, read_all(folder.file("err"))};
}

Finished interrupt_prt(const Arguments& arguments, int milliseconds) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(milliseconds);
  return signal_prt(arguments, SIGINT, [end] { return std::chrono::steady_clock::now() >= end; });
}

}  // namespace sh::prt::test
