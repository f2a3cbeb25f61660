# Configures a preset of SOURCE in WORK, and builds it there: wholly, or TARGETS (a,b) of it. With CHECK
# the compiler only checks each file by itself, as CheckEachFile.cmake has it.
#   -DSOURCE= -DWORK= -DPRESET= [-DTARGETS=a,b] [-DCHECK=ON] [-DBUILD=OFF] [-DLAUNCHER=]
cmake_minimum_required(VERSION 3.22)
file(REMOVE ${WORK}/CMakeCache.txt)
set(arguments -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER})
if(CHECK)
    # Nothing is compiled that a cache could keep.
    set(arguments -DCMAKE_PROJECT_aolib_INCLUDE=${SOURCE}/tests/presets/CheckEachFile.cmake)
endif()
set(targets "")
if(TARGETS)
    string(REPLACE "," ";" targets "${TARGETS}")
    list(PREPEND targets --target)
endif()

function(run what)
    execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${SOURCE}
        RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(NOT result EQUAL 0)
        message(FATAL_ERROR "${what} the preset ${PRESET} failed (${result}):\n${output}")
    endif()
endfunction()

run("configuring" ${CMAKE_COMMAND} --preset ${PRESET} -B ${WORK} ${arguments})
if(NOT DEFINED BUILD OR BUILD)
    run("building" ${CMAKE_COMMAND} --build ${WORK} --parallel 2 ${targets} -- -k 0)
endif()
