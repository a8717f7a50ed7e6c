# Contains the common part of pi64.cmake and pi32.cmake: uses Debian's cross compiler, with the libraries that
# pi_sysroot.sh unpacks.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_C_COMPILER ${CMAKE_LIBRARY_ARCHITECTURE}-gcc)
set(CMAKE_CXX_COMPILER ${CMAKE_LIBRARY_ARCHITECTURE}-g++)
get_filename_component(CMAKE_SYSROOT ${CMAKE_CURRENT_LIST_DIR}/../build/${ROBOSIM_PI_ARCHITECTURE}-sysroot REALPATH)
if(NOT EXISTS ${CMAKE_SYSROOT}/complete)
  message(FATAL_ERROR "The ${ROBOSIM_PI_ARCHITECTURE} libraries are missing: "
    "run toolchain/pi_sysroot.sh ${ROBOSIM_PI_ARCHITECTURE}")
endif()
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(CMAKE_CROSSCOMPILING_EMULATOR ${ROBOSIM_PI_EMULATOR};-L;${CMAKE_SYSROOT})
