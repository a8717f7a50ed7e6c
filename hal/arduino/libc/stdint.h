// Fixed-width integers, as gcc itself defines them for the target.
#pragma once
#include <stdint-gcc.h>
