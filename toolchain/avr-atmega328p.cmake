# Configures gcc-avr for the ATmega328P of an Arduino Uno or Nano, for the preset `avr`. avr_firmware.cmake
# sets the flags.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR avr)
set(CMAKE_C_COMPILER avr-gcc)
set(CMAKE_CXX_COMPILER avr-g++)
set(CMAKE_ASM_COMPILER avr-gcc)
# With link-time optimisation, objects do not contain code yet. The plugin of avr-gcc-ar reads their symbols,
# but plain ar does not.
find_program(AVR_AR avr-gcc-ar)
find_program(AVR_RANLIB avr-gcc-ranlib)
set(CMAKE_AR ${AVR_AR} CACHE FILEPATH "")
set(CMAKE_RANLIB ${AVR_RANLIB} CACHE FILEPATH "")
# CMake's trial builds create only libraries, because linking a program needs a board's Arduino core.
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_EXECUTABLE_SUFFIX_C .elf)
set(CMAKE_C_FLAGS_INIT -mmcu=atmega328p)
set(CMAKE_CXX_FLAGS_INIT -mmcu=atmega328p)
set(CMAKE_ASM_FLAGS_INIT -mmcu=atmega328p)
