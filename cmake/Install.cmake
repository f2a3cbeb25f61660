# What `cmake --install` puts where. The installed tree finds itself and may be moved as a whole.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(aolib_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/aolib)

# A library with its rows in `export_set`, runtime and development parts apart.
function(aolib_install_library target export_set)
    install(TARGETS ${target} EXPORT ${export_set}
        RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT runtime
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT runtime NAMELINK_COMPONENT development
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
    install(EXPORT ${export_set} NAMESPACE aolib:: DESTINATION ${aolib_package_dir}
        COMPONENT development)
endfunction()

# A pkg-config file, of a template of that name or another, that says where it lies relative to itself.
function(aolib_install_pkg_config name)
    set(template ${name})
    if(ARGN)
        set(template ${ARGN})
    endif()
    file(RELATIVE_PATH prefix_from_pc ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
    file(RELATIVE_PATH libdir ${CMAKE_INSTALL_PREFIX} ${CMAKE_INSTALL_FULL_LIBDIR})
    file(RELATIVE_PATH includedir ${CMAKE_INSTALL_PREFIX} ${CMAKE_INSTALL_FULL_INCLUDEDIR})
    string(REGEX REPLACE "/$" "" prefix_from_pc "${prefix_from_pc}")
    configure_file(${PROJECT_SOURCE_DIR}/cmake/${template}.pc.in ${PROJECT_BINARY_DIR}/${name}.pc @ONLY)
    install(FILES ${PROJECT_BINARY_DIR}/${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
        COMPONENT development)
endfunction()

# An optional component: the target aolib_<component> as aolib::<component>,
# found by find_package(aolib COMPONENTS <component>) or pkg-config aolib-<component>.
function(aolib_install_component component description)
    set(target aolib_${component})
    set_target_properties(${target} PROPERTIES EXPORT_NAME ${component} INSTALL_RPATH "$ORIGIN")
    # What a static component is linked with, after itself.
    set(component_libs "")
    get_target_property(linked ${target} LINK_LIBRARIES)
    if(aolib_type STREQUAL STATIC_LIBRARY)
        if("embree" IN_LIST linked)
            set(component_libs " -lembree${embree_VERSION_MAJOR} -lpthread")
        endif()
        string(TOUPPER ${target} upper)
        string(APPEND aolib_pc_cflags " -D${upper}_STATIC_DEFINE")
    endif()
    aolib_install_library(${target} ${target}Targets)
    aolib_install_pkg_config(aolib-${component} aolib-component)
    install(FILES ${ARGN} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/aolib COMPONENT development)
endfunction()

get_target_property(aolib_type aolib TYPE)
set(aolib_pc_cflags "")
if(aolib_type STREQUAL STATIC_LIBRARY)
    set(aolib_pc_cflags " -DAOLIB_STATIC_DEFINE")
endif()
# GLM is headers alone; where it has a file for pkg-config its folder comes from there.
find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
    pkg_check_modules(AOLIB_GLM QUIET glm)
endif()
set(aolib_pc_requires "")
if(AOLIB_GLM_FOUND)
    set(aolib_pc_requires "glm")
endif()

aolib_install_library(aolib aolibTargets)
aolib_install_pkg_config(aolib)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/aolib DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
    COMPONENT development PATTERN RayTracing.h EXCLUDE PATTERN bake EXCLUDE
    PATTERN lighting EXCLUDE)
install(FILES ${PROJECT_BINARY_DIR}/include/aolib/Export.h
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/aolib COMPONENT development)

if(TARGET aolib_raytracing AND AOLIB_WITH_RAYTRACING)
    aolib_install_component(raytracing "Texels of aolib's cube maps, traced by rays"
        ${PROJECT_SOURCE_DIR}/include/aolib/RayTracing.h
        ${PROJECT_BINARY_DIR}/include/aolib/RayTracingExport.h)
endif()
if(TARGET aolib_bake AND AOLIB_WITH_BAKE)
    aolib_install_component(bake "Maps and vertices of models, baked by rays"
        ${PROJECT_BINARY_DIR}/include/aolib/BakeExport.h)
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/aolib/bake
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/aolib COMPONENT development)
endif()

if(TARGET aolib_lighting AND AOLIB_WITH_LIGHTING)
    aolib_install_component(lighting "Light from environment maps by baked accessibility"
        ${PROJECT_BINARY_DIR}/include/aolib/LightingExport.h)
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/aolib/lighting
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/aolib COMPONENT development)
endif()

if(TARGET aolib_tool)
    file(RELATIVE_PATH libdir_from_bin ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
    set_target_properties(aolib_tool PROPERTIES INSTALL_RPATH "$ORIGIN/${libdir_from_bin}")
    install(TARGETS aolib_tool RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT tools)
endif()

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/aolibConfig.cmake.in
    ${PROJECT_BINARY_DIR}/aolibConfig.cmake
    INSTALL_DESTINATION ${aolib_package_dir} NO_SET_AND_CHECK_MACRO)
# Before 1.0 a minor version may break; from 1.0 on, a major one.
if(PROJECT_VERSION_MAJOR EQUAL 0)
    set(aolib_compatibility SameMinorVersion)
else()
    set(aolib_compatibility SameMajorVersion)
endif()
write_basic_package_version_file(${PROJECT_BINARY_DIR}/aolibConfigVersion.cmake
    COMPATIBILITY ${aolib_compatibility})
install(FILES ${PROJECT_BINARY_DIR}/aolibConfig.cmake ${PROJECT_BINARY_DIR}/aolibConfigVersion.cmake
    DESTINATION ${aolib_package_dir} COMPONENT development)
