# Builds a .elf and a .hex file of each Arduino sketch for the boards uno and nano, with avr-atmega328p.cmake.
# The core is Arduino's own core from the package arduino-core-avr. The flags are those of this package's
# platform.txt, as in sim/build/target.cpp.
include(${CMAKE_CURRENT_LIST_DIR}/arduino_firmware.cmake)
find_program(AVR_OBJCOPY avr-objcopy)
find_program(AVR_SIZE avr-size)

# For each board: its macro, the folder of its pins, and the bytes of flash for a sketch.
set(ROBOSIM_AVR_uno ARDUINO_AVR_UNO standard 32256)
set(ROBOSIM_AVR_nano ARDUINO_AVR_NANO eightanaloginputs 30720)
set(ROBOSIM_AVR_RAM 2048)

# Creates two targets for a board: arduino-BOARD-flags, with the compile and link options, and arduino-BOARD,
# the Arduino core.
function(robosim_board board)
  if(TARGET arduino-${board})
    return()
  endif()
  list(GET ROBOSIM_AVR_${board} 0 macro)
  list(GET ROBOSIM_AVR_${board} 1 variant)
  add_library(arduino-${board}-flags INTERFACE)
  # These folders must not be SYSTEM folders, in which avr-gcc would treat headers as C.
  target_include_directories(arduino-${board}-flags INTERFACE
    ${ARDUINO_AVR}/cores/arduino ${ARDUINO_AVR}/variants/${variant})
  target_compile_definitions(arduino-${board}-flags INTERFACE
    F_CPU=16000000L ARDUINO=10819 ${macro} ARDUINO_ARCH_AVR)
  target_compile_options(arduino-${board}-flags INTERFACE
    -Os -gdwarf-4 -gno-record-gcc-switches -ffunction-sections -fdata-sections -flto -fno-fat-lto-objects
    $<$<COMPILE_LANGUAGE:C>:-std=gnu11>
    $<$<COMPILE_LANGUAGE:CXX>:-std=gnu++11 -fpermissive -fno-exceptions -fno-threadsafe-statics -Wno-error=narrowing>)
  target_link_options(arduino-${board}-flags INTERFACE
    -Os -gdwarf-4 -gno-record-gcc-switches -flto -fuse-linker-plugin -Wl,--gc-sections)

  file(GLOB sources CONFIGURE_DEPENDS ${ARDUINO_AVR}/cores/arduino/*.cpp ${ARDUINO_AVR}/cores/arduino/*.c
    ${ARDUINO_AVR}/cores/arduino/*.S)
  list(SORT sources)  # in the order of `robosim build`, so the linked images are equal
  add_library(arduino-${board} STATIC ${sources})
  target_link_libraries(arduino-${board} PUBLIC arduino-${board}-flags)
  # avr-libc 2.0 has no DECIMAL_DIG, which WString.cpp needs.
  target_compile_options(arduino-${board} PRIVATE -w -DDECIMAL_DIG=__DECIMAL_DIG__)
endfunction()

function(robosim_finish target board)
  list(GET ROBOSIM_AVR_${board} 2 flash)
  add_custom_command(TARGET ${target} POST_BUILD
    COMMAND ${AVR_OBJCOPY} -O ihex -R .eeprom $<TARGET_FILE:${target}> ${CMAKE_CURRENT_BINARY_DIR}/${target}.hex
    COMMAND ${ROBOSIM_TOOLCHAIN}/chip_size.sh ${AVR_SIZE} $<TARGET_FILE:${target}> ${target} ${flash}
      ${ROBOSIM_AVR_RAM}
    VERBATIM)
endfunction()
