#pragma once

namespace aolib::lighting {

/// The two cells of a table that a place lies between, and how far.
struct Between {
    int lower = 0;
    int upper = 0;
    float part = 0.0F;
};

/// Between the middles of columns, all the way round. @param place  0 to 1.
Between columnsAt(float place, int count);

/// Between steps from 0 to 1, both ends included.
Between stepsAt(float place, int count);

} // namespace aolib::lighting
