#pragma once

#include <map>
#include <string>
#include <vector>

#include <GL/glcorearb.h>

#include <aolib/ProcAddressLoader.h>

namespace aolib {

/// Hands out GL functions that tell what passes through them. One exists at a time: GL functions
/// carry no pointer of ours.
class WatchedLoader {
public:
    /// Times that a fence is asked for before it says that it has passed.
    static constexpr int kEarly = 2;

    /// @param renderer  what GL says that it is; empty leaves it.
    WatchedLoader(const ProcAddressLoader& real, const std::string& renderer);
    ~WatchedLoader();
    WatchedLoader(const WatchedLoader&) = delete;
    WatchedLoader& operator=(const WatchedLoader&) = delete;

    const ProcAddressLoader& loader() const { return loader_; }

    int drawn = 0;                  ///< times that triangles of a mesh were drawn
    std::vector<std::string> waits; ///< calls that wait for the GPU, by name

    // For the functions handed out.
    std::string renderer;
    PFNGLGETSTRINGPROC getString;
    PFNGLGETINTEGERVPROC getIntegerv;
    PFNGLDRAWELEMENTSPROC drawElements;
    PFNGLREADPIXELSPROC readPixels;
    PFNGLCLIENTWAITSYNCPROC clientWaitSync;
    PFNGLDELETESYNCPROC deleteSync;
    PFNGLFINISHPROC finish;
    std::map<GLsync, int> asked; ///< how often, for each fence

private:
    ProcAddressLoader loader_;
};

} // namespace aolib
