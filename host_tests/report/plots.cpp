// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>

#include "write.h"

namespace report {

namespace {

struct Series {
    std::string title;
    std::string color;
    std::vector<std::pair<double, double>> points;
    bool thick = false;
};

/// The same colour for a method on every plot.
std::string color_of(const std::string& method) {
    static const std::map<std::string, std::string> colors = {
        {"default", "#d1495b"},           {"listing1_euler", "#8d99ae"},           {"lie_midpoint", "#6c757d"},
        {"rk4_polar", "#3a86ff"},         {"moser_veselov_2", "#b5a642"},          {"moser_veselov_4", "#e09f3e"},
        {"moser_veselov_4_plain", "#ffb703"}, {"moser_veselov_6", "#9e2a2b"},   {"moser_veselov_6_plain", "#f28482"},    {"moser_veselov_8", "#7b2cbf"},
        {"moser_veselov_10", "#240046"},  {"symmetric_top_splitting_2", "#52b788"}, {"symmetric_top_splitting_6", "#1b4332"},
        {"symmetric_top", "#00b4d8"},     {"exact_elliptic", "#000000"},           {"kick_drift_kick", "#d1495b"},
        {"blanes_moan_4", "#1b4332"},     {"commutator_free_4", "#3a86ff"}};
    const auto found = colors.find(method);
    return found == colors.end() ? "#444444" : found->second;
}

struct Sheet {
    std::string name, title, x_label, y_label, how_to_read, more;  ///< more: gnuplot commands
    std::vector<Series> series;
};

std::string svg_of(const std::string& path) {
    std::ifstream file(path);
    std::stringstream all;
    all << file.rdbuf();
    const std::string text = all.str();
    const std::size_t begin = text.find("<svg");
    return begin == std::string::npos ? "" : text.substr(begin);
}

/// Names inside an SVG are global once it stands in a page with others.
std::string with_own_names(std::string svg, const std::string& prefix) {
    for (const char* name : {"gnuplot_plot_", "gpDot", "gpPt", "textbox", "greybox", "LinearGradient", "RadialGradient"}) {
        std::string renamed;
        std::size_t from = 0;
        for (std::size_t at; (at = svg.find(name, from)) != std::string::npos; from = at + std::string(name).size())
            renamed += svg.substr(from, at - from) + prefix + "_" + name;
        svg = renamed + svg.substr(from);
    }
    return svg;
}

Plot draw(const Sheet& sheet, const std::string& dir) {
    Plot plot{sheet.name, sheet.title, sheet.how_to_read, ""};
    if (std::string(INGOT_GNUPLOT).empty()) return plot;
    const std::string script = dir + "/" + sheet.name + ".gp", svg = dir + "/" + sheet.name + ".svg";
    {
        std::ofstream file(script);
        file << "set terminal svg size 980,560 font 'sans-serif,14' background 'white'\nset output '" << svg << "'\nset grid lc rgb '#e4e8ef'\nset border lc rgb '#6a7386'\n"
             << "set logscale xy\nset format x '10^{%L}'\nset format y '10^{%L}'\nset key outside right top spacing 1.1 samplen 2 noenhanced\nset xlabel '" << sheet.x_label
             << "'\nset ylabel '" << sheet.y_label << "'\n" << sheet.more << "\n";
        for (std::size_t i = 0; i < sheet.series.size(); ++i) {
            file << "$data" << i << " << EOD\n";
            for (const auto& point : sheet.series[i].points) file << point.first << ' ' << point.second << '\n';
            file << "EOD\n";
        }
        for (std::size_t i = 0; i < sheet.series.size(); ++i) {
            file << (i == 0 ? "plot " : ", ") << "$data" << i << " using 1:2 with linespoints lw " << (sheet.series[i].thick ? 4 : 1.8) << " pt 7 ps "
                 << (sheet.series[i].thick ? 0.7 : 0.45) << " lc rgb '" << sheet.series[i].color << "' title '" << sheet.series[i].title << "'";
        }
        file << "\n";
    }
    const std::string command = std::string(INGOT_GNUPLOT) + " '" + script + "'";
    if (std::system(command.c_str()) == 0) plot.svg = with_own_names(svg_of(svg), sheet.name);
    std::remove(script.c_str());
    return plot;
}

bool plottable(double x, double y) { return x > 0 && y > 0 && std::isfinite(x) && std::isfinite(y); }

/// Error of the book case after a minute against what a simulated second costs.
enum class Cost { time, flops, instructions };

/// What a step costs by the measure; flops are counted in float, and the default of double is the method of order 10.
double cost_of_step(const Rows& rows, const std::string& method, const std::string& scalar, Cost cost) {
    if (cost == Cost::time) return rows.value("rotation", "bodies_1024", method, scalar, 4, 0, "ns_per_body_step", 0);
    if (cost == Cost::instructions) return rows.value("mcu", "one_body", method, "float", 0, 0, "instructions_per_body_step", 0);
    const std::string counted = method == "default" && scalar == "double" ? "moser_veselov_10" : method;
    double sum = 0;
    for (const char* metric : {"additions_and_multiplications", "divisions", "square_roots"})
        sum += rows.value("rotation", "book", counted, "float", 0, 0, metric, 0);
    return sum;
}

Sheet work_precision(const Rows& rows, const std::string& scalar, Cost measure) {
    Sheet sheet;
    sheet.name = "work_precision_" + scalar + (measure == Cost::time ? "_ns" : measure == Cost::flops ? "_flops" : "_instructions");
    sheet.title = "Error against cost, " + scalar + (measure == Cost::time ? " (time)" : measure == Cost::flops ? " (flops)" : " (instructions of a Cortex-M4F)");
    sheet.x_label = measure == Cost::time    ? "ns for a simulated second, one body, 4 lanes"
                    : measure == Cost::flops ? "additions, multiplications, divisions and roots for a simulated second, one body"
                                             : "instructions for a simulated second, one body";
    sheet.y_label = "attitude error after 60 s, rad";
    sheet.how_to_read = "Each line is a method, each point a step length from 15 Hz (left) to 960 Hz (right): lower is more accurate, left is cheaper. A line that is "
                        "flat has reached the rounding of the numbers: smaller steps buy nothing.";
    std::map<std::string, Series> lines;
    std::vector<std::string> order;
    for (const Row& row : rows.all()) {
        if (row.suite != "rotation" || row.case_name != "book" || row.scalar != scalar || row.metric != "attitude_error" || !(row.h > 0)) continue;
        const double cost = cost_of_step(rows, row.method, scalar, measure);
        if (!plottable(cost / row.h, row.value)) continue;
        if (lines.find(row.method) == lines.end()) order.push_back(row.method);
        Series& line = lines[row.method];
        line.title = row.method;
        line.color = color_of(row.method);
        line.thick = row.method == "default";
        line.points.emplace_back(cost / row.h, row.value);
    }
    for (const std::string& method : order) sheet.series.push_back(lines[method]);
    return sheet;
}

Sheet float_floor(const Rows& rows) {
    Sheet sheet{"float_floor", "The floor of float", "steps a second", "attitude error after 60 s, rad",
                "Error of the book case in float against the rate. Left of the floor the error of the method shows, right of it the rounding of every step: a method of "
                "order 6 is best at 15 to 60 Hz, and compensation keeps it there.", "", {}};
    std::map<std::string, Series> lines;
    std::vector<std::string> order;
    for (const Row& row : rows.all()) {
        if (row.suite != "rotation" || row.case_name != "book" || row.scalar != "float" || row.metric != "attitude_error" || !plottable(row.h, row.value)) continue;
        if (lines.find(row.method) == lines.end()) order.push_back(row.method);
        Series& line = lines[row.method];
        line.title = row.method;
        line.color = color_of(row.method);
        line.thick = row.method == "default";
        line.points.emplace_back(1 / row.h, row.value);
    }
    for (const std::string& method : order) sheet.series.push_back(lines[method]);
    return sheet;
}

Sheet drift(const Rows& rows, const std::string& metric) {
    Sheet sheet{"drift_" + metric, metric == "orthogonality" ? "Does A stay a rotation?" : "Does the energy drift?", "steps", metric == "orthogonality" ? "largest entry of |A^T A - 1|" : "relative energy error",
                "The worst of each stretch of a long flight at 60 Hz, against its end. Flat: the method keeps it. Rising with slope 1/2: roundings add up like a random walk; "
                "slope 1: the method loses it.", "", {}};
    std::map<std::string, Series> lines;
    std::vector<std::string> order;
    for (const Row& row : rows.all()) {
        if (row.suite != "drift" || row.metric != metric) continue;
        const double steps = std::atof(row.case_name.c_str() + row.case_name.find('_') + 1);
        if (!plottable(steps, row.value)) continue;
        const std::string title = row.method + ", " + row.scalar;
        if (lines.find(title) == lines.end()) order.push_back(title);
        Series& line = lines[title];
        line.title = title;
        line.color = color_of(row.method);
        line.thick = row.method == "default";
        line.points.emplace_back(steps, row.value);
    }
    for (const std::string& title : order) sheet.series.push_back(lines[title]);
    return sheet;
}

Sheet driven(const Rows& rows) {
    Sheet sheet{"work_precision_driven", "Driven bodies: error against cost, double", "ns for a simulated second, one body, 4 lanes", "attitude error, rad",
                "Three heavy tops, by every flight, from 32 Hz (left) to 512 Hz. The schemes of order 4 fall four times as steeply as they move to the right twice.", "", {}};
    std::map<std::string, Series> lines;
    std::vector<std::string> order;
    for (const Row& row : rows.all()) {
        if (row.suite != "driven" || row.scalar != "double" || row.metric != "attitude_error") continue;
        if (row.case_name != "asymmetric_chaotic" && row.case_name != "looping" && row.case_name != "hanging_asymmetric") continue;
        const double cost = rows.value("driven", "bodies_1024", row.method, "double", 4, 0, "ns_per_body_step", 0);
        if (!plottable(cost / row.h, row.value)) continue;
        const std::string title = row.method + ", " + row.case_name;
        if (lines.find(title) == lines.end()) order.push_back(title);
        Series& line = lines[title];
        line.title = title;
        line.color = color_of(row.method);
        line.points.emplace_back(cost / row.h, row.value);
    }
    for (const std::string& title : order) sheet.series.push_back(lines[title]);
    return sheet;
}

Sheet throughput(const Rows& rows) {
    Sheet sheet{"throughput", "Throughput: cost of a body as their number grows", "bodies", "ns per body-step",
                "The whole public step of the default method. One body costs as much as a vector of them; from there to 65536 bodies the cost stays, while memory can deliver.", "", {}};
    for (const char* scalar : {"float", "double"}) {
        for (const int lanes : {1, 4, 8}) {
            Series line;
            line.title = std::string(scalar) + ", " + std::to_string(lanes) + (lanes == 1 ? " lane" : " lanes");
            line.color = std::string(scalar) == "float" ? (lanes == 1 ? "#f4a3ac" : lanes == 4 ? "#d1495b" : "#7a1f2b") : (lanes == 1 ? "#9fc5ff" : lanes == 4 ? "#3a86ff" : "#123f80");
            for (const int bodies : {1, 64, 1024, 4096, 65536}) {
                const double ns = rows.value("throughput", "bodies_" + std::to_string(bodies), "default", scalar, lanes, 0, "ns_per_body_step", 0);
                if (plottable(bodies, ns)) line.points.emplace_back(bodies, ns);
            }
            if (!line.points.empty()) sheet.series.push_back(line);
        }
    }
    sheet.more = "set format x '%g'\nset format y '%g'\nset yrange [5:500]";
    return sheet;
}

}  // namespace

std::vector<Plot> draw_plots(const Rows& rows, const std::string& dir) {
    std::vector<Plot> plots;
    for (const Sheet& sheet : {work_precision(rows, "double", Cost::time), work_precision(rows, "double", Cost::flops), work_precision(rows, "float", Cost::time),
                               work_precision(rows, "float", Cost::flops), work_precision(rows, "float", Cost::instructions), float_floor(rows),
                               driven(rows), drift(rows, "energy_error"), drift(rows, "orthogonality"), throughput(rows)})
        if (!sheet.series.empty()) plots.push_back(draw(sheet, dir));
    return plots;
}

}  // namespace report
