# What `cpack -G DEB` makes of the installed parts: a package each for the shared libraries (where
# they are shared), for those who compile against them, and for the program.
set(CPACK_PACKAGE_NAME aolib)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION}) # not that of a project around this one
set(CPACK_PACKAGE_VENDOR aolib)
set(CPACK_PACKAGE_CONTACT "aolib <aolib@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_GENERATOR DEB)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_COMPONENTS_ALL development)

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libaolib-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS libglm-dev)
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "Headers and what links against them")
if(AOLIB_WITH_RAYTRACING OR AOLIB_WITH_BAKE)
    string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS ", libembree-dev")
endif()

if(aolib_type STREQUAL SHARED_LIBRARY)
    list(APPEND CPACK_COMPONENTS_ALL runtime)
    set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME libaolib${AOLIB_SOVERSION})
    set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION libs)
    set(CPACK_COMPONENT_RUNTIME_DESCRIPTION "Shared libraries")
    set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
    string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
        ", libaolib${AOLIB_SOVERSION} (= ${PROJECT_VERSION})")
endif()
if(TARGET aolib_tool)
    list(APPEND CPACK_COMPONENTS_ALL tools)
    set(CPACK_DEBIAN_TOOLS_PACKAGE_NAME aolib-tools)
    set(CPACK_DEBIAN_TOOLS_PACKAGE_SECTION graphics)
    set(CPACK_COMPONENT_TOOLS_DESCRIPTION "The program aolib: render, compare, bench")
    if(aolib_type STREQUAL SHARED_LIBRARY)
        set(CPACK_DEBIAN_TOOLS_PACKAGE_DEPENDS "libaolib${AOLIB_SOVERSION} (= ${PROJECT_VERSION})")
    endif()
endif()

# Under what licence each comes, where Debian looks for it.
foreach(component IN LISTS CPACK_COMPONENTS_ALL)
    string(TOUPPER ${component} upper)
    install(FILES ${PROJECT_SOURCE_DIR}/LICENSE RENAME copyright COMPONENT ${component}
        DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/doc/${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
endforeach()

# Which packages hold the libraries that a binary names, where Debian's own tool can tell.
find_program(AOLIB_DPKG_SHLIBDEPS dpkg-shlibdeps DOC "Finds the packages of shared libraries")
mark_as_advanced(AOLIB_DPKG_SHLIBDEPS)
if(AOLIB_DPKG_SHLIBDEPS)
    set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
    set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS
        ${PROJECT_BINARY_DIR}/src ${PROJECT_BINARY_DIR}/src/raytracing ${PROJECT_BINARY_DIR}/src/bake
        ${PROJECT_BINARY_DIR}/src/lighting)
endif()
include(CPack)
