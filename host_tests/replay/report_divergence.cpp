// SPDX-License-Identifier: MIT
#include "replay/report_divergence.h"

#include <algorithm>
#include <iomanip>

#include "replay/snapshot_fields.h"

namespace replay {

namespace {

using ingot::platform::Divergence;

constexpr int lines_max = 20;  ///< of numbers that differ

void write_hex(std::ostream& out, uint64_t bits, int digits) {
    out << "0x" << std::hex << std::setw(digits) << std::setfill('0') << bits << std::dec << std::setfill(' ');
}

void write_value(std::ostream& out, const SnapshotField& field, bool doubles) {
    out << std::setprecision(doubles ? 17 : 9) << field.value(doubles);
    if (!field.is_real) return;
    out << " (";
    write_hex(out, field.bits, doubles ? 16 : 8);
    out << ')';
}

void write_first_other_byte(const Recording& a, const Recording& b, uint32_t step, std::ostream& out) {
    const size_t size_a = a.input_size(step), size_b = b.input_size(step);
    if (size_a != size_b) {
        out << "  inputs of " << size_a << " and " << size_b << " bytes\n";
        return;
    }
    const size_t byte_i = static_cast<size_t>(std::mismatch(a.input(step), a.input(step) + size_a, b.input(step)).first - a.input(step));
    out << "  byte " << byte_i << " of the input is ";
    write_hex(out, a.input(step)[byte_i], 2);
    out << " and ";
    write_hex(out, b.input(step)[byte_i], 2);
    out << '\n';
}

/// The numbers of two states that differ, by body and name.
void write_other_numbers(const RecordedState& a, const RecordedState& b, std::ostream& out) {
    SnapshotFields of_a, of_b;
    for (const auto& [state, fields] : {std::pair(&a, &of_a), std::pair(&b, &of_b)}) {
        const std::string error = read_fields(state->bytes, *fields);
        if (error.empty()) continue;
        out << "  the state of step " << state->step << " is " << error << '\n';
        return;
    }
    if (of_a.signature != of_b.signature) {
        out << "  the states are of different scenes\n";
        return;
    }
    int differing = 0;
    const size_t common = std::min(of_a.fields.size(), of_b.fields.size());
    for (size_t field_i = 0; field_i < common; ++field_i) {
        const SnapshotField &in_a = of_a.fields[field_i], &in_b = of_b.fields[field_i];
        if (in_a.slot != in_b.slot || in_a.name != in_b.name) break;  // a body lives here and not there: its generation was told
        if (in_a.bits == in_b.bits || ++differing > lines_max) continue;
        out << "  " << (in_a.slot < 0 ? std::string("world") : "body in slot " + std::to_string(in_a.slot)) << ": " << in_a.name << " is ";
        write_value(out, in_a, of_a.doubles);
        out << " and ";
        write_value(out, in_b, of_b.doubles);
        out << '\n';
    }
    if (differing > lines_max) out << "  and " << differing - lines_max << " numbers more\n";
    if (differing == 0) out << "  the states of step " << a.step << " are the same\n";
}

}  // namespace

bool report_divergence(const Recording& a, const Recording& b, std::ostream& out) {
    const Divergence divergence = ingot::platform::first_divergence(a, b);
    if (divergence.kind == Divergence::Kind::none) {
        int common = 0;
        for (int step_i = 0; step_i < a.step_count(); ++step_i) common += b.has(a.first_step() + static_cast<uint32_t>(step_i)) ? 1 : 0;
        out << "the same in all " << common << " steps that both have\n";
        return false;
    }
    const uint32_t step = divergence.step;
    out << "step " << step << ": ";
    if (divergence.kind == Divergence::Kind::input) {
        out << "told different things\n";
        write_first_other_byte(a, b, step, out);
    } else {
        out << "told the same, and the hashes are ";
        write_hex(out, a.hash(step), 16);
        out << " and ";
        write_hex(out, b.hash(step), 16);
        out << '\n';
    }
    if (!divergence.is_first) out << "  no earlier step is in both: it may have begun before\n";

    uint32_t at = step;
    while (a.has(at) && b.has(at) && (a.state_of(at) == nullptr || b.state_of(at) == nullptr)) ++at;
    if (!a.has(at) || !b.has(at)) {
        out << "  no state of this step or a later one is in both: keep_state tells bodies and numbers\n";
        return true;
    }
    if (at != step) out << "step " << at << " is the first one with states:\n";
    write_other_numbers(*a.state_of(at), *b.state_of(at), out);
    return true;
}

}  // namespace replay
