# Configures where pkg-config finds nothing: the library must configure, the derivation must name the package that it lacks.
set(build "${SCRATCH}/without-ginac")
file(REMOVE_RECURSE "${build}")
file(MAKE_DIRECTORY "${build}/empty")
set(ENV{PKG_CONFIG_LIBDIR} "${build}/empty")
unset(ENV{PKG_CONFIG_PATH})
foreach(derivation OFF ON)
  execute_process(COMMAND ${CMAKE_COMMAND} -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${COMPILER} -S ${SOURCE} -B ${build}/${derivation}
                          -DDENHARTOG_DERIVATION=${derivation}
                  RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE messages)
  if(derivation STREQUAL OFF AND NOT status EQUAL 0)
    message(FATAL_ERROR "does not configure without GiNaC:\n${output}\n${messages}")
  elseif(derivation STREQUAL ON AND status EQUAL 0)
    message(FATAL_ERROR "the derivation configures without GiNaC")
  elseif(derivation STREQUAL ON AND NOT messages MATCHES "libginac-dev")
    message(FATAL_ERROR "the derivation does not say that libginac-dev is missing:\n${messages}")
  endif()
endforeach()
