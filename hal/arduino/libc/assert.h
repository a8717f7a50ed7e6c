// Defines assert(). A failed assertion ends the sketch like abort().
#undef assert
#ifdef NDEBUG
#define assert(condition) ((void)0)
#else
#define assert(condition) ((condition) ? (void)0 : __assert(__func__, __FILE__, __LINE__, #condition))
#endif
#if !defined(__cplusplus) && !defined(static_assert)
#define static_assert _Static_assert
#endif
#ifndef ROBOSIM_ASSERT_DECLARED
#define ROBOSIM_ASSERT_DECLARED
#ifdef __cplusplus
extern "C"
#endif
    void
    __assert(const char* function, const char* file, int line, const char* condition)
        __attribute__((noreturn));
#endif
