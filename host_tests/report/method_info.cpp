// SPDX-License-Identifier: MIT
#include "method_info.h"

#include <map>

namespace report {

namespace {

struct Look {
    const char *color, *sentence;
};

/// Moser-Veselov from light to dark blue with the order; what it is compared with in other hues; the default in red.
const std::map<std::string, Look>& looks() {
    static const std::map<std::string, Look> known = {
        {"default", {"#e63946", "What a scene gets that names nothing: order 6 in float, 10 in double, with all options."}},
        {"listing1_euler", {"#9aa0a6", "Explicit Euler exactly as the article printed it. The baseline."}},
        {"lie_midpoint", {"#8d6e63", "Explicit midpoint rule on the rotation group, order 2."}},
        {"rk4_polar", {"#f4a300", "Classical Runge-Kutta on the nine numbers of A, then made orthonormal again. Order 4."}},
        {"moser_veselov_2", {"#a8d5f2", "The discrete Moser-Veselov method without preprocessing: order 2."}},
        {"moser_veselov_4", {"#5fb3e6", "Preprocessed discrete Moser-Veselov, order 4."}},
        {"moser_veselov_6", {"#2684c9", "Preprocessed discrete Moser-Veselov, order 6: the default of float."}},
        {"moser_veselov_8", {"#17569b", "Preprocessed discrete Moser-Veselov, order 8."}},
        {"moser_veselov_10", {"#0b2f66", "Preprocessed discrete Moser-Veselov, order 10: the default of double."}},
        {"moser_veselov_4_plain",
         {"#7fd1ae", "Order 4 without compensation, energy return and substeps: for the smallest cores."}},
        {"moser_veselov_6_plain", {"#1b9e77", "Order 6 without compensation and energy return."}},
        {"moser_veselov_6_compensated", {"#8856a7", "Order 6 with compensated A, without energy return."}},
        {"moser_veselov_10_plain", {"#66a61e", "Order 10 without compensation and energy return."}},
        {"symmetric_top_splitting_2", {"#d7b5f0", "A symmetric top and the rest of the body in turn, order 2; any spin."}},
        {"symmetric_top_splitting_6", {"#9c4dcc", "The same composed to order 6; any spin."}},
        {"symmetric_top", {"#00897b", "Closed form for bodies with two or three equal moments; wrong for others."}},
        {"exact_elliptic",
         {"#000000", "The exact motion, by Jacobi's elliptic functions: what the others are measured against."}},
        {"kick_drift_kick", {"#e63946", "The default for forces: half a kick, free flight, half a kick. Order 2."}},
        {"blanes_moan_4", {"#2684c9", "Six kicks between free flights, order 4; for fields that do not look at velocity."}},
        {"commutator_free_4", {"#1b9e77", "Commutator-free Lie group method, order 4; for any field."}},
        {"bullet", {"#c2185b", "Bullet, boxes in its broad phase, default settings."}},
        {"bullet_no_shapes", {"#f06292", "Bullet, bodies without shapes, default settings."}},
        {"ode", {"#827717", "ODE, quick step, bodies without shapes, default settings."}},
    };
    return known;
}

}  // namespace

const std::vector<MethodInfo>& method_infos() {
    static const std::vector<MethodInfo> infos = [] {
        std::vector<MethodInfo> list;
        const auto add = [&](const std::string& name, const std::string& type) {
            const auto look = looks().find(name);
            list.push_back({name, type, look == looks().end() ? "" : look->second.sentence});
        };
#define INGOT_METHOD(name, order, angle_max, symmetric_only, ...) add(#name, #__VA_ARGS__);
#include "methods.def"
#undef INGOT_METHOD
        for (const char* flight :
             {"kick_drift_kick:KickDriftKick", "blanes_moan_4:BlanesMoan4", "commutator_free_4:CommutatorFree4"}) {
            const std::string both = flight;
            add(both.substr(0, both.find(':')), both.substr(both.find(':') + 1));
        }
        for (const char* peer : {"bullet", "bullet_no_shapes", "ode"}) add(peer, "");
        return list;
    }();
    return infos;
}

std::string color_of(const std::string& method) {
    const auto look = looks().find(method);
    return look == looks().end() ? "#444444" : look->second.color;
}

}  // namespace report
