# SPDX-License-Identifier: LGPL-2.1-or-later
# Run at every build: write the source of whipple::version, but touch it only when something changed.
# Takes OUTPUT (the file), SOURCE_DIR, VERSION, BUILD_TYPE.
execute_process(
  COMMAND git -C ${SOURCE_DIR} describe --always --dirty --exclude=*
  OUTPUT_VARIABLE hash
  OUTPUT_STRIP_TRAILING_WHITESPACE
  ERROR_QUIET
  RESULT_VARIABLE failed)
if(failed)
  set(hash unknown)
endif()
configure_file(${SOURCE_DIR}/cmake/version.cc.in ${OUTPUT} @ONLY)
