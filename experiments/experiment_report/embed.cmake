# Writes the files of assets/ into a source of their own, so that the program needs none of them
# where it is installed, and adds it to experiment_report_lib.
find_package(ZLIB REQUIRED)

set(ASSETS ${CMAKE_CURRENT_LIST_DIR}/assets)
set(EMBEDDED "#include \"experiments/experiment_report/html.h\"\n")
string(APPEND EMBEDDED "namespace cirque::experiment_report {\n")

# Adds NAME, the contents of FILES one after the other. Compilers limit the length of one literal
# (C++ promises 65536 characters), none of these files comes near it.
function(embed NAME)
  set(LITERALS "")
  foreach(FILE ${ARGN})
    file(READ ${ASSETS}/${FILE} CONTENT)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${ASSETS}/${FILE})
    string(APPEND LITERALS " R\"_asset_(${CONTENT})_asset_\"")
  endforeach()
  string(APPEND EMBEDDED "const std::string_view ${NAME} =${LITERALS};\n")
  set(EMBEDDED "${EMBEDDED}" PARENT_SCOPE)
endfunction()

embed(kStyle style.css)
embed(kTableScript tables.js)
embed(kViewerHtml viewer.html)
embed(kViewerScript mesh_payload.js shaders.js surface_view.js viewer.js)
embed(kFiguresScript figures.py)
string(APPEND EMBEDDED "}  // namespace cirque::experiment_report\n")
set(SOURCE ${CMAKE_CURRENT_BINARY_DIR}/experiment_report_assets.cc)
file(WRITE ${SOURCE}.new "${EMBEDDED}")
configure_file(${SOURCE}.new ${SOURCE} COPYONLY)  # touched only where it changes
target_sources(experiment_report_lib PRIVATE ${SOURCE})
target_link_libraries(experiment_report_lib PUBLIC ZLIB::ZLIB)
