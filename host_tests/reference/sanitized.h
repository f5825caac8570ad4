// SPDX-License-Identifier: MIT
// Whether this build watches what it does: a draw takes tens of times as long then, and a division by 0 ends it.
#pragma once

namespace ingot_reference {

#ifndef __has_feature
#define __has_feature(name) 0
#endif
inline constexpr bool is_sanitized = __has_feature(address_sanitizer);

}  // namespace ingot_reference
