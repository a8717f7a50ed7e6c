# Builds WebAssembly for a browser tab with Debian's emscripten, which includes compiled system libraries.
set(emscripten /usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake)
if(NOT EXISTS ${emscripten})
  message(FATAL_ERROR "The tab needs the Debian package emscripten: toolchain/packages.sh tab")
endif()
include(${emscripten})

# Emscripten needs the Node module acorn from Debian. A Node that is not Debian's finds the module only with
# this path.
set(CMAKE_CXX_LINKER_LAUNCHER ${CMAKE_COMMAND} -E env NODE_PATH=/usr/share/nodejs)
