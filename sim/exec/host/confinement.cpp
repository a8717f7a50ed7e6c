#include "sim/exec/host/confinement.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/filter.h>
#include <linux/futex.h>
#include <linux/seccomp.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "sim/base/descriptor.h"
#include "sim/exec/host/asan_build.h"
#include "sim/exec/host/host_fault.h"

namespace robosim::exec {
namespace {

// Placeholders in the filter that all processes share (filter_for_all()). Each process replaces them by its
// key and its process number.
constexpr std::uint32_t kKeyHere = 0x4F1D5A01, kOtherKeyHere = 0x4F1D5A02, kProcessHere = 0x4F1D5A03;

/// Size in bytes of the kernel's signal sets.
constexpr std::size_t kSignalSet = 8;
/// Limit of the address space. RLIMIT_DATA does not count page tables and read-only pages, so this limit
/// bounds them. Read-only pages can use memory: a process may have written them before, and some kernels
/// allocate even unwritten pages.
constexpr rlim_t kConfinedAddresses = kConfinedMemory + (64 << 20);
/// Size of the main thread's stack, which RLIMIT_DATA does not count.
constexpr rlim_t kConfinedStack = 8 << 20;

CallKey key_of_process{};
bool confined = false;
/// The size of the address space, and of the memory that RLIMIT_DATA counts, in bytes.
struct MemoryInUse {
  rlim_t addresses = 0, data = 0;
};
MemoryInUse memory_when_prepared;

/// System calls that affect at most the memory of the calling process, and never wait.
constexpr const char* kHarmless[] = {
    "brk",          "cacheflush",  "clock_getres", "clock_gettime",   "clock_gettime64", "getcpu",
    "getpid",       "getrandom",   "gettid",       "gettimeofday",    "mremap",          "munmap",
    "rt_sigreturn", "sched_yield", "sigaltstack",  "restart_syscall", "sigreturn",       "sysinfo",
    "time",         "membarrier"};

class Filter {
 public:
  Filter() : filter_(::seccomp_init(SCMP_ACT_TRAP)) {
    if (!filter_) throw std::runtime_error("no filter of system calls");
    // Makes libseccomp arrange the rules as a binary tree. This saves time when the filter is installed,
    // because the kernel then evaluates the filter for each possible system call.
    ::seccomp_attr_set(filter_.get(), SCMP_FLTATR_CTL_OPTIMIZE, 2);
  }

  /// Adds a rule. Skips system calls that do not exist on this machine.
  void add(std::uint32_t action, const char* name, const std::vector<scmp_arg_cmp>& arguments = {}) {
    const int number = ::seccomp_syscall_resolve_name(name);
    if (number == __NR_SCMP_ERROR || number < 0) return;
    const int error = ::seccomp_rule_add_array(filter_.get(), action, number,
                                               static_cast<unsigned>(arguments.size()), arguments.data());
    if (error != 0) throw std::runtime_error(fmt::format("no rule for {}: {}", name, std::strerror(-error)));
  }
  void allow(const char* name, const std::vector<scmp_arg_cmp>& arguments = {}) {
    add(SCMP_ACT_ALLOW, name, arguments);
  }
  std::vector<sock_filter> program() const {
    const Descriptor file(::memfd_create("robosim-filter", MFD_CLOEXEC));
    if (!file.is_open() || ::seccomp_export_bpf(filter_.get(), file.get()) != 0)
      throw std::runtime_error("no filter of system calls");
    const off_t bytes = ::lseek(file.get(), 0, SEEK_END);
    std::vector<sock_filter> steps(static_cast<std::size_t>(bytes) / sizeof(sock_filter));
    if (::pread(file.get(), steps.data(), static_cast<std::size_t>(bytes), 0) != bytes)
      throw std::runtime_error("no filter of system calls");
    return steps;
  }

 private:
  struct End {
    void operator()(void* filter) const { ::seccomp_release(filter); }
  };
  std::unique_ptr<void, End> filter_;
};

/// Returns the condition that argument `number`, which is an int, equals `value`. The upper half of the
/// argument's register may have any value.
scmp_arg_cmp is(unsigned number, std::uint32_t value) {
  return {number, SCMP_CMP_MASKED_EQ, 0xFFFFFFFF, value};
}
scmp_arg_cmp has(unsigned number, std::uint32_t bits, std::uint32_t of) {
  return {number, SCMP_CMP_MASKED_EQ, of, bits};
}

/// Allows system calls for memory. Mappings must be private and must not grow downwards, since RLIMIT_DATA
/// does not count other mappings. The only file that may be mapped is the sealed image at kImageFd. A
/// writable page cannot become executable.
void add_memory(Filter& filter) {
  constexpr std::uint32_t kUncounted =
      ~(MAP_NORESERVE | MAP_STACK | MAP_FIXED | MAP_FIXED_NOREPLACE | MAP_POPULATE | MAP_DENYWRITE);
  for (const char* name : {"mmap", "mmap2"}) {
    filter.allow(name, {has(2, 0, PROT_EXEC), has(3, MAP_PRIVATE | MAP_ANONYMOUS, kUncounted)});
    for (const std::uint32_t one : {PROT_EXEC, PROT_WRITE})
      filter.allow(name, {has(2, 0, one), has(3, MAP_PRIVATE, kUncounted), is(4, kImageFd)});
  }
  filter.allow("mprotect", {has(2, 0, PROT_EXEC)});
  // Rejects names for memory ranges. The library RE2 of Debian 13 sets such names, but also works if the
  // kernel rejects them.
  filter.add(SCMP_ACT_ERRNO(EINVAL), "prctl", {is(0, PR_SET_VMA)});
  // Allows only these kinds of advice. Other kinds may affect other processes. With MADV_HWPOISON, for
  // example, root could take pages of memory out of use.
  for (const std::uint32_t advice : {MADV_DONTNEED, MADV_FREE, MADV_HUGEPAGE})
    filter.allow("madvise", {is(2, advice)});
  for (const char* name : {"futex", "futex_time64"}) filter.allow(name, {has(1, FUTEX_WAKE, FUTEX_CMD_MASK)});
}

void add_descriptors(Filter& filter) {
  filter.allow("write", {is(0, kTellFd), is(3, kKeyHere), is(4, kOtherKeyHere)});
  for (const int fd : {kAnswersFd, kLinesFd})
    filter.allow("read", {is(0, static_cast<std::uint32_t>(fd)), is(3, kKeyHere), is(4, kOtherKeyHere)});
  for (const std::uint32_t fd : {0u, 1u, 2u}) {
    for (const char* name : {"read", "write", "writev", "lseek", "_llseek"}) filter.allow(name, {is(0, fd)});
    // Returns ENOTTY, instead of raising SIGSYS, for the calls that stdio makes before it prints.
    for (const char* name : {"fcntl", "fcntl64", "fstat", "fstat64", "ioctl", "newfstatat", "statx"})
      filter.add(SCMP_ACT_ERRNO(ENOTTY), name, {is(0, fd)});
  }
  // Allows the loader to read the image.
  for (const char* name : {"read", "pread64", "lseek", "_llseek"}) filter.allow(name, {is(0, kImageFd)});
  filter.allow("fstat", {is(0, kImageFd), is(3, kKeyHere), is(4, kOtherKeyHere)});
  filter.allow("newfstatat", {is(0, kImageFd), is(4, kKeyHere), is(5, kOtherKeyHere)});
  filter.allow("statx", {is(0, kImageFd), is(5, kKeyHere)});
  filter.allow("dup3", {is(1, kImageFd), is(3, kKeyHere), is(4, kOtherKeyHere)});
  // Allows close(), except for sealed images, which must stay open.
  filter.allow("close", {{0, SCMP_CMP_LT, kFirstSealed, 0}});
  filter.add(SCMP_ACT_ERRNO(EBADF), "close", {{0, SCMP_CMP_GE, kFirstSealed, 0}});
}

/// Allows the process to end, or to send itself a signal, but only with the key. A sketch does not have the
/// key: its attempts are reported, and do not end the process.
void add_signals(Filter& filter) {
  filter.allow("kill", {is(0, kProcessHere), is(3, kKeyHere), is(4, kOtherKeyHere)});
  filter.allow("exit_group", {is(3, kKeyHere), is(4, kOtherKeyHere)});
  for (const char* name : {"rt_sigaction", "rt_sigprocmask"})
    filter.allow(name, {{1, SCMP_CMP_EQ, 0, 0}});  // calls that only return the present setting
  // Does not allow SIG_BLOCK, which serve_call() emulates.
  filter.allow("rt_sigprocmask", {{0, SCMP_CMP_NE, SIG_BLOCK, 0}});
  for (const int fault : {SIGSEGV, SIGBUS, SIGILL, SIGFPE})
    filter.allow("rt_sigaction", {is(0, static_cast<std::uint32_t>(fault))});
}

void set_limit(int what, rlim_t most) {
  rlimit limit{};
  ::getrlimit(static_cast<__rlimit_resource_t>(what), &limit);
  limit.rlim_max = std::min(limit.rlim_max, most);
  limit.rlim_cur = limit.rlim_max;
  ::setrlimit(static_cast<__rlimit_resource_t>(what), &limit);
}

Descriptor open_statm() { return Descriptor(::open("/proc/self/statm", O_RDONLY | O_CLOEXEC)); }

/// Reads the memory use of the process that has opened `statm`.
MemoryInUse memory_in_use(const Descriptor& statm) {
  // Does not use a C++ stream: the first stream of a process takes longer than the rest of this function.
  char text[256];
  const ssize_t bytes = statm.is_open() ? ::pread(statm.get(), text, sizeof text - 1, 0) : 0;
  if (bytes <= 0) return {};
  text[bytes] = '\0';
  char* at = text;
  const auto field = [&] {
    return static_cast<rlim_t>(std::strtoull(at, &at, 10)) * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE));
  };
  MemoryInUse in_use{field(), 0};
  for (int between = 0; between < 4; ++between) field();
  in_use.data = field();
  return in_use;
}

/// Erases the environment variables, so that a sketch cannot read them and learn the user's identity.
void forget_environment() {
  for (char** variable = environ; variable && *variable; ++variable)
    ::explicit_bzero(*variable, std::strlen(*variable));
  ::clearenv();
}

/// Returns the common filter. The first call creates the filter, which takes a millisecond. Each process
/// replaces the placeholders in its copy.
const std::vector<sock_filter>& filter_for_all() {
  static const std::vector<sock_filter> steps = [] {
    Filter filter;
    for (const char* name : kHarmless) filter.allow(name);
    add_memory(filter);
    add_descriptors(filter);
    add_signals(filter);
    return filter.program();
  }();
  return steps;
}

struct Loading {
  std::uintptr_t arguments[5];
  void* result;
};

#if defined(__x86_64__)
constexpr bool kKnownMachine = true;
Loading loading_of(ucontext_t& context) {
  auto& r = context.uc_mcontext.gregs;
  const auto at = [&](int i) { return static_cast<std::uintptr_t>(r[i]); };
  return {{at(REG_RDI), at(REG_RSI), at(REG_RDX), at(REG_R10), at(REG_R8)}, &r[REG_RAX]};
}
#elif defined(__aarch64__)
constexpr bool kKnownMachine = true;
Loading loading_of(ucontext_t& context) {
  auto& r = context.uc_mcontext.regs;
  return {{r[0], r[1], r[2], r[3], r[4]}, &r[0]};
}
#elif defined(__arm__)
constexpr bool kKnownMachine = true;
Loading loading_of(ucontext_t& context) {
  auto& c = context.uc_mcontext;
  return {{c.arm_r0, c.arm_r1, c.arm_r2, c.arm_r3, c.arm_r4}, &c.arm_r0};
}
#else
constexpr bool kKnownMachine = false;
Loading loading_of(ucontext_t&) { return {}; }
#endif

struct Subject {
  std::string_view what;
  std::vector<std::string_view> beginnings;
};

/// Returns the subject of a system call, such as "files". Searches the table for the first prefix that
/// matches the call's name.
std::string_view subject_of(std::string_view call) {
  static const std::vector<Subject> subjects = {
      {"programs", {"exec"}},
      {"processes and threads", {"clone", "fork", "vfork", "wait", "ptrace", "process_", "pidfd", "set_tid"}},
      {"the end of its process", {"exit"}},
      {"signals to others", {"kill", "tkill", "tgkill", "rt_sigqueue", "rt_tgsigqueue"}},
      {"signals", {"rt_sig", "sig"}},
      {"the network",
       {"socket", "connect", "bind", "listen", "accept", "send", "recv", "getsockname", "getpeername",
        "setsockopt", "getsockopt", "shutdown"}},
      {"time outside of the simulation",
       {"nanosleep", "clock_nanosleep", "pause", "poll", "ppoll", "select", "pselect", "_newselect", "epoll",
        "alarm", "setitimer", "timer", "clock_set", "settimeofday", "futex"}},
      {"memory", {"mmap", "mprotect", "shm", "mlock", "pkey", "madvise", "memfd"}},
      {"descriptors",
       {"read", "write", "pread", "pwrite", "vmsplice", "splice", "tee", "dup", "fcntl", "ioctl", "pipe"}},
      {"files",
       {"open",     "creat",  "stat",    "lstat",    "fstat",          "newfstat", "access",  "faccess",
        "readlink", "unlink", "mkdir",   "rmdir",    "rename",         "link",     "symlink", "mknod",
        "chmod",    "chown",  "fch",     "lchown",   "truncate",       "getdents", "chdir",   "getcwd",
        "mount",    "umount", "inotify", "fanotify", "name_to_handle", "utime",    "chroot"}},
  };
  for (const Subject& subject : subjects)
    for (const std::string_view beginning : subject.beginnings)
      if (call.starts_with(beginning)) return subject.what;
  return "the operating system";
}

}  // namespace

std::string what_kernel_lacks() {
  if (!kKnownMachine) return "Robosim cannot confine sketches on this kind of processor yet";
  // Passes an invalid address. A kernel that supports filters tries to read the filter there, and sets
  // EFAULT.
  static const bool has_filter =
      ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, nullptr, 0, 0) != 0 && errno == EFAULT;
  return has_filter ? "" : "the kernel has no filter of system calls (seccomp)";
}

std::string why_not_confined() {
#ifdef ROBOSIM_ASAN
  return "this Robosim is built with AddressSanitizer, which itself needs files and processes";
#endif
  const char* const wish = std::getenv("ROBOSIM_SANDBOX");
  if (wish && std::string_view(wish) == "off") return "ROBOSIM_SANDBOX is off";
  return what_kernel_lacks();
}

void confine(const CallKey& key, bool has_grown) {
  const MemoryInUse in_use = has_grown ? memory_in_use(open_statm()) : memory_when_prepared;
  set_limit(RLIMIT_DATA, kConfinedMemory + in_use.data);
  set_limit(RLIMIT_AS, kConfinedAddresses + in_use.addresses);
  set_limit(RLIMIT_STACK, kConfinedStack);
  std::set_new_handler([] { keyed_exit(kNoMemoryStatus); });
  forget_environment();
  set_limit(RLIMIT_CORE, 0);
  set_limit(RLIMIT_FSIZE, 0);
  set_limit(RLIMIT_NOFILE, kFirstSealed);
  std::vector<sock_filter> steps = filter_for_all();
  for (sock_filter& step : steps) {
    if (BPF_CLASS(step.code) != BPF_JMP) continue;
    if (step.k == kKeyHere) step.k = key[0];
    if (step.k == kOtherKeyHere) step.k = key[1];
    if (step.k == kProcessHere) step.k = static_cast<std::uint32_t>(::getpid());
  }
  key_of_process = key;
  confined = true;
  const sock_fprog program{static_cast<unsigned short>(steps.size()), steps.data()};
  // SPEC_ALLOW disables mitigations against attacks by speculative execution. The mitigations would slow down
  // branches. This process contains no secrets that an attack could read.
  if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 ||
      ::syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, SECCOMP_FILTER_FLAG_SPEC_ALLOW, &program) != 0)
    throw std::runtime_error(fmt::format("the process cannot be confined: {}", std::strerror(errno)));
}

void prepare_to_confine() {
  ensure_signal_stack();
  static const Descriptor statm = open_statm();
  memory_when_prepared = memory_in_use(statm);
  // Makes the loader bind the symbols that libfmt uses, such as memchr() for texts of at least 32 bytes.
  // Otherwise each forked process would look these symbols up in all libraries.
  static const std::string bound = fmt::format("so that it has formatted {} text: {}", 1, kImageName);
  if (why_not_confined().empty()) filter_for_all();
}

long keyed_read(int fd, void* data, std::size_t bytes) {
  return ::syscall(SYS_read, fd, data, bytes, key_of_process[0], key_of_process[1]);
}

long keyed_write(int fd, const void* data, std::size_t bytes) {
  return ::syscall(SYS_write, fd, data, bytes, key_of_process[0], key_of_process[1]);
}

bool keyed_dup(int fd, int as) {
  return ::syscall(SYS_dup3, fd, as, O_CLOEXEC, key_of_process[0], key_of_process[1]) >= 0;
}

void keyed_exit(int status) {
  ::syscall(SYS_exit_group, status, 0, 0, key_of_process[0], key_of_process[1]);
  __builtin_unreachable();
}

bool is_confined() { return confined; }

int own_signal(const siginfo_t& info, ucontext_t& context) {
  if (info.si_code <= 0) return info.si_pid == ::getpid() ? info.si_signo : 0;
  if (info.si_signo != SIGSYS) return 0;
  const Loading asked = loading_of(context);
  const bool names_thread = info.si_syscall == SYS_tgkill;
  if (info.si_syscall != SYS_kill && info.si_syscall != SYS_tkill && !names_thread) return 0;
  if (static_cast<pid_t>(asked.arguments[0]) != ::getpid()) return 0;
  return static_cast<int>(asked.arguments[names_thread ? 2 : 1]);
}

void end_by_signal(int signal) {
  if (signal == SIGABRT) ::syscall(SYS_kill, ::getpid(), signal, 0, key_of_process[0], key_of_process[1]);
  keyed_exit(kSignalStatus + signal);
}

bool serve_call(const siginfo_t& info, ucontext_t& context) {
  const Loading asked = loading_of(context);
  const auto* const path = reinterpret_cast<const char*>(asked.arguments[1]);
  long result = 0;
  static std::uint64_t opened = 0;
  // The loader identifies files by their inode number. Therefore each opened image gets its own number above
  // kFirstNumber. The inode numbers of memory files are smaller.
  constexpr std::uint64_t kFirstNumber = std::uint64_t{1} << 30;
  if (info.si_syscall == SYS_rt_sigprocmask) {
    // Reports success for SIG_BLOCK, but blocks nothing. If SIGSYS were blocked, the kernel would end the
    // process at the next refused call. No handler could report that call. glibc 2.41 blocks all signals
    // in fork() and abort().
    if (asked.arguments[3] != kSignalSet) return false;
    if (auto* const before = reinterpret_cast<void*>(asked.arguments[2]))
      std::memcpy(before, &context.uc_sigmask, kSignalSet);
  } else if (info.si_syscall == SYS_openat) {
    if (!std::string_view(path).starts_with(kImageName)) return false;
    result = kImageFd;
    ++opened;
#ifdef SYS_newfstatat
  } else if (info.si_syscall == SYS_fstat) {
    if (asked.arguments[0] != kImageFd) return false;
    result = ::syscall(SYS_fstat, kImageFd, asked.arguments[1], 0, key_of_process[0], key_of_process[1]);
    if (result == 0) reinterpret_cast<struct stat*>(asked.arguments[1])->st_ino = kFirstNumber + opened;
  } else if (info.si_syscall == SYS_newfstatat) {
    if (asked.arguments[0] != kImageFd || *path) return false;
    result = ::syscall(SYS_newfstatat, kImageFd, "", asked.arguments[2], AT_EMPTY_PATH, key_of_process[0],
                       key_of_process[1]);
    if (result == 0) reinterpret_cast<struct stat*>(asked.arguments[2])->st_ino = kFirstNumber + opened;
#endif
  } else if (info.si_syscall == SYS_statx) {
    if (asked.arguments[0] != kImageFd || *path) return false;
    result = ::syscall(SYS_statx, kImageFd, "", AT_EMPTY_PATH, asked.arguments[3], asked.arguments[4],
                       key_of_process[0]);
    if (result == 0) reinterpret_cast<struct statx*>(asked.arguments[4])->stx_ino = kFirstNumber + opened;
  } else {
    return false;
  }
  const long answer = result < 0 ? -errno : result;
  std::memcpy(asked.result, &answer, sizeof answer);
  return true;
}

std::string refusal(int call) {
  const std::unique_ptr<char, decltype(&std::free)> known(
      ::seccomp_syscall_resolve_num_arch(SCMP_ARCH_NATIVE, call), &std::free);
  const std::string name = known ? known.get() : fmt::format("number {}", call);
  return fmt::format("the sandbox refuses its system call {} ({})", name, subject_of(name));
}

}  // namespace robosim::exec
