# Fails when a file includes a room that lies above or beside its own, or a public header names GL.
#
#   cmake -DSOURCE_DIR=<root> -P CheckIncludes.cmake
cmake_minimum_required(VERSION 3.22)

set(faults "")

# Files in `folder` (and below it, but for folders that have a rule of their own) may include, of the
# library's rooms, only those named after ALLOW, and their own.
set(rooms "")
function(room folder)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "ALLOW")
    set(rooms "${rooms};${folder}" PARENT_SCOPE)
    set(allow_${folder} "${arg_ALLOW}" PARENT_SCOPE)
endfunction()

# The arrows. A room may include what stands after ALLOW, all of it below.
room(scene)
room(gl)
room(backbone/frame ALLOW gl scene)
room(backbone/estimators ALLOW gl scene)
room(backbone/cubemaps ALLOW backbone/frame backbone/estimators gl scene)
room(backbone/passes ALLOW backbone/cubemaps backbone/frame backbone/estimators gl scene)
room(backbone/texels ALLOW backbone/cubemaps backbone/frame backbone/estimators gl scene)
room(backbone/refine ALLOW backbone/passes backbone/texels backbone/cubemaps backbone/frame
    backbone/estimators gl scene)
room(backbone ALLOW backbone/refine backbone/passes backbone/texels backbone/cubemaps backbone/frame
    backbone/estimators gl scene)
room(raytracing ALLOW scene)
room(reference ALLOW scene raytracing)
room(bake ALLOW scene gl raytracing reference)
room(lighting ALLOW gl)
room(platform)

# The room that a path below src lies in: the longest that matches; empty for the facade's own files.
function(find_room path result)
    set(found "")
    foreach(one IN LISTS rooms)
        string(LENGTH "${one}" length)
        string(LENGTH "${found}" best)
        string(FIND "${path}" "${one}/" at)
        if(at EQUAL 0 AND length GREATER best)
            set(found "${one}")
        endif()
    endforeach()
    set(${result} "${found}" PARENT_SCOPE)
endfunction()

file(GLOB_RECURSE files RELATIVE ${SOURCE_DIR}/src ${SOURCE_DIR}/src/*.h ${SOURCE_DIR}/src/*.cpp)
foreach(file IN LISTS files)
    find_room("${file}" own)
    if(own STREQUAL "")
        continue() # the facade may include every room
    endif()
    set(seen_${own} TRUE)
    file(STRINGS ${SOURCE_DIR}/src/${file} includes REGEX "^[ \t]*#[ \t]*include[ \t]*\"")
    foreach(line IN LISTS includes)
        string(REGEX REPLACE ".*\"(.*)\".*" "\\1" target "${line}")
        find_room("${target}" other)
        if(NOT other STREQUAL "" AND NOT other STREQUAL own AND NOT other IN_LIST allow_${own})
            string(APPEND faults "src/${file}: ${line}\n    ${own} may include: ${allow_${own}}\n")
        endif()
    endforeach()
endforeach()
foreach(one IN LISTS rooms)
    if(one AND NOT seen_${one})
        message(FATAL_ERROR "src/${one} holds no source files; the rule about it is out of date")
    endif()
endforeach()

# Each file below `folder` must not have an include that matches `pattern`.
function(forbid folder pattern why)
    file(GLOB_RECURSE files ${SOURCE_DIR}/${folder}/*.h ${SOURCE_DIR}/${folder}/*.cpp)
    if(NOT files)
        message(FATAL_ERROR "${folder} holds no source files; the rule about it is out of date")
    endif()
    foreach(file IN LISTS files)
        file(STRINGS ${file} includes REGEX "^[ \t]*#[ \t]*include")
        foreach(line IN LISTS includes)
            if(line MATCHES "${pattern}")
                string(APPEND faults "${file}: ${line}\n    ${why}\n")
            endif()
        endforeach()
    endforeach()
    set(faults "${faults}" PARENT_SCOPE)
endfunction()

forbid(include "[<\"](GL|GLES|EGL|GLFW|glad|epoxy|embree|tiny_gltf)" "public headers name no GL and no third party but GLM")
forbid(include "\"" "public headers include public headers only")
forbid(tools/content "\"(gl|backbone|platform|reference|bake|host|app)/" "content is data, no GL")
forbid(tools/bench "\"app/" "benchmarks do not depend on the command line")
forbid(tools/image "\"(gl|backbone|platform|reference|host|app|content)/" "images depend on no other room")

if(faults)
    message(FATAL_ERROR "includes against the architecture:\n${faults}")
endif()
