# Runs EXAMPLE without a window and looks at the PICTURE it writes: the size, and three pixels.
cmake_minimum_required(VERSION 3.22)
file(REMOVE ${PICTURE})
execute_process(COMMAND ${EXAMPLE} --headless --frames 3 --screenshot ${PICTURE}
    RESULT_VARIABLE result ERROR_VARIABLE message)
if(NOT result EQUAL 0)
    message(FATAL_ERROR "${EXAMPLE} failed (${result}): ${message}")
endif()

file(READ ${PICTURE} header LIMIT 15)
if(NOT header STREQUAL "P6\n960 540\n255\n")
    message(FATAL_ERROR "${PICTURE} begins with ${header}")
endif()

# The red value of a pixel, rows from the top.
function(red_at x y value)
    math(EXPR offset "15 + 3 * (${y} * 960 + ${x})")
    file(READ ${PICTURE} byte OFFSET ${offset} LIMIT 1 HEX)
    math(EXPR number "0x${byte}")
    set(${value} ${number} PARENT_SCOPE)
endfunction()

red_at(40 40 sky)
red_at(940 500 open)    # ground with nothing near it
red_at(480 364 contact) # ground at the foot of the two tallest boxes
if(NOT sky EQUAL 153)
    message(FATAL_ERROR "${PICTURE}: the sky is not the host's 153 but ${sky}: it was darkened")
endif()
if(open LESS 190)
    message(FATAL_ERROR "${PICTURE}: open ground is ${open}, but nothing is near it")
endif()
math(EXPR most "${open} * 85 / 100")
if(contact GREATER most)
    message(FATAL_ERROR "${PICTURE}: ground at the foot of boxes is ${contact}, open ground ${open}")
endif()
