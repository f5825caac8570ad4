// SPDX-License-Identifier: MIT
// What the project has set itself to reach, and what this run measured.
#pragma once

#include <string>
#include <vector>

#include "rows.h"

namespace report {

struct Claim {
    std::string what;
    double measured;  ///< NaN: this run did not measure it
    double bound;
    bool at_least;  ///< the bound is from below
    bool exact;     ///< errors and counts: the same in every run; times are not
    std::string unit;

    bool is_measured() const { return measured == measured; }
    bool holds() const { return at_least ? measured >= bound : measured <= bound; }
};

std::vector<Claim> claims(const Rows& rows);

}  // namespace report
