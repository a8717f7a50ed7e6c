// Suppresses libsimavr's leak of interrupt signal names. No other code may leak.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libsimavr\n"; }
