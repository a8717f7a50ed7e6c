// Includes libunicorn 2.0.1 (GPL-2), which emulates the processor. Only this folder includes it, and only the
// program robosim-stm32 links it. Therefore that program is under the GPL-2 as a whole. The source in this
// folder is under the MIT licence, like all source of Robosim. The program links nothing under the GPL-3.
#pragma once

#include <unicorn/unicorn.h>
