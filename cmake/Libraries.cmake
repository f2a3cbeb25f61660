# The libraries that packages hold: aolib itself and its components.
include(GenerateExportHeader)

# What every library of aolib's has, and every object library that goes into one.
function(aolib_library_properties target)
    target_compile_features(${target} PUBLIC cxx_std_20)
    set_target_properties(${target} PROPERTIES
        POSITION_INDEPENDENT_CODE ON
        CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
endfunction()

# aolib_add_room(NAME SOURCE...): the object library aolib_NAME, a room of the tree below src.
function(aolib_add_room name)
    set(target aolib_${name})
    add_library(${target} OBJECT EXCLUDE_FROM_ALL ${ARGN})
    aolib_library_properties(${target})
    target_include_directories(${target} PUBLIC ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/include
        ${PROJECT_BINARY_DIR}/include)
    target_link_libraries(${target} PUBLIC glm::glm)
endfunction()

# aolib_add_library(TARGET EXPORT_HEADER SOURCE...): a library that is installed. It exports through
# <aolib/EXPORT_HEADER.h>: TARGET_EXPORT, and TARGET_STATIC_DEFINE for who links it where it is static.
function(aolib_add_library target export_header)
    add_library(${target} ${ARGN})
    aolib_library_properties(${target})
    set_target_properties(${target} PROPERTIES VERSION ${PROJECT_VERSION} SOVERSION ${AOLIB_SOVERSION})
    string(TOUPPER ${target} prefix)
    generate_export_header(${target} BASE_NAME ${prefix} EXPORT_MACRO_NAME ${prefix}_EXPORT
        EXPORT_FILE_NAME ${PROJECT_BINARY_DIR}/include/aolib/${export_header}.h)
    get_target_property(type ${target} TYPE)
    if(type STREQUAL STATIC_LIBRARY)
        target_compile_definitions(${target} PUBLIC ${prefix}_STATIC_DEFINE)
    endif()
endfunction()

# aolib_add_component(NAME EXPORT_HEADER SOURCE...): the optional library aolib_NAME, for its users
# aolib::NAME. It links aolib, which does not link it.
function(aolib_add_component name export_header)
    set(target aolib_${name})
    aolib_add_library(${target} ${export_header} ${ARGN})
    add_library(aolib::${name} ALIAS ${target})
    if(NOT PROJECT_IS_TOP_LEVEL AND NOT AOLIB_INSTALL)
        # Within another project: built where it is linked.
        set_target_properties(${target} PROPERTIES EXCLUDE_FROM_ALL ON)
    endif()
    target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/shaders)
    target_link_libraries(${target} PUBLIC aolib)
endfunction()

# aolib_embed_shaders(FILE TYPE HEADER STAGES stage... DEPENDS file...): the command that makes FILE of
# stages below shaders/, as EmbedShaders.cmake has it.
function(aolib_embed_shaders file type header)
    cmake_parse_arguments(PARSE_ARGV 3 embed "" "" "STAGES;DEPENDS")
    list(JOIN embed_STAGES "," stages)
    add_custom_command(OUTPUT ${file}
        COMMAND ${CMAKE_COMMAND} -DSHADER_DIR=${PROJECT_SOURCE_DIR}/shaders -DSTAGES=${stages}
                -DOUTPUT=${file} -DTYPE=${type} -DHEADER=${header}
                -P ${PROJECT_SOURCE_DIR}/cmake/EmbedShaders.cmake
        DEPENDS ${embed_DEPENDS} ${PROJECT_SOURCE_DIR}/cmake/EmbedShaders.cmake
        COMMENT "Embedding shaders: k${type}s")
endfunction()
