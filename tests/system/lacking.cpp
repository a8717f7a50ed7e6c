// lacking landlock|walls|seccomp|sandbox PROGRAM WORDS…: runs a program as if the kernel lacked the feature.
// The feature's system calls fail as they do on such a kernel. "walls" stands for Landlock and namespaces.
// "sandbox" stands for all these features.
#include <seccomp.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

int main(int count, char** words) {
  if (count < 3) return 99;
  const bool all = std::strcmp(words[1], "sandbox") == 0;
  const scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ALLOW);
  int faults = 0;
  const bool walls = all || std::strcmp(words[1], "walls") == 0;
  if (walls) faults |= seccomp_rule_add(filter, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(unshare), 0);
  if (walls || std::strcmp(words[1], "landlock") == 0)
    faults |= seccomp_rule_add(filter, SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(landlock_create_ruleset), 0);
  if (all || std::strcmp(words[1], "seccomp") == 0) {
    faults |= seccomp_rule_add(filter, SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(seccomp), 0);
    faults |= seccomp_rule_add(filter, SCMP_ACT_ERRNO(EINVAL), SCMP_SYS(prctl), 1,
                               SCMP_A0(SCMP_CMP_EQ, PR_SET_SECCOMP));
  }
  if (faults != 0 || seccomp_load(filter) != 0) return 99;
  ::execv(words[2], words + 2);
  return 99;
}
