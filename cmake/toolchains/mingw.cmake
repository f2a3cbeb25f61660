# Windows, 64 bits, compiled elsewhere by mingw-w64 (Debian: g++-mingw-w64-x86-64-posix). OpenGL's headers
# are mingw-w64's own. GLM is headers alone and the same everywhere, so those of the system that compiles
# will do: a folder of the build shows them, and nothing else of that system.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
find_program(CMAKE_CXX_COMPILER NAMES x86_64-w64-mingw32-g++-posix x86_64-w64-mingw32-g++)
find_program(CMAKE_RC_COMPILER NAMES x86_64-w64-mingw32-windres)
set(CMAKE_FIND_ROOT_PATH /usr/x86_64-w64-mingw32)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
# Programs run without mingw-w64's own DLLs beside them.
set(CMAKE_EXE_LINKER_FLAGS_INIT -static)

get_property(aolib_trying GLOBAL PROPERTY IN_TRY_COMPILE)
if(NOT glm_DIR AND NOT aolib_trying)
    find_path(AOLIB_GLM_INCLUDE_DIR glm/glm.hpp NO_CMAKE_FIND_ROOT_PATH
        PATHS /usr/include /usr/local/include /opt/homebrew/include DOC "Folder of glm/glm.hpp")
    mark_as_advanced(AOLIB_GLM_INCLUDE_DIR)
    if(AOLIB_GLM_INCLUDE_DIR)
        set(aolib_headers ${CMAKE_BINARY_DIR}/headers)
        file(MAKE_DIRECTORY ${aolib_headers}/include)
        file(CREATE_LINK ${AOLIB_GLM_INCLUDE_DIR}/glm ${aolib_headers}/include/glm SYMBOLIC)
        file(WRITE ${aolib_headers}/glmConfig.cmake
            "if(NOT TARGET glm::glm)\n"
            "    add_library(glm::glm INTERFACE IMPORTED)\n"
            "    target_include_directories(glm::glm INTERFACE \${CMAKE_CURRENT_LIST_DIR}/include)\n"
            "endif()\n")
        set(glm_DIR ${aolib_headers} CACHE PATH "Folder of glmConfig.cmake")
    endif()
endif()
