// SPDX-License-Identifier: MIT
// What is there only in scenes that name it.
#pragma once

#include "config.h"

namespace ingot { inline namespace INGOT_ABI {

template <bool named, class Part, class Else>
struct Chosen {
    using type = Part;
};
template <class Part, class Else>
struct Chosen<false, Part, Else> {
    using type = Else;
};
/// The one type where the scene names it; else the other.
template <bool named, class Part, class Else>
using If = typename Chosen<named, Part, Else>::type;

} }  // namespace ingot
