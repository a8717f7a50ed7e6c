// Generates hostile sketches. Each sketch makes a forbidden library call or system call, or another attack.
// The attack happens in setup(), or when the sketch is loaded.
#include <fmt/format.h>
#include <seccomp.h>

#include "hal/host/image.h"
#include "tests/hostile/input.h"

namespace robosim::hostile {
namespace {

/// The beginning of every sketch for the host. P is the path of the secret file. B is a buffer, whose text
/// the sketch sends by Serial after the attack.
constexpr const char* kBeginning = R"(#define P "@SECRET@"
static long B[2048];
extern "C" { long c_syscall(...) __asm__("syscall"); long c_write(int, const void*, unsigned long) __asm__("write");
long c_mmap(...) __asm__("mmap"); int c_raise(int) __asm__("raise"); long c_open(const char*, int, ...) __asm__("open");
typedef void (*Handler)(int); Handler c_signal(int, Handler) __asm__("signal"); void c_exit(int) __asm__("_exit"); }
)";

// clang-format off
/// Attacks by a function of the C library. Each text has a mechanism, the function, and its arguments.
constexpr const char* kCalls[] = {
    "files open P, 0", "files open64 P, 0", "files openat -100, P, 0", "files creat P, 0644",
    "files fopen P, \"r\"", "files opendir \"/\"", "files readlink \"/proc/self/exe\", B, 99",
    "files realpath P, B", "files stat P, B", "files lstat P, B", "files access P, 4", "files euidaccess P, 4",
    "files unlink P", "files remove P", "files rename P, P \"x\"", "files mkdir P \"d\", 0755", "files rmdir \"/tmp\"",
    "files symlink P, P \"l\"", "files link P, P \"h\"", "files chmod P, 0777", "files chown P, 1, 1",
    "files truncate P, 0", "files mkfifo P \"f\", 0644", "files mknod P \"n\", 0600, 0", "files chdir \"/\"",
    "files chroot \"/\"", "files mount \"none\", \"/tmp\", \"tmpfs\", 0, 0", "files umount2 \"/\", 2",
    "files getcwd B, 99", "files scandir \"/\", B, 0, 0", "files glob \"/*\", 0, 0, B", "files nftw P, 0, 4, 0",
    "files utimes P, 0", "files statvfs \"/\", B", "files inotify_init1 0", "files tmpfile 0", "files mkstemp B",
    "files dlopen \"/lib/x86_64-linux-gnu/libm.so.6\", 2", "files getpwuid 0", "files setlocale 6, \"de_DE.UTF-8\"",
    "network socket 2, 1, 0", "network socket 1, 1, 0", "network socket 16, 3, 0", "network socket 17, 3, 0",
    "network socketpair 1, 1, 0, B", "network getaddrinfo \"localhost\", \"@PORT@\", 0, B",
    "network gethostbyname \"example.com\"", "network getifaddrs B", "network syslog 1, \"x\"",
    "network connect 3, B, 16", "network sendto 3, B, 9, 0, 0, 0", "network recvfrom 4, B, 9, 0, 0, 0",
    "processes fork 0", "processes vfork 0", "processes system \"id >\" P", "processes popen \"id\", \"r\"",
    "processes execl \"/bin/sh\", \"sh\", \"-c\", \"id\", 0", "processes execlp \"id\", \"id\", 0",
    "processes posix_spawnp B, \"id\", 0, 0, B, B", "processes daemon 0, 0", "processes wait B",
    "processes pthread_create B, 0, c_exit, 0", "processes clone c_exit, B + 1024, 0x100, 0",
    "processes thrd_create B, c_exit, 0", "processes setsid 0", "processes setpgid 0, 0", "processes setuid 0",
    "processes setgroups 0, B", "processes setrlimit 7, B", "processes prlimit 1, 0, B, 0",
    "processes setpriority 0, 0, -20", "processes sched_setaffinity 0, 8, B", "processes sched_setscheduler 0, 1, B",
    "processes ptrace 0, 0, 0, 0", "processes unshare 0x10000000", "processes prctl 15, \"robosim\"",
    "processes prctl 4, 1", "processes prctl 36, 1", "processes prctl 1, 0", "processes personality 0x40000",
    "processes sethostname \"x\", 1", "processes reboot 0x1234567", "processes iopl 3", "processes _exit 0",
    "processes exit 0", "processes quick_exit 0", "processes abort 0",
    "time sleep 1000", "time usleep 1000000000", "time nanosleep \"\\377\\377\\377\\377\\0\\0\\0\\0\\0\\0\\0\\0\\0\\0\\0\", 0",
    "time alarm 1", "time ualarm 1, 1", "time setitimer 0, B, 0", "time timer_create 0, 0, B", "time pause 0",
    "time poll 0, 0, -1", "time select 0, 0, 0, 0, 0", "time epoll_create1 0", "time timerfd_create 0, 0",
    "time settimeofday B, 0", "time adjtimex B", "time sem_wait B",
    "memory shm_open \"/x\", 0102, 0600", "memory shmget 0, 1 << 30, 01600", "memory semget 0, 1, 01600",
    "memory msgget 0, 01600", "memory mq_open \"/x\", 0102, 0600, 0", "memory memfd_create \"x\", 0",
    "memory mlockall 3", "memory mprotect (long)B & ~4095, 4096, 7", "memory mremap (long)B & ~4095, 4096, 1l << 40, 1",
    "memory munmap 0, 0x7fffffffffff", "memory mmap (long)B & ~4095, 4096, 3, 0x32, -1, 0",
    "memory sbrk 1l << 40", "memory malloc_trim 0", "memory posix_memalign B, 1l << 40, 8", "memory madvise (long)B & ~4095, 4096, 100",
    "descriptors pipe B", "descriptors dup2 1, 3", "descriptors dup2 3, 1", "descriptors dup3 4, 6, 0",
    "descriptors close 3", "descriptors closefrom 0", "descriptors close_range 0, -1, 0", "descriptors fcntl 3, 0, 100",
    "descriptors ioctl 0, 0x5412, \"x\"", "descriptors read 4, B, 4096", "descriptors pread 6, B, 4096, 0",
    "descriptors write 3, B, 4096", "descriptors writev 3, B, 1", "descriptors sendfile 3, 6, 0, 4096",
    "descriptors splice 4, 0, 3, 0, 4096, 0", "descriptors lseek 3, 0, 0", "descriptors ftruncate 6, 0",
    "descriptors eventfd 0, 0", "descriptors signalfd -1, B, 0", "descriptors fdatasync 3", "descriptors flock 3, 2",
    "signals kill -1, 9", "signals killpg 0, 9", "signals raise 19", "signals raise 20", "signals raise 2",
    "signals raise 9", "signals raise 31", "signals raise 64", "signals sigqueue 1, 9, 0", "signals sigsuspend B",
    "signals sigwait B, B", "signals sigprocmask 0, \"\\377\\377\\377\\377\\377\\377\\377\\377\", 0",
    "signals sigaction 31, B, 0", "signals signal 14, 1", "signals signal 11, 1", "signals siginterrupt 2, 0",
    "signals sigaltstack B, 0", "signals pthread_kill B, 9"};

/// Raw system calls, with arguments. A number such as "-1" is a call that the kernel does not have.
constexpr const char* kSystemCalls[] = {
    "io_uring_setup 8, B", "bpf 5, B, 128", "userfaultfd 0", "perf_event_open B, 0, -1, -1, 0", "keyctl 0, -3, 0",
    "add_key \"user\", \"x\", B, 8, -3", "process_vm_readv 1, B, 1, B, 1, 0", "process_vm_writev 1, B, 1, B, 1, 0",
    "pidfd_open 1, 0", "pidfd_getfd 3, 0, 0", "pidfd_send_signal 3, 9, 0, 0", "clone3 B, 88", "openat2 -100, P, B, 24",
    "name_to_handle_at -100, P, B, B, 0", "open_by_handle_at 3, B, 0", "setns 3, 0", "pivot_root \"/\", \"/\"",
    "kcmp 1, 1, 0, 0, 0", "seccomp 1, 0, B", "landlock_create_ruleset B, 8, 0", "execveat -100, \"/bin/sh\", B, B, 0",
    "vmsplice 3, B, 1, 0", "tee 4, 3, 9, 0", "preadv2 6, B, 1, 0, 0, 0", "pwritev2 3, B, 1, 0, 0, 0",
    "copy_file_range 6, 0, 3, 0, 9, 0", "fsopen \"tmpfs\", 0", "move_mount -100, \"/\", -100, \"/\", 0",
    "open_tree -100, \"/\", 1", "mount_setattr -100, \"/\", 0, B, 32", "init_module B, 9, \"\"", "delete_module \"x\", 0",
    "kexec_load 0, 0, 0, 0", "ioperm 0, 9, 1", "modify_ldt 1, B, 16", "arch_prctl 0x1002, 0", "arch_prctl 0x1001, B",
    "set_tid_address B", "set_robust_list B, 24", "rseq B, 32, 0, 0", "futex B, 0, 0, 0, 0, 0", "futex B, 9, 0, 0, 0, -1",
    "tkill 1, 9", "tgkill 1, 1, 9", "rt_sigqueueinfo 1, 9, B", "rt_tgsigqueueinfo 1, 1, 9, B", "rt_sigtimedwait B, 0, 0, 8",
    "rt_sigreturn 0", "sigaltstack B, 0", "membarrier 8, 0, 0", "mlock2 B, 4096, 0", "mincore 0, 4096, B",
    "remap_file_pages B, 4096, 0, 0, 0", "mbind B, 4096, 0, 0, 0, 0", "process_madvise 3, B, 1, 0, 0", "memfd_secret 0",
    "pkey_mprotect B, 4096, 7, 0", "pkey_alloc 0, 0", "acct \"/tmp/x\"", "swapon P, 0", "clock_settime 0, B",
    "clock_nanosleep 0, 0, \"\\377\\377\\377\\177\\0\\0\\0\\0\\0\\0\\0\\0\\0\\0\\0\", 0", "restart_syscall 0", "exit 0",
    "exit_group 0", "ppoll 0, 0, 0, 0, 0", "epoll_pwait 3, B, 1, -1, 0, 8", "fanotify_init 0, 0", "quotactl 0, P, 0, B",
    "lookup_dcookie 0, B, 9", "shmat 0, 0, 0", "getdents64 3, B, 4096", "cachestat 3, B, B, 0", "uselib P",
    "-1 0", "100000 0", "1073741826 P, 0", "1073741863 0"};

struct Row {
  const char* mechanism;
  const char* variant;
  const char* before;  ///< outside of functions
  const char* setup;
  Target target = Target::host;
};

#define LOOPS_UNSEEN "__attribute__((no_sanitize_coverage)) "

constexpr Row kRows[] = {
    // Faults, and handlers that hide them.
    {"faults", "null", "", "*(volatile int*)1 = 1;"},
    {"faults", "quotient", "volatile int z;", "B[0] = 1 / z;", Target::both},
    {"faults", "trap", "", "__builtin_trap();"},
    {"faults", "privileged", "", "asm volatile(\"hlt\");"},
    {"faults", "breakpoint", "", "asm volatile(\"int3\");"},
    {"faults", "single_step", "", "asm volatile(\"pushf; orl $0x100, (%rsp); popf; nop; nop\");"},
    {"faults", "alignment", "", "asm volatile(\"pushf; orl $0x40000, (%rsp); popf\"); *(volatile int*)((char*)B + 1) = 1;"},
    {"faults", "32_bit_call", "", "asm volatile(\"int $0x80\" :: \"a\"(20));"},
    {"faults", "jump_to_null", "", "((void (*)())0)();"},
    {"faults", "jump_to_data", "", "B[0] = 0xc3; ((void (*)())B)();"},
    {"faults", "jump_to_stack", "", "char code[16] = {(char)0xc3}; ((void (*)())code)();"},
    {"faults", "recursion", "int deep(int n) { volatile char big[4096]; big[0] = n; return deep(n + 1) + big[0]; }", "B[0] = deep(0);"},
    {"faults", "recursion_in_a_handler", "void again(int) { *(volatile int*)1 = 1; }", "c_signal(11, again); *(volatile int*)1 = 1;"},
    {"faults", "handler_that_returns", "void again(int) {}", "c_signal(11, again); *(volatile int*)1 = 1;"},
    {"faults", "handler_that_exits", "void end(int) { c_exit(0); }", "c_signal(11, end); *(volatile int*)1 = 1;"},
    {"faults", "handler_that_jumps", "extern \"C\" { int _setjmp(void*); void longjmp(void*, int); } void jump(int) { longjmp(B, 1); }", "c_signal(11, jump); _setjmp(B); *(volatile int*)1 = 1;"},
    {"faults", "handler_of_refusals", "void end(int) { c_exit(0); }", "c_signal(31, end); c_open(P, 0);"},
    {"faults", "no_stack_pointer", "", "asm volatile(\"xor %esp, %esp; push %rax\");"},
    {"faults", "no_thread_pointer", "", "asm volatile(\"wrfsbase %0\" :: \"r\"(0l));"},
    {"faults", "smashed_frame", "", "long* f = (long*)__builtin_frame_address(0); for (int i = 0; i < 4096; ++i) f[i] = (long)&c_exit;"},
    {"faults", "wild_writes_up", "", "for (char* p = (char*)B;; ++p) *p = 0;"},
    {"faults", "wild_writes_down", "", "for (char* p = (char*)B;; --p) *p = 0;"},
    {"faults", "wild_writes_to_the_stack", "", "for (char* p = (char*)__builtin_frame_address(0);; ++p) *p = 0;"},
    {"faults", "direction_flag", "", "asm volatile(\"std\"); Serial.begin(9600); Serial.print(\"text\");"},
    {"faults", "floating_traps", "volatile double z;", "unsigned m = 0; asm volatile(\"ldmxcsr %0\" :: \"m\"(m)); z = 1 / z;"},
    {"faults", "rounding", "", "unsigned m = 0x7f80; asm volatile(\"ldmxcsr %0\" :: \"m\"(m));"},
    {"faults", "jump_into_nothing", "extern \"C\" { int _setjmp(void*); void longjmp(void*, int); }", "_setjmp(B); for (int i = 0; i < 8; ++i) B[i] = 0x4141414141414141; longjmp(B, 1);"},
    // Attacks that use up memory or flood the outputs.
    {"appetite", "malloc", "", "for (;;) memset(malloc(1 << 20), 1, 1 << 20);"},
    {"appetite", "new", "", "for (;;) memset(new char[1 << 20], 1, 1 << 20);"},
    {"appetite", "realloc", "", "char* p = 0; for (long n = 4096;; n *= 2) { p = (char*)realloc(p, n); memset(p, 1, n); }"},
    {"appetite", "small_pieces", "", "for (;;) *(volatile char*)malloc(24) = 1;"},
    {"appetite", "string", "", "String s; for (;;) s += F(\"0123456789012345678901234567890123456789\");", Target::both},
    {"appetite", "variables", "static char big[180 << 20];", "memset(big, 1, sizeof big);"},
    {"appetite", "more_variables_than_addresses", "static char big[1l << 45];", "big[1] = 1;"},
    {"appetite", "thread_variables", "static thread_local char big[200 << 20];", "memset(big, 1, sizeof big);"},
    {"appetite", "pages", "", "for (long p; (p = c_mmap(0, 1 << 20, 3, 0x22, -1, 0)) != -1;) memset((void*)p, 1, 1 << 20);"},
    {"appetite", "populated_pages", "", "while (c_mmap(0, 64 << 20, 3, 0x8022, -1, 0) != -1) {}"},
    {"appetite", "pages_only_read", "", "for (long p; (p = c_mmap(0, 64l << 20, 1, 0x4022, -1, 0)) != -1;) for (long i = 0; i < 64 << 20; i += 4096) B[0] += ((volatile char*)p)[i];"},
    {"appetite", "pages_protected_after_writing", "extern \"C\" int mprotect(void*, unsigned long, int);", "for (long p; (p = c_mmap(0, 1 << 20, 3, 0x22, -1, 0)) != -1;) { memset((void*)p, 1, 1 << 20); mprotect((void*)p, 1 << 20, 1); }"},
    {"appetite", "shared_pages", "", "for (long p; (p = c_mmap(0, 1 << 20, 3, 0x21, -1, 0)) != -1;) memset((void*)p, 1, 1 << 20);"},
    {"appetite", "growing_pages", "", "for (;;) c_mmap(0, 1 << 20, 3, 0x122, -1, 0);"},
    {"appetite", "copies_of_the_image", "", "for (long p; (p = c_mmap(0, 4096, 3, 2, 6, 0)) != -1;) *(volatile char*)p = 1;"},
    {"appetite", "many_mappings", "", "for (long i = 0;; ++i) if (c_mmap(0, 4096, i & 1 ? 1 : 3, 0x22, -1, 0) == -1) break;"},
    {"appetite", "huge_pages", "extern \"C\" int madvise(void*, unsigned long, int);", "for (long p; (p = c_mmap(0, 4 << 20, 3, 0x22, -1, 0)) != -1;) { madvise((void*)p, 4 << 20, 14); for (int i = 0; i < 4 << 20; i += 4096) ((volatile char*)p)[i] = 1; }"},
    {"appetite", "stack", "", "for (long n = 1 << 16;; n *= 2) memset(__builtin_alloca(n), 1, n);"},
    {"appetite", "double_free", "", "void* p = malloc(64); free(p); free(p);"},
    {"appetite", "damaged_heap", "", "char* p = (char*)malloc(64); memset(p - 64, 255, 256); free(p); malloc(1 << 20);"},
    {"appetite", "heap_of_others", "", "for (int i = 16; i < 2000; i *= 2) { char* p = (char*)malloc(i); memset(p, 255, 4 * i); }"},
    {"appetite", "no_memory_at_all", "extern \"C\" int munmap(void*, unsigned long);", "munmap((void*)0x1000, 0x7ffffffff000);"},
    {"appetite", "serial_flood", "", "Serial.begin(2000000); for (;;) Serial.println(F(\"0123456789012345678901234567890123456789\"));", Target::both},
    {"appetite", "serial_zeros", "", "Serial.begin(2000000); for (;;) Serial.write((uint8_t)0);", Target::both},
    {"appetite", "pin_flood", "", "pinMode(13, OUTPUT); for (;;) { digitalWrite(13, HIGH); digitalWrite(13, LOW); }", Target::both},
    // Code that the loader runs before the sketch begins, and after its end.
    {"loading", "init_opens", "extern \"C\" " LOOPS_UNSEEN "void _init() { c_open(P, 0); }", ""},
    {"loading", "init_loops", "extern \"C\" " LOOPS_UNSEEN "void _init() { for (;;) asm volatile(\"\"); }", ""},
    {"loading", "fini_exits", "extern \"C\" void _fini() { c_exit(0); }", ""},
    {"loading", "constructor_opens", "__attribute__((constructor(101))) void early() { c_open(P, 0); }", ""},
    {"loading", "constructor_loops", "__attribute__((constructor)) " LOOPS_UNSEEN "void early() { for (;;) asm volatile(\"\"); }", "", Target::both},
    {"loading", "constructor_exits", "__attribute__((constructor)) void early() { c_exit(0); }", ""},
    {"loading", "constructor_stops", "__attribute__((constructor)) void early() { c_raise(19); }", ""},
    {"loading", "constructor_eats", "__attribute__((constructor)) void early() { for (;;) memset(malloc(1 << 20), 1, 1 << 20); }", ""},
    {"loading", "constructor_of_an_object", "struct E { E() { c_open(P, 0); } } e;", ""},
    {"loading", "init_array", "void early() { c_open(P, 0); } __attribute__((section(\".init_array\"), used)) void (*hook)() = early;", ""},
    {"loading", "preinit_array", "void early() { c_open(P, 0); } __attribute__((section(\".preinit_array\"), used)) void (*hook)() = early;", ""},
    {"loading", "fini_array", "void late() { c_open(P, 0); } __attribute__((section(\".fini_array\"), used)) void (*hook)() = late;", ""},
    {"loading", "junk_in_init_array", "__attribute__((section(\".init_array\"), used)) long hook = 0x4141414141414141;", ""},
    {"loading", "destructor_opens", "__attribute__((destructor)) void late() { c_open(P, 0); }", ""},
    {"loading", "destructor_loops", "__attribute__((destructor)) " LOOPS_UNSEEN "void late() { for (;;) asm volatile(\"\"); }", ""},
    {"loading", "destructor_of_an_object", "struct E { ~E() { c_exit(0); } } e;", ""},
    {"loading", "atexit", "extern \"C\" int atexit(void (*)()); void late() { c_exit(0); }", "atexit(late);"},
    {"loading", "ifunc_opens", "extern \"C\" { " LOOPS_UNSEEN "void* choose() { c_syscall(2, P, 0); return 0; } void chosen() __attribute__((ifunc(\"choose\"))); }", "chosen();"},
    {"loading", "ifunc_loops", "extern \"C\" { " LOOPS_UNSEEN "void* choose() { for (;;) asm volatile(\"\"); } void chosen() __attribute__((ifunc(\"choose\"))); }", "chosen();"},
    {"loading", "ifunc_crashes", "extern \"C\" { void* choose() { __builtin_trap(); } void chosen() __attribute__((ifunc(\"choose\"))); }", "chosen();"},
    {"loading", "missing_symbol", "extern \"C\" void nowhere();", "nowhere();"},
    {"loading", "weak_symbol", "extern \"C\" __attribute__((weak)) void nowhere();", "nowhere();"},
    {"loading", "section_written_and_executed", "asm(\".pushsection .x, \\\"awx\\\", @progbits\\n.skip 64\\n.popsection\");", ""},
    {"loading", "executable_stack", "asm(\".pushsection .note.GNU-stack, \\\"x\\\", @progbits\\n.popsection\");", "char code[16] = {(char)0xc3}; ((void (*)())code)();"},
    {"loading", "interpreter", "__attribute__((section(\".interp\"), used)) const char interp[] = P;", ""},
    {"loading", "huge_alignment", "__attribute__((aligned(1 << 28))) char wide[4];", "wide[0] = 1;"},
    {"loading", "shadows_malloc", "extern \"C\" void* malloc(size_t) { return B; }", "String s(\"text\");"},
    {"loading", "shadows_memcpy", "extern \"C\" void* memcpy(void* to, const void*, size_t) { return to; }", ""},
    {"loading", "shadows_write_and_exit", "extern \"C\" long own(...) __asm__(\"write\"); long own(...) { return 9; } extern \"C\" void exit(int) { for (;;) {} }", ""},
    {"loading", "shadows_syscall", "extern \"C\" long own(...) __asm__(\"syscall_\"); extern \"C\" int dl_iterate_phdr(...) { return 0; }", ""},
    {"loading", "is_the_image", "extern \"C\" __attribute__((visibility(\"default\"))) const long robosim_image[16] = {IMAGE_VERSION, 0, (long)&c_exit};", ""},
    {"loading", "has_a_main", "int main() { return 0; }", ""},
    {"loading", "has_the_operators", "void* operator new(size_t) { return 0; } void operator delete(void*) { c_exit(0); }", "delete new int;"},
    // Forgeries of messages that only Robosim may write.
    {"forgery", "each_descriptor", "", "for (int fd = 0; fd < 256; ++fd) c_write(fd, LINE, sizeof LINE - 1); c_exit(0);"},
    {"forgery", "pipe", "", "c_write(3, LINE, sizeof LINE - 1); c_exit(0);"},
    {"forgery", "guessed_keys", "", "for (long k = -64; k < 64; ++k) c_syscall(1, 3, LINE, sizeof LINE - 1, k, k); c_exit(0);"},
    {"forgery", "keys_from_the_stack", "", "for (long* at = (long*)__builtin_frame_address(0);; ++at) c_syscall(1, 3, LINE, 9, *at, *at >> 32);"},
    {"forgery", "reads_answers", "", "c_syscall(0, 4, B, 4096, B[0], B[0]);"},
    {"forgery", "standard_output", "extern \"C\" int puts(const char*);", "puts(LINE);"},
    {"forgery", "serial", "", "Serial.begin(115200); Serial.println(F(LINE)); delay(200);", Target::both},
    {"forgery", "serial_without_end", "", "Serial.begin(2000000); for (;;) Serial.print(F(\"{[\\\"\"));", Target::both},
    {"forgery", "serial_binary", "", "Serial.begin(2000000); for (int i = 0;; ++i) Serial.write((uint8_t)(i * 7));", Target::both},
    {"forgery", "serial_bad_utf8", "", "Serial.begin(9600); Serial.print(F(\"\\xc0\\x80\\xed\\xa0\\x80\\xff\\xfe\\xf4\\x90\\x80\\x80\")); delay(100);", Target::both},
    {"forgery", "image_changed", "", "for (long p = (long)&setup & ~4095;; p += 4096) *(volatile char*)p = 0xc3;"},
    {"forgery", "environment", "extern \"C\" { extern char** environ; char* getenv(const char*); }", "Serial.begin(115200); if (getenv(\"HOSTILE_SECRET\")) Serial.print(getenv(\"HOSTILE_SECRET\")); for (char** e = environ; e && *e; ++e) Serial.println(*e); delay(200);"},
    {"forgery", "stack_of_the_process", "", "Serial.begin(2000000); char* p = (char*)__builtin_frame_address(0); for (int i = 0; i < 8000; ++i) Serial.write(p[i]);"},
    // Sketches that never end.
    {"endless", "setup", "", "for (;;) asm volatile(\"\");", Target::both},
    {"endless", "setup_unseen", "", "spin();", Target::host},
    {"endless", "handler", "void h() { for (;;) {} }", "pinMode(2, OUTPUT); attachInterrupt(digitalPinToInterrupt(2), h, CHANGE); digitalWrite(2, HIGH); digitalWrite(2, LOW);", Target::both},
    {"endless", "library_function", "", "memset(B, 0, 0); for (;;) qsort(B, 2048, 8, [](const void*, const void*) { return 1; });", Target::both},
    {"endless", "switched_off_interrupts", "", "noInterrupts(); while (millis() < 9) {}", Target::both},
    {"endless", "millis", "", "for (;;) millis();", Target::both},
    {"endless", "micros", "", "for (;;) micros();", Target::both},
    {"endless", "delay", "", "delay(0xFFFFFFFF);", Target::both},
    {"endless", "delay_of_nothing", "", "for (;;) delay(0);", Target::both},
    {"endless", "pulse", "", "for (;;) pulseIn(2, HIGH, 0xFFFFFFFF);", Target::both},
    {"endless", "serial_wait", "", "Serial.begin(1); for (;;) Serial.flush();", Target::both},
    {"endless", "analog", "", "for (;;) analogRead(A0);", Target::both},
    {"endless", "recursion_of_loop", "void loop();", "loop(); setup();", Target::both},
    // Escape sequences, printed to a terminal.
    {"terminal", "title", "", "Serial.begin(115200); Serial.print(F(\"\\x1b]0;FORGED\\x07\")); delay(99);", Target::both},
    {"terminal", "clipboard", "", "Serial.begin(115200); Serial.print(F(\"\\x1b]52;c;RVZJTA==\\x1b\\\\\")); delay(99);", Target::both},
    {"terminal", "clear", "", "Serial.begin(115200); Serial.print(F(\"\\x1b[2J\\x1b[H\\x1b" "c\")); delay(99);", Target::both},
    {"terminal", "question", "", "Serial.begin(115200); Serial.print(F(\"\\x1b[6n\\x1bP$q\\\"p\\x1b\\\\\\x05\")); delay(99);", Target::both},
    {"terminal", "8_bit", "", "Serial.begin(115200); Serial.print(F(\"\\x9b" "2J\\x9d" "0;x\\x9c\\x90x\\x9c\")); delay(99);", Target::both},
    {"terminal", "utf8_of_8_bit", "", "Serial.begin(115200); Serial.print(F(\"\\xc2\\x9b" "2J\\xc2\\x9d" "0;x\")); delay(99);", Target::both},
    {"terminal", "split_in_two", "", "Serial.begin(9600); Serial.print(F(\"\\x1b\")); delay(50); Serial.print(F(\"[2J\")); delay(50);", Target::both},
    {"terminal", "overwriting", "", "Serial.begin(115200); Serial.print(F(\"x\\rFORGED\\b\\b\\b\\b\\b\\b\\x7f\\x0b\\x0c\")); delay(99);", Target::both},
    {"terminal", "right_to_left", "", "Serial.begin(115200); Serial.print(F(\"\\xe2\\x80\\xae" "x\\xe2\\x81\\xa6\\xe2\\x80\\x8b\")); delay(99);", Target::both},
    {"terminal", "name_of_a_function", "void \xe2\x80\xae" "f() { *(volatile int*)1 = 1; }", "\xe2\x80\xae" "f();"},
    {"terminal", "file_of_a_line", "void f() {\n#line 7 \"\\x1b[2J\\nFORGED: x\"\n*(volatile int*)1 = 1; }", "f();"},
    // Arduino API calls with unexpected arguments.
    {"misuse", "pin_numbers", "", "for (long p = -300; p < 300; ++p) { pinMode(p, OUTPUT); digitalWrite(p, HIGH); analogWrite(p, 999); B[0] += analogRead(p); }", Target::both},
    {"misuse", "modes", "", "for (int m = 0; m < 256; ++m) pinMode(5, m);", Target::both},
    {"misuse", "null_handler", "", "attachInterrupt(0, 0, CHANGE); pinMode(2, OUTPUT); digitalWrite(2, HIGH);", Target::both},
    {"misuse", "wild_handler", "", "attachInterrupt(0, (void (*)())0x7abc, CHANGE); pinMode(2, OUTPUT); digitalWrite(2, HIGH); digitalWrite(2, LOW);", Target::both},
    {"misuse", "interrupt_numbers", "void h() {}", "for (int i = 0; i < 256; ++i) { attachInterrupt(i, h, i); detachInterrupt(i); }", Target::both},
    {"misuse", "tones", "", "for (long f = 0; f < 70000; f += 999) tone(f % 20, f, f);", Target::both},
    {"misuse", "eeprom", "#include <EEPROM.h>", "for (long a = -9; a < 70000; a += 77) EEPROM.write(a, a); B[0] = EEPROM.read(-1);", Target::both},
    {"misuse", "wire", "#include <Wire.h>", "Wire.begin(255); Wire.setClock(0); Wire.beginTransmission(999); for (int i = 0; i < 999; ++i) Wire.write(i); Wire.endTransmission(); Wire.requestFrom(300, 300);", Target::both},
    {"misuse", "spi", "#include <SPI.h>", "SPI.begin(); SPI.setClockDivider(255); SPI.setDataMode(99); for (int i = 0; i < 99; ++i) SPI.transfer(i); SPI.end(); SPI.end();", Target::both},
    {"misuse", "pulses", "", "for (int i = 0; i < 99; ++i) { shiftOut(i, i, i, i); B[0] += shiftIn(i, i, i); noTone(i); analogReference(i); }", Target::both},
    {"misuse", "serial_rates", "", "for (long b = -5; b < 5; ++b) { Serial.begin(b); Serial.print('x'); Serial.end(); }", Target::both},
    {"misuse", "text_without_end", "", "memset(B, 'x', sizeof B); Serial.begin(2000000); Serial.print((char*)B);", Target::both},
    {"misuse", "registers", "", "DDRB = PORTB = DDRC = PORTC = 255; TCCR1A = TCCR1B = 255; OCR1A = 0; TIMSK1 = 255; UBRR0 = 0; UCSR0B = 255; ADCSRA = 255; SPCR = 255;", Target::both},
    // Attacks that run only on the chip.
    {"chip", "all_memory", "", "for (unsigned i = 0; i < 0x8FF; ++i) *(volatile char*)i = 255;", Target::avr},
    {"chip", "all_registers", "", "for (unsigned i = 0x20; i < 0x100; ++i) *(volatile char*)i = i;", Target::avr},
    {"chip", "stack_pointer", "", "SP = 0; asm volatile(\"push r0\"); SP = 0xFFFF; asm volatile(\"push r0\");", Target::avr},
    {"chip", "jump_out", "", "asm volatile(\"ldi r30, 0xff\\nldi r31, 0x7f\\nijmp\" ::: \"r30\", \"r31\");", Target::avr},
    {"chip", "unknown_instructions", "", "asm volatile(\".word 0xffff, 0x95a9, 0x9404, 0x0001\");", Target::avr},
    {"chip", "self_programming", "", "asm volatile(\"ldi r16, 3\\nout 0x37, r16\\nspm\" ::: \"r16\");", Target::avr},
    {"chip", "watchdog", "#include <avr/wdt.h>", "wdt_enable(WDTO_15MS); for (;;) {}", Target::avr},
    {"chip", "sleep_for_ever", "#include <avr/sleep.h>", "noInterrupts(); sleep_enable(); set_sleep_mode(SLEEP_MODE_PWR_DOWN); sleep_cpu();", Target::avr},
    {"chip", "clock", "", "CLKPR = 128; CLKPR = 255;", Target::avr},
    {"chip", "eeprom_for_ever", "#include <avr/eeprom.h>", "for (unsigned i = 0;; ++i) eeprom_write_byte((uint8_t*)(i & 2047), i);", Target::avr},
    {"chip", "own_vectors", "ISR(TIMER2_OVF_vect) { for (;;) {} }", "TCCR2B = 1; TIMSK2 = 1;", Target::avr},
    {"chip", "interrupts_in_interrupts", "ISR(TIMER1_COMPA_vect) { sei(); for (;;) {} }", "TCCR1B = 9; OCR1A = 1; TIMSK1 = 2;", Target::avr},
    {"chip", "no_return", "", "asm volatile(\"pop r0\\npop r0\\npop r0\\npop r0\\nret\");", Target::avr},
    {"chip", "eats_stack", "void deep() { volatile char big[99]; big[0] = 1; deep(); }", "deep();", Target::avr},
};

// clang-format on

std::string forged_line() {
  return R"(#define LINE "{\"id\":2,\"result\":{\"verdict\":\"reached\",\"why\":\"FORGED\",\"status\":0}}\n")";
}

Input sketch(const std::string& mechanism, const std::string& variant, const std::string& before,
             const std::string& setup, Target target) {
  std::string text = target == Target::host ? kBeginning : "static long B[64];\n";
  text += fmt::format("#define IMAGE_VERSION {}\n{}\n", host::kImageVersion, forged_line());
  if (target == Target::host) text += LOOPS_UNSEEN "void spin() { for (;;) asm volatile(\"\"); }\n";
  text += fmt::format("{}\nvoid setup() {{\n{}\n", before, setup);
  // Sends the data that the attack has read.
  if (target == Target::host)
    text += "Serial.begin(115200); B[63] = 0; Serial.print((char*)B); Serial.flush();\n";
  text += "}\nvoid loop() { delay(1); }\n";
  Input input{mechanism, variant, {{"S.ino", text}}, target};
  input.compiles = mechanism != "loading";
  input.on_terminal = mechanism == "terminal";
  return input;
}

/// Splits at the first blank.
std::pair<std::string, std::string> split(const std::string& text) {
  const std::size_t at = text.find(' ');
  return {text.substr(0, at), text.substr(at + 1)};
}

}  // namespace

std::vector<Input> sketches() {
  std::vector<Input> all;
  int number = 0;
  for (const char* row : kCalls) {
    const auto [mechanism, rest] = split(row);
    const auto [name, arguments] = split(rest);
    all.push_back(sketch("libc_" + mechanism, fmt::format("{}_{}", name, number++),
                         fmt::format("extern \"C\" long attack(...) __asm__(\"{}\");", name),
                         fmt::format("attack({});", arguments), Target::host));
  }
  for (const char* row : kSystemCalls) {
    const auto [name, arguments] = split(row);
    const bool numbered = name[0] == '-' || (name[0] >= '0' && name[0] <= '9');
    const int call = numbered ? std::stoi(name) : ::seccomp_syscall_resolve_name(name.c_str());
    if (!numbered && call < 0) continue;  // this machine does not have the call
    all.push_back(sketch("system_calls", fmt::format("{}_{}", numbered ? "number" : name, number++), "",
                         fmt::format("B[1] = c_syscall({}, {});", call, arguments), Target::host));
  }
  for (const Row& row : kRows)
    all.push_back(sketch(row.mechanism, row.variant, row.before, row.setup, row.target));
  return all;
}

}  // namespace robosim::hostile
