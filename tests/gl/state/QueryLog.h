#pragma once

#include <set>

#include <GL/glcorearb.h>

#include <aolib/ProcAddressLoader.h>

namespace aolib {

/// Hands out GL functions that note what state is asked for. One exists at a time: GL functions
/// carry no pointer of ours.
class QueryLog {
public:
    explicit QueryLog(const ProcAddressLoader& real);
    ~QueryLog();
    QueryLog(const QueryLog&) = delete;
    QueryLog& operator=(const QueryLog&) = delete;

    const ProcAddressLoader& loader() const { return loader_; }
    void clear();

    std::set<GLenum> asked; ///< since clear()
    int queries = 0;        ///< since clear()
    int groups = 0;         ///< debug groups that were opened since clear()

private:
    ProcAddressLoader loader_;
};

} // namespace aolib
