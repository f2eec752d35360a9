# The package `flatblock`, beside VTK's own `vtkmodules`.

find_package(Python3 REQUIRED COMPONENTS Interpreter)
vtk_module_python_default_destination(flatblock_python_destination)
vtk_module_wrap_python(MODULES ${flatblock_modules} TARGET FlatBlock::VolumePython
  PYTHON_PACKAGE flatblock MODULE_DESTINATION "${flatblock_python_destination}"
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  BUILD_STATIC OFF INSTALL_HEADERS OFF INSTALL_EXPORT FlatBlockVolume)
configure_file("${CMAKE_CURRENT_LIST_DIR}/__init__.py"
  "${CMAKE_BINARY_DIR}/${flatblock_python_destination}/flatblock/__init__.py" COPYONLY)
install(FILES "${CMAKE_CURRENT_LIST_DIR}/__init__.py"
  DESTINATION "${flatblock_python_destination}/flatblock")
