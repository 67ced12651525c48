# Build step: writes `output` from `template` with the commit of `source`, only when it changed.
execute_process(
  COMMAND git -c safe.directory=* -C ${source} describe --always --dirty --abbrev=10
  OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  set(commit "unknown")
endif()
configure_file(${template} ${output} @ONLY)
