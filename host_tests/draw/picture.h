// SPDX-License-Identifier: MIT
// Bodies as a picture: SVG, solid, in parallel light, with the shadows that they cast straight down; in one field or in several, side by side.
#pragma once

#include <ingot/ingot.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <string>
#include <vector>

namespace draw {

using Point = std::array<double, 3>;
inline Point point_of(const ingot::Vector& v) { return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)}; }
inline Point operator+(const Point& a, const Point& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Point operator-(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Point operator*(double s, const Point& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Point cross(const Point& a, const Point& b) { return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}; }

struct Paint {
    int red, green, blue;
};
inline constexpr Paint blue = {95, 170, 225}, red = {226, 72, 78}, ochre = {224, 168, 84}, green = {112, 184, 132}, grey = {196, 204, 214},
                       violet = {150, 126, 200};

/// Where the eye is, seen from what stands in the middle.
struct Eye {
    double width;        ///< m, that a field shows from left to right
    Point middle;        ///< m
    double turn = 25;    ///< degrees, to the right of in front, which is -y
    double height = 17;  ///< degrees, above the ground
};

/// Unit vectors: rightwards and upwards in the picture, and towards the eye.
struct Axes {
    Point right, up, view;
};
inline Axes axes_of(const Eye& eye) {
    const double to_rad = std::acos(-1.0) / 180, c = std::cos(eye.turn * to_rad), s = std::sin(eye.turn * to_rad);
    const double height = std::sin(eye.height * to_rad), level = std::cos(eye.height * to_rad);
    const Point right = {c, s, 0}, view = {s * level, -c * level, height};
    return {right, cross(view, right), view};
}

class Picture {
public:
    /// Of a field, in units of the picture. caption: what it shows, for people.
    Picture(const char* caption, int fields, double field_width, double field_height)
        : caption_(caption), fields_(fields), field_width_(field_width), field_height_(field_height) {}

    /// What is added from now on stands in this field.
    void begin_field(int field_i, const Eye& eye, const char* note = "") {
        const Axes axes = axes_of(eye);
        right_ = axes.right;
        up_ = axes.up;
        view_ = axes.view;
        flush();
        body_ += print("%s<svg x=\"%g\" y=\"%g\" width=\"%g\" height=\"%g\">\n", end_of_field_.c_str(), field_i * field_width_, head, field_width_,
                       field_height_);
        end_of_field_ = "</svg>\n";
        scale_ = field_width_ / eye.width;
        middle_ = eye.middle;
        if (*note != 0) notes_ += text(field_i * field_width_ + 10, head + field_height_ - 10, 13, note);
    }

    /// A level part of the ground, centre and half of each side, m. Shadows fall on the highest that was added before.
    void add_floor(const Point& at, double half_x, double half_y, const Paint& paint = {233, 237, 243}) {
        floors_.push_back({at, half_x, half_y});
        const Point x = {half_x, 0, 0}, y = {0, half_y, 0};
        add_face(ground_, {at - x - y, at + x - y, at + x + y, at - x + y}, paint, -1e6 + at[2], false);
    }
    /// Of the ground: a face that is not level.
    void add_ground_face(const std::vector<Point>& corners, const Paint& paint, bool outlined = true) {
        add_face(ground_, corners, paint, dot(corners[0] + corners[1] + corners[2], view_) / 3, outlined);
    }
    /// A box that does not move, and on which shadows fall.
    void add_block(const Point& at, const Point& half, const Paint& paint = grey) {
        ingot::PlacedShape shape;
        shape.shape = ingot::Box{{static_cast<ingot::scalar>(half[0]), static_cast<ingot::scalar>(half[1]), static_cast<ingot::scalar>(half[2])}};
        shape.r = {static_cast<ingot::scalar>(at[0]), static_cast<ingot::scalar>(at[1]), static_cast<ingot::scalar>(at[2])};
        add_solid(ground_, shape, paint);
        floors_.push_back({{at[0], at[1], at[2] + half[2]}, half[0], half[1]});
    }

    /// Sphere, capsule, box or cylinder; others are left out. part: 1, or less where it is only hinted at, as where it was before.
    void add(const ingot::PlacedShape& shape, const Paint& paint, bool casts_shadow = true, double part = 1) {
        if (casts_shadow) add_shadow(shape);
        part_ = part;
        add_solid(things_, shape, paint);
        if (part < 1 && !things_.empty()) things_.back().depth -= 1 / scale_;  // a dot behind what is there now
        part_ = 1;
    }

    /// False where the file cannot be written.
    bool write(const char* path) {
        flush();
        std::FILE* const file = std::fopen(path, "w");
        if (file == nullptr) return false;
        const double width = fields_ * field_width_, height = field_height_ + head;
        std::fprintf(file,
                     "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%g\" height=\"%g\" viewBox=\"0 0 %g %g\" font-family=\"sans-serif\" "
                     "fill=\"#1c2530\" stroke-linejoin=\"round\">\n"
                     "<rect width=\"%g\" height=\"%g\" fill=\"white\"/>\n",
                     width, height, width, height, width, height);
        std::fprintf(file, "%s%s%s%s</svg>\n", body_.c_str(), end_of_field_.c_str(), text(12, 25, 16, caption_.c_str()).c_str(), notes_.c_str());
        return std::fclose(file) == 0;
    }

private:
    static constexpr double head = 40;  // above the fields, for the caption
    struct Item {
        double depth;
        std::string svg;
    };
    struct Floor {
        Point at;
        double half_x, half_y;
    };
    using Items = std::vector<Item>;

    [[gnu::format(printf, 1, 2)]] static std::string print(const char* format, ...) {
        va_list values, again;
        va_start(values, format);
        va_copy(again, values);
        std::string to(static_cast<std::size_t>(std::vsnprintf(nullptr, 0, format, values)) + 1, '\0');
        (void)std::vsnprintf(to.data(), to.size(), format, again);
        va_end(again);
        va_end(values);
        to.pop_back();
        return to;
    }
    static std::string text(double x, double y, int size, const char* words) {
        return print("<text x=\"%g\" y=\"%g\" font-size=\"%d\">%s</text>\n", x, y, size, words);
    }
    double x(const Point& P) const { return field_width_ / 2 + scale_ * dot(P - middle_, right_); }
    double y(const Point& P) const { return field_height_ / 2 - scale_ * dot(P - middle_, up_); }
    std::string pair(const Point& P) const { return print("%.1f,%.1f ", x(P), y(P)); }
    std::string color(const Paint& paint, double light) const {
        const auto tone = [&](int value) { return static_cast<int>(value * light * part_ + 255 * (1 - part_)); };
        return print("#%02x%02x%02x", tone(paint.red), tone(paint.green), tone(paint.blue));
    }
    /// Of a face with this unit normal: from the left, from in front and from above.
    static double light_on(const Point& n) { return 0.62 + 0.38 * std::max(0.0, dot(n, {-0.35, -0.55, 0.76})); }

    /// Convex; seen from one side where it is outlined.
    void add_face(Items& to, const std::vector<Point>& corners, const Paint& paint, double depth, bool outlined) {
        Point n = cross(corners[1] - corners[0], corners[2] - corners[0]);
        const double length = std::sqrt(dot(n, n));
        if (length > 0) n = 1 / length * n;
        if (dot(n, view_) < 0) n = -1 * n;
        std::string path;
        for (const Point& corner : corners) path += pair(corner);
        const std::string fill = color(paint, light_on(n)), edge = outlined ? color(paint, 0.45) : fill;
        to.push_back(
            {depth, print("<polygon points=\"%s\" fill=\"%s\" stroke=\"%s\" stroke-width=\".8\"/>\n", path.c_str(), fill.c_str(), edge.c_str())});
    }

    void add_solid(Items& to, const ingot::PlacedShape& placed, const Paint& paint) {
        const Point r = point_of(placed.r), size = point_of(placed.shape.size),
                    axes[3] = {point_of(placed.A.c0), point_of(placed.A.c1), point_of(placed.A.c2)};
        switch (placed.shape.kind) {
            case ingot::ShapeKind::sphere: return add_ball(to, r, size[0], axes, paint);
            case ingot::ShapeKind::capsule: return add_capsule(to, r, size[0], size[1], axes[2], paint);
            case ingot::ShapeKind::box: return add_box(to, r, size, axes, paint);
            case ingot::ShapeKind::cylinder: return add_cylinder(to, r, size[0], size[1], axes, paint);
            default: return;
        }
    }
    /// With a stripe, the great circle of its x and y axes, which shows how it turns.
    void add_ball(Items& to, const Point& r, double radius, const Point (&axes)[3], const Paint& paint) {
        std::string svg = print("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\" fill=\"%s\" stroke=\"%s\" stroke-width=\".8\"/>\n", x(r), y(r),
                                radius * scale_, color(paint, 0.92).c_str(), color(paint, 0.45).c_str());
        const Point glint = r + radius * 0.45 * (Point{-0.35, -0.55, 0.76} + view_);
        svg += print("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\" fill=\"white\" fill-opacity=\"%g\"/>\n", x(glint), y(glint), radius * scale_ * 0.2,
                     0.5 * part_);
        std::string path;
        bool drawn = false;
        for (int i = 0; i <= 32; ++i) {
            const double angle = i * std::acos(-1.0) / 16;
            const Point P = radius * (std::cos(angle) * axes[0] + std::sin(angle) * axes[1]);
            const bool seen = dot(P, view_) > 0;
            if (seen) path += (drawn ? "L" : "M") + pair(r + P);
            drawn = seen;
        }
        svg += print("<path d=\"%s\" fill=\"none\" stroke=\"%s\" stroke-width=\"%.1f\"/>\n", path.c_str(), color(paint, 0.6).c_str(),
                     radius * scale_ * 0.12);
        to.push_back({dot(r, view_), svg});
    }
    void add_capsule(Items& to, const Point& r, double radius, double half_length, const Point& axis, const Paint& paint) {
        const Point a = r - half_length * axis, b = r + half_length * axis;
        const auto stroke = [&](double width, double light) {
            return print("<path d=\"M%sL%s\" stroke-linecap=\"round\" stroke-width=\"%.1f\" stroke=\"%s\"/>\n", pair(a).c_str(), pair(b).c_str(),
                         width, color(paint, light).c_str());
        };
        to.push_back({dot(r, view_), stroke(2 * radius * scale_, 0.45) + stroke(2 * radius * scale_ - 1.6, 0.92)});
    }
    void add_box(Items& to, const Point& r, const Point& extents, const Point (&axes)[3], const Paint& paint) {
        const double half[3] = {extents[0], extents[1], extents[2]};
        std::string svg;
        for (int axis_i = 0; axis_i < 3; ++axis_i) {
            const int u = (axis_i + 1) % 3, v = (axis_i + 2) % 3;
            for (const double side : {-1.0, 1.0}) {
                if (side * dot(axes[axis_i], view_) <= 0) continue;
                const Point middle = r + side * half[axis_i] * axes[axis_i], to_u = half[u] * axes[u], to_v = half[v] * axes[v];
                Items face;
                add_face(face, {middle - to_u - to_v, middle + to_u - to_v, middle + to_u + to_v, middle - to_u + to_v}, paint, 0, true);
                svg += face[0].svg;
            }
        }
        to.push_back({dot(r, view_), svg});
    }
    void add_cylinder(Items& to, const Point& r, double radius, double half_length, const Point (&axes)[3], const Paint& paint) {
        constexpr int sides = 24;
        const auto rim = [&](int i, double side) {
            const double angle = 2 * i * std::acos(-1.0) / sides;
            return r + radius * (std::cos(angle) * axes[0] + std::sin(angle) * axes[1]) + side * half_length * axes[2];
        };
        std::string svg;
        Items faces;
        std::vector<Point> cap;
        const double side = dot(axes[2], view_) > 0 ? 1 : -1;
        for (int i = 0; i < sides; ++i) {
            cap.push_back(rim(i, side));
            const Point n = rim(i, 0) + rim(i + 1, 0) - 2 * r;
            if (dot(n, view_) > 0) add_face(faces, {rim(i, -1), rim(i + 1, -1), rim(i + 1, 1), rim(i, 1)}, paint, 0, false);
        }
        add_face(faces, cap, paint, 0, true);
        for (const Item& face : faces) svg += face.svg;
        to.push_back(
            {dot(r, view_), svg + print("<path d=\"M%sL%s\" stroke=\"%s\" stroke-width=\"1.5\"/>\n", pair(r + side * half_length * axes[2]).c_str(),
                                        pair(rim(0, side)).c_str(), color(paint, 0.45).c_str())});
    }

    /// What lies straight below, on the highest floor that is there: as far as it is of one floor.
    void add_shadow(const ingot::PlacedShape& placed) {
        const Point r = point_of(placed.r), size = point_of(placed.shape.size),
                    axes[3] = {point_of(placed.A.c0), point_of(placed.A.c1), point_of(placed.A.c2)};
        const Floor* below = nullptr;
        for (const Floor& floor : floors_)
            if (std::fabs(r[0] - floor.at[0]) <= floor.half_x && std::fabs(r[1] - floor.at[1]) <= floor.half_y && floor.at[2] <= r[2] &&
                (below == nullptr || floor.at[2] > below->at[2]))
                below = &floor;
        if (below == nullptr) return;
        std::vector<Point> outline;
        const auto round = [&](const Point& at, double radius) {
            for (int i = 0; i < 24; ++i) {
                const double angle = i * std::acos(-1.0) / 12;
                outline.push_back({at[0] + radius * std::cos(angle), at[1] + radius * std::sin(angle), 0});
            }
        };
        const ingot::ShapeKind kind = placed.shape.kind;
        if (kind == ingot::ShapeKind::sphere) round(r, size[0]);
        if (kind == ingot::ShapeKind::capsule)
            for (const double side : {-1.0, 1.0}) round(r + side * size[1] * axes[2], size[0]);
        for (int corner = 0; corner < 8 && kind == ingot::ShapeKind::box; ++corner) {
            const auto side = [&](int axis_i) { return corner >> axis_i & 1 ? 1.0 : -1.0; };
            outline.push_back(r + side(0) * size[0] * axes[0] + side(1) * size[1] * axes[1] + side(2) * size[2] * axes[2]);
        }
        for (int i = 0; i < 48 && kind == ingot::ShapeKind::cylinder; ++i) {
            const double angle = i * std::acos(-1.0) / 12;
            outline.push_back(r + size[0] * (std::cos(angle) * axes[0] + std::sin(angle) * axes[1]) + (i < 24 ? 1 : -1) * size[1] * axes[2]);
        }
        for (Point& P : outline)
            P = {std::clamp(P[0], below->at[0] - below->half_x, below->at[0] + below->half_x),
                 std::clamp(P[1], below->at[1] - below->half_y, below->at[1] + below->half_y), below->at[2]};
        std::string path;
        for (const Point& P : hull_of(outline)) path += pair(P);
        if (!path.empty()) shadows_ += print("<polygon points=\"%s\" fill=\"#c3cad4\"/>\n", path.c_str());
    }
    /// Of points of one height, going round.
    static std::vector<Point> hull_of(std::vector<Point> points) {
        std::sort(points.begin(), points.end());
        std::vector<Point> around;
        for (int pass = 0; pass < 2; ++pass) {
            const std::size_t begin = around.size();
            for (const Point& P : points) {
                while (around.size() >= begin + 2 && cross(around.back() - around[around.size() - 2], P - around.back())[2] <= 0) around.pop_back();
                around.push_back(P);
            }
            if (!around.empty()) around.pop_back();
            std::reverse(points.begin(), points.end());
        }
        return around;
    }

    void flush() {
        for (Items* items : {&ground_, &things_}) {
            std::stable_sort(items->begin(), items->end(), [](const Item& a, const Item& b) { return a.depth < b.depth; });
            for (const Item& item : *items) body_ += item.svg;
            items->clear();
            if (items == &ground_) body_ += shadows_;
        }
        shadows_.clear();
        floors_.clear();
    }

    std::string caption_, body_, notes_, shadows_, end_of_field_;
    int fields_;
    double field_width_, field_height_, scale_ = 1, part_ = 1;
    Point middle_{}, right_{1, 0, 0}, up_{0, 0, 1}, view_{0, -1, 0};
    Items ground_, things_;
    std::vector<Floor> floors_;
};

}  // namespace draw
