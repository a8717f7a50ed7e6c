// avr-libc's <math.h>. `double` is the host's type, which has 64 bits; the chip's `double` has 32.
#pragma once

#ifdef __cplusplus
extern "C" {
#endif

#define M_E 2.7182818284590452354
#define M_LOG2E 1.4426950408889634074
#define M_LOG10E 0.43429448190325182765
#define M_LN2 0.69314718055994530942
#define M_LN10 2.30258509299404568402
#define M_PI 3.14159265358979323846
#define M_PI_2 1.57079632679489661923
#define M_PI_4 0.78539816339744830962
#define M_1_PI 0.31830988618379067154
#define M_2_PI 0.63661977236758134308
#define M_2_SQRTPI 1.12837916709551257390
#define M_SQRT2 1.41421356237309504880
#define M_SQRT1_2 0.70710678118654752440

#define NAN __builtin_nan("")
#define INFINITY __builtin_inf()
#define HUGE_VAL __builtin_huge_val()

double acos(double x);
double asin(double x);
double atan(double x);
double atan2(double y, double x);
double cbrt(double x);
double ceil(double x);
double copysign(double x, double sign);
double cos(double x);
double cosh(double x);
double exp(double x);
double fabs(double x);
double fdim(double x, double y);
double floor(double x);
double fma(double x, double y, double z);
double fmax(double x, double y);
double fmin(double x, double y);
double fmod(double x, double y);
double frexp(double x, int* exponent);
double hypot(double x, double y);
double ldexp(double x, int exponent);
double log(double x);
double log10(double x);
long lrint(double x);
long lround(double x);
double modf(double x, double* whole);
double pow(double x, double y);
double round(double x);
double sin(double x);
double sinh(double x);
double sqrt(double x);
double tan(double x);
double tanh(double x);
double trunc(double x);

static inline double square(double x) { return x * x; }
static inline int isfinite(double x) { return __builtin_isfinite(x); }
static inline int isinf(double x) { return __builtin_isinf_sign(x); }
static inline int isnan(double x) { return __builtin_isnan(x); }
static inline int signbit(double x) { return __builtin_signbit(x) != 0; }

// On the chip `float` and `double` are one type, so avr-libc defines the names below as synonyms.
#define acosf acos
#define asinf asin
#define atan2f atan2
#define atanf atan
#define cbrtf cbrt
#define ceilf ceil
#define copysignf copysign
#define cosf cos
#define coshf cosh
#define expf exp
#define fabsf fabs
#define fdimf fdim
#define floorf floor
#define fmaf fma
#define fmaxf fmax
#define fminf fmin
#define fmodf fmod
#define frexpf frexp
#define hypotf hypot
#define isfinitef isfinite
#define isinff isinf
#define isnanf isnan
#define ldexpf ldexp
#define log10f log10
#define logf log
#define lrintf lrint
#define lroundf lround
#define powf pow
#define roundf round
#define signbitf signbit
#define sinf sin
#define sinhf sinh
#define sqrtf sqrt
#define squaref square
#define tanf tan
#define tanhf tanh
#define truncf trunc

#ifdef __cplusplus
}
#endif
