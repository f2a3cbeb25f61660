# MANIFEST, the file of vcpkg, is JSON and of this VERSION.
cmake_minimum_required(VERSION 3.22)
file(READ ${MANIFEST} text)
string(JSON version GET "${text}" version)
if(NOT version STREQUAL VERSION)
    message(FATAL_ERROR "${MANIFEST} says ${version}, the project ${VERSION}")
endif()
string(JSON first GET "${text}" dependencies 0)
