# cmake -DFILES=a.html;b.js -DHEADER=… -DNAMESPACE=… -DOUT=texts.cpp -P embed_texts.cmake
#
# Embeds text files in a C++ source. For a.html, the source defines the function `std::string_view a_html()`.
set(source "#include \"${HEADER}\"\n")
foreach(path ${FILES})
  get_filename_component(name ${path} NAME)
  string(MAKE_C_IDENTIFIER ${name} function)
  file(READ ${path} text)
  # Writes one literal for each line, because compilers limit a literal's length.
  string(REPLACE "\n" ")text~\" \"\\n\"\nR\"text~(" text "${text}")
  string(APPEND source "\nstd::string_view ${NAMESPACE}::${function}() {\n  return\nR\"text~(${text})text~\";\n}\n")
endforeach()
file(WRITE ${OUT} "${source}")
