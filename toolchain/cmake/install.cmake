# `cmake --install` and CPack: what an installed Robosim is made of. sim/base/file.h says how it finds it.
# One component for each licence: host (MIT), avr (GPL-3 by libsimavr), stm32 (GPL-2 by Unicorn); each a Debian package.
if(NOT TARGET robosim OR NOT TARGET robosim-host)
  return()
endif()

install(TARGETS robosim DESTINATION bin COMPONENT host)
install(TARGETS robosim-host DESTINATION libexec/robosim COMPONENT host)
install(DIRECTORY sim/classic/include DESTINATION share/robosim/sim/classic COMPONENT host)
install(DIRECTORY docs/examples DESTINATION share/robosim COMPONENT host)
install(DIRECTORY hal firmware maps DESTINATION share/robosim COMPONENT host PATTERN CMakeLists.txt EXCLUDE)
install(DIRECTORY sim/robot/stock/ DESTINATION share/robosim/robots COMPONENT host)
install(FILES README.md LICENSE DESTINATION share/doc/robosim COMPONENT host)

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
set(CPACK_PACKAGE_NAME robosim)
set(CPACK_PACKAGE_CONTACT "Robosim's maintainers <maintainers@robosim.invalid>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SECTION electronics)
set(CPACK_DEBIAN_PACKAGE_HOMEPAGE "")

# What a sketch is compiled with. The libraries are linked in (ROBOSIM_PORTABLE), so that one package serves Debian 12
# and 13 alike.
set(CPACK_DEBIAN_HOST_PACKAGE_NAME robosim)
set(CPACK_DEBIAN_HOST_DESCRIPTION "Firmware test harness for line-follower robots
 Takes an Arduino sketch as it is, lets it drive a simulated robot over a floor drawn as text, and judges the run.")
set(CPACK_DEBIAN_HOST_PACKAGE_DEPENDS "g++, binutils, arduino-ctags, arduino-core-avr")
set(CPACK_DEBIAN_HOST_PACKAGE_SUGGESTS "robosim-avr, robosim-stm32, libgmock-dev, cmake, avrdude")
set(CPACK_DEBIAN_AVR_PACKAGE_NAME robosim-avr)
set(CPACK_DEBIAN_AVR_DESCRIPTION "Robosim's target avr
 Runs the very image that is flashed to an Arduino Uno or Nano, in an emulator, on Robosim's simulated robots.")
set(CPACK_DEBIAN_AVR_PACKAGE_DEPENDS "robosim (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_STM32_PACKAGE_NAME robosim-stm32)
set(CPACK_DEBIAN_STM32_DESCRIPTION "Robosim's target stm32
 Compiles sketches for the STM32F103 \"Blue Pill\" and runs the image in an emulator, on Robosim's simulated robots.")
set(CPACK_DEBIAN_STM32_PACKAGE_DEPENDS "robosim (= ${PROJECT_VERSION}), gcc-arm-none-eabi, libnewlib-arm-none-eabi")
include(CPack)
