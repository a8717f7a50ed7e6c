# Arduino sketches as CMake targets, for a build by stm32f103.cmake:
#
#   robosim_stm32_library(LineKit FOLDER firmware)
#   robosim_stm32_sketch(PidFollower FOLDER firmware/examples/PidFollower LIBRARIES LineKit BOARDS bluepill bluepill8)
#
# makes PidFollower-bluepill.elf and PidFollower-bluepill.bin, and prints their sizes as Arduino does. The core is
# hal/stm32 and hal/arduino with the portable sources of the package arduino-core-avr; flags are as in
# sim/sketch/target.cpp.
set(ARDUINO_AVR /usr/share/arduino/hardware/arduino/avr CACHE PATH "Arduino's AVR platform")
if(NOT EXISTS ${ARDUINO_AVR}/cores/arduino/Print.cpp)
  message(FATAL_ERROR "The Arduino core is missing: sudo apt install arduino-core-avr")
endif()
find_program(ARDUINO_CTAGS arduino-ctags)
find_program(STM32_OBJCOPY arm-none-eabi-objcopy)
find_program(STM32_SIZE arm-none-eabi-size)
if(NOT ARDUINO_CTAGS)
  message(FATAL_ERROR "arduino-ctags is missing: sudo apt install arduino-ctags")
endif()
set(ROBOSIM_STM32_TOOLCHAIN ${CMAKE_CURRENT_LIST_DIR})
cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH ROBOSIM_STM32_ROOT)

# Board: its processor's clock. Bytes of flash for a sketch, and of RAM.
set(ROBOSIM_STM32_bluepill 72000000)
set(ROBOSIM_STM32_bluepill8 8000000)
set(ROBOSIM_STM32_FLASH 61440)
set(ROBOSIM_STM32_RAM 20480)

# The genuine core's portable sources, apart from what is an AVR's.
set(ROBOSIM_STM32_PORTABLE Print.h Print.cpp Printable.h Stream.h Stream.cpp WString.h WString.cpp WCharacter.h
  IPAddress.h IPAddress.cpp binary.h Client.h Server.h Udp.h new new.h new.cpp abi.cpp)
set(ROBOSIM_STM32_STAGE ${CMAKE_BINARY_DIR}/core)
file(MAKE_DIRECTORY ${ROBOSIM_STM32_STAGE})
foreach(name ${ROBOSIM_STM32_PORTABLE})
  file(CREATE_LINK ${ARDUINO_AVR}/cores/arduino/${name} ${ROBOSIM_STM32_STAGE}/${name} SYMBOLIC)
endforeach()

# What everything for a board is compiled and linked with: the target arduino-BOARD-flags; and its core.
function(robosim_stm32_board board)
  if(TARGET arduino-${board})
    return()
  endif()
  execute_process(COMMAND ${CMAKE_CXX_COMPILER} -print-file-name=include
    OUTPUT_VARIABLE own_headers OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  set(hal ${ROBOSIM_STM32_ROOT}/hal)
  add_library(arduino-${board}-flags INTERFACE)
  target_include_directories(arduino-${board}-flags INTERFACE
    ${hal}/stm32 ${hal}/arduino ${ROBOSIM_STM32_STAGE} ${ROBOSIM_STM32_ROOT})
  target_compile_definitions(arduino-${board}-flags INTERFACE
    F_CPU=${ROBOSIM_STM32_${board}}L ARDUINO=10819 ARDUINO_BLUEPILL_F103C8 ARDUINO_ARCH_STM32 STM32F103xB)
  target_compile_options(arduino-${board}-flags INTERFACE
    -Os -gdwarf-4 -gno-record-gcc-switches -ffunction-sections -fdata-sections -nostdinc
    -fno-delete-null-pointer-checks
    "SHELL:-isystem ${hal}/arduino/libc" "SHELL:-isystem ${own_headers}" -Wno-builtin-declaration-mismatch
    $<$<COMPILE_LANGUAGE:C>:-std=gnu11>
    $<$<COMPILE_LANGUAGE:CXX>:-std=gnu++14 -fpermissive -fno-exceptions -fno-rtti -fno-threadsafe-statics
      -fno-use-cxa-atexit -nostdinc++ -Wno-error=narrowing>)
  target_link_options(arduino-${board}-flags INTERFACE
    -nostartfiles --specs=nano.specs -Wl,--gc-sections -Wl,--build-id=none "SHELL:-T ${hal}/stm32/stm32f103c8.ld")

  # The linker takes archives' members in their order: the same bytes as by `robosim build` (sim/sketch/toolchain.cpp).
  set(sources)
  foreach(folder ${hal}/stm32 ${hal}/arduino ${ROBOSIM_STM32_STAGE})
    file(GLOB found CONFIGURE_DEPENDS ${folder}/*.cpp)
    list(SORT found)
    list(APPEND sources ${found})
  endforeach()
  add_library(arduino-${board} STATIC ${sources})
  target_link_libraries(arduino-${board} PUBLIC arduino-${board}-flags)
  target_compile_options(arduino-${board} PRIVATE -w)
endfunction()

# robosim_stm32_library(<name> FOLDER <folder>): an Arduino library with src/ or of headers only; of its objects those
# are linked that are needed.
function(robosim_stm32_library name)
  cmake_parse_arguments(arg "" FOLDER "" ${ARGN})
  cmake_path(ABSOLUTE_PATH arg_FOLDER)
  set_property(GLOBAL PROPERTY robosim_stm32_library_${name} ${arg_FOLDER})
endfunction()

# The library, compiled for a board: the target NAME-BOARD.
function(robosim_stm32_library_for_board name board)
  if(TARGET ${name}-${board})
    return()
  endif()
  get_property(folder GLOBAL PROPERTY robosim_stm32_library_${name})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${folder}/src/*.cpp ${folder}/src/*.c)
  add_library(${name}-${board} STATIC ${sources})
  target_include_directories(${name}-${board} PUBLIC ${folder}/src)
  target_link_libraries(${name}-${board} PUBLIC arduino-${board})
endfunction()

# robosim_stm32_sketch(<name> FOLDER <folder> [LIBRARIES <names>] BOARDS <boards>)
function(robosim_stm32_sketch name)
  cmake_parse_arguments(arg "" FOLDER "LIBRARIES;BOARDS" ${ARGN})
  cmake_path(ABSOLUTE_PATH arg_FOLDER)
  # The .ino of the folder's name first, as Arduino joins them.
  file(GLOB inos CONFIGURE_DEPENDS ${arg_FOLDER}/*.ino)
  list(REMOVE_ITEM inos ${arg_FOLDER}/${name}.ino)
  list(PREPEND inos ${arg_FOLDER}/${name}.ino)
  set(joined ${CMAKE_CURRENT_BINARY_DIR}/${name}.ino.cpp)
  add_custom_command(OUTPUT ${joined}
    COMMAND ${ROBOSIM_STM32_TOOLCHAIN}/join_inos.sh ${ARDUINO_CTAGS} ${joined} ${inos}
    DEPENDS ${inos} ${ROBOSIM_STM32_TOOLCHAIN}/join_inos.sh
    COMMENT "Joining ${name}'s .ino files, with prototypes" VERBATIM)
  add_custom_target(${name}-source DEPENDS ${joined})
  file(GLOB sources CONFIGURE_DEPENDS ${arg_FOLDER}/*.cpp ${arg_FOLDER}/*.c)

  foreach(board ${arg_BOARDS})
    robosim_stm32_board(${board})
    set(target ${name}-${board})
    add_executable(${target} ${joined} ${sources})
    add_dependencies(${target} ${name}-source)
    set_target_properties(${target} PROPERTIES LINKER_LANGUAGE C
      LINK_DEPENDS ${ROBOSIM_STM32_ROOT}/hal/stm32/stm32f103c8.ld)
    target_include_directories(${target} PRIVATE ${arg_FOLDER})
    foreach(library ${arg_LIBRARIES})
      robosim_stm32_library_for_board(${library} ${board})
      target_link_libraries(${target} PRIVATE ${library}-${board})
    endforeach()
    target_link_libraries(${target} PRIVATE arduino-${board} m)
    add_custom_command(TARGET ${target} POST_BUILD
      COMMAND ${STM32_OBJCOPY} -O binary $<TARGET_FILE:${target}> ${CMAKE_CURRENT_BINARY_DIR}/${target}.bin
      COMMAND ${ROBOSIM_STM32_TOOLCHAIN}/chip_size.sh ${STM32_SIZE} $<TARGET_FILE:${target}> ${target}
        ${ROBOSIM_STM32_FLASH} ${ROBOSIM_STM32_RAM}
      VERBATIM)
  endforeach()
endfunction()
