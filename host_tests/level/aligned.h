// SPDX-License-Identifier: MIT
#pragma once

#include <ingot/level/level_from_bytes.h>

#include <cstring>
#include <string>
#include <vector>

namespace level_test {

/// Bytes where a level may lie: at a multiple of 4.
struct Aligned {
    explicit Aligned(const std::string& text) : words(text.size() / 4 + 2), size(text.size()) { std::memcpy(words.data(), text.data(), size); }
    uint8_t* bytes() { return reinterpret_cast<uint8_t*>(words.data()); }
    ingot::Result<ingot::LevelTable> level() { return ingot::level_from_bytes(words.data(), size); }
    std::vector<uint32_t> words;
    size_t size;
};

}  // namespace level_test
