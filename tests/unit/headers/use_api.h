// What a host says of aolib, with names that were macros' before.
#pragma once

#include <aolib/OptionFields.h>
#include <aolib/aolib.h>

inline aolib::AoStatus useApi(aolib::AmbientOcclusion& ao) {
    aolib::Options options;
    options.falloff = aolib::Falloff::Off;
    options.debugView = aolib::DebugView::Off;
    options.estimator = aolib::Estimator::Automatic;
    aolib::visitOptions(options, [](auto&&...) {});
    ao.setSceneRenderer([](const aolib::FaceView&) {}, glm::vec3(-1.0F), glm::vec3(1.0F));
    const auto mesh = ao.addMesh({});
    return mesh ? ao.setOptions(options) : mesh.status();
}
