// SPDX-License-Identifier: MIT
#include "chunks.h"

#include <array>
#include <cmath>
#include <map>
#include <numeric>

namespace level_tool {

namespace {

constexpr int64_t last = ingot::lattice::last;
constexpr int64_t furthest = int64_t{1} << 23;  // of float, so that tables are the same for both scalars
constexpr int told_most = 1000;                 // triangles that are named

bool has_area(const LatticeFace& face) {
    int64_t e[2][3];
    for (int axis = 0; axis < 3; ++axis) {
        e[0][axis] = face.corners[1][axis] - face.corners[0][axis];
        e[1][axis] = face.corners[2][axis] - face.corners[0][axis];
    }
    // Edges are below 2^30 steps: see place_on_lattice.
    for (int axis = 0; axis < 3; ++axis) {
        const int y = (axis + 1) % 3, z = (axis + 2) % 3;
        if (e[0][y] * e[1][z] != e[0][z] * e[1][y]) return true;
    }
    return false;
}

using Key = std::array<int64_t, 9>;
/// The same whatever corner a triangle begins with.
Key key_of(const LatticeFace& face) {
    Key least{};
    for (int first = 0; first < 3; ++first) {
        Key key;
        for (int i = 0; i < 3; ++i)
            for (int axis = 0; axis < 3; ++axis) key[static_cast<size_t>(3 * i + axis)] = face.corners[(first + i) % 3][axis];
        if (first == 0 || key < least) least = key;
    }
    return least;
}

/// Numbers of materials, by the order in which they appeared.
Refusal number_materials(const std::vector<std::string>& names, std::vector<uint8_t>& numbers, std::vector<std::string>& by_number) {
    bool are_numbers = true;
    for (const std::string& name : names) {
        int64_t number = 0;
        are_numbers = are_numbers && whole_number_of(name, number) && number >= 0 && number <= 255;
        numbers.push_back(static_cast<uint8_t>(number));
    }
    if (are_numbers || (names.size() == 1 && names[0].empty())) return "";
    by_number = names;
    std::sort(by_number.begin(), by_number.end());
    if (names.size() > 256) return "it has " + std::to_string(names.size()) + " materials: a level has up to 256";
    for (size_t i = 0; i < names.size(); ++i)
        numbers[i] = static_cast<uint8_t>(std::lower_bound(by_number.begin(), by_number.end(), names[i]) - by_number.begin());
    return "";
}

/// Names triangles that are there twice, and leaves one of each: of materials the least.
void drop_doubled(LatticeMesh& mesh, std::ostream& messages) {
    std::vector<std::pair<Key, int>> keys;
    for (size_t i = 0; i < mesh.faces.size(); ++i) keys.emplace_back(key_of(mesh.faces[i]), static_cast<int>(i));
    std::sort(keys.begin(), keys.end(), [&](const auto& a, const auto& b) {
        const LatticeFace &x = mesh.faces[static_cast<size_t>(a.second)], &y = mesh.faces[static_cast<size_t>(b.second)];
        return std::tie(a.first, x.material, x.line) < std::tie(b.first, y.material, y.line);
    });
    std::vector<bool> dropped(mesh.faces.size());
    int told = 0;
    for (size_t i = 1; i < keys.size(); ++i) {
        if (keys[i].first != keys[i - 1].first) continue;
        const auto number = static_cast<size_t>(keys[i].second);
        dropped[number] = true;
        if (++told <= told_most) messages << "line " << mesh.faces[number].line << ": a triangle that is there already, left out\n";
    }
    if (told > told_most) messages << "and " << told - told_most << " more that are there already\n";
    size_t kept = 0;
    for (size_t i = 0; i < mesh.faces.size(); ++i)
        if (!dropped[i]) mesh.faces[kept++] = mesh.faces[i];
    mesh.faces.resize(kept);
}

/// A part of the faces, and how it lies.
struct Span {
    size_t begin, end;
};
struct Extent {
    int64_t low[3], high[3];
    int64_t across(int axis) const { return high[axis] - low[axis]; }
    int longest() const {
        int axis = 0;
        for (int other = 1; other < 3; ++other)
            if (across(other) > across(axis)) axis = other;
        return axis;
    }
};
Extent extent_of(const LatticeMesh& mesh, const std::vector<int>& order, const Span& span) {
    Extent extent{{INT64_MAX, INT64_MAX, INT64_MAX}, {INT64_MIN, INT64_MIN, INT64_MIN}};
    for (size_t i = span.begin; i < span.end; ++i)
        for (const auto& corner : mesh.faces[static_cast<size_t>(order[i])].corners)
            for (int axis = 0; axis < 3; ++axis) {
                extent.low[axis] = std::min(extent.low[axis], corner[axis]);
                extent.high[axis] = std::max(extent.high[axis], corner[axis]);
            }
    return extent;
}

bool corners_fit(const LatticeMesh& mesh, const std::vector<int>& order, const Span& span) {
    if (3 * (span.end - span.begin) <= static_cast<size_t>(last)) return true;
    std::vector<std::array<int64_t, 3>> corners;
    for (size_t i = span.begin; i < span.end; ++i)
        for (const auto& c : mesh.faces[static_cast<size_t>(order[i])].corners) corners.push_back({c[0], c[1], c[2]});
    std::sort(corners.begin(), corners.end());
    return std::unique(corners.begin(), corners.end()) - corners.begin() <= last;
}

/// Cuts a span in two, which are ordered: at the middle of what is too long, else so that both have as many.
size_t cut(const LatticeMesh& mesh, std::vector<int>& order, const Span& span, const Extent& extent, bool is_too_long) {
    const int axis = extent.longest();
    const auto middle = [&](int number) {
        const auto& corners = mesh.faces[static_cast<size_t>(number)].corners;
        return corners[0][axis] + corners[1][axis] + corners[2][axis];
    };
    const auto begin = order.begin() + static_cast<std::ptrdiff_t>(span.begin), end = order.begin() + static_cast<std::ptrdiff_t>(span.end);
    std::vector<std::pair<int64_t, int>> keyed;
    for (auto i = begin; i != end; ++i) keyed.emplace_back(middle(*i), *i);
    std::sort(keyed.begin(), keyed.end(), [&](const auto& a, const auto& b) {
        if (a.first != b.first) return a.first < b.first;
        return key_of(mesh.faces[static_cast<size_t>(a.second)]) < key_of(mesh.faces[static_cast<size_t>(b.second)]);
    });
    for (size_t i = 0; i < keyed.size(); ++i) order[span.begin + i] = keyed[i].second;
    const size_t half = span.begin + keyed.size() / 2;
    if (!is_too_long) return half;
    const int64_t twice_three_middles = 3 * (extent.low[axis] + extent.high[axis]);
    size_t at = span.begin;
    while (at < span.end && 2 * keyed[at - span.begin].first < twice_three_middles) ++at;
    return at == span.begin || at == span.end ? half : at;
}

}  // namespace

Refusal place_on_lattice(const ObjMesh& obj, const Placing& placing, LatticeMesh& mesh, std::ostream& messages) {
    mesh = {};
    std::vector<uint8_t> numbers;
    const Refusal refusal = number_materials(obj.materials, numbers, mesh.materials);
    if (!refusal.empty()) return refusal;
    int told = 0;
    for (const ObjFace& given : obj.faces) {
        LatticeFace face{};
        face.line = given.line;
        face.material = numbers[static_cast<size_t>(given.material)];
        for (int i = 0; i < 3; ++i) {
            const double* place = &obj.places[3 * static_cast<size_t>(given.corners[i])];
            const double turned[3] = {place[0], placing.y_is_up ? -place[2] : place[1], placing.y_is_up ? place[1] : place[2]};
            for (int axis = 0; axis < 3; ++axis) {
                const double steps = std::floor(turned[axis] * placing.scale / placing.step + 0.5);
                if (!(std::abs(steps) <= static_cast<double>(furthest)))
                    return "line " + std::to_string(given.line) + ": a corner is further than " + std::to_string(furthest) + " steps (" +
                           std::to_string(static_cast<double>(furthest) * placing.step) + " m) from the origin: choose a larger --step, or move it";
                face.corners[i][axis] = static_cast<int64_t>(steps);
            }
        }
        if (!has_area(face)) {
            if (++told <= told_most) messages << "line " << face.line << ": a triangle that has no area on the lattice, left out\n";
            continue;
        }
        mesh.faces.push_back(face);
    }
    if (told > told_most) messages << "and " << told - told_most << " more that have no area\n";
    if (mesh.faces.empty()) return "no triangle has an area on a lattice of " + std::to_string(placing.step) + " m: is --scale right?";
    drop_doubled(mesh, messages);
    return "";
}

Refusal cut_into_chunks(const LatticeMesh& mesh, std::vector<std::vector<int>>& chunks) {
    chunks.clear();
    std::vector<int> order(mesh.faces.size());
    std::iota(order.begin(), order.end(), 0);
    std::vector<Span> spans{{0, order.size()}};
    while (!spans.empty()) {
        const Span span = spans.back();
        spans.pop_back();
        const Extent extent = extent_of(mesh, order, span);
        const bool is_too_long = extent.across(extent.longest()) > last;
        const bool are_too_many = span.end - span.begin > static_cast<size_t>(last);
        if (!is_too_long && !are_too_many && corners_fit(mesh, order, span)) {
            chunks.emplace_back(order.begin() + static_cast<std::ptrdiff_t>(span.begin), order.begin() + static_cast<std::ptrdiff_t>(span.end));
            continue;
        }
        if (span.end - span.begin == 1)
            return "line " + std::to_string(mesh.faces[static_cast<size_t>(order[span.begin])].line) + ": a triangle is " +
                   std::to_string(extent.across(extent.longest())) + " steps across, a level is up to 65535: choose a larger --step";
        const size_t at = cut(mesh, order, span, extent, is_too_long);
        spans.push_back({at, span.end});
        spans.push_back({span.begin, at});
    }
    return "";
}

Refusal build_chunk(const LatticeMesh& mesh, const std::vector<int>& numbers, ingot::scalar step, MeshData& data) {
    std::vector<int> order = numbers;
    const Extent extent = extent_of(mesh, order, {0, order.size()});
    std::vector<ingot::LatticePoint> points;
    std::vector<ingot::LevelFace> faces;
    for (const int number : numbers) {
        const LatticeFace& face = mesh.faces[static_cast<size_t>(number)];
        const auto first = static_cast<int>(points.size());
        for (const auto& c : face.corners)
            points.push_back({static_cast<uint16_t>(c[0] - extent.low[0]), static_cast<uint16_t>(c[1] - extent.low[1]),
                              static_cast<uint16_t>(c[2] - extent.low[2])});
        faces.push_back({first, first + 1, first + 2, face.material});
    }
    const ingot::Status status = build_mesh(points, faces, extent.low, step, data);
    return status == ingot::Status::ok ? "" : std::string("the builder says ") + name(status);
}

}  // namespace level_tool
