// SPDX-License-Identifier: MIT
// A pen that draws an SVG picture: parallel light, from in front, a little from the right and from above.
#pragma once

#include <ingot/ingot.h>

#include <cstdio>

namespace draw {

class SvgPen {
public:
    /// to: where the picture goes. width: m that it shows from left to right; middle: what is in its middle, m. stroke: of a picture 960 wide.
    SvgPen(std::FILE* to, double width, const ingot::Vector& middle, double stroke = 1.2)
        : to_(to), scale_(size / width), radius_(2 * stroke), middle_(middle) {
        std::fprintf(to_,
                     "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%g\" height=\"%g\" viewBox=\"0 0 %g %g\" "
                     "stroke-linecap=\"round\" stroke-width=\"%g\">\n"
                     "<rect width=\"100%%\" height=\"100%%\" fill=\"white\"/>\n",
                     size * shown, size * 0.75 * shown, size, size * 0.75, stroke);
    }
    SvgPen(const SvgPen&) = delete;
    SvgPen& operator=(const SvgPen&) = delete;
    ~SvgPen() { std::fprintf(to_, "</svg>\n"); }

    void line(const ingot::Vector& a, const ingot::Vector& b, ingot::DrawColor color) {
        std::fprintf(to_, "<path d=\"M%.1f %.1fL%.1f %.1f\" stroke=\"%s\"/>\n", x(a), y(a), x(b), y(b), paint(color));
    }
    void point(const ingot::Vector& P, ingot::DrawColor color) {
        std::fprintf(to_, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\" fill=\"%s\"/>\n", x(P), y(P), radius_, paint(color));
    }

    static const char* paint(ingot::DrawColor color) {
        static const char* const paints[ingot::draw_color_count] = {"#2f6fb5", "#9aa7b4", "#c9ced6", "#b5792f", "#8b2fb5", "#5fb58a",  // shapes
                                                                    "#d62828", "#2a9d3a", "#1d4ed8",                                   // axes
                                                                    "#111111", "#e0c060", "#a21caf", "#0891b2",  // centre, bounds, L, omega
                                                                    "#e63946", "#f08020", "#70a020",             // contact, impulse, friction
                                                                    "#444444", "#9333ea", "#d4a0d4"};            // joint, its axis, island
        return paints[static_cast<int>(color)];
    }

private:
    static constexpr double size = 960, shown = 0.4;  // of its own, and as a page shows it that says nothing
    // Unit vectors, to the rounding of the digits printed.
    static constexpr double right[3] = {0.980, 0.199, 0}, up[3] = {-0.060, 0.294, 0.954};

    double along(const double (&axis)[3], const ingot::Vector& P) const {
        const ingot::Vector d = P - middle_;
        return axis[0] * static_cast<double>(d.x) + axis[1] * static_cast<double>(d.y) + axis[2] * static_cast<double>(d.z);
    }
    double x(const ingot::Vector& P) const { return size / 2 + scale_ * along(right, P); }
    double y(const ingot::Vector& P) const { return size * 0.375 - scale_ * along(up, P); }

    std::FILE* to_;
    double scale_, radius_;
    ingot::Vector middle_;
};

}  // namespace draw
