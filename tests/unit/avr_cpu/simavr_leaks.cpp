// Makes LeakSanitizer ignore a leak in libsimavr, which does not free the names of its interrupt signals. All
// other leaks are reported.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libsimavr\n"; }
