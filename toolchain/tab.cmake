# WebAssembly for a browser's tab, by Debian's emscripten. Its system libraries come compiled with the package.
set(emscripten /usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake)
if(NOT EXISTS ${emscripten})
  message(FATAL_ERROR "The tab needs the Debian package emscripten: toolchain/packages.sh tab")
endif()
include(${emscripten})

# A node that is not Debian's does not find Debian's modules, of which emscripten needs acorn.
set(CMAKE_CXX_LINKER_LAUNCHER ${CMAKE_COMMAND} -E env NODE_PATH=/usr/share/nodejs)
