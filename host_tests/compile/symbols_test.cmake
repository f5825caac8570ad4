# SPDX-License-Identifier: MIT
# LIBRARY (an archive or an object) reaches for nothing but memcpy, memset and the compiler's own arithmetic, and runs nothing
# before main: no static constructor, no destructor, no section of pointers to either. With BSS, the symbol of that name lies
# in .bss and the library has no initialised data at all.
#
#   NM, OBJDUMP   of the target
#   KERNEL        optional: an archive in which LIBRARY may find functions of ingot
cmake_minimum_required(VERSION 3.25)

function(listing_of tool out)
  execute_process(COMMAND ${tool} ${ARGN} OUTPUT_VARIABLE listing RESULT_VARIABLE result ERROR_VARIABLE errors)
  if(NOT result EQUAL 0 OR listing STREQUAL "")
    message(FATAL_ERROR "${tool} ${ARGN}: ${errors}")
  endif()
  set(${out} "${listing}" PARENT_SCOPE)
endfunction()
listing_of(${NM} symbols ${LIBRARY})
listing_of(${OBJDUMP} sections -h ${LIBRARY})
set(providers ${LIBRARY} ${KERNEL})
listing_of(${NM} provided ${providers})
string(REGEX MATCHALL "[^\n]+" lines "${symbols}")

string(REGEX MATCHALL "[0-9a-f]+ [TtWwVvDdBbRr] [^\n]+" own "${provided}")
list(TRANSFORM own REPLACE "^[0-9a-f]+ [A-Za-z] " "")
set(memory "memcpy|memset|memmove|memcmp")  # what a compiler may call in freestanding code too
# libgcc: __aeabi_* of Arm, and by name what others have for arithmetic on 32 and 64 bits.
set(arithmetic "__aeabi_[a-z0-9_]+|__gnu_thumb1_case_[a-z]+|__(add|sub|mul|div|cmp|unord|eq|ne|lt|le|gt|ge)[sd]f[23]|__neg[sd]f2|\
__(mul|div|udiv|mod|umod|divmod|udivmod)[sd]i[34]|__(ash|lsh)[lr][sd]i3|__ashr[sd]i3|__clz[sd]i2|__ctz[sd]i2|__popcount[sd]i2|\
__(fix|fixuns)[sd]f[sd]i|__(float|floatun|floatuns|floatunsi)[sd]i?[sd]f|__extendsfdf2|__truncdfsf2")
# Also libgcc: saved registers of PowerPC, copies, shifts and divisions of SH-4; on Windows what touches each page of a large frame.
set(helpers "___chkstk_ms|_(save|rest)[gf]pr_[0-9]+(_x)?|__movmem[0-9A-Za-z_]+|__[us]divsi3_i4i?|__(ashr|ashl|lshr)si3_r0")
set(linker "_GLOBAL_OFFSET_TABLE_|_gp_disp|__linear_memory|__stack_pointer|__indirect_function_table")

set(forbidden "")
foreach(line IN LISTS lines)
  if(line MATCHES "^ +[Uw] (.+)$")
    set(symbol ${CMAKE_MATCH_1})
    if(NOT symbol MATCHES "^(${memory}|${arithmetic}|${linker})$" AND NOT symbol MATCHES "^(${helpers})$" AND NOT symbol IN_LIST own)
      list(APPEND forbidden "${symbol} (undefined)")
    endif()
  elseif(line MATCHES " [a-zA-Z] (_GLOBAL__.*|__cxx_global_var_init.*|_Z.*static_initialization_and_destruction.*)$")
    list(APPEND forbidden "${CMAKE_MATCH_1} (static constructor)")
  elseif(line MATCHES " [a-zA-Z] (_ZGV.*)$")
    list(APPEND forbidden "${CMAKE_MATCH_1} (guard of a static that is initialised at its first use)")
  endif()
endforeach()
string(REGEX MATCHALL "\\.(preinit_array|init_array|fini_array|ctors|dtors|tdata|tbss)[^ ]*" before_main "${sections}")
list(APPEND forbidden ${before_main})
if(BSS)
  string(REGEX MATCHALL "[^\n]+ [dD] [^\n]+" data "${symbols}")
  list(APPEND forbidden ${data})
endif()
if(forbidden)
  list(REMOVE_DUPLICATES forbidden)
  message(FATAL_ERROR "symbols: forbidden in ${LIBRARY}: ${forbidden}")
endif()

if(BSS AND NOT symbols MATCHES "[0-9a-f]+ [bB] ${BSS}\n")
  message(FATAL_ERROR "symbols: ${BSS} is not in .bss:\n${symbols}")
endif()
