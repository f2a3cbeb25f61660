# Makes one C++ file of all shader stages: includes resolved, one string per stage, no tool but CMake.
#
#   cmake -DSHADER_DIR=<dir> -DSTAGES=<a.vert,b.frag,...> -DOUTPUT=<file.cpp>
#         -DTYPE=<struct> -DHEADER=<header> -P EmbedShaders.cmake
#
# It holds the array k<TYPE>s, of structs <TYPE>, as HEADER declares both.
#
# `#include "path"` is relative to SHADER_DIR; a file is included once per stage. `#line` gives the
# compiler's messages the line and the number of the file; the table of names is embedded beside.

cmake_minimum_required(VERSION 3.22)

function(resolve path)
    list(LENGTH files index)
    list(APPEND files ${path})
    set(files "${files}" PARENT_SCOPE)
    file(READ "${SHADER_DIR}/${path}" rest)
    set(line 1)
    set(text "")
    if(index GREATER 0)
        set(text "#line 1 ${index}\n")
    endif()
    while(rest MATCHES "(^|\n)#include \"([^\"]+)\"[^\n]*")
        set(directive "${CMAKE_MATCH_0}")
        set(included "${CMAKE_MATCH_2}")
        string(FIND "${rest}" "${directive}" position)
        string(LENGTH "${directive}" length)
        string(SUBSTRING "${rest}" 0 ${position} before)
        math(EXPR position "${position} + ${length}")
        string(SUBSTRING "${rest}" ${position} -1 rest)
        string(APPEND text "${before}\n")
        string(REGEX REPLACE "[^\n]" "" newlines "${before}${directive}")
        string(LENGTH "${newlines}" count)
        math(EXPR line "${line} + ${count}")
        if(NOT included IN_LIST files)
            resolve(${included})
            string(APPEND text "${resolved}")
        endif()
        math(EXPR next "${line} + 1")
        string(REGEX REPLACE "^\n" "" rest "${rest}")
        string(APPEND text "#line ${next} ${index}\n")
        set(line ${next})
    endwhile()
    set(resolved "${text}${rest}" PARENT_SCOPE)
    set(files "${files}" PARENT_SCOPE)
endfunction()

string(REPLACE "," ";" STAGES "${STAGES}")
set(content "// Made by cmake/EmbedShaders.cmake from shaders/.\n#include \"${HEADER}\"\n\n#include <iterator>\n\n")
string(APPEND content "namespace aolib {\n\nconst ${TYPE} k${TYPE}s[] = {\n")
foreach(stage IN LISTS STAGES)
    set(files "")
    resolve(${stage})
    string(REPLACE ";" " " names "${files}")
    string(APPEND content "{\"${stage}\", \"${names}\", R\"GLSL(${resolved})GLSL\"},\n")
endforeach()
string(APPEND content "};\n\nconst std::size_t k${TYPE}Count = std::size(k${TYPE}s);\n\n} // namespace aolib\n")
file(WRITE "${OUTPUT}" "${content}")
