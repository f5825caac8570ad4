// SPDX-License-Identifier: MIT
#include "output.h"

#include <ingot/level/level_from_bytes.h>

#include <cstdio>
#include <cstring>

namespace level_tool {

namespace {

/// All digits of a number that is a float.
std::string digits(ingot::scalar number) {
    char text[64];
    std::snprintf(text, sizeof text, "ingot::scalar(%.9g)", static_cast<double>(number));
    return text;
}
std::string digits(const ingot::Vector& v) { return "{" + digits(v.x) + ", " + digits(v.y) + ", " + digits(v.z) + "}"; }

/// Items between commas, in lines of up to 150 characters.
class List {
public:
    explicit List(std::ostream& out) : out_(out) {}
    void add(const std::string& item) {
        if (column_ > 0 && column_ + item.size() + 2 > 148) {
            out_ << "\n";
            column_ = 0;
        }
        out_ << (column_ == 0 ? "    " : " ") << item << ",";
        column_ += item.size() + (column_ == 0 ? 5 : 2);
    }

private:
    std::ostream& out_;
    size_t column_ = 0;
};

template <class Item, class Text>
void write_array(std::ostream& out, const std::string& type, const std::string& name, const Item* items, size_t count, const Text& text) {
    out << "inline constexpr " << type << " " << name << "[] = {\n";
    List list(out);
    for (size_t i = 0; i < count; ++i) list.add(text(items[i]));
    out << "\n};\n";
}

std::string text_of(const ingot::LatticePoint& p) {
    return "{" + std::to_string(p.x) + ", " + std::to_string(p.y) + ", " + std::to_string(p.z) + "}";
}

std::string text_of(const ingot::LatticeTriangle& t) {
    return "{{" + std::to_string(t.corners[0]) + ", " + std::to_string(t.corners[1]) + ", " + std::to_string(t.corners[2]) + "}, " +
           std::to_string(t.edges) + ", " + std::to_string(t.material) + "}";
}

std::string text_of(const uint8_t (&sides)[3][ingot::MeshNode::children]) {
    std::string text = "{";
    for (int axis = 0; axis < 3; ++axis) {
        text += axis > 0 ? ", {" : "{";
        for (int k = 0; k < ingot::MeshNode::children; ++k) text += (k > 0 ? ", " : "") + std::to_string(sides[axis][k]);
        text += "}";
    }
    return text + "}";
}
std::string text_of(const ingot::MeshNode& n) {
    return "{" + text_of(n.origin) + ", " + std::to_string(n.shifts) + ", " + std::to_string(n.counts) + ", " + std::to_string(n.first_node) + ", " +
           std::to_string(n.first_triangle) + ", " + text_of(n.low) + ", " + text_of(n.high) + "}";
}

std::string text_of(const ingot::HeightBlock& b) { return "{" + std::to_string(b.base) + ", " + std::to_string(b.shift) + "}"; }

size_t blocks_of(const ingot::HeightTable& h) { return static_cast<size_t>(ingot::grid::byte_blocks_of(h.columns, h.rows)); }
size_t samples_of(const ingot::HeightTable& h) { return size_t{h.columns} * h.rows; }
size_t cells_of(const ingot::HeightTable& h) { return size_t(h.columns - 1) * size_t(h.rows - 1); }

void write_tables(std::ostream& out, const std::string& name, const ingot::LevelTable& level) {
    const auto text = [](const auto& item) { return text_of(item); };
    const auto number = [](auto item) { return std::to_string(item); };
    if (level.is_mesh()) {
        write_array(out, "ingot::LatticePoint", name + "_corners", level.mesh.corners, level.mesh.corner_count, text);
        write_array(out, "ingot::LatticeTriangle", name + "_triangles", level.mesh.triangles, level.mesh.triangle_count, text);
        write_array(out, "ingot::MeshNode", name + "_nodes", level.mesh.nodes, level.mesh.node_count, text);
        return;
    }
    const ingot::HeightTable& heights = level.heights;
    if (heights.bytes != nullptr) {
        write_array(out, "uint8_t", name + "_bytes", heights.bytes, samples_of(heights), number);
        write_array(out, "ingot::HeightBlock", name + "_blocks", heights.blocks, blocks_of(heights), text);
    } else {
        write_array(out, "uint16_t", name + "_heights", heights.heights, samples_of(heights), number);
    }
    const auto extremes = static_cast<size_t>(ingot::grid::extremes_of(heights.columns, heights.rows));
    write_array(out, "uint16_t", name + "_extremes", heights.extremes, extremes, number);
    if (heights.cells != nullptr) write_array(out, "uint8_t", name + "_cells", heights.cells, cells_of(heights), number);
}

std::string table_of(const std::string& name, const ingot::LevelTable& level) {
    std::string text = "    {";
    if (level.is_mesh()) {
        text += "{" + name + "_corners, " + name + "_triangles, " + name + "_nodes, " + std::to_string(level.mesh.corner_count) + ", " +
                std::to_string(level.mesh.triangle_count) + ", " + std::to_string(level.mesh.node_count) + "}, {},\n     ";
    } else {
        const ingot::HeightTable& h = level.heights;
        const bool is_in_bytes = h.bytes != nullptr;
        text += "{}, {" + (is_in_bytes ? "nullptr" : name + "_heights") + ", " +
                (h.cells != nullptr ? name + "_cells" : "nullptr") + ", " + name + "_extremes, " +
                std::to_string(h.columns) + ", " + std::to_string(h.rows) + ", " + digits(h.spacing_x) + ", " + digits(h.spacing_y) + ", " +
                (h.other_diagonal ? "true" : "false") +
                (is_in_bytes ? ", " + name + "_bytes, " + name + "_blocks" : "") + "},\n     ";
    }
    std::string high = digits(level.high);
    if (!level.is_mesh()) {
        // As the scalar of whoever reads it rounds it.
        const auto end = [](ingot::scalar origin, ingot::scalar spacing, int samples) {
            return digits(origin) + " + " + digits(spacing) + " * " + std::to_string(samples - 1);
        };
        const ingot::HeightTable& h = level.heights;
        high =
            "{" + end(level.origin.x, h.spacing_x, h.columns) + ", " + end(level.origin.y, h.spacing_y, h.rows) + ", " + digits(level.high.z) + "}";
    }
    return text + digits(level.origin) + ", " + digits(level.step) + ",\n     " + digits(level.low) + ", " + high + ", " +
           std::to_string(level.checksum) + "u},\n";
}

/// Numbers as bytes, in either order.
class Bytes {
public:
    explicit Bytes(bool big_endian) : big_endian_(big_endian) {}
    template <class Number>
    void add(Number number) {
        uint64_t bits = 0;
        if constexpr (sizeof(Number) == 4) {
            uint32_t word;
            std::memcpy(&word, &number, sizeof word);
            bits = word;
        } else {
            bits = number;
        }
        for (size_t i = 0; i < sizeof number; ++i) {
            const size_t place = big_endian_ ? sizeof number - 1 - i : i;
            text += static_cast<char>(bits >> 8 * place & 255);
        }
    }
    void add(const ingot::LatticePoint& p) {
        for (const uint16_t x : {p.x, p.y, p.z}) add(x);
    }
    void add(const ingot::Vector& v) {
        for (const ingot::scalar x : {v.x, v.y, v.z}) add(static_cast<float>(x));
    }
    std::string text;

private:
    bool big_endian_;
};

void add_mesh(Bytes& bytes, const ingot::MeshTable& mesh) {
    for (int i = 0; i < mesh.node_count; ++i) {
        const ingot::MeshNode& n = mesh.nodes[i];
        bytes.add(n.origin);
        for (const uint16_t x : {n.shifts, n.counts, n.first_node, n.first_triangle}) bytes.add(x);
        for (const auto& sides : {&n.low, &n.high})
            for (const auto& along : *sides)
                for (const uint8_t x : along) bytes.add(x);
    }
    for (int i = 0; i < mesh.triangle_count; ++i) {
        for (const uint16_t corner : mesh.triangles[i].corners) bytes.add(corner);
        bytes.add(mesh.triangles[i].edges);
        bytes.add(mesh.triangles[i].material);
    }
    for (int i = 0; i < mesh.corner_count; ++i) bytes.add(mesh.corners[i]);
}

}  // namespace

void write_header(std::ostream& out, const std::string& name, const std::vector<ingot::LevelTable>& levels, const std::vector<std::string>& remarks) {
    out << "// Made by ingot_level; do not edit.\n";
    for (const std::string& remark : remarks) out << "// " << remark << "\n";
    out << "#pragma once\n\n#include <ingot/level/level_table.h>\n\n";
    std::string tables;
    for (size_t i = 0; i < levels.size(); ++i) {
        const std::string part = name + "_" + std::to_string(i);
        write_tables(out, part, levels[i]);
        tables += table_of(part, levels[i]);
    }
    out << "\ninline constexpr ingot::LevelTable " << name << "[] = {\n" << tables << "};\n";
}

std::string level_bytes(const ingot::LevelTable& level, bool big_endian) {
    using Header = ingot::LevelHeader;
    const ingot::HeightTable& h = level.heights;
    Bytes bytes(big_endian), body(big_endian);
    if (level.is_mesh()) {
        add_mesh(body, level.mesh);
    } else {
        const bool is_in_bytes = h.bytes != nullptr;
        for (size_t i = 0; is_in_bytes && i < blocks_of(h); ++i) {
            body.add(h.blocks[i].base);
            body.add(h.blocks[i].shift);
            body.add(h.blocks[i].unused);
        }
        for (size_t i = 0; !is_in_bytes && i < samples_of(h); ++i) body.add(h.heights[i]);
        for (int64_t i = 0; i < ingot::grid::extremes_of(h.columns, h.rows); ++i) body.add(h.extremes[i]);
        for (size_t i = 0; h.cells != nullptr && i < cells_of(h); ++i) body.add(h.cells[i]);
        for (size_t i = 0; is_in_bytes && i < samples_of(h); ++i) body.add(h.bytes[i]);
    }
    for (const uint8_t letter : Header::name) bytes.add(letter);
    bytes.add(Header::order_of_machine);
    bytes.add(Header::version_now);
    bytes.add(static_cast<uint32_t>(sizeof(Header) + body.text.size()));
    bytes.add(level.checksum);
    bytes.add(static_cast<float>(level.step));
    for (const ingot::Vector* v : {&level.origin, &level.low, &level.high}) bytes.add(*v);
    bytes.add(static_cast<float>(h.spacing_x));
    bytes.add(static_cast<float>(h.spacing_y));
    for (const uint16_t count : {level.mesh.corner_count, level.mesh.triangle_count, level.mesh.node_count, h.columns, h.rows}) bytes.add(count);
    bytes.add(static_cast<uint8_t>(h.other_diagonal));
    bytes.add(static_cast<uint8_t>((h.cells != nullptr ? Header::has_cells : 0) | (h.bytes != nullptr ? Header::has_bytes : 0)));
    return bytes.text + body.text;
}

}  // namespace level_tool
