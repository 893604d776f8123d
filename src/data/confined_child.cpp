#include "confined_child.hpp"

#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <new>
#include <vector>

#include <fmt/format.h>

#include "limber/common/descriptor.hpp"
#include "limber/common/error.hpp"
#include "limber/common/refuse_if.hpp"

namespace limber {

namespace {

// How a child ends that found no room, or that failed in a way nobody foresaw.
constexpr int kNoMemory = 3;
constexpr int kUnforeseen = 4;

constexpr const char* kExpected =
    "the file is damaged, or made to do harm; expected a whole recording";

#if defined(__x86_64__)
constexpr std::uint32_t kArchitecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t kArchitecture = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t kArchitecture = 0;  // limits alone
#endif

/// What memory, the pipe and the end of a process need. All else fails with EPERM.
constexpr std::array kAllowedCalls = {
    __NR_read,         __NR_write,          __NR_mmap,         __NR_munmap, __NR_mremap,
    __NR_mprotect,     __NR_madvise,        __NR_brk,          __NR_futex,  __NR_exit_group,
    __NR_rt_sigreturn, __NR_rt_sigprocmask, __NR_clock_gettime};

/// The kernel's filter, where it has one (a container may forbid it; the limits hold anyway).
void allow_computing_only() {
  if (kArchitecture == 0 || ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) {
    return;
  }
  std::vector<sock_filter> program = {
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, arch)),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, kArchitecture, 1, 0),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS),
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr))};
  for (const auto call : kAllowedCalls) {
    program.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, std::uint32_t(call), 0, 1));
    program.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW));
  }
  program.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EPERM));
  const sock_fprog filter{static_cast<unsigned short>(program.size()), program.data()};
  (void)::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter, 0, 0);
}

void limit(__rlimit_resource what, std::uintmax_t value) {
  const rlimit both{static_cast<rlim_t>(value), static_cast<rlim_t>(value)};
  (void)::setrlimit(what, &both);
}

/// Bytes of address space that this process has.
std::uintmax_t address_space() {
  std::uintmax_t pages = 0;
  if (std::FILE* file = std::fopen("/proc/self/statm", "re")) {
    unsigned long found = 0;
    pages = std::fscanf(file, "%lu", &found) == 1 ? found : 0;
    (void)std::fclose(file);
  }
  return pages * std::uintmax_t(::sysconf(_SC_PAGESIZE));
}

/// In the child, before it reads anything: the pipe is all that is left to it.
void confine(int pipe, pid_t parent, const ChildLimits& limits) {
  (void)::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) {
    ::_exit(kUnforeseen);
  }
  for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU, SIGTRAP, SIGSYS}) {
    (void)::signal(number, SIG_DFL);  // Python and others may have handlers of their own
  }
  (void)::signal(SIGINT, SIG_IGN);  // Ctrl-C is the parent's to answer
  const std::uintmax_t size = address_space();
  if (pipe != STDIN_FILENO) {
    (void)::dup2(pipe, STDIN_FILENO);
  }
  (void)::close_range(STDIN_FILENO + 1, ~0U, 0);  // also what libraries would print
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, 0);
  limit(RLIMIT_NOFILE, 0);
  limit(RLIMIT_CPU, limits.cpu_s);
  if (size > 0) {
    limit(RLIMIT_AS, size + limits.memory_bytes);
  }
  allow_computing_only();
}

/// The child, and this end of its pipe.
class Child {
 public:
  Child(const std::string& name, const ChildLimits& limits, const std::function<void(int)>& work) {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
      refuse(name, errno);
    }
    read_end_ = Descriptor(ends[0]);
    const Descriptor write_end(ends[1]);
    const pid_t parent = ::getpid();
    pid_ = ::fork();
    if (pid_ == 0) {
      confine(write_end.get(), parent, limits);
      try {
        work(STDIN_FILENO);
      } catch (const std::bad_alloc&) {
        ::_exit(kNoMemory);
      } catch (...) {
        ::_exit(kUnforeseen);
      }
      ::_exit(0);
    }
    if (pid_ < 0) {
      refuse(name, errno);
    }
  }
  ~Child() {
    if (pid_ > 0) {
      (void)::kill(pid_, SIGKILL);
      (void)status();
    }
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  int read_end() const { return read_end_.get(); }

  /// How it ended, once it has. 0 also where somebody else waited for it.
  int status() {
    int status = 0;
    while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
    }
    pid_ = 0;
    return status;
  }

 private:
  [[noreturn]] static void refuse(const std::string& name, int error) {
    throw SystemFault(fmt::format("{}: no process to read it in: {}", name, std::strerror(error)));
  }

  pid_t pid_ = 0;
  Descriptor read_end_;
};

[[noreturn]] void explain(const std::string& name, const ChildLimits& limits, int status) {
  std::string what = "reading it failed";
  if (WIFSIGNALED(status)) {
    const int number = WTERMSIG(status);
    // The hard limit, which equals the soft one, kills.
    what = number == SIGXCPU || number == SIGKILL
               ? fmt::format("reading it took more than {} s of processor time, or was killed",
                             limits.cpu_s)
               : fmt::format("reading it crashed ({})", ::sigdescr_np(number));
  } else if (WEXITSTATUS(status) == kNoMemory) {
    what = fmt::format("reading it needs more than {} MB of memory", limits.memory_bytes >> 20U);
  }
  throw InputError(fmt::format("{}: {}: {}", name, what, kExpected));
}

}  // namespace

void run_confined(const std::string& name, const ChildLimits& limits,
                  const std::function<void(int pipe)>& work,
                  const std::function<void(int pipe)>& receive) {
  Child child(name, limits, work);
  try {
    receive(child.read_end());
  } catch (const EndOfPipe& end) {
    refuse_if(end.silent, "{}: reading it does not end: {}", name, kExpected);
    explain(name, limits, child.status());
  }
}

}  // namespace limber
