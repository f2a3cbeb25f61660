#include "viewer/StateReport.h"

#include <nlohmann/json.hpp>

#include "viewer/OptionTexts.h"

namespace aolib::viewer {

namespace {

using Json = nlohmann::ordered_json;

Json list(const glm::vec3& v) {
    return Json::array({v.x, v.y, v.z});
}

Json rectangle(const glm::vec4& place) {
    return Json::array({place.x, place.y, place.z, place.w});
}

Json truthOf(const ViewerState& state, const TruthWorker::State& truth) {
    Json json;
    json["rays"] = truth.truth ? truth.truth->rays : 0;
    json["progress"] = truth.progress;
    json["working"] = truth.working;
    if (truth.truth) {
        json["noise"] = truth.truth->noise;
    }
    if (state.error) {
        json["rmse"] = state.error->rmse;
        json["bias"] = state.error->bias;
    }
    return json;
}

} // namespace

std::string stateReport(const ViewerState& state, const PanelFacts& facts, const SidePanel& panel,
                        const ReportFacts& report) {
    const NamedCamera& camera = state.camera.camera();
    Json json;
    json["frames"] = report.frames;
    json["settled"] = report.settled;
    json["scene"] = facts.scene;
    json["triangles"] = facts.triangles;
    json["picture"] = {report.picture.x, report.picture.y};
    json["mode"] = state.camera.mode == CameraMode::Walk ? "walk" : "orbit";
    json["eye"] = list(camera.eye);
    json["target"] = list(camera.target);
    json["occlusion"] = state.occlusion;
    json["compared"] = std::string(choiceOf(state.compared).name);
    json["split"] = state.split.share();
    json["panel"] = state.panel;
    json["help"] = state.help;
    json["gizmos"] = state.gizmos;
    json["chosen"] = state.chosen ? Json(static_cast<unsigned>(*state.chosen)) : Json(nullptr);
    json["message"] = report.message;
    json["coverage"] = facts.statistics.coverage;
    json["computed"] = facts.statistics.computed;
    json["cube_maps"] = Json::array();
    for (const CubeMapInfo& cubeMap : facts.cubeMaps) {
        json["cube_maps"].push_back(list(cubeMap.position));
    }
    json["marks"] = Json::array();
    for (const Gizmo& gizmo : report.gizmos) {
        json["marks"].push_back(gizmo.visible ? Json{gizmo.centre.x, gizmo.centre.y}
                                              : Json(nullptr));
    }
    json["truth"] = truthOf(state, facts.truth);
    json["environment"] = state.environment;
    json["light"]["working"] = facts.light.working;
    json["light"]["progress"] = facts.light.progress;
    json["light"]["vertices"] = facts.light.scene ? facts.light.scene->vertices() : 0;
    for (const OptionText& text : optionTexts(state.options)) {
        json["options"][text.name] = text.value;
    }
    for (const auto& [name, place] : panel.options().places()) {
        json["widgets"][name] = rectangle(place);
    }
    json["widgets"]["path"] = rectangle(panel.pathPlace());
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace aolib::viewer
