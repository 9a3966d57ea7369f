# embed_assets(TARGET NAMESPACE FOLDER HEADERS header... CONTENTS "NAME:file,file"...): adds a source
# to TARGET that defines each string_view NAME, which some header declares, as the contents of files of
# FOLDER one after the other; so programs need none of the files where they are installed.
function(embed_assets TARGET NAMESPACE FOLDER)
  cmake_parse_arguments(PARSE_ARGV 3 ARG "" "" "HEADERS;CONTENTS")
  set(TEXT "")
  foreach(HEADER ${ARG_HEADERS})
    string(APPEND TEXT "#include \"${HEADER}\"\n")
  endforeach()
  string(APPEND TEXT "namespace ${NAMESPACE} {\n")
  foreach(CONTENT ${ARG_CONTENTS})
    string(REPLACE ":" ";" PARTS ${CONTENT})
    list(GET PARTS 0 NAME)
    list(GET PARTS 1 FILES)
    string(REPLACE "," ";" FILES ${FILES})
    # Compilers limit the length of one literal (C++ promises 65536 characters), none of the files
    # comes near it.
    set(LITERALS "")
    foreach(FILE ${FILES})
      file(READ ${FOLDER}/${FILE} BYTES)
      set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${FOLDER}/${FILE})
      string(APPEND LITERALS " R\"_asset_(${BYTES})_asset_\"")
    endforeach()
    string(APPEND TEXT "const std::string_view ${NAME} =${LITERALS};\n")
  endforeach()
  string(APPEND TEXT "}  // namespace ${NAMESPACE}\n")
  set(SOURCE ${CMAKE_CURRENT_BINARY_DIR}/${TARGET}_assets.cc)
  file(WRITE ${SOURCE}.new "${TEXT}")
  configure_file(${SOURCE}.new ${SOURCE} COPYONLY)  # touched only where it changes
  target_sources(${TARGET} PRIVATE ${SOURCE})
endfunction()
