# Runs EXAMPLE with and without ambient occlusion and compares the pictures: the sky is the same, open
# ground nearly so, and the foot of the boxes is darker.
cmake_minimum_required(VERSION 3.22)
foreach(kind with without)
    set(flag "")
    if(kind STREQUAL without)
        set(flag --without)
    endif()
    file(REMOVE ${PICTURE}-${kind}.ppm)
    execute_process(COMMAND ${EXAMPLE} ${flag} ${PICTURE}-${kind}.ppm
        RESULT_VARIABLE result ERROR_VARIABLE message)
    if(message MATCHES "NOT TESTED")
        message(STATUS "${message}")
        return()
    endif()
    if(NOT result EQUAL 0)
        message(FATAL_ERROR "${EXAMPLE} failed (${result}): ${message}")
    endif()
    file(READ ${PICTURE}-${kind}.ppm header LIMIT 15)
    if(NOT header STREQUAL "P6\n480 270\n255\n")
        message(FATAL_ERROR "${PICTURE}-${kind}.ppm begins with ${header}")
    endif()
endforeach()

# The red value of a pixel, rows from the top.
function(red_at kind x y value)
    math(EXPR offset "15 + 3 * (${y} * 480 + ${x})")
    file(READ ${PICTURE}-${kind}.ppm byte OFFSET ${offset} LIMIT 1 HEX)
    math(EXPR number "0x${byte}")
    set(${value} ${number} PARENT_SCOPE)
endfunction()

# The value with ambient occlusion lies between shares of that without, in percent.
function(between what x y least most)
    red_at(with ${x} ${y} with)
    red_at(without ${x} ${y} without)
    math(EXPR low "${without} * ${least}")
    math(EXPR high "${without} * ${most}")
    math(EXPR found "${with} * 100")
    if(found LESS low OR found GREATER high OR without LESS 40)
        message(SEND_ERROR "${what} at ${x}, ${y}: ${with} with, ${without} without; "
            "expected ${least} to ${most} percent")
    endif()
endfunction()

between("sky" 20 20 100 100)
between("open ground" 470 250 95 100)
between("ground at the foot of the tallest boxes" 240 182 20 92)
