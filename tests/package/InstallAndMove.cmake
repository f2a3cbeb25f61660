# Installs BUILD's libraries below a first prefix and moves them to PREFIX: nothing may remember where
# it was.
cmake_minimum_required(VERSION 3.22)
file(REMOVE_RECURSE ${PREFIX} ${PREFIX}-first)
foreach(component runtime development)
    execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${PREFIX}-first
            --component ${component} --config "${TYPE}"
        RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(NOT result EQUAL 0)
        message(FATAL_ERROR "cmake --install ${BUILD} (${component}) failed:\n${output}")
    endif()
endforeach()
file(RENAME ${PREFIX}-first ${PREFIX})

file(GLOB_RECURSE files ${PREFIX}/*)
foreach(file IN LISTS files)
    if(file MATCHES "\\.(cmake|pc|h)$")
        file(READ ${file} text)
        foreach(path ${PREFIX}-first ${BUILD} ${SOURCE}/)
            string(FIND "${text}" "${path}" place)
            if(NOT place EQUAL -1)
                message(SEND_ERROR "${file} names ${path}")
            endif()
        endforeach()
    endif()
endforeach()
if(NOT files MATCHES "aolib/Export\\.h")
    message(SEND_ERROR "Export.h was not installed")
endif()
