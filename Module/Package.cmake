# find_package(FlatBlockVolume), from the install tree and from the build tree.

include(CMakePackageConfigHelpers)
if(FLATBLOCK_PLUGIN)
  set(flatblock_find_vtk
"find_dependency(ParaView 5.11 COMPONENTS RemotingViews)
find_dependency(VTK COMPONENTS \${flatblock_components} PATHS \"\${VTK_DIR}\" NO_DEFAULT_PATH)")
else()
  set(flatblock_find_vtk "find_dependency(VTK 9.1 COMPONENTS \${flatblock_components})")
endif()
configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/FlatBlockVolumeConfig.cmake.in"
  "${CMAKE_BINARY_DIR}/${flatblock_cmake_destination}/FlatBlockVolumeConfig.cmake"
  INSTALL_DESTINATION "${flatblock_cmake_destination}")
write_basic_package_version_file(
  "${CMAKE_BINARY_DIR}/${flatblock_cmake_destination}/FlatBlockVolumeConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(FILES
  "${CMAKE_BINARY_DIR}/${flatblock_cmake_destination}/FlatBlockVolumeConfig.cmake"
  "${CMAKE_BINARY_DIR}/${flatblock_cmake_destination}/FlatBlockVolumeConfigVersion.cmake"
  DESTINATION "${flatblock_cmake_destination}")
