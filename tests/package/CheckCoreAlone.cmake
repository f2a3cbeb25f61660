# What the README says builds the core alone compiles no file of a component, and so does a guest who
# links aolib::aolib and installs nothing.
#   -DSOURCE= -DGUEST= -DWORK= -DCOMPILER=
cmake_minimum_required(VERSION 3.22)
file(STRINGS ${SOURCE}/README.md command REGEX "^cmake -S \\. -B build/core ")
list(LENGTH command count)
if(NOT count EQUAL 1)
    message(FATAL_ERROR "README.md has ${count} commands for the core alone")
endif()
string(REGEX MATCHALL "-DAOLIB[A-Z_]+=[A-Z]+" readme "${command}")

# Configures `source` and lists the commands that a build needs.
function(check what source)
    execute_process(COMMAND ${CMAKE_COMMAND} -S ${source} -B ${WORK}/${what} -G Ninja
            -DCMAKE_CXX_COMPILER=${COMPILER} ${ARGN}
        RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(NOT result EQUAL 0)
        message(FATAL_ERROR "${what}: configuring failed (${result}):\n${output}")
    endif()
    execute_process(COMMAND ${CMAKE_COMMAND} --build ${WORK}/${what} -- -t commands
        RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(NOT result EQUAL 0 OR NOT output MATCHES "aolib_backbone")
        message(FATAL_ERROR "${what}: there is nothing to build (${result}):\n${output}")
    endif()
    if(output MATCHES "aolib_(raytracing|rays|loop|bake|lighting|platform)[./]")
        message(SEND_ERROR "${what} builds aolib_${CMAKE_MATCH_1}, too:\n${output}")
    endif()
endfunction()

file(REMOVE_RECURSE ${WORK})
check(readme ${SOURCE} ${readme})
check(guest ${GUEST} -DAOLIB_SOURCE=${SOURCE})
