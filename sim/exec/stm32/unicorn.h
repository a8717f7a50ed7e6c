// Includes libunicorn 2.0.1 (GPL-2), which emulates the processor. Only files in this folder include
// libunicorn, and only the program robosim-stm32 links libunicorn. Therefore robosim-stm32 is under the GPL-2
// as a whole, and links no library under the GPL-3. The source in this folder is under the MIT licence, like
// all source of Robosim.
#pragma once

#include <unicorn/unicorn.h>
