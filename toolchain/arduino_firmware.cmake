# Builds Arduino libraries and sketches for a chip as CMake targets. avr_firmware.cmake and
# stm32_firmware.cmake include this file.
#
#   robosim_arduino_library(LineKit FOLDER firmware)
#   robosim_arduino_sketch(PidFollower FOLDER firmware/examples/PidFollower LIBRARIES LineKit BOARDS uno nano)
#
# These calls build PidFollower-uno.elf and the file to flash, and print the sketch's size as Arduino does.
# The including file must define
#
#   robosim_board(BOARD)           makes the targets arduino-BOARD (the Arduino core) and arduino-BOARD-flags
#   robosim_finish(TARGET BOARD)   makes further files from a linked sketch
set(ARDUINO_AVR /usr/share/arduino/hardware/arduino/avr CACHE PATH "Arduino's AVR platform")
if(NOT EXISTS ${ARDUINO_AVR}/cores/arduino/Arduino.h)
  message(FATAL_ERROR "The Arduino core is missing: sudo apt install arduino-core-avr")
endif()
find_program(ARDUINO_CTAGS arduino-ctags)
if(NOT ARDUINO_CTAGS)
  message(FATAL_ERROR "arduino-ctags is missing: sudo apt install arduino-ctags")
endif()
set(ROBOSIM_TOOLCHAIN ${CMAKE_CURRENT_LIST_DIR})

# robosim_arduino_library(<name> FOLDER <folder>): registers the Arduino library in the folder's src/. A
# library may consist of headers alone. The linker uses only the objects that a sketch needs.
function(robosim_arduino_library name)
  cmake_parse_arguments(arg "" FOLDER "" ${ARGN})
  cmake_path(ABSOLUTE_PATH arg_FOLDER)
  set_property(GLOBAL PROPERTY robosim_arduino_library_${name} ${arg_FOLDER})
endfunction()

# Creates the target NAME-BOARD, which compiles a library for a board.
function(robosim_library_for_board name board)
  if(TARGET ${name}-${board})
    return()
  endif()
  get_property(folder GLOBAL PROPERTY robosim_arduino_library_${name})
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

# robosim_arduino_sketch(<name> FOLDER <folder> [LIBRARIES <names>] BOARDS <boards>): builds a sketch for
# boards.
function(robosim_arduino_sketch name)
  cmake_parse_arguments(arg "" FOLDER "LIBRARIES;BOARDS" ${ARGN})
  cmake_path(ABSOLUTE_PATH arg_FOLDER)
  # The .ino with the folder's name comes first, as in Arduino's order.
  file(GLOB inos CONFIGURE_DEPENDS ${arg_FOLDER}/*.ino)
  list(REMOVE_ITEM inos ${arg_FOLDER}/${name}.ino)
  list(PREPEND inos ${arg_FOLDER}/${name}.ino)
  set(joined ${CMAKE_CURRENT_BINARY_DIR}/${name}.ino.cpp)
  add_custom_command(OUTPUT ${joined}
    COMMAND ${ROBOSIM_TOOLCHAIN}/join_inos.sh ${ARDUINO_CTAGS} ${joined} ${inos}
    DEPENDS ${inos} ${ROBOSIM_TOOLCHAIN}/join_inos.sh
    COMMENT "Joining ${name}'s .ino files, with prototypes" VERBATIM)
  add_custom_target(${name}-source DEPENDS ${joined})
  file(GLOB sources CONFIGURE_DEPENDS ${arg_FOLDER}/*.cpp ${arg_FOLDER}/*.c)

  foreach(board ${arg_BOARDS})
    robosim_board(${board})
    set(target ${name}-${board})
    add_executable(${target} ${joined} ${sources})
    add_dependencies(${target} ${name}-source)
    set_target_properties(${target} PROPERTIES LINKER_LANGUAGE C)  # as in Arduino's builds
    target_include_directories(${target} PRIVATE ${arg_FOLDER})
    foreach(library ${arg_LIBRARIES})
      robosim_library_for_board(${library} ${board})
      target_link_libraries(${target} PRIVATE ${library}-${board})
    endforeach()
    target_link_libraries(${target} PRIVATE arduino-${board} m)
    robosim_finish(${target} ${board})
  endforeach()
endfunction()
