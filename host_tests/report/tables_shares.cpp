// SPDX-License-Identifier: MIT
// The table of times as shares of other engines' times, with errors beside them.
#include <cmath>

#include "page.h"

namespace report {

namespace {

const double missing = std::nan("");
constexpr double frame = 1.0 / 60;

struct Engine {
    std::string title, method;
};
const std::vector<Engine>& peers() {
    static const std::vector<Engine> all = {{"Box3D", "box3d"}, {"Jolt", "jolt"}, {"Bullet", "bullet"}, {"ODE", "ode"}};
    return all;
}

/// A scene, and the two of its errors that are shown.
struct Shown {
    std::string title, scene, errors, first, second;
};

std::vector<Shown> scenes_shown() {
    std::vector<Shown> all;
    const auto wall = [&](const char* title, const char* scene) { all.push_back({title, scene, "shift / settling, mm", "shift", "settling"}); };
    const auto pile = [&](const char* title, const char* scene) {
        all.push_back({title, scene, "mean / largest overlap, mm", "mean_overlap", "max_overlap"});
    };
    wall("wall of 55 cubes", "pyramid_55");
    wall("wall of 210 cubes", "pyramid_210");
    wall("wall of 465 cubes", "pyramid_465");
    pile("512 balls", "pile_512");
    pile("4096 balls", "pile_4096");
    pile("512 random boxes", "pile_boxes_512");
    pile("2048 random boxes", "pile_boxes_2048");
    pile("512 mixed", "pile_mixed_512");
    pile("2048 mixed", "pile_mixed_2048");
    all.push_back({"tower of 20 cubes", "tower_20", "stood, s / top sinks, mm", "stood", "sink"});
    return all;
}

/// Peers come in one scalar, whichever they were built for.
double figure(const Rows& rows, const std::string& scene, const std::string& method, int lanes, const std::string& metric) {
    const double in_double = rows.value("peers", scene, method, "double", lanes, frame, metric, missing);
    return rows.value("peers", scene, method, "float", lanes, frame, metric, in_double);
}

std::string text_of(double value) {
    return value != 0 && std::abs(value) < 0.01 ? error_text(value) : number_text(value, std::abs(value) < 999.5 ? "%.3g" : "%.0f");
}

/// A stack that came down before its run was over.
bool fell(const Rows& rows, const std::string& scene, const std::string& method) {
    return figure(rows, scene, method, 0, "stood") < figure(rows, scene, method, 0, "seconds") - frame / 2;
}

/// What an engine does with a stack that has fallen is another scene: no share.
std::string share_of(const Rows& rows, const std::string& scene, int lanes, const std::string& peer) {
    const double share = figure(rows, scene, "default", lanes, "time_ratio_to_" + peer);
    return !std::isnan(share) && (fell(rows, scene, peer) || fell(rows, scene, "default")) ? "fell" : number_text(share, "%.2f");
}

std::string errors_of(const Rows& rows, const Shown& shown, const std::string& method) {
    const double first = figure(rows, shown.scene, method, 0, shown.first), second = figure(rows, shown.scene, method, 0, shown.second);
    if (std::isnan(first)) return "";
    const bool lies = shown.second == "sink" && fell(rows, shown.scene, method);
    return text_of(first) + " / " + (lies ? "fell" : text_of(second));
}

}  // namespace

Table shares_table(const Rows& rows) {
    Table table{"Time as a share of other engines' times",
                "60 Hz; ingot in float. All take turns, step by step: 0.5 is half the time of the other engine. Errors are of the same "
                "seconds; in the 3 s of a quick run piles do not come to rest. Fell: a cube of the other engine's stack left its place by 0.5 m.",
                {{"scene"}}};
    std::vector<Engine> present;
    for (const Engine& peer : peers())
        for (const Shown& shown : scenes_shown())
            if ((present.empty() || present.back().method != peer.method) && !std::isnan(figure(rows, shown.scene, peer.method, 0, "seconds")))
                present.push_back(peer);
    for (const int lanes : {4, 8})
        for (const Engine& peer : present) table.cells[0].push_back(std::to_string(lanes) + " lanes by " + peer.title);
    table.cells[0].insert(table.cells[0].end(), {"what is wrong", "ingot"});
    for (const Engine& peer : present) table.cells[0].push_back(peer.title);
    for (const Shown& shown : scenes_shown()) {
        std::vector<std::string> line = {shown.title};
        for (const int lanes : {4, 8})
            for (const Engine& peer : present) line.push_back(share_of(rows, shown.scene, lanes, peer.method));
        line.insert(line.end(), {shown.errors, errors_of(rows, shown, "default")});
        for (const Engine& peer : present) line.push_back(errors_of(rows, shown, peer.method));
        if (!present.empty() && !line.back().empty()) table.cells.push_back(line);
    }
    return table;
}

}  // namespace report
