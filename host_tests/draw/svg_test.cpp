// SPDX-License-Identifier: MIT
// The picture of a yard has a stroke for each line and a dot for each point. With INGOT_PICTURES=<folder> it stays there to be looked at.
#include "draw/svg.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "draw/yard.h"

namespace {

using namespace draw_yard;

struct CountingPen {
    int lines = 0, points = 0;
    void line(const Vector&, const Vector&, DrawColor) { ++lines; }
    void point(const Vector&, DrawColor) { ++points; }
};

// So long that what turns once in ten seconds shows it, and what bears a crate does not leave the picture.
constexpr ingot::DrawScale scale = {scalar(0.8), scalar(0.05), 1, scalar(0.02), 1, 1};

int count(const std::string& text, const std::string& part) {
    int found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
}

template <unsigned what>
std::string picture_of(const World& world, const char* name) {
    const char* const folder = std::getenv("INGOT_PICTURES");
    std::FILE* const file = folder == nullptr ? std::tmpfile() : std::fopen((std::string(folder) + "/" + name + ".svg").c_str(), "w+");
    if (file == nullptr) return "";
    {
        draw::SvgPen pen(file, 18, {0, 0, scalar(1.5)});
        ingot::draw<what>(world, pen, scale);
    }
    std::string text(static_cast<std::size_t>(std::ftell(file)), '\0');
    std::rewind(file);
    text.resize(std::fread(text.data(), 1, text.size(), file));
    std::fclose(file);
    return text;
}

template <unsigned flag>
void expect_picture(const World& world, const char* name) {
    const std::string text = picture_of<ingot::Draw::shapes | flag>(world, name);
    CountingPen pen;
    ingot::draw<ingot::Draw::shapes | flag>(world, pen, scale);
    EXPECT_EQ(count(text, "<path "), pen.lines) << name;
    EXPECT_EQ(count(text, "<circle "), pen.points) << name;
    EXPECT_EQ(count(text, "nan") + count(text, "inf"), 0) << name;
    ASSERT_GE(text.size(), 7u) << name;
    EXPECT_EQ(text.substr(text.size() - 7), "</svg>\n") << name;
}

TEST(Svg, has_what_is_drawn) {
    const auto world = yard();
    for (int step_i = 0; step_i < 20; ++step_i) ASSERT_TRUE(ingot::step(*world, scalar(1) / 60).status == ingot::Status::ok);
    using ingot::Draw;
    expect_picture<Draw::sleep | Draw::islands>(*world, "islands");
    expect_picture<Draw::axes | Draw::centres>(*world, "axes");
    expect_picture<Draw::bounds>(*world, "bounds");
    expect_picture<Draw::L | Draw::omega>(*world, "momenta");
    expect_picture<Draw::contacts | Draw::impulses>(*world, "contacts");
    expect_picture<Draw::joints>(*world, "joints");
}

}  // namespace
