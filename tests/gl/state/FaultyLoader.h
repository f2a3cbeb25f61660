#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>

#include <GL/glcorearb.h>

#include <aolib/ProcAddressLoader.h>

namespace aolib {

/// What GL can refuse.
enum class Fault {
    GenTextures,       ///< names of 0
    GenBuffers,        ///< names of 0
    GenFramebuffers,   ///< names of 0
    GenVertexArrays,   ///< names of 0
    GenQueries,        ///< names of 0
    CreateShader,      ///< a name of 0
    CreateProgram,     ///< a name of 0
    CompileShader,     ///< the status says failure
    LinkProgram,       ///< the status says failure
    FramebufferStatus, ///< unsupported
    TextureStorage,    ///< no memory: the texture has no size
    TextureSize,       ///< the texture says that it has no size
    BufferStorage,     ///< no memory: the buffer has no size
    FenceSync,         ///< a null fence
    MapBuffer,         ///< a null address
};
inline constexpr int kFaults = 15;
const char* faultName(Fault fault);

/// Hands out GL functions that keep a ledger of the objects made and deleted through them, and that
/// fail once when told to. One exists at a time: GL functions carry no pointer of ours.
class FaultyLoader {
public:
    explicit FaultyLoader(const ProcAddressLoader& real);
    ~FaultyLoader();
    FaultyLoader(const FaultyLoader&) = delete;
    FaultyLoader& operator=(const FaultyLoader&) = delete;

    const ProcAddressLoader& loader() const { return loader_; }

    /// Lets the n-th call from now, 1 being the next, fail; it alone.
    void failAt(Fault fault, int n);
    void heal() { countdown_ = 0; }
    /// Whether the call that failAt() announced was made.
    bool failed() const { return failed_; }
    /// Objects made and not deleted: "textures 3 7 8", empty for none.
    std::string alive() const;

    // For the functions handed out.
    bool fails(Fault fault);
    template <typename Function>
    Function real(const char* name) const {
        return reinterpret_cast<Function>(functions_.at(name));
    }
    std::map<std::string, std::set<std::uintptr_t>> ledger;
    int timestamps = 0; ///< asked for so far

private:
    ProcAddressLoader loader_;
    std::map<std::string, void*> functions_;
    Fault fault_ = Fault::GenTextures;
    int countdown_ = 0;
    bool failed_ = false;
};

} // namespace aolib
