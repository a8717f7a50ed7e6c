// The emulator of the processor: libunicorn 2.0.1 (GPL-2). Only this folder includes it, and only the program
// robosim-stm32 links it. So that program is under the GPL-2 as a whole. Its source here, like all of
// Robosim's, is under the MIT licence. It links nothing that is under the GPL-3.
#pragma once

#include <unicorn/unicorn.h>
