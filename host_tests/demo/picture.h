// SPDX-License-Identifier: MIT
// Bodies as a picture: SVG, seen from in front, a little from the right and from above.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace demo {

class Picture {
public:
    /// width: m that the picture shows from left to right; z_middle: height of what is in its middle, m.
    Picture(double width, double z_middle) : scale_(size / width), z_middle_(z_middle) {}

    /// r: centre, m.
    void add_ball(const double (&r)[3], double radius) { balls_.push_back({{r[0], r[1], r[2]}, radius}); }

    /// Columns of A are the axes; half: half extents, m. Faces that look away are left out.
    void add_box(const double (&A)[3][3], const double (&r)[3], const double (&half)[3]) {
        for (int axis = 0; axis < 3; ++axis) {
            for (const double side : {-1.0, 1.0}) {
                const double n[3] = {side * A[axis][0], side * A[axis][1], side * A[axis][2]};
                if (dot(n, view) <= 0) continue;
                Face face{};
                const int u = (axis + 1) % 3, v = (axis + 2) % 3;
                const double signs[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
                for (int corner = 0; corner < 4; ++corner)
                    for (int i = 0; i < 3; ++i)
                        face.corner[corner][i] = r[i] + n[i] * half[axis] + signs[corner][0] * A[u][i] * half[u] +
                                                 signs[corner][1] * A[v][i] * half[v];
                face.depth = dot(r, view);
                face.light = 0.55 + 0.4 * std::max(0.0, dot(n, sun));
                faces_.push_back(face);
            }
        }
    }

    /// Draws from back to front. Returns false if the file cannot be written.
    bool write(const char* path, const char* caption) {
        std::FILE* const file = std::fopen(path, "w");
        if (file == nullptr) return false;
        std::fprintf(
            file,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %g %g\" font-family=\"sans-serif\" font-size=\"15\">\n"
            "<defs><radialGradient id=\"ball\" cx=\"0.65\" cy=\"0.3\" r=\"0.8\"><stop offset=\"0\" stop-color=\"#ffd9dc\"/>"
            "<stop offset=\"0.5\" stop-color=\"#e63946\"/><stop offset=\"1\" stop-color=\"#6d141c\"/></radialGradient></defs>\n"
            "<rect width=\"%g\" height=\"%g\" fill=\"white\"/>\n",
            size, height, size, height);
        std::fprintf(file, "<text x=\"20\" y=\"30\" fill=\"#1c2530\">%s</text>\n", caption);
        write_floor(file);
        std::sort(balls_.begin(), balls_.end(), [](const Ball& a, const Ball& b) { return dot(a.r, view) < dot(b.r, view); });
        for (const Ball& ball : balls_)
            std::fprintf(file, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\" fill=\"url(#ball)\"/>\n", x(ball.r), y(ball.r),
                         ball.radius * scale_);
        std::stable_sort(faces_.begin(), faces_.end(), [](const Face& a, const Face& b) { return a.depth < b.depth; });
        for (const Face& face : faces_) {
            std::fprintf(file, "<polygon points=\"");
            for (const auto& corner : face.corner) std::fprintf(file, "%.2f,%.2f ", x(corner), y(corner));
            const auto tone = [&](double c) { return static_cast<int>(c * face.light); };
            std::fprintf(file,
                         "\" fill=\"rgb(%d,%d,%d)\" stroke=\"#0b2f66\" stroke-width=\"0.8\" stroke-linejoin=\"round\"/>\n",
                         tone(95), tone(179), tone(230));
        }
        std::fprintf(file, "</svg>\n");
        return std::fclose(file) == 0;
    }

private:
    struct Ball {
        double r[3], radius;
    };
    struct Face {
        double corner[4][3], depth, light;
    };

    static constexpr double size = 900, height = 900;
    // Unit vectors, to the rounding of the digits printed: towards the eye, rightwards, upwards, towards the sun.
    static constexpr double view[3] = {0.41, -0.86, 0.30}, right[3] = {0.903, 0.430, 0}, up[3] = {-0.129, 0.271, 0.954},
                            sun[3] = {0.10, -0.70, 0.71};

    /// A square of the floor under what stands on it.
    void write_floor(std::FILE* file) const {
        const double half = 0.28 * size / scale_;
        const double corners[4][3] = {{-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}};
        std::fprintf(file, "<polygon points=\"");
        for (const auto& corner : corners) std::fprintf(file, "%.1f,%.1f ", x(corner), y(corner));
        std::fprintf(file, "\" fill=\"#e9edf3\"/>\n");
    }
    static double dot(const double (&a)[3], const double (&b)[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
    double x(const double (&r)[3]) const { return size / 2 + scale_ * dot(r, right); }
    double y(const double (&r)[3]) const { return height / 2 - scale_ * (dot(r, up) - z_middle_ * up[2]); }

    double scale_, z_middle_;
    std::vector<Ball> balls_;
    std::vector<Face> faces_;
};

}  // namespace demo
