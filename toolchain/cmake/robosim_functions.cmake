# Defines functions for your own project. Use them after find_package(robosim) or FetchContent of Robosim's
# sources:
#
#   robosim_add_sketch(NAME SKETCH folder [TARGETS host avr stm32] [ROBOT robot])
#     Adds a target that compiles the sketch for the robot's board, as `robosim build` does. Each build compiles
#     the sketch again if it has changed. The build fails if the sketch does not compile, does not fit the chip,
#     or exceeds the robot's budget. Images and .hex files go to NAME-TARGET/ in the current binary folder.
#     By default, TARGETS is only host.
#
#   robosim_add_test(NAME SOURCES file... [SKETCH folder | IMAGE file.elf] [TARGETS host avr stm32])
#     Adds a GoogleTest of firmware, linked with robosim::testing (#include <robosim/testing.h>), and registers
#     each test with ctest. In the test, the macro ROBOSIM_SKETCH is the path of the sketch or image.
#     AllTargets() returns TARGETS, or by default all available targets.
include_guard(GLOBAL)

function(robosim_add_sketch name)
  cmake_parse_arguments(arg "" "SKETCH;ROBOT" "TARGETS" ${ARGN})
  if(NOT arg_SKETCH OR arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "expected robosim_add_sketch(${name} SKETCH folder [TARGETS …] [ROBOT robot]), got: ${ARGN}")
  endif()
  cmake_path(ABSOLUTE_PATH arg_SKETCH NORMALIZE)
  if(NOT arg_TARGETS)
    set(arg_TARGETS host)
  endif()
  set(robot)
  if(arg_ROBOT)
    set(robot --robot ${arg_ROBOT})
  endif()
  set(commands)
  foreach(target ${arg_TARGETS})
    list(APPEND commands COMMAND robosim::robosim build ${arg_SKETCH}/ --target ${target} ${robot}
      --out ${CMAKE_CURRENT_BINARY_DIR}/${name}-${target})
  endforeach()
  # robosim build caches its results, and takes a few milliseconds if nothing has changed.
  add_custom_target(${name} ALL ${commands} WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} VERBATIM)
endfunction()

function(robosim_add_test name)
  cmake_parse_arguments(arg "" "SKETCH;IMAGE" "SOURCES;TARGETS" ${ARGN})
  if(NOT arg_SOURCES OR arg_UNPARSED_ARGUMENTS OR (arg_SKETCH AND arg_IMAGE))
    message(FATAL_ERROR
      "expected robosim_add_test(${name} SOURCES file… [SKETCH folder | IMAGE file.elf] [TARGETS …]), got: ${ARGN}")
  endif()
  if(NOT TARGET GTest::gmock)  # the project's own GoogleTest takes precedence over the system's
    find_package(GTest REQUIRED)
  endif()
  add_executable(${name} ${arg_SOURCES} ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/test_setup.cpp)
  target_link_libraries(${name} PRIVATE robosim::testing GTest::gmock GTest::gtest_main)
  foreach(runner robosim-host robosim-avr robosim-stm32)
    if(TARGET ${runner})
      add_dependencies(${name} ${runner})
    endif()
  endforeach()
  # If Robosim is not installed, but built with this project, tests use the programs in the build folder.
  get_property(installation GLOBAL PROPERTY ROBOSIM_INSTALLATION)
  string(REPLACE ";" "," targets "${arg_TARGETS}")
  target_compile_definitions(${name} PRIVATE
    ROBOSIM_TEST_INSTALLATION="${installation}" ROBOSIM_TEST_TARGETS="${targets}")
  set(firmware ${arg_SKETCH}${arg_IMAGE})
  if(firmware)
    cmake_path(ABSOLUTE_PATH firmware NORMALIZE)
    target_compile_definitions(${name} PRIVATE ROBOSIM_SKETCH="${firmware}")
  endif()
  include(GoogleTest)  # not at the top, because it sets variables in this scope
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
endfunction()
