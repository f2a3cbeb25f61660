# Fails when a file includes a room that lies above its own, or a public header names GL.
#
#   cmake -DSOURCE_DIR=<root> -P CheckIncludes.cmake
cmake_minimum_required(VERSION 3.22)

set(faults "")

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
forbid(src/scene "\"(gl|backbone|platform|parallel|raytracing|reference|bake)/" "scene knows nobody above it")
forbid(src/gl "\"(scene|backbone|platform|parallel|raytracing|reference|bake)/" "gl knows nobody above it")
forbid(src/backbone "\"(platform|parallel|raytracing|reference|bake)/" "backbones know scene and gl alone")
forbid(src/raytracing "\"(gl|backbone|platform|reference|bake)/" "rays know the scene and loops alone")
forbid(src/reference "\"(gl|backbone|platform|bake)/" "the truth knows the scene, rays and loops alone")
forbid(src/bake "\"(backbone|platform|reference)/" "bakers know the scene, gl, rays and loops alone")
forbid(src/parallel "\"(scene|gl|backbone|platform|raytracing|reference|bake|lighting)/" "loops know no other room")
forbid(src/lighting "\"(scene|backbone|platform|parallel|raytracing|reference|bake)/" "light knows gl alone")
forbid(src/platform "\"(gl|scene|backbone|parallel|raytracing|reference|bake)/" "contexts know nothing of the library's rooms")
forbid(src/backbone/screenspace "\"backbone/cubemapped/" "one backbone does not know another")
forbid(src/backbone/cubemapped "\"backbone/screenspace/" "one backbone does not know another")
forbid(tools/content "\"(gl|backbone|platform|reference|bake|host|app)/" "content is data, no GL")
forbid(tools/bench "\"app/" "what is measured knows nothing of the command line")
forbid(tools/image "\"(gl|backbone|platform|reference|host|app|content)/" "image knows nobody")

if(faults)
    message(FATAL_ERROR "includes against the architecture:\n${faults}")
endif()
