// SPDX-License-Identifier: MIT
#include "settings.h"

#include <algorithm>
#include <cstdio>

namespace report {

bool Settings::wants(const std::string& suite) const {
    return suites.empty() || std::find(suites.begin(), suites.end(), suite) != suites.end();
}

namespace {

bool refuse(const std::string& why) {
    std::string names;
    for (const std::string& suite : known_suites()) names += (names.empty() ? "" : ", ") + suite;
    std::fprintf(stderr, "ingot_report: %s\nusage: ingot_report [--out DIR] [--quick] [--suite NAME]...\nsuites: %s\n",
                 why.c_str(), names.c_str());
    return false;
}

}  // namespace

bool read_arguments(int count, char** arguments, Settings& settings) {
    for (int i = 1; i < count; ++i) {
        const std::string word = arguments[i];
        if (word == "--quick") {
            settings.quick = true;
        } else if (word == "--out" || word == "--suite") {
            if (i + 1 == count) return refuse(word + " needs a value");
            const std::string value = arguments[++i];
            if (word == "--out") {
                settings.out = value;
            } else if (std::find(known_suites().begin(), known_suites().end(), value) == known_suites().end()) {
                return refuse("no suite is called '" + value + "'");
            } else {
                settings.suites.push_back(value);
            }
        } else {
            return refuse("'" + word + "' is not understood");
        }
    }
    return true;
}

}  // namespace report
