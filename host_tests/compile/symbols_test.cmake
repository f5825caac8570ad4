# SPDX-License-Identifier: MIT
# LIBRARY (an archive or an object) reaches for nothing but memcpy, memset and the compiler's own arithmetic, and has no
# static constructor. With BSS, the symbol of that name lies in .bss.
execute_process(COMMAND ${NM} ${LIBRARY} OUTPUT_VARIABLE listing RESULT_VARIABLE result ERROR_VARIABLE errors)
if(NOT result EQUAL 0 OR listing STREQUAL "")
  message(FATAL_ERROR "nm ${LIBRARY}: ${errors}")
endif()
string(REGEX MATCHALL "[^\n]+" lines "${listing}")

set(own "_ZN5ingot|_ZNK5ingot")                                       # defined in another member of the library
set(memory "memcpy|memset|memmove|memcmp")                            # what a compiler may call in freestanding code too
set(arithmetic "__aeabi_[a-z0-9_]+|__[a-z]+[sdt][fi][23]?|__gnu_[a-z0-9_]+|__clz[sd]i2")
set(linker "_GLOBAL_OFFSET_TABLE_")
set(forbidden "")
foreach(line IN LISTS lines)
  if(line MATCHES "^ +U (.+)$")
    set(symbol ${CMAKE_MATCH_1})
    if(NOT symbol MATCHES "^(${own}|(${memory}|${arithmetic}|${linker})$)")
      list(APPEND forbidden "${symbol} (undefined)")
    endif()
  elseif(line MATCHES " ([a-zA-Z]) (_GLOBAL__sub_I.*|_GLOBAL__I.*|__cxx_global_var_init.*|_Z.*static_initialization_and_destruction.*)$")
    list(APPEND forbidden "${CMAKE_MATCH_2} (static constructor)")
  endif()
endforeach()
if(forbidden)
  list(REMOVE_DUPLICATES forbidden)
  message(FATAL_ERROR "symbols: forbidden in ${LIBRARY}: ${forbidden}")
endif()

if(BSS AND NOT listing MATCHES "[0-9a-f]+ [bB] ${BSS}\n")
  message(FATAL_ERROR "symbols: ${BSS} is not in .bss:\n${listing}")
endif()
