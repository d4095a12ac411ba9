// SPDX-License-Identifier: MIT
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include "support/temporary_folder.h"

namespace revisit_slam {

/// A program that runs beside the test and ends with it at the latest.
class ChildProcess {
 public:
  /// `arguments` starts with the program, which is looked for in PATH.
  explicit ChildProcess(const std::vector<std::string>& arguments,
                        const std::string& folder = ".") {
    std::vector<char*> argv;
    for (const std::string& argument : arguments)
      argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    const std::string log = log_folder_.with("output", "");
    process_ = fork();
    if (process_ != 0) return;
    setpgid(0, 0);  // the children of the child are to get its signals
    const int file = open(log.c_str(), O_WRONLY | O_APPEND);
    dup2(file, STDOUT_FILENO);
    dup2(file, STDERR_FILENO);
    if (chdir(folder.c_str()) == 0) {
      setenv("PWD", folder.c_str(), folder == "." ? 0 : 1);  // as a shell does
      execvp(argv[0], argv.data());
    }
    _exit(127);
  }
  ~ChildProcess() {
    interrupt();
    if (wait(10.0) == still_running) kill(-process_, SIGKILL);
  }
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  static constexpr int still_running = -1;

  /// Exit status, 128 + signal, or still_running when `seconds` have passed.
  int wait(double seconds) {
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::duration<double>(seconds);
    for (int status; status_ == still_running && Clock::now() < end;) {
      if (waitpid(process_, &status, WNOHANG) == process_)
        status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
      else
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return status_;
  }

  void interrupt() { signal(SIGINT); }
  void signal(int number) {
    if (status_ == still_running) kill(-process_, number);
  }

  pid_t id() const { return process_; }

  /// What it has written so far.
  std::string output() const { return textOf(log_folder_.file("output")); }

 private:
  TemporaryFolder log_folder_;
  pid_t process_ = 0;
  int status_ = still_running;
};

}  // namespace revisit_slam
