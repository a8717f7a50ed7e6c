// libsimavr keeps the names of its interrupts' signals when a chip is taken down; nobody else may leak.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libsimavr\n"; }
