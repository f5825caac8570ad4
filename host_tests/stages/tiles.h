// SPDX-License-Identifier: MIT
// Bodies in tiles without a world around them: what a stage works on.
#pragma once

#include <ingot/body/freeze_bad_bodies.h>
#include <ingot/body/auxiliary.h>
#include <ingot/world/edit_bodies.h>

#include <vector>

namespace ingot_stages {

/// A number of slots, each the identity body until it is written; the stages' view of them is view().
class Tiles {
public:
    explicit Tiles(int slots)
        : rotation_(tiles_for(slots)),
          translation_(tiles_for(slots)),
          compensation_(tiles_for(slots)),
          energy_(tiles_for(slots)) {
        for (int slot = 0; slot < view().tile_count * ingot::lanes; ++slot) ingot::set_identity_body(view(), slot);
    }

    ingot::BodyView view() {
        return {rotation_.data(), translation_.data(), compensation_.data(), energy_.data(),
                static_cast<int>(rotation_.size())};
    }

    /// Without the checks of World::add: stages take any numbers.
    void write(int slot, const ingot::BodyDef& def) { ingot::write_body(view(), slot, def); }

    ingot::BodyState state(int slot) { return ingot::read_state(view(), slot); }
    ingot::RotationTile& rotation(int slot) { return rotation_[static_cast<std::size_t>(slot / ingot::lanes)]; }
    ingot::TranslationTile& translation(int slot) { return translation_[static_cast<std::size_t>(slot / ingot::lanes)]; }

private:
    static std::size_t tiles_for(int slots) { return static_cast<std::size_t>((slots + ingot::lanes - 1) / ingot::lanes); }

    std::vector<ingot::RotationTile> rotation_;
    std::vector<ingot::TranslationTile> translation_;
    std::vector<ingot::CompensationTile> compensation_;
    std::vector<ingot::EnergyTile> energy_;
};

}  // namespace ingot_stages
