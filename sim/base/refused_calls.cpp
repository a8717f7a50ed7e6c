#include "sim/base/refused_calls.h"

#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>

namespace robosim {
namespace {

// Numbers of system calls that are equal on all architectures.
constexpr std::uint32_t kPidfdSendSignal = 424, kIoUringSetup = 425, kPidfdGetfd = 438;

constexpr std::uint32_t kNeedless[] = {SYS_socket,
                                       SYS_kill,
                                       SYS_tkill,
                                       SYS_tgkill,
                                       SYS_rt_sigqueueinfo,
                                       SYS_rt_tgsigqueueinfo,
                                       SYS_ptrace,
                                       SYS_process_vm_readv,
                                       SYS_process_vm_writev,
                                       SYS_keyctl,
                                       SYS_add_key,
                                       SYS_request_key,
                                       SYS_bpf,
                                       SYS_perf_event_open,
                                       SYS_unshare,
                                       SYS_setns,
                                       kPidfdSendSignal,
                                       kIoUringSetup,
                                       kPidfdGetfd};

#if defined(__x86_64__)
constexpr std::uint32_t kMachine = AUDIT_ARCH_X86_64, kOtherMachine = AUDIT_ARCH_I386;
/// Numbers of the calls of kNeedless in 32-bit programs. The first one is socketcall().
constexpr std::uint32_t kNeedlessOfOther[] = {102,           359,        37,  238, 270, 178,
                                              335,           26,         347, 348, 288, 286,
                                              287,           357,        336, 310, 346, kPidfdSendSignal,
                                              kIoUringSetup, kPidfdGetfd};
#elif defined(__aarch64__)
constexpr std::uint32_t kMachine = AUDIT_ARCH_AARCH64, kOtherMachine = AUDIT_ARCH_ARM;
constexpr std::uint32_t kNeedlessOfOther[] = {281,
                                              37,
                                              238,
                                              268,
                                              178,
                                              363,
                                              26,
                                              376,
                                              377,
                                              311,
                                              309,
                                              310,
                                              386,
                                              364,
                                              337,
                                              375,
                                              kPidfdSendSignal,
                                              kIoUringSetup,
                                              kPidfdGetfd};
#elif defined(__arm__)
constexpr std::uint32_t kMachine = AUDIT_ARCH_ARM, kOtherMachine = 0;
constexpr std::uint32_t kNeedlessOfOther[] = {kIoUringSetup};
#else
constexpr std::uint32_t kMachine = 0, kOtherMachine = 0;
constexpr std::uint32_t kNeedlessOfOther[] = {kIoUringSetup};
#endif

constexpr std::size_t kMostSteps = 128;
struct Program {
  std::array<sock_filter, kMostSteps> steps{};
  unsigned short size = 0;

  constexpr void add(std::uint32_t code, std::uint32_t value, std::size_t if_so = 0, std::size_t if_not = 0) {
    steps[size++] = {static_cast<std::uint16_t>(code), static_cast<std::uint8_t>(if_so),
                     static_cast<std::uint8_t>(if_not), value};
  }
  constexpr void refuse() { add(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EPERM); }

  template <std::size_t N>
  constexpr void add_machine(std::uint32_t machine, const std::uint32_t (&calls)[N]) {
    constexpr std::uint32_t kOfX32 = 0x40000000;  // calls of the x32 ABI of x86-64, with 32-bit pointers
    add(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, arch));
    add(BPF_JMP | BPF_JEQ | BPF_K, machine, 0, 2 * N + 4);
    add(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr));
    add(BPF_JMP | BPF_JGE | BPF_K, kOfX32, 0, 1);
    refuse();
    for (const std::uint32_t call : calls) {
      add(BPF_JMP | BPF_JEQ | BPF_K, call, 0, 1);
      refuse();
    }
    add(BPF_RET | BPF_K, SECCOMP_RET_ALLOW);
  }
};

constexpr Program kProgram = [] {
  Program program;
  program.add_machine(kMachine, kNeedless);
  program.add_machine(kOtherMachine, kNeedlessOfOther);
  program.refuse();
  return program;
}();

}  // namespace

void refuse_needless_calls() {
  if (kMachine == 0) return;
  const sock_fprog program{kProgram.size, const_cast<sock_filter*>(kProgram.steps.data())};
  // Does not enable the speculation mitigations, which a filter enables by default. They slow branches, and
  // compilers hold no secrets of other programs.
  ::syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, SECCOMP_FILTER_FLAG_SPEC_ALLOW, &program);
}

}  // namespace robosim
