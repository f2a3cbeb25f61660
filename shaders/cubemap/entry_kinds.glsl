// What peel_entry.frag says of an entry that is no solid's: a sheet without thickness, or the side of
// one behind which space is taken as solid.
const float kSheetEntry = 0.0;
const float kLidEntry = -1.0;
