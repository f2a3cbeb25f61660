#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include <aolib/bake/AbstractBaker.h>

#include "app/Failure.h"
#include "app/OutputFiles.h"

namespace aolib::app {

/// What baked values go to: a model's textures, its vertices, or its vertices in several poses.
/// Called in this order: prepare(), then beginRound() and bake() for each round, then put().
class AbstractBakeDestination {
public:
    AbstractBakeDestination() = default;
    AbstractBakeDestination(const AbstractBakeDestination&) = delete;
    AbstractBakeDestination& operator=(const AbstractBakeDestination&) = delete;
    virtual ~AbstractBakeDestination() = default;

    /// Readies the model and announces files of its own, before the long work. Errors: BadInput.
    virtual MaybeFailure prepare(OutputFiles& files) = 0;
    /// How many bakes it takes.
    virtual std::size_t rounds() const { return 1; }
    /// Moves the model to what the next bake is of. Errors: BadInput.
    virtual MaybeFailure beginRound(std::size_t /*round*/) { return std::nullopt; }
    /// Errors: the baker's.
    virtual AoStatus bake(bake::AbstractBaker& baker, const bake::BakeProgress& progress) = 0;
    /// Puts the values into the model and into files. Gives a table for people.
    virtual Result<std::string, Failure> put(OutputFiles& files) = 0;
    /// All files have been written.
    virtual void succeed() {}
};

} // namespace aolib::app
