#include "ReaderGuard.h"

#include <algorithm>
#include <fcntl.h>
#include <fstream>
#include <iostream>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

namespace
{
volatile bool* IsReading = nullptr; // of both processes

void SetReading(bool isReading)
{
  if (IsReading)
  {
    *IsReading = isReading;
  }
}

// Of the process, which RLIMIT_DATA counts: proc(5), /proc/pid/statm.
std::uintmax_t GetDataBytes()
{
  std::ifstream stream("/proc/self/statm");
  std::uintmax_t pages = 0;
  constexpr int Data = 6;
  for (int i = 0; i < Data; ++i)
  {
    stream >> pages;
  }
  return pages * static_cast<std::uintmax_t>(sysconf(_SC_PAGESIZE));
}

// Of the processor, so that slow disks are waited for. 0: as many as it likes.
void LimitSeconds(double seconds)
{
  constexpr double Million = 1e6;
  itimerval timer = {};
  timer.it_value.tv_sec = static_cast<time_t>(seconds);
  timer.it_value.tv_usec =
    static_cast<suseconds_t>((seconds - static_cast<double>(timer.it_value.tv_sec)) * Million);
  setitimer(ITIMER_PROF, &timer, nullptr);
}

std::uintmax_t LimitData(std::uintmax_t bytes)
{
  rlimit limit = {};
  getrlimit(RLIMIT_DATA, &limit);
  const rlim_t former = limit.rlim_cur;
  limit.rlim_cur = std::min<rlim_t>(bytes, limit.rlim_max);
  setrlimit(RLIMIT_DATA, &limit);
  return former;
}
} // namespace

ReaderGuard::ReaderGuard(double seconds, std::uintmax_t bytes)
{
  constexpr std::uintmax_t Spare = std::uintmax_t(100) << 20;
  std::cerr.flush();
  this->StandardError = dup(STDERR_FILENO);
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  dup2(nowhere, STDERR_FILENO);
  close(nowhere);
  LimitSeconds(1.0 + seconds);
  SetReading(true);
  this->FormerLimit = LimitData(GetDataBytes() + Spare + bytes);
}

ReaderGuard::~ReaderGuard()
{
  LimitData(this->FormerLimit);
  LimitSeconds(0.0);
  SetReading(false);
  dup2(this->StandardError, STDERR_FILENO);
  close(this->StandardError);
}

int RunInChild(
  const std::function<int()>& work, const std::function<int(int signal, bool wasReading)>& died)
{
  void* shared =
    mmap(nullptr, sizeof(bool), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  IsReading = shared == MAP_FAILED ? nullptr : static_cast<bool*>(shared);
  const pid_t child = fork();
  if (child == 0)
  {
    prctl(PR_SET_PDEATHSIG, SIGKILL); // not to outlive what a person stops
    return work();
  }
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child)
  {
    return work();
  }
  return WIFSIGNALED(status) ? died(WTERMSIG(status), IsReading && *IsReading)
                             : WEXITSTATUS(status);
}
