# Instantiates the template `kernel` of KERNEL.hpp for NUMBER. It must compile; with ERROR given it must not, and for that reason.
set(unit "${SCRATCH}/${NAME}.cpp")
file(WRITE "${unit}" "#include \"derivation/algebra/symbolic.hpp\"\n#include \"tests/compile/${KERNEL}.hpp\"\n"
                     "template ${NUMBER} kernel<${NUMBER}>(const ${NUMBER}&);\n")
set(ENV{LC_ALL} C)
execute_process(COMMAND ${COMPILER} -std=c++20 -fsyntax-only -I${SOURCE}/src -I${SOURCE} "${unit}"
                RESULT_VARIABLE status ERROR_VARIABLE messages)
if(NOT ERROR AND NOT status EQUAL 0)
  message(FATAL_ERROR "${KERNEL} must compile for ${NUMBER}:\n${messages}")
elseif(ERROR AND status EQUAL 0)
  message(FATAL_ERROR "${KERNEL} must not compile for ${NUMBER}, but does")
elseif(ERROR AND NOT messages MATCHES "${ERROR}")
  message(FATAL_ERROR "${KERNEL} does not compile for ${NUMBER}, but for another reason than \"${ERROR}\":\n${messages}")
endif()
