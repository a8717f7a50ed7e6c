# Shortens the first build, without changing the behaviour of the programs.

# Uses less optimisation for code that takes little of a run's time. Compiling this code takes two thirds of
# the build's time.
set(quick $<$<CONFIG:Release>:-O1>)
foreach(library project build course print calibrate launch play wiring mutate terminal client record
    statistics analysis campaign_options rerun campaign cli cli_campaign serve wire runner map course base scenario)
  if(TARGET robosim_${library})
    target_compile_options(robosim_${library} PRIVATE ${quick})
  endif()
endforeach()
# Each character of a map passes through the loops of map_parser.cpp. With these options, map_parser.cpp
# cannot use the precompiled header, which is compiled without them.
set_source_files_properties(${PROJECT_SOURCE_DIR}/sim/map/map_parser.cpp TARGET_DIRECTORY robosim_map
  PROPERTIES COMPILE_OPTIONS $<$<CONFIG:Release>:-O3> SKIP_PRECOMPILE_HEADERS ON)

# With more than 3 GB of memory per processor, gcc starts to collect garbage at 2 GB. This saves a tenth of
# the build's time.
if(ROBOSIM_AMPLE_MEMORY)
  target_compile_options(robosim_options INTERFACE $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=2000000>)
endif()

# Groups the files that use nlohmann-json, whose templates take a compiler about 5 s. Files that are compiled
# together share this time.
foreach(library course record campaign cli cli_campaign)
  get_target_property(sources robosim_${library} SOURCES)
  set(with_json "")
  foreach(source ${sources})
    set(json "")
    if(EXISTS ${source})
      file(STRINGS ${source} json REGEX "#include .(nlohmann/json.hpp|sim/wire/json_)" LIMIT_COUNT 1)
    endif()
    if(json)
      list(APPEND with_json ${source})
    endif()
  endforeach()
  list(REMOVE_ITEM sources ${with_json})
  set_target_properties(robosim_${library} PROPERTIES SOURCES "${with_json};${sources}")
endforeach()

# Precompiles the headers of the standard library and fmt for each level of optimisation. This saves about 2 s
# for each file. ccache caches files that use precompiled headers only if its sloppiness is set.
if(CMAKE_CXX_COMPILER_LAUNCHER MATCHES ccache AND NOT "$ENV{CCACHE_SLOPPINESS}" MATCHES pch_defines)
  return()
endif()
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/headers.cpp "")
foreach(level usual quick)
  add_library(robosim_headers_${level} OBJECT ${CMAKE_CURRENT_BINARY_DIR}/headers.cpp)
  target_link_libraries(robosim_headers_${level} PRIVATE robosim_options fmt::fmt)
  target_precompile_headers(robosim_headers_${level} PRIVATE ${ROBOSIM_SHARED_HEADERS})
endforeach()
target_compile_options(robosim_headers_quick PRIVATE ${quick})
set_target_properties(robosim_headers_usual robosim_headers_quick PROPERTIES ROBOSIM_SHARES_HEADERS ON)

get_property(folders DIRECTORY PROPERTY SUBDIRECTORIES)
list(FILTER folders INCLUDE REGEX "/sim/")
foreach(folder ${folders})
  get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target ${targets})
    get_target_property(type ${target} TYPE)
    get_target_property(libraries ${target} LINK_LIBRARIES)
    get_target_property(options ${target} COMPILE_OPTIONS)
    if(NOT type STREQUAL STATIC_LIBRARY OR NOT fmt::fmt IN_LIST libraries)
      continue()
    endif()
    if(options STREQUAL "${quick}")
      target_precompile_headers(${target} REUSE_FROM robosim_headers_quick)
    elseif(NOT options)
      target_precompile_headers(${target} REUSE_FROM robosim_headers_usual)
    else()
      continue()
    endif()
    set_target_properties(${target} PROPERTIES ROBOSIM_SHARES_HEADERS ON)
  endforeach()
endforeach()
