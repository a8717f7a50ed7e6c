# Cross-builds Robosim itself for a Raspberry Pi with a 64-bit system. On this machine, Robosim's programs
# run under qemu-user.
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)
set(ROBOSIM_PI_ARCHITECTURE arm64)
set(ROBOSIM_PI_EMULATOR qemu-aarch64)
include(${CMAKE_CURRENT_LIST_DIR}/pi.cmake)
