# Arduino sketches as CMake targets, for a build by avr-atmega328p.cmake:
#
#   robosim_avr_library(LineKit FOLDER firmware)
#   robosim_avr_sketch(PidFollower FOLDER firmware/examples/PidFollower LIBRARIES LineKit BOARDS uno nano)
#
# makes PidFollower-uno.elf and PidFollower-uno.hex, and prints their sizes as Arduino does. The core is the genuine
# one of the package arduino-core-avr; flags are those of its platform.txt, as in sim/sketch/target.cpp.
set(ARDUINO_AVR /usr/share/arduino/hardware/arduino/avr CACHE PATH "Arduino's AVR platform")
if(NOT EXISTS ${ARDUINO_AVR}/cores/arduino/Arduino.h)
  message(FATAL_ERROR "The Arduino core is missing: sudo apt install arduino-core-avr")
endif()
find_program(ARDUINO_CTAGS arduino-ctags)
find_program(AVR_OBJCOPY avr-objcopy)
find_program(AVR_SIZE avr-size)
if(NOT ARDUINO_CTAGS)
  message(FATAL_ERROR "arduino-ctags is missing: sudo apt install arduino-ctags")
endif()
set(ROBOSIM_AVR_TOOLCHAIN ${CMAKE_CURRENT_LIST_DIR})

# Board: macro, folder of pins, bytes of flash for a sketch.
set(ROBOSIM_AVR_uno ARDUINO_AVR_UNO standard 32256)
set(ROBOSIM_AVR_nano ARDUINO_AVR_NANO eightanaloginputs 30720)
set(ROBOSIM_AVR_RAM 2048)

# What everything for a board is compiled and linked with: the target arduino-BOARD-flags; and its core.
function(robosim_avr_board board)
  if(TARGET arduino-${board})
    return()
  endif()
  list(GET ROBOSIM_AVR_${board} 0 macro)
  list(GET ROBOSIM_AVR_${board} 1 variant)
  add_library(arduino-${board}-flags INTERFACE)
  # Never SYSTEM: avr-gcc takes such folders for C.
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
  list(SORT sources)  # the linker takes archives' members in their order: the same bytes as by `robosim build`
  add_library(arduino-${board} STATIC ${sources})
  target_link_libraries(arduino-${board} PUBLIC arduino-${board}-flags)
  # avr-libc 2.0 has no DECIMAL_DIG, which WString.cpp needs.
  target_compile_options(arduino-${board} PRIVATE -w -DDECIMAL_DIG=__DECIMAL_DIG__)
endfunction()

# robosim_avr_library(<name> FOLDER <folder>): an Arduino library with src/ or of headers only; of its objects those are
# linked that are needed.
function(robosim_avr_library name)
  cmake_parse_arguments(arg "" FOLDER "" ${ARGN})
  cmake_path(ABSOLUTE_PATH arg_FOLDER)
  set_property(GLOBAL PROPERTY robosim_avr_library_${name} ${arg_FOLDER})
endfunction()

# The library, compiled for a board: the target NAME-BOARD.
function(robosim_avr_library_for_board name board)
  if(TARGET ${name}-${board})
    return()
  endif()
  get_property(folder GLOBAL PROPERTY robosim_avr_library_${name})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${folder}/src/*.cpp ${folder}/src/*.c)
  if(sources)
    add_library(${name}-${board} STATIC ${sources})
    target_include_directories(${name}-${board} PUBLIC ${folder}/src)
    target_link_libraries(${name}-${board} PUBLIC arduino-${board})
  else()
    add_library(${name}-${board} INTERFACE)
    target_include_directories(${name}-${board} INTERFACE ${folder}/src)
  endif()
endfunction()

# robosim_avr_sketch(<name> FOLDER <folder> [LIBRARIES <names>] BOARDS <boards>)
function(robosim_avr_sketch name)
  cmake_parse_arguments(arg "" FOLDER "LIBRARIES;BOARDS" ${ARGN})
  cmake_path(ABSOLUTE_PATH arg_FOLDER)
  # The .ino of the folder's name first, as Arduino joins them.
  file(GLOB inos CONFIGURE_DEPENDS ${arg_FOLDER}/*.ino)
  list(REMOVE_ITEM inos ${arg_FOLDER}/${name}.ino)
  list(PREPEND inos ${arg_FOLDER}/${name}.ino)
  set(joined ${CMAKE_CURRENT_BINARY_DIR}/${name}.ino.cpp)
  add_custom_command(OUTPUT ${joined}
    COMMAND ${ROBOSIM_AVR_TOOLCHAIN}/join_inos.sh ${ARDUINO_CTAGS} ${joined} ${inos}
    DEPENDS ${inos} ${ROBOSIM_AVR_TOOLCHAIN}/join_inos.sh
    COMMENT "Joining ${name}'s .ino files, with prototypes" VERBATIM)
  add_custom_target(${name}-source DEPENDS ${joined})
  file(GLOB sources CONFIGURE_DEPENDS ${arg_FOLDER}/*.cpp ${arg_FOLDER}/*.c)

  foreach(board ${arg_BOARDS})
    robosim_avr_board(${board})
    set(target ${name}-${board})
    add_executable(${target} ${joined} ${sources})
    add_dependencies(${target} ${name}-source)
    set_target_properties(${target} PROPERTIES LINKER_LANGUAGE C)  # as Arduino links
    target_include_directories(${target} PRIVATE ${arg_FOLDER})
    foreach(library ${arg_LIBRARIES})
      robosim_avr_library_for_board(${library} ${board})
      target_link_libraries(${target} PRIVATE ${library}-${board})
    endforeach()
    target_link_libraries(${target} PRIVATE arduino-${board} m)
    list(GET ROBOSIM_AVR_${board} 2 flash)
    add_custom_command(TARGET ${target} POST_BUILD
      COMMAND ${AVR_OBJCOPY} -O ihex -R .eeprom $<TARGET_FILE:${target}> ${CMAKE_CURRENT_BINARY_DIR}/${target}.hex
      COMMAND ${ROBOSIM_AVR_TOOLCHAIN}/chip_size.sh ${AVR_SIZE} $<TARGET_FILE:${target}> ${target} ${flash}
        ${ROBOSIM_AVR_RAM}
      VERBATIM)
  endforeach()
endfunction()
