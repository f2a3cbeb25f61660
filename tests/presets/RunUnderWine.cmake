# Runs the program EXAMPLE of the preset mingw by wine, on a display of its own, and looks at its
# pictures as at those of every example. Where REFERENCE is given, its pictures are the same, bit by bit.
#   -DEXAMPLE= -DWORK= -DWINE= -DXVFB_RUN= -DCHECK= [-DREFERENCE=]
cmake_minimum_required(VERSION 3.22)
file(MAKE_DIRECTORY ${WORK})
set(ENV{WINEPREFIX} ${WORK}/prefix)
set(ENV{WINEDEBUG} -all)
set(ENV{WINEDLLOVERRIDES} "mscoree=;mshtml=") # no offer to install .NET and a browser
set(ENV{LIBGL_ALWAYS_SOFTWARE} 1)
set(PICTURE ${WORK}/picture)
set(program ${EXAMPLE})
set(EXAMPLE ${XVFB_RUN} -a -s "-screen 0 1280x1024x24" ${WINE} ${program})
include(${CHECK})
if(NOT REFERENCE OR NOT EXISTS ${PICTURE}-with.ppm)
    return()
endif()
foreach(kind with without)
    set(flag "")
    if(kind STREQUAL without)
        set(flag --without)
    endif()
    execute_process(COMMAND ${REFERENCE} ${flag} ${WORK}/reference-${kind}.ppm
        RESULT_VARIABLE result ERROR_VARIABLE message)
    if(message MATCHES "NOT TESTED")
        message(STATUS "${message}")
        return()
    endif()
    execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${WORK}/reference-${kind}.ppm
        ${PICTURE}-${kind}.ppm RESULT_VARIABLE differ)
    if(NOT result EQUAL 0 OR NOT differ EQUAL 0)
        message(SEND_ERROR "${PICTURE}-${kind}.ppm differs from ${WORK}/reference-${kind}.ppm")
    endif()
endforeach()
