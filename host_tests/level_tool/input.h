// SPDX-License-Identifier: MIT
// What the tool reads: meshes of OBJ files, heights of images and tables. Whatever is in a file, it is read, or refused with a sentence.
#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace level_tool {

/// Why there is no result: a sentence, empty where there is one.
using Refusal = std::string;

struct ObjFace {
    int corners[3];
    int line;      ///< of the file
    int material;  ///< number of its name in ObjMesh::materials, in order of appearance
};
struct ObjMesh {
    std::vector<double> places;  ///< x, y and z of each corner, in units of the file
    std::vector<ObjFace> faces;
    std::vector<std::string> materials;
};
/// Reads v, f and usemtl; everything else is none of a level's. Faces of more corners are cut as fans.
Refusal read_obj(const std::string& text, ObjMesh& mesh, std::ostream& progress);

struct HeightGrid {
    int columns = 0, rows = 0;
    std::vector<double> heights;  ///< row by row; of images 0 .. most
    std::vector<bool> is_hole;    ///< by sample
    double most = 0;              ///< of an image: what white is
};
/// An image of levels of grey, P2 or P5, of 8 or 16 bits. The first line of it is the first row.
Refusal read_pgm(const std::string& bytes, HeightGrid& grid);
/// Numbers in m, a row a line, with commas, semicolons, tabs or spaces between them. What is empty or nan is a hole.
Refusal read_csv(const std::string& text, HeightGrid& grid);

/// Where the lines of a text are.
class Lines {
public:
    explicit Lines(const std::string& text) : text_(text) {}
    /// The next line without its end; false at the end. A line that ends in a backslash goes on in the next where `joined` says so.
    bool next(std::string& line, bool joined = false);
    int number() const { return number_; }  ///< of the line that was read last, where it begins
    size_t place() const { return at_; }

private:
    const std::string& text_;
    size_t at_ = 0;
    int number_ = 0, read_ = 0;
};

/// A word of a line from `at` on; empty at the end.
std::string next_word(const std::string& line, size_t& at, const char* separators = " \t");
/// False where the word is no finite number, or not all of it.
bool number_of(const std::string& word, double& number);
bool whole_number_of(const std::string& word, int64_t& number);

}  // namespace level_tool
