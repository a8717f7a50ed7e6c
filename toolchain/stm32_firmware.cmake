# Builds a .elf and a .bin file of each Arduino sketch for the boards bluepill (72 MHz) and bluepill8 (8 MHz),
# with stm32f103.cmake. The Arduino core consists of hal/stm32, hal/arduino and the portable sources of the
# package arduino-core-avr. The flags are those of sim/build/target.cpp.
include(${CMAKE_CURRENT_LIST_DIR}/arduino_firmware.cmake)
find_program(STM32_OBJCOPY arm-none-eabi-objcopy)
find_program(STM32_SIZE arm-none-eabi-size)
cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH ROBOSIM_STM32_ROOT)

# The clock of each board in Hz, the bytes of flash for a sketch, and the bytes of RAM.
set(ROBOSIM_STM32_bluepill 72000000)
set(ROBOSIM_STM32_bluepill8 8000000)
set(ROBOSIM_STM32_FLASH 65536)
set(ROBOSIM_STM32_RAM 20480)

# The portable sources of Arduino's own core, which are not specific to AVR.
set(ROBOSIM_STM32_PORTABLE Print.h Print.cpp Printable.h Stream.h Stream.cpp WString.h WString.cpp WCharacter.h
  IPAddress.h IPAddress.cpp binary.h Client.h Server.h Udp.h new new.h new.cpp abi.cpp)
set(ROBOSIM_STM32_STAGE ${CMAKE_BINARY_DIR}/core)
file(MAKE_DIRECTORY ${ROBOSIM_STM32_STAGE})
foreach(name ${ROBOSIM_STM32_PORTABLE})
  file(CREATE_LINK ${ARDUINO_AVR}/cores/arduino/${name} ${ROBOSIM_STM32_STAGE}/${name} SYMBOLIC)
endforeach()

# Creates two targets for a board: arduino-BOARD-flags, with the compile and link options, and arduino-BOARD,
# the Arduino core.
function(robosim_board board)
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

  # Sorts the sources in the order of `robosim build` (sim/build/toolchain.cpp), so the linked images are
  # equal.
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

function(robosim_finish target board)
  set_target_properties(${target} PROPERTIES LINK_DEPENDS ${ROBOSIM_STM32_ROOT}/hal/stm32/stm32f103c8.ld)
  add_custom_command(TARGET ${target} POST_BUILD
    COMMAND ${STM32_OBJCOPY} -O binary $<TARGET_FILE:${target}> ${CMAKE_CURRENT_BINARY_DIR}/${target}.bin
    COMMAND ${ROBOSIM_TOOLCHAIN}/chip_size.sh ${STM32_SIZE} $<TARGET_FILE:${target}> ${target}
      ${ROBOSIM_STM32_FLASH} ${ROBOSIM_STM32_RAM}
    VERBATIM)
endfunction()
