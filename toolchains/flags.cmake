# SPDX-License-Identifier: MIT
# Compile options as functions on a target. Nothing here sets a global flag, so a project that takes ingot in with
# add_subdirectory or FetchContent keeps its own flags.
#
#   ingot_floating_point_contract(<target>)   PUBLIC    the flags that the bits of every result depend on
#   ingot_freestanding(<target>)              PRIVATE   no exceptions, no RTTI, no hosted library; one section per function
#   ingot_strict_warnings(<target>)           PRIVATE   the warnings this project is written under
include_guard(GLOBAL)

option(INGOT_WERROR "Turn the warnings of ingot's own targets into errors" OFF)

# Adds options for compilers that understand GCC's, in C++ units only. The compiler is asked for by generator expression,
# because PUBLIC options are exported, and an installed ingot may be used by another compiler than the one that built it.
#
# clang-cl is Clang too, and takes words of GCC's only as /clang:<word>; without it, it ignores -ffp-contract=off with a warning (clang 14).
function(_ingot_add_gnu_options target scope)
  set(options ${ARGN})
  if(CMAKE_CXX_COMPILER_FRONTEND_VARIANT STREQUAL "MSVC")
    list(TRANSFORM options PREPEND "/clang:")
  endif()
  target_compile_options(${target} ${scope}
    "$<$<COMPILE_LANG_AND_ID:CXX,GNU,Clang,AppleClang,ARMClang,IntelLLVM>:${options}>")
endfunction()

# The floating-point contract: one golden hash for every target (host_tests/guide/determinism.md).
#
# PUBLIC, because the templates of the headers are compiled in the user's unit and must give the same bits there. Options of
# a target come after CMAKE_CXX_FLAGS on the command line, so a project-wide -ffast-math is undone for the units that link
# ingot, and for those only. The order within the list matters: -fno-fast-math resets -fmath-errno in GCC and
# -ffp-contract in clang, so it comes first.
#
#   -fno-fast-math       no reassociation, no reciprocals, NaN and infinities and signed zeros exist
#   -ffp-contract=off    a * b + c rounds twice. g++ 12 contracts even under -std=c++17, clang 14 does within expressions
#   -fno-math-errno      sqrt is one instruction where the core has it, and never a call that sets errno
#   -msse2 -mfpmath=sse  32-bit x86 only: x87 registers keep 80 bits and round twice
#   -vectorize-slp=false WebAssembly only: what clang 14 makes of straight-line code with -msimd128 has other bits than without (impacts of fast
#                        bodies, the direct solver); lanes are vectors of their own and lose nothing. By -mllvm, as an -O after it takes
#                        -fno-slp-vectorize back
#
# Not covered by any flag: units whose vectors flush denormals (Arm MVE, AltiVec, NEON on 32-bit Arm). GCC 12 vectorises for
# MVE and AltiVec at -O2 without being asked: build for -mcpu=cortex-m55+nomve.fp, or without -maltivec.
function(ingot_floating_point_contract target)
  set(flags -fno-fast-math -ffp-contract=off -fno-math-errno)
  if(CMAKE_SIZEOF_VOID_P EQUAL 4 AND CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64|x86|i[3-6]86)$")
    list(APPEND flags -msse2 -mfpmath=sse)
  endif()
  if(CMAKE_SYSTEM_PROCESSOR STREQUAL "wasm32")
    list(APPEND flags -mllvm -vectorize-slp=false)
  endif()
  _ingot_add_gnu_options(${target} PUBLIC ${flags})
  target_compile_options(${target} PUBLIC "$<$<COMPILE_LANG_AND_ID:CXX,MSVC>:/fp:precise>")
endfunction()

# What a kernel without an operating system is compiled with. PRIVATE: how the user compiles is the user's business.
#
# One section per function and object, so that --gc-sections drops every stage that a scene does not call.
function(ingot_freestanding target)
  set(flags
    -ffreestanding
    -fno-exceptions
    -fno-rtti
    -fno-threadsafe-statics  # no __cxa_guard_acquire
    -fno-use-cxa-atexit      # no __cxa_atexit, should a destructor ever be registered
    -ffunction-sections
    -fdata-sections)
  _ingot_add_gnu_options(${target} PRIVATE ${flags})
endfunction()

# Warnings that both GCC 12 and clang 14 know; errors when INGOT_WERROR is ON.
#
# -Wdouble-promotion earns its place on microcontrollers: one stray double literal costs a soft-float call on a Cortex-M4F.
function(ingot_strict_warnings target)
  set(flags
    -Wall
    -Wextra
    -Wpedantic
    -Wconversion
    -Wsign-conversion
    -Wdouble-promotion
    -Wshadow
    -Wold-style-cast
    -Wcast-align
    -Wcast-qual
    -Wundef
    -Wnull-dereference
    -Wnon-virtual-dtor
    -Woverloaded-virtual
    -Wextra-semi
    -Wmissing-declarations
    -Wimplicit-fallthrough
    -Wvla
    -Wformat=2)
  if(INGOT_WERROR)
    list(APPEND flags -Werror)
  endif()
  _ingot_add_gnu_options(${target} PRIVATE ${flags})
endfunction()
