#pragma once

#include "GLTest.h"

namespace aolib::test {

/// EGL and OSMesa, core profile: pictures do not depend on the profile.
inline std::vector<TestContext> coreContexts() {
    std::vector<TestContext> contexts;
    for (const TestContext& context : testContexts()) {
        if (context.profile == ContextRequest::Profile::Core) {
            contexts.push_back(context);
        }
    }
    return contexts;
}

} // namespace aolib::test

/// Instantiates a suite for each of them.
#define AOLIB_FOR_CORE_CONTEXTS(suite)                                                             \
    INSTANTIATE_TEST_SUITE_P(Core, suite, testing::ValuesIn(aolib::test::coreContexts()),          \
                             aolib::nameOf)
