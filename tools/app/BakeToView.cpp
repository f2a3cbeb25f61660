#include "app/BakeToView.h"

#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "app/BakedImage.h"
#include "app/Table.h"
#include "app/View.h"
#include "raytracing/RayScene.h"
#include "reference/PictureTracer.h"

namespace aolib::app {

namespace {

/// The triangle's own normal, any length.
glm::vec3 planeOf(const TriangleMesh& mesh, std::uint32_t triangle) {
    const auto corner = [&](std::size_t k) {
        return glm::dvec3(mesh.positions[mesh.indices[std::size_t{triangle} * 3 + k]]);
    };
    const glm::dvec3 normal = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
    const double length = glm::length(normal);
    return length > 0.0 ? glm::vec3(normal / length) : glm::vec3(0.0F);
}

Result<bake::ViewPixels, Failure> pixelsOf(const View& view) {
    const TriangleMesh mesh = view.model.flattened();
    Result<RayScene> scene = RayScene::create(mesh);
    if (!scene) {
        return badInput(view.model.name + ": " + scene.status().message());
    }
    PictureCamera camera;
    camera.view = glm::dmat4(viewMatrix(view.camera));
    camera.projection = glm::dmat4(
        projectionMatrix(view.camera, static_cast<float>(view.width) / float(view.height)));
    camera.width = view.width;
    camera.height = view.height;
    PictureSettings settings;
    settings.trace.rays = 2; // its W is of no use here
    settings.trace.radius = view.diagonal;
    settings.normals = NormalSource::Given;
    settings.surfaces = true;
    Result<Picture> picture = tracePicture(*scene, camera, settings);
    if (!picture) {
        return badInput(view.model.name + ": " + picture.status().message());
    }
    bake::ViewPixels pixels;
    pixels.width = view.width;
    pixels.height = view.height;
    pixels.positions = std::move(picture->position);
    pixels.normals = std::move(picture->normal);
    for (std::size_t i = 0; i < pixels.normals.size(); ++i) {
        pixels.planes.push_back(pixels.normals[i] == glm::vec3(0.0F)
                                    ? glm::vec3(0.0F)
                                    : planeOf(mesh, picture->triangle[i]));
    }
    return pixels;
}

} // namespace

MaybeFailure BakeToView::prepare(OutputFiles& files) {
    if (flags_.ao.empty() || !flags_.out.empty()) {
        return badInput("--target camera writes a picture with --ao, and no model");
    }
    for (const auto& [option, file] :
         {std::pair("--ao", &flags_.ao), std::pair("--bent-normals", &flags_.bentNormals)}) {
        if (!file->empty()) {
            if (MaybeFailure failure = files.announce(option, *file, bakedImageExtensions())) {
                return failure;
            }
        }
    }
    Result<View, Failure> view = openSceneView(model_, flags_.camera);
    if (!view) {
        return view.error();
    }
    view->width = flags_.width;
    view->height = flags_.height;
    camera_ = view->camera.name;
    Result<bake::ViewPixels, Failure> pixels = pixelsOf(*view);
    if (!pixels) {
        return pixels.error();
    }
    view_ = std::move(*pixels);
    return std::nullopt;
}

AoStatus BakeToView::bake(bake::AbstractBaker& baker, const bake::BakeProgress& progress) {
    Result<bake::BakedMap> baked = baker.bakeView(view_, progress);
    if (!baked) {
        return baked.status();
    }
    picture_ = std::move(*baked);
    return {};
}

Result<std::string, Failure> BakeToView::put(OutputFiles& files) {
    const std::filesystem::path ao(flags_.ao);
    if (ao.extension() == ".pfm") { // -1 is the background, as in those of "aolib truth"
        FloatImage image(picture_.width, picture_.height, 1);
        image.pixels = picture_.visibility;
        files.put(ao, std::move(image));
    } else {
        putImage(files, ao, occlusionImage(picture_), flags_.bits);
    }
    if (!flags_.bentNormals.empty()) {
        putImage(files, flags_.bentNormals, directionImage(picture_), flags_.bits);
    }
    double sum = 0.0;
    std::size_t seen = 0;
    for (const float w : picture_.visibility) {
        sum += w >= 0.0F ? double(w) : 0.0;
        seen += w >= 0.0F ? 1U : 0U;
    }
    Table table({"model", "camera", "pixels", "mean W"});
    table.add({input_.name, camera_, grouped(seen),
               knownNumber(seen > 0 ? sum / double(seen) : -1.0, 3)});
    return table.text();
}

} // namespace aolib::app
