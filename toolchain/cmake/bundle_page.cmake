# cmake -DFOLDER=sim/page -DOUT=page_text.cpp -P bundle_page.cmake
#
# Makes one file of the page: style.css and the modules are put into page.html, and that into a C++ source, unless OUT
# is an .html itself. A module
# may import from those before it in the list, by name; all modules share one scope then, so that no name at a module's
# top may be there twice (a browser says so at once).
set(modules recording run colours player live fleet view bodies floor timeline charts now pins lists main)

file(READ ${FOLDER}/style.css style)
set(script "")
foreach(module ${modules})
  file(READ ${FOLDER}/${module}.js text)
  string(REGEX REPLACE "import [^;]*;\n" "" text "${text}")
  string(REGEX REPLACE "(^|\n)export " "\\1" text "${text}")
  string(APPEND script "\n// ---- ${module}.js\n${text}")
endforeach()
file(READ ${FOLDER}/page.html page)
string(REPLACE "/* style.css */" "${style}" page "${page}")
string(REPLACE "/* modules */" "${script}" page "${page}")

if(OUT MATCHES "\\.html$")
  file(WRITE ${OUT} "${page}")
  return()
endif()

# A literal a line: compilers have limits for one.
string(REPLACE "\n" ")page~\" \"\\n\"\nR\"page~(" page "${page}")
file(WRITE ${OUT} "#include \"sim/record/page_text.h\"

std::string_view robosim::record::page_text() {
  return
R\"page~(${page})page~\";
}
")
