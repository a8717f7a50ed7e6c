# Builds WebAssembly for a browser tab with Debian's emscripten, which includes compiled system libraries.
set(emscripten /usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake)
if(NOT EXISTS ${emscripten})
  message(FATAL_ERROR "The tab needs the Debian package emscripten: toolchain/packages.sh tab")
endif()
include(${emscripten})

# Emscripten needs Node's module acorn from Debian, which Node versions other than Debian's do not find by
# themselves.
set(CMAKE_CXX_LINKER_LAUNCHER ${CMAKE_COMMAND} -E env NODE_PATH=/usr/share/nodejs)
