// SPDX-License-Identifier: MIT
#include "input.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

namespace level_tool {

bool Lines::next(std::string& line, bool joined) {
    if (at_ >= text_.size()) return false;
    line.clear();
    number_ = read_ + 1;
    for (bool goes_on = true; goes_on && at_ < text_.size();) {
        size_t end = text_.find_first_of("\r\n", at_);
        end = end == std::string::npos ? text_.size() : end;
        line.append(text_, at_, end - at_);
        // Unix, DOS and old Mac ends.
        at_ = end < text_.size() && text_[end] == '\r' && end + 1 < text_.size() && text_[end + 1] == '\n' ? end + 2 : end + 1;
        ++read_;
        goes_on = joined && !line.empty() && line.back() == '\\';
        if (goes_on) line.back() = ' ';
    }
    return true;
}

std::string next_word(const std::string& line, size_t& at, const char* separators) {
    at = std::min(line.find_first_not_of(separators, at), line.size());
    const size_t end = std::min(line.find_first_of(separators, at), line.size());
    const std::string word = line.substr(at, end - at);
    at = end;
    return word;
}

bool number_of(const std::string& word, double& number) {
    const char *begin = word.data() + (!word.empty() && word[0] == '+' ? 1 : 0), *end = word.data() + word.size();
    const auto [at, error] = std::from_chars(begin, end, number);
    return error == std::errc() && at == end && std::isfinite(number);
}

bool whole_number_of(const std::string& word, int64_t& number) {
    const char* end = word.data() + word.size();
    const auto [at, error] = std::from_chars(word.data(), end, number);
    return error == std::errc() && at == end;
}

namespace {

std::string at_line(int line) { return "line " + std::to_string(line) + ": "; }

/// What a person may see of a word of a file.
std::string quoted(const std::string& word) {
    std::string shown = "'";
    for (const char c : word.substr(0, 40)) shown += c >= ' ' && c < 127 ? c : '?';
    return shown + (word.size() > 40 ? "...'" : "'");
}

Refusal read_corner(const std::string& line, size_t at, int number, ObjMesh& mesh) {
    for (int axis = 0; axis < 3; ++axis) {
        const std::string word = next_word(line, at);
        double place = 0;
        if (word.empty()) return at_line(number) + "a corner has three numbers, this one has " + std::to_string(axis);
        if (!number_of(word, place)) return at_line(number) + quoted(word) + " is no number that a corner could have";
        mesh.places.push_back(place);
    }
    return "";
}

Refusal read_face(const std::string& line, size_t at, int number, int material, ObjMesh& mesh) {
    const auto corner_count = static_cast<int64_t>(mesh.places.size() / 3);
    int corners[3] = {}, count = 0;
    for (std::string word = next_word(line, at); !word.empty(); word = next_word(line, at)) {
        int64_t corner = 0;
        if (!whole_number_of(word.substr(0, word.find('/')), corner)) return at_line(number) + quoted(word) + " is no corner of a face";
        corner = corner < 0 ? corner_count + corner : corner - 1;
        if (corner < 0 || corner >= corner_count)
            return at_line(number) + "corner " + quoted(word) + " is not there: " + std::to_string(corner_count) + " were named before it";
        corners[count < 2 ? count : 2] = static_cast<int>(corner);
        if (++count < 3) continue;
        mesh.faces.push_back({{corners[0], corners[1], corners[2]}, number, material});
        corners[1] = corners[2];
    }
    if (count < 3) return at_line(number) + "a face has three corners or more, this one has " + std::to_string(count);
    return "";
}

}  // namespace

Refusal read_obj(const std::string& text, ObjMesh& mesh, std::ostream& progress) {
    mesh = {};
    Lines lines(text);
    std::string line;
    std::map<std::string, int> numbers;
    int material = -1, told = 0;
    const auto number_of_material = [&](const std::string& name) {
        const auto [place, is_new] = numbers.emplace(name, static_cast<int>(numbers.size()));
        if (is_new) mesh.materials.push_back(name);
        return place->second;
    };
    while (lines.next(line, true)) {
        const size_t comment = line.find('#');
        if (comment != std::string::npos) line.resize(comment);
        size_t at = 0;
        const std::string word = next_word(line, at);
        Refusal refusal;
        if (word == "v") {
            refusal = read_corner(line, at, lines.number(), mesh);
        } else if (word == "usemtl") {
            material = number_of_material(next_word(line, at));
        } else if (word == "f") {
            if (material < 0) material = number_of_material("");
            refusal = read_face(line, at, lines.number(), material, mesh);
        }
        if (!refusal.empty()) return refusal;
        const int share = static_cast<int>(10 * (lines.place() / 4096) / (text.size() / 4096 + 1));
        if (share > told && text.size() > 5000000)
            progress << "read " << 10 * (told = share) << " %: " << mesh.faces.size() << " triangles" << std::endl;
    }
    if (mesh.places.empty()) return "there is no corner in it (no line that begins with v): this is no OBJ file, or an empty one";
    if (mesh.faces.empty()) return "there is no face in it (no line that begins with f)";
    return "";
}

namespace {

/// A number of the header of an image, behind white space and comments.
bool header_number(const std::string& bytes, size_t& at, int64_t& number) {
    while (at < bytes.size() && (std::isspace(static_cast<unsigned char>(bytes[at])) != 0 || bytes[at] == '#')) {
        if (bytes[at] == '#')
            at = std::min(bytes.find('\n', at), bytes.size());
        else
            ++at;
    }
    size_t end = at;
    while (end < bytes.size() && bytes[end] >= '0' && bytes[end] <= '9') ++end;
    const bool is_number = end > at && whole_number_of(bytes.substr(at, std::min<size_t>(end - at, 18)), number);
    at = end;
    return is_number;
}

}  // namespace

Refusal read_pgm(const std::string& bytes, HeightGrid& grid) {
    grid = {};
    if (bytes.size() < 2 || bytes[0] != 'P' || (bytes[1] != '2' && bytes[1] != '5'))
        return "this is no image of levels of grey: it does not begin with P2 or P5";
    const bool is_binary = bytes[1] == '5';
    size_t at = 2;
    int64_t columns = 0, rows = 0, most = 0;
    if (!header_number(bytes, at, columns) || !header_number(bytes, at, rows) || !header_number(bytes, at, most))
        return "the header of the image has no width, height and greatest level";
    if (columns < 2 || rows < 2 || columns > 65535 || rows > 65535)
        return "a field of heights has 2 to 65535 columns and rows, this one " + std::to_string(columns) + " by " + std::to_string(rows);
    if (most < 1 || most > 65535) return "levels of grey go up to 1 .. 65535, here to " + std::to_string(most);
    const int64_t samples = columns * rows;
    const int64_t width = most > 255 ? 2 : 1;
    ++at;  // one white space
    if (is_binary && static_cast<int64_t>(bytes.size()) - static_cast<int64_t>(at) < samples * width)
        return "the image ends early: " + std::to_string(samples * width) + " bytes of heights are due, " +
               std::to_string(std::max<int64_t>(0, static_cast<int64_t>(bytes.size()) - static_cast<int64_t>(at))) + " are there";
    if (!is_binary && samples > static_cast<int64_t>(bytes.size())) return "the image ends early: it has fewer characters than heights";
    grid.columns = static_cast<int>(columns);
    grid.rows = static_cast<int>(rows);
    grid.most = static_cast<double>(most);
    grid.heights.reserve(static_cast<size_t>(samples));
    for (int64_t i = 0; i < samples; ++i) {
        int64_t height = 0;
        if (is_binary) {
            for (int64_t k = 0; k < width; ++k) height = height << 8 | static_cast<uint8_t>(bytes[at++]);
        } else if (!header_number(bytes, at, height)) {
            return "the image ends early: height " + std::to_string(i + 1) + " of " + std::to_string(samples) + " is no number";
        }
        if (height > most)
            return "height " + std::to_string(i + 1) + " is " + std::to_string(height) + ", above the greatest level " + std::to_string(most);
        grid.heights.push_back(static_cast<double>(height));
    }
    grid.is_hole.assign(static_cast<size_t>(samples), false);
    return "";
}

Refusal read_csv(const std::string& text, HeightGrid& grid) {
    grid = {};
    Lines lines(text);
    std::string line;
    while (lines.next(line)) {
        if (line.find_first_not_of(" \t") == std::string::npos || line[line.find_first_not_of(" \t")] == '#') continue;
        // With commas or semicolons between the numbers nothing between two of them is a hole.
        const char separator = line.find(';') != std::string::npos ? ';' : line.find(',') != std::string::npos ? ',' : ' ';
        int columns = 0;
        for (size_t at = 0; at <= line.size();) {
            std::string word;
            if (separator == ' ') {
                word = next_word(line, at);
                if (word.empty()) break;
            } else {
                const size_t end = std::min(line.find(separator, at), line.size());
                size_t inside = 0;
                word = next_word(line.substr(at, end - at), inside);
                at = end + 1;
            }
            double height = 0;
            const bool is_hole = word.empty() || word == "nan" || word == "NaN" || word == "NAN";
            if (!is_hole && !number_of(word, height)) return at_line(lines.number()) + quoted(word) + " is no height";
            grid.heights.push_back(height);
            grid.is_hole.push_back(is_hole);
            ++columns;
        }
        if (grid.rows > 0 && columns != grid.columns)
            return at_line(lines.number()) + std::to_string(columns) + " heights, where the rows before it have " + std::to_string(grid.columns);
        grid.columns = columns;
        ++grid.rows;
    }
    if (grid.columns < 2 || grid.rows < 2 || grid.columns > 65535 || grid.rows > 65535)
        return "a field of heights has 2 to 65535 columns and rows, this one " + std::to_string(grid.columns) + " by " + std::to_string(grid.rows);
    return "";
}

}  // namespace level_tool
