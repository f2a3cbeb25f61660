// What peel_entry.frag says of an entry that is no solid's: an open mesh without thickness, or the side of
// one behind which space is taken as solid.
const float kOpenMeshEntry = 0.0;
const float kShellEntry = -1.0;
