# SPDX-License-Identifier: MIT
# The machine at hand, compiled by clang. Another clang: -DINGOT_HOST_CLANGXX=clang++-18.
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES INGOT_HOST_CLANGXX)

# Distributions that install several clangs side by side may lack the plain name.
find_program(INGOT_HOST_CLANGXX
  NAMES clang++ clang++-20 clang++-19 clang++-18 clang++-17 clang++-16 clang++-15 clang++-14
  DOC "clang for the host" REQUIRED)
set(CMAKE_CXX_COMPILER "${INGOT_HOST_CLANGXX}")
