# SPDX-License-Identifier: MIT
# libdragon has make files: the flat form of the kernel (toolchains/bundle.py --arduino --out ingot) in a folder ingot, whose units keep the
# floating-point contract by themselves.
BUILD_DIR = build
include $(N64_INST)/include/n64.mk

src := main.cpp $(wildcard ingot/src/ingot/*.cpp)
N64_CXXFLAGS += -std=gnu++17 -Iingot/src

all: crate.z64
$(BUILD_DIR)/crate.elf: $(src:%.cpp=$(BUILD_DIR)/%.o)
crate.z64: N64_ROM_TITLE = "crate"
.PHONY: all
