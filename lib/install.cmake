# What `cmake --install` puts where: the program, the library from core to integrators, its headers, and the package
# file that find_package(superstep) reads. A consumer links superstep::superstep.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(library_rooms core parallel packing contact network rhs dynamics case integrators)
add_library(superstep_all INTERFACE)
add_library(superstep::superstep ALIAS superstep_all)
set_target_properties(superstep_all PROPERTIES EXPORT_NAME superstep)
set_target_properties(superstep_options PROPERTIES EXPORT_NAME options)
set(exported superstep_all superstep_options)
foreach(room IN LISTS library_rooms)
  target_link_libraries(superstep_all INTERFACE superstep_${room})
  list(APPEND exported superstep_${room})
endforeach()

install(TARGETS superstep RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
if(TARGET superstep_mpi)  # modules lie where the program looks for them
  install(TARGETS superstep_mpi superstep_petsc LIBRARY DESTINATION lib)
endif()
install(TARGETS ${exported} EXPORT superstepTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/lib/ DESTINATION include/superstep FILES_MATCHING PATTERN "*.hpp"
  PATTERN python EXCLUDE)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/integrators DESTINATION include/superstep FILES_MATCHING PATTERN "*.hpp"
  PATTERN detail EXCLUDE)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/superstep)
install(EXPORT superstepTargets NAMESPACE superstep:: DESTINATION ${package_folder})
configure_package_config_file(${PROJECT_SOURCE_DIR}/lib/superstepConfig.cmake.in
  ${PROJECT_BINARY_DIR}/generated/superstepConfig.cmake INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/generated/superstepConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/generated/superstepConfig.cmake
  ${PROJECT_BINARY_DIR}/generated/superstepConfigVersion.cmake DESTINATION ${package_folder})
