// Suppresses libsimavr's leak of the names of interrupts' signals. No other code may leak.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libsimavr\n"; }
