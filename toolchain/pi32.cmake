# Cross-builds Robosim itself for a Raspberry Pi with a 32-bit system (ARMv7, hard float: a Pi 2 or newer with
# Debian's armhf). On this machine, Robosim's programs run under qemu-user.
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_LIBRARY_ARCHITECTURE arm-linux-gnueabihf)
set(ROBOSIM_PI_ARCHITECTURE armhf)
set(ROBOSIM_PI_EMULATOR qemu-arm)
include(${CMAKE_CURRENT_LIST_DIR}/pi.cmake)
set(CMAKE_CXX_FLAGS_INIT -Wno-psabi)  # disables notes about the passing of arguments in GCC 7.1
