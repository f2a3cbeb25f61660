# With a contrast of 0 aolib does all its work and changes no pixel: OpenSceneGraph draws the very same
# pictures, the second of two frames as well. The sign that it draws after them is never darkened.
cmake_minimum_required(VERSION 3.22)
foreach(kind without neutral)
    execute_process(COMMAND ${EXAMPLE} --${kind} ${PICTURE}-${kind}.ppm
        RESULT_VARIABLE result ERROR_VARIABLE message)
    if(NOT result EQUAL 0)
        message(FATAL_ERROR "${EXAMPLE} --${kind} failed (${result}): ${message}")
    endif()
endforeach()
file(SHA256 ${PICTURE}-without.ppm without)
file(SHA256 ${PICTURE}-neutral.ppm neutral)
if(NOT without STREQUAL neutral)
    message(FATAL_ERROR "${PICTURE}-neutral.ppm is not what OpenSceneGraph draws by itself")
endif()
execute_process(COMMAND ${EXAMPLE} ${PICTURE}.ppm RESULT_VARIABLE result)
foreach(kind -without "")
    # The middle of the sign, rows from the top.
    math(EXPR offset "15 + 3 * (240 * 480 + 30)")
    file(READ ${PICTURE}${kind}.ppm sign${kind} OFFSET ${offset} LIMIT 3 HEX)
endforeach()
if(NOT sign STREQUAL sign-without OR NOT sign STREQUAL "ff0000")
    message(FATAL_ERROR "the sign is ${sign}, not ${sign-without}")
endif()
