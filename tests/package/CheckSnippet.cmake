# PAGE shows the file SNIPPET as it is.
cmake_minimum_required(VERSION 3.22)
file(READ ${SNIPPET} snippet)
file(READ ${PAGE} page)
string(FIND "${page}" "```cmake\n${snippet}```\n" place)
if(place EQUAL -1)
    message(FATAL_ERROR "${PAGE} does not show ${SNIPPET}")
endif()
