# cmake -DFOLDER=sim/view/page -DOUT=page_text.cpp -P bundle_page.cmake
#
# Bundles the page: inserts style.css and the modules into page.html. Embeds the result in a C++ source,
# unless OUT is an .html file. A module may import names from modules that are earlier in the list. All
# modules share one scope, so the top levels of two modules must not define the same name. A browser reports
# such a name immediately.
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

# Writes one literal for each line, because compilers limit a literal's length.
string(REPLACE "\n" ")page~\" \"\\n\"\nR\"page~(" page "${page}")
file(WRITE ${OUT} "#include \"sim/record/page_text.h\"

std::string_view robosim::record::page_text() {
  return
R\"page~(${page})page~\";
}
")
