// SPDX-License-Identifier: MIT
#include "level_tool.h"

#include <ingot/level/level_walk.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "chunks.h"
#include "heights.h"
#include "output.h"

namespace level_tool {

namespace {

constexpr char help[] =
    R"(ingot_level FILE [options]: makes the ground of a level for ingot.

FILE is a mesh (.obj: v, f, usemtl), an image of heights (.pgm, 8 or 16 bits), or a table of heights (.csv).
Writes BASE.h, constants for flash with an array BASE of ingot::LevelTable, and BASE.bin, or BASE_0.bin, BASE_1.bin ... for ingot::level_from_bytes.

  --out BASE         what to write; without it the name of FILE, in this folder
  --name NAME        of the array; without it that of BASE
  --step STEP        m, of the lattice: a power of two, as 1/1024 (what meshes have without it; heights 1/256)
  --no-header, --no-binary
  --big-endian       bytes for machines of that order
  --help

Meshes:
  --scale S          m a unit of the file (1)
  --y-up             y of the file is up; in a level z is
Corners move to the lattice. Triangles that have no area then are named and left out. What is larger than 65535 triangles or 65535 steps (64 m of
1/1024) is cut into levels that meet on one lattice. Materials are numbers 0 to 255, or names, which are numbered in alphabetical order.

Heights:
  --spacing X [Y]    m between samples (1)
  --range LOW HIGH   m, what black and white of an image are; without it a level of grey is a step
  --other-diagonal   cells are cut from (0, 1) to (1, 0)
  --bytes            heights in bytes, half the size: where 16 by 16 of them are more than 255 steps high, they move to larger steps
The first line is y = 0. In a .csv what is empty or nan is a hole.

The same triangles make the same bytes, in whatever order they are named.
Exit codes: 0 done, 1 refused, 2 wrong use, 3 a file cannot be read or written.
)";

struct Options {
    std::string file, base, name;
    double step = 0;
    Placing placing;
    HeightPlacing heights;
    bool header = true, binary = true, big_endian = false, help = false;
};

/// A number, or a fraction of two.
bool fraction_of(const std::string& word, double& number) {
    const size_t slash = word.find('/');
    double below = 1;
    if (!number_of(word.substr(0, slash), number)) return false;
    if (slash != std::string::npos && !number_of(word.substr(slash + 1), below)) return false;
    number /= below;
    return std::isfinite(number);
}

Refusal read_options(const std::vector<std::string>& words, Options& options) {
    for (size_t i = 0; i < words.size(); ++i) {
        const std::string& word = words[i];
        const auto numbers = [&](double* to, int count) {
            for (int k = 0; k < count; ++k)
                if (++i >= words.size() || !fraction_of(words[i], to[k])) return false;
            return true;
        };
        bool is_right = true;
        if (word == "--help" || word == "-h")
            options.help = true;
        else if (word == "--no-header")
            options.header = false;
        else if (word == "--no-binary")
            options.binary = false;
        else if (word == "--big-endian")
            options.big_endian = true;
        else if (word == "--y-up")
            options.placing.y_is_up = true;
        else if (word == "--other-diagonal")
            options.heights.other_diagonal = true;
        else if (word == "--bytes")
            options.heights.in_bytes = true;
        else if (word == "--step")
            is_right = numbers(&options.step, 1) && ingot::lattice::is_step(static_cast<ingot::scalar>(options.step));
        else if (word == "--scale")
            is_right = numbers(&options.placing.scale, 1) && options.placing.scale > 0;
        else if (word == "--range")
            is_right = numbers(&options.heights.low, 1) && numbers(&options.heights.high, 1) && options.heights.low != options.heights.high;
        else if (word == "--spacing") {
            double* spacing = options.heights.spacing;
            is_right = numbers(spacing, 1);
            spacing[1] = spacing[0];
            double second = 0;
            if (is_right && i + 1 < words.size() && fraction_of(words[i + 1], second)) {
                spacing[1] = second;
                ++i;
            }
            for (int axis = 0; axis < 2; ++axis) is_right = is_right && spacing[axis] >= 1e-6 && spacing[axis] <= 1e6;
        } else if (word == "--out" || word == "--name") {
            is_right = ++i < words.size() && !words[i].empty();
            if (is_right) (word == "--out" ? options.base : options.name) = words[i];
        } else if (word.size() > 1 && word[0] == '-')
            return "there is no option " + word;
        else if (!options.file.empty())
            return "one file at a time: " + options.file + ", or " + word;
        else
            options.file = word;
        if (!is_right) return word + (word == "--step" ? " takes a power of two, from 1/1048576 to 1048576" : " takes something else: see --help");
    }
    if (options.file.empty() && !options.help) return "which file?";
    return "";
}

std::string without_folder(const std::string& path) { return path.substr(path.find_last_of("/\\") + 1); }
std::string suffix_of(const std::string& path) {
    const std::string file = without_folder(path);
    const size_t dot = file.rfind('.');
    std::string suffix = dot == std::string::npos ? "" : file.substr(dot);
    for (char& c : suffix) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return suffix;
}

/// What C++ takes for a name.
std::string identifier_of(const std::string& text) {
    std::string name;
    for (const char c : text) name += (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ? c : '_';
    return name.empty() || (name[0] >= '0' && name[0] <= '9') ? "level_" + name : name;
}

bool read_file(const std::string& path, std::string& bytes) {
    std::ifstream file(path, std::ios::binary);
    std::vector<char> part(1 << 20);
    while (file.read(part.data(), static_cast<std::streamsize>(part.size())) || file.gcount() > 0)
        bytes.append(part.data(), static_cast<size_t>(file.gcount()));
    return file.is_open() && file.eof() && !file.bad();
}

bool write_file(const std::string& path, const std::string& bytes) {
    std::ofstream file(path, std::ios::binary);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.close();
    return !file.fail();
}

Outcome write_levels(const Options& options, const std::vector<ingot::LevelTable>& levels, const std::vector<std::string>& remarks,
                     std::ostream& messages) {
    for (size_t i = 0; options.binary && i < levels.size(); ++i) {
        const std::string path = options.base + (levels.size() > 1 ? "_" + std::to_string(i) : "") + ".bin";
        if (!write_file(path, level_bytes(levels[i], options.big_endian))) {
            messages << "ingot_level: " << path << " cannot be written\n";
            return Outcome::no_file;
        }
    }
    if (!options.header) return Outcome::done;
    std::ofstream file(options.base + ".h", std::ios::binary);
    write_header(file, options.name, levels, remarks);
    file.close();
    if (!file.fail()) return Outcome::done;
    messages << "ingot_level: " << options.base << ".h cannot be written\n";
    return Outcome::no_file;
}

size_t mesh_bytes(const ingot::MeshTable& mesh) {
    return mesh.corner_count * sizeof(ingot::LatticePoint) + mesh.triangle_count * sizeof(ingot::LatticeTriangle) +
           mesh.node_count * sizeof(ingot::MeshNode);
}

Refusal make_meshes(const Options& options, const std::string& text, std::vector<MeshData>& meshes, std::vector<std::string>& remarks,
                    std::ostream& messages) {
    ObjMesh obj;
    LatticeMesh mesh;
    std::vector<std::vector<int>> chunks;
    Refusal refusal = read_obj(text, obj, messages);
    if (refusal.empty()) refusal = place_on_lattice(obj, options.placing, mesh, messages);
    if (refusal.empty()) refusal = cut_into_chunks(mesh, chunks);
    if (!refusal.empty()) return refusal;
    if (chunks.size() > 1) messages << mesh.faces.size() << " triangles make " << chunks.size() << " levels" << std::endl;
    size_t bytes = 0;
    for (const std::vector<int>& chunk : chunks) {
        meshes.emplace_back();
        refusal = build_chunk(mesh, chunk, static_cast<ingot::scalar>(options.placing.step), meshes.back());
        if (!refusal.empty()) return refusal;
        const ingot::MeshTable& table = meshes.back().view.mesh;
        bytes += mesh_bytes(table);
        messages << "level " << meshes.size() - 1 << ": " << table.triangle_count << " triangles, " << table.corner_count << " corners, "
                 << table.node_count << " nodes, " << mesh_bytes(table) << " bytes" << std::endl;
    }
    remarks.push_back(std::to_string(mesh.faces.size()) + " triangles in " + std::to_string(bytes) + " bytes, " + std::to_string(chunks.size()) +
                      " levels.");
    for (size_t i = 0; i < mesh.materials.size(); ++i) remarks.push_back("Material " + std::to_string(i) + ": " + identifier_of(mesh.materials[i]));
    return "";
}

Refusal make_heights(const Options& options, const std::string& text, HeightData& data, std::vector<std::string>& remarks, std::ostream& messages) {
    HeightGrid grid;
    Refusal refusal = suffix_of(options.file) == ".pgm" ? read_pgm(text, grid) : read_csv(text, grid);
    int moved_by = 0;
    if (refusal.empty()) refusal = build_heights(grid, options.heights, data, moved_by);
    if (!refusal.empty()) return refusal;
    const size_t in_bytes = data.bytes.size() + sizeof(ingot::HeightBlock) * data.blocks.size();
    const size_t samples = data.bytes.empty() ? sizeof(uint16_t) * data.heights.size() : in_bytes;
    const size_t bytes = samples + sizeof(uint16_t) * data.extremes.size() + data.cells.size();
    remarks.push_back(std::to_string(grid.columns) + " by " + std::to_string(grid.rows) + " heights in " + std::to_string(bytes) + " bytes.");
    messages << remarks.back() << std::endl;
    if (moved_by > 0) {
        std::ostringstream remark;
        remark << "Heights moved by up to " << moved_by * options.heights.step << " m, to fit into bytes.";
        messages << remark.str() << std::endl;
        remarks.push_back(remark.str());
    }
    return "";
}

}  // namespace

Outcome run(const std::vector<std::string>& words, std::ostream& messages) {
    Options options;
    const Refusal wrong = read_options(words, options);
    if (!wrong.empty() || options.help) {
        messages << (wrong.empty() ? "" : "ingot_level: " + wrong + "\n\n") << help;
        return wrong.empty() ? Outcome::done : Outcome::wrong_use;
    }
    const std::string suffix = suffix_of(options.file);
    const bool is_mesh = suffix == ".obj";
    if (!is_mesh && suffix != ".pgm" && suffix != ".csv") {
        messages << "ingot_level: " << options.file << " is no .obj, .pgm or .csv\n";
        return Outcome::wrong_use;
    }
    std::string text;
    if (!read_file(options.file, text)) {
        messages << "ingot_level: " << options.file << " cannot be read\n";
        return Outcome::no_file;
    }
    const std::string stem = without_folder(options.file);
    if (options.base.empty()) options.base = stem.substr(0, stem.size() - suffix.size());
    options.name = identifier_of(options.name.empty() ? without_folder(options.base) : options.name);
    options.placing.step = options.heights.step = options.step > 0 ? options.step : is_mesh ? 1.0 / 1024 : 1.0 / 256;

    std::vector<MeshData> meshes;
    HeightData heights;
    std::vector<std::string> remarks{"From " + identifier_of(stem)};
    const Refusal refusal = is_mesh ? make_meshes(options, text, meshes, remarks, messages) : make_heights(options, text, heights, remarks, messages);
    if (!refusal.empty()) {
        messages << "ingot_level: " << options.file << ": " << refusal << "\n";
        return Outcome::refused;
    }
    std::vector<ingot::LevelTable> levels;
    for (const MeshData& mesh : meshes) levels.push_back(mesh.view);
    if (!is_mesh) levels.push_back(heights.view);
    // What is written is what would be taken.
    for (const ingot::LevelTable& level : levels) {
        if (check_level(level) == ingot::Status::ok) continue;
        messages << "ingot_level: the table is not right: this is a fault of the tool\n";
        return Outcome::refused;
    }
    return write_levels(options, levels, remarks, messages);
}

}  // namespace level_tool
