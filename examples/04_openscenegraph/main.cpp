// Ambient occlusion in an existing engine: OpenSceneGraph loads a file and draws it, and aolib sits
// in two of its callbacks. What OpenSceneGraph draws after that stays as it is.
//
// aolib: 59 lines, between the marks.
#include <numeric>

#include <osg/Geometry>
#include <osg/TriangleFunctor>
#include <osgDB/ReadFile>
#include <osgViewer/Viewer>

#include <glm/gtc/type_ptr.hpp>

#include "Offscreen.h"
#include "Stage.h"

// [aolib]
#include <aolib/aolib.h>

/// The triangles of a scene graph, in world space.
class Describe : public osg::NodeVisitor {
public:
    explicit Describe(aolib::AmbientOcclusion& ao)
        : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN), ao_(ao) {}
    void apply(osg::Drawable& drawable) override {
        osg::TriangleFunctor<Corners> triangles;
        drawable.accept(triangles);
        const osg::Matrixf world = osg::computeLocalToWorld(getNodePath());
        std::vector<std::uint32_t> indices(triangles.positions.size());
        std::iota(indices.begin(), indices.end(), 0U);
        (void)ao_.addMesh({triangles.positions, {}, indices, glm::make_mat4(world.ptr())});
    }

private:
    struct Corners {
        void operator()(const osg::Vec3& a, const osg::Vec3& b, const osg::Vec3& c) {
            for (const osg::Vec3& corner : {a, b, c}) {
                positions.push_back(glm::make_vec3(corner.ptr()));
            }
        }
        std::vector<glm::vec3> positions;
    };
    aolib::AmbientOcclusion& ao_;
};

struct BeginAo : osg::Camera::DrawCallback {
    explicit BeginAo(aolib::AmbientOcclusion& ao) : ao_(ao) {}
    void operator()(osg::RenderInfo& /*info*/) const override { ao_.aoDrawBegin(); }
    aolib::AmbientOcclusion& ao_;
};

struct EndAo : osg::Camera::DrawCallback {
    explicit EndAo(aolib::AmbientOcclusion& ao) : ao_(ao) {}
    void operator()(osg::RenderInfo& info) const override {
        const osg::Camera& camera = *info.getCurrentCamera();
        const osg::Matrixf view(camera.getViewMatrix());
        const osg::Matrixf projection(camera.getProjectionMatrix());
        const osg::Vec3 eye = camera.getInverseViewMatrix().getTrans();
        ao_.aoSetCamera(glm::make_mat4(view.ptr()), glm::make_mat4(projection.ptr()));
        ao_.aoDrawEnd(eye.x(), eye.y(), eye.z());
    }
    aolib::AmbientOcclusion& ao_;
};
// [/aolib]

namespace {

/// A red sign on top of the picture, which nothing may darken.
osg::ref_ptr<osg::Camera> sign() {
    osg::ref_ptr<osg::Camera> camera = new osg::Camera;
    camera->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
    camera->setRenderOrder(osg::Camera::POST_RENDER);
    camera->setClearMask(GL_DEPTH_BUFFER_BIT);
    camera->setProjectionMatrixAsOrtho2D(0, stage::kWidth, 0, stage::kHeight);
    camera->setViewMatrix(osg::Matrix::identity());
    osg::ref_ptr<osg::Geometry> quad =
        osg::createTexturedQuadGeometry({10, 10, 0}, {40, 0, 0}, {0, 40, 0});
    osg::ref_ptr<osg::Vec4Array> red = new osg::Vec4Array;
    red->push_back({1, 0, 0, 1});
    quad->setColorArray(red, osg::Array::BIND_OVERALL);
    quad->getOrCreateStateSet()->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
    camera->addChild(quad);
    return camera;
}

void setUp(osgViewer::Viewer& viewer, osg::Node& scene) {
    const stage::Camera at = stage::camera();
    viewer.setUpViewerAsEmbeddedInWindow(0, 0, stage::kWidth, stage::kHeight);
    viewer.setThreadingModel(osgViewer::Viewer::SingleThreaded);
    osg::ref_ptr<osg::Group> root = new osg::Group;
    root->addChild(&scene);
    root->addChild(sign());
    viewer.setSceneData(root);
    osg::Camera& camera = *viewer.getCamera();
    camera.setComputeNearFarMode(osg::Camera::DO_NOT_COMPUTE_NEAR_FAR);
    camera.setClearColor({0.60F, 0.72F, 0.86F, 1.0F});
    camera.setViewMatrix(osg::Matrixf(glm::value_ptr(at.view)));
    camera.setProjectionMatrix(osg::Matrixf(glm::value_ptr(at.projection)));
}

int run(const stage::Arguments& arguments) {
    const auto context = stage::openContext(aolib::ContextRequest::Profile::Compatibility);
    const osg::ref_ptr<osgDB::Options> asItIs = new osgDB::Options("noRotation"); // y stays up
    osg::ref_ptr<osg::Node> scene = osgDB::readRefNodeFile(SCENE_FILE, asItIs);
    if (!scene) {
        return stage::fail("NOT TESTED: OpenSceneGraph cannot read " SCENE_FILE);
    }
    osgViewer::Viewer viewer;
    setUp(viewer, *scene);
    // [aolib]
    auto ao = aolib::AmbientOcclusion::create(context->loader(),
                                              {.estimator = aolib::Estimator::LayeredIntervals,
                                               .radius = 1.5F,
                                               .contrast = arguments.neutral ? 0.0F : 1.0F,
                                               .frameBudget = 0.0F,
                                               .cubeMaps = {.faceSize = 256}});
    if (!ao) {
        return stage::fail(ao.status().message());
    }
    if (arguments.ambientOcclusion) {
        Describe describe(*ao);
        scene->accept(describe);
        viewer.getCamera()->setPreDrawCallback(new BeginAo(*ao));
        viewer.getCamera()->setPostDrawCallback(new EndAo(*ao));
    }
    // [/aolib]
    viewer.frame();
    viewer.frame(); // the first may have loaded and compiled, and left state of its own
    std::vector<std::uint8_t> rgb(3 * static_cast<std::size_t>(stage::kWidth * stage::kHeight));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, stage::kWidth, stage::kHeight, GL_RGB, GL_UNSIGNED_BYTE, rgb.data());
    // [aolib]
    if (!ao->lastStatus()) {
        return stage::fail(ao->lastStatus().message());
    }
    // [/aolib]
    return stage::save(arguments.picture, rgb);
}

} // namespace

int main(int argc, char** argv) {
    const stage::Arguments arguments = stage::parse(argc, argv);
    return arguments.picture.empty() ? 2 : run(arguments);
}
