# Installs and packages Robosim, for `cmake --install` and CPack. sim/base/file.h describes how Robosim finds
# the installed files. Each target is a component and a Debian package. host and avr have the MIT licence.
# stm32 has the licence GPL-2 because of Unicorn.
if(NOT TARGET robosim OR NOT TARGET robosim-host)
  return()
endif()

install(TARGETS robosim DESTINATION bin COMPONENT host)
install(TARGETS robosim-host DESTINATION libexec/robosim COMPONENT host)
install(TARGETS robosim-campaign DESTINATION libexec/robosim COMPONENT host)
if(TARGET robosim-serve)
  install(TARGETS robosim-serve DESTINATION libexec/robosim COMPONENT host)
endif()
install(DIRECTORY sim/map/cells/include DESTINATION share/robosim/sim/map/cells COMPONENT host)
install(DIRECTORY docs/examples sim/cli/files/new DESTINATION share/robosim COMPONENT host)
install(DIRECTORY hal firmware maps DESTINATION share/robosim COMPONENT host PATTERN CMakeLists.txt EXCLUDE)
install(DIRECTORY sim/robot/stock/ DESTINATION share/robosim/robots COMPONENT host)
install(FILES README.md DESTINATION share/doc/robosim COMPONENT host)
install(DIRECTORY docs DESTINATION share/doc/robosim COMPONENT host FILES_MATCHING PATTERN *.md)

# The built command prints its own manual pages and completion. This happens during the installation, so that
# it does not lengthen a build.
set(help ${CMAKE_CURRENT_BINARY_DIR}/help)
string(REPLACE ";" "\" \"" emulator "${CMAKE_CROSSCOMPILING_EMULATOR}")
if(emulator)
  set(emulator "\"${emulator}\"")
endif()
install(CODE "
  set(command ${emulator} \"$<TARGET_FILE:robosim>\")
  execute_process(COMMAND \${command} man --out \"${help}/man\" COMMAND_ERROR_IS_FATAL ANY)
  foreach(shell bash zsh fish)
    execute_process(COMMAND \${command} completion \${shell} OUTPUT_FILE \"${help}/\${shell}\" COMMAND_ERROR_IS_FATAL ANY)
  endforeach()" COMPONENT host)
install(DIRECTORY ${help}/man/ DESTINATION share/man/man1 COMPONENT host)
install(FILES ${help}/bash DESTINATION share/bash-completion/completions RENAME robosim COMPONENT host)
install(FILES ${help}/zsh DESTINATION share/zsh/vendor-completions RENAME _robosim COMPONENT host)
install(FILES ${help}/fish DESTINATION share/fish/vendor_completions.d RENAME robosim.fish COMPONENT host)

install(FILES toolchain/licences/robosim.copyright DESTINATION share/doc/robosim RENAME copyright COMPONENT host)

# Installs the parts that find_package(robosim) needs: the harness as source, the headers that the harness
# includes, and one library that contains all libraries that the harness links.
set(libraries world_generator launch analysis statistics record terminal client wire result build project elf cells map trace board base)
set(script "create librobosim.a\n")
foreach(library ${libraries})
  if(TARGET robosim_${library})
    list(APPEND merged robosim_${library})
    list(GET ROBOSIM_PNG 0 ROBOSIM_PNG_FILE)
  string(APPEND script "addlib $<TARGET_FILE:robosim_${library}>\n")
  endif()
endforeach()
if(ROBOSIM_PORTABLE)
  string(APPEND script "addlib ${ROBOSIM_LIBMD}\naddlib ${ROBOSIM_PNG_FILE}\naddlib ${ROBOSIM_XXHASH}\naddlib ${ROBOSIM_YAML}\n")
  set(ROBOSIM_NOT_MERGED "elf z")
else()
  set(ROBOSIM_NOT_MERGED "${ROBOSIM_LIBMD} ${ROBOSIM_PNG} ${ROBOSIM_XXHASH} ${ROBOSIM_YAML} ${ROBOSIM_LIBELF} z")
endif()
file(GENERATE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/librobosim.mri CONTENT "${script}save\nend\n")
add_custom_command(OUTPUT librobosim.a COMMAND ${CMAKE_COMMAND} -E rm -f librobosim.a
  COMMAND sh -c "\"$1\" -M < librobosim.mri" sh ${CMAKE_AR} DEPENDS ${merged} VERBATIM)
add_custom_target(librobosim ALL DEPENDS librobosim.a)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/librobosim.a DESTINATION lib/robosim COMPONENT host)
install(DIRECTORY sim/testing DESTINATION share/robosim/source/sim COMPONENT host
  FILES_MATCHING PATTERN *.h PATTERN *.cpp)
foreach(folder
    sim/base sim/map sim/result sim/wire sim/build sim/run/trace sim/launch sim/record sim/campaign/analysis sim/campaign/random_worlds
    sim/view/terminal hal/board)
  install(DIRECTORY ${folder}/ DESTINATION share/robosim/source/${folder} COMPONENT host FILES_MATCHING PATTERN *.h)
endforeach()
include(CMakePackageConfigHelpers)
configure_package_config_file(toolchain/cmake/robosim-config.cmake.in robosim-config.cmake
  INSTALL_DESTINATION lib/cmake/robosim)
write_basic_package_version_file(robosim-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/robosim-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/robosim-config-version.cmake
  toolchain/cmake/robosim_functions.cmake toolchain/cmake/test_setup.cpp DESTINATION lib/cmake/robosim COMPONENT host)

set(CPACK_COMPONENTS_ALL host)
foreach(target avr stm32)
  if(TARGET robosim-${target})
    install(TARGETS robosim-${target} DESTINATION libexec/robosim COMPONENT ${target})
    install(FILES toolchain/licences/robosim-${target}.copyright DESTINATION share/doc/robosim-${target}
      RENAME copyright COMPONENT ${target})
    list(APPEND CPACK_COMPONENTS_ALL ${target})
  endif()
endforeach()

set(CPACK_GENERATOR DEB)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_PACKAGE_NAME robosim)
set(CPACK_PACKAGE_CONTACT "Robosim's maintainers <maintainers@robosim.invalid>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(libraries "")
set(libelf "")
set(libnlopt "")
if(CMAKE_CROSSCOMPILING)  # dpkg-shlibdeps handles only the libraries of this machine
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS OFF)
  set(CPACK_DEBIAN_PACKAGE_ARCHITECTURE ${ROBOSIM_PI_ARCHITECTURE})
  set(libraries ", libc6 (>= 2.34), libgcc-s1, libstdc++6 (>= 11), libseccomp2, zlib1g")
  set(libelf ", libelf1 | libelf1t64")
  set(libnlopt ", libnlopt0")
endif()
set(CPACK_DEBIAN_PACKAGE_SECTION electronics)
set(CPACK_DEBIAN_PACKAGE_HOMEPAGE "")

# The command's package depends on the packages that compile sketches. ROBOSIM_PORTABLE links the libraries statically,
# so that one package serves both Debian 12 and 13.
set(CPACK_DEBIAN_HOST_PACKAGE_NAME robosim)
set(CPACK_DEBIAN_HOST_DESCRIPTION "Firmware test harness for line-follower robots
 Takes an Arduino sketch as it is, lets it drive a simulated robot over a floor drawn as text, and judges the run.")
set(CPACK_DEBIAN_HOST_PACKAGE_DEPENDS "g++, binutils, arduino-ctags, arduino-core-avr${libraries}${libelf}${libnlopt}")
set(CPACK_DEBIAN_HOST_PACKAGE_RECOMMENDS "cmake, make, libgmock-dev, libfmt-dev, libelf-dev")  # for C++ tests
set(CPACK_DEBIAN_HOST_PACKAGE_SUGGESTS "robosim-avr, robosim-stm32, avrdude")
set(CPACK_DEBIAN_AVR_PACKAGE_NAME robosim-avr)
set(CPACK_DEBIAN_AVR_DESCRIPTION "Robosim's target avr
 Runs the very image that is flashed to an Arduino Uno or Nano, in an emulator, on Robosim's simulated robots.")
set(CPACK_DEBIAN_AVR_PACKAGE_DEPENDS "robosim (= ${PROJECT_VERSION})${libraries}")
set(CPACK_DEBIAN_STM32_PACKAGE_NAME robosim-stm32)
set(CPACK_DEBIAN_STM32_DESCRIPTION "Robosim's target stm32
 Compiles sketches for the STM32F103 \"Blue Pill\" and runs the image in an emulator, on Robosim's simulated robots.")
set(CPACK_DEBIAN_STM32_PACKAGE_DEPENDS "robosim (= ${PROJECT_VERSION}), gcc-arm-none-eabi, libnewlib-arm-none-eabi${libraries}")
include(CPack)
