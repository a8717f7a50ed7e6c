#pragma once

static void __attribute__((noinline)) brittle(volatile int* where) { *where = 1; }
