# Configures and builds the project SOURCE in WORK and runs its program; where PREFIX is given, aolib
# is to be found below it and nowhere else.
#   -DSOURCE= -DWORK= -DGENERATOR= -DCOMPILER= -DFLAGS= -DTYPE= [-DPREFIX=] [-DLAUNCHER=] [-DRUN=OFF]
#   [-DARGUMENTS=a,b]
cmake_minimum_required(VERSION 3.22)
string(REPLACE "," ";" arguments "${ARGUMENTS}")
if(PREFIX)
    file(REMOVE_RECURSE ${WORK})
    list(APPEND arguments -DCMAKE_PREFIX_PATH=${PREFIX} -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF)
endif()
if(COMPILER)
    list(APPEND arguments -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}
        -DCMAKE_CXX_FLAGS=${FLAGS} -DCMAKE_BUILD_TYPE=${TYPE})
endif()

function(run what)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(NOT result EQUAL 0)
        message(FATAL_ERROR "${SOURCE}: ${what} failed (${result}):\n${output}")
    endif()
    set(output "${output}" PARENT_SCOPE)
endfunction()

run("configuring" ${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK} -G ${GENERATOR} ${arguments})
if(PREFIX AND EXISTS ${WORK}/CMakeCache.txt)
    file(STRINGS ${WORK}/CMakeCache.txt found REGEX "^aolib_DIR:")
    string(FIND "${found}" "=${PREFIX}/" place)
    if(place EQUAL -1)
        message(FATAL_ERROR "${SOURCE}: aolib was not found below ${PREFIX}: ${found}")
    endif()
endif()
if(NOT DEFINED RUN OR RUN)
    run("building" ${CMAKE_COMMAND} --build ${WORK} --parallel 2 --target consumer)
    run("running" ${WORK}/consumer)
    message(STATUS "${output}")
endif()
