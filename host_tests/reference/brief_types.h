// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <tuple>
#include <utility>

namespace ingot_reference {

template <class... All, std::size_t... i>
testing::Types<std::tuple_element_t<i, std::tuple<All...>>...> types_at(std::index_sequence<i...>);

/// The list of a typed test: the first `few` with INGOT_TEST_BRIEF, all of them by nightly. A scene that is stepped takes a compiler seconds, and
/// those first have each solver and each feature once, where all have them together.
template <std::size_t few, class... All>
using BriefTypes = decltype(types_at<All...>(std::make_index_sequence<INGOT_TEST_BRIEF ? few : sizeof...(All)>{}));

}  // namespace ingot_reference
