#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <aolib/AbstractTexelTracer.h>
#include <aolib/Export.h>
#include <aolib/HostTextures.h>
#include <aolib/Options.h>
#include <aolib/ProcAddressLoader.h>
#include <aolib/Scene.h>
#include <aolib/SceneRenderer.h>
#include <aolib/Statistics.h>
#include <aolib/Status.h>
#include <aolib/ViewId.h>

namespace aolib {

/// Ambient occlusion for an OpenGL renderer: describe the scene once, wrap each frame.
///
/// Every call reports an AoStatus and never throws, prints or aborts. A failed call leaves the
/// scene, the cube maps and the host's GL state unchanged; exceptions are stated at the call.
/// Threads: call an instance from one thread at a time.
///
/// Calls marked "Context" need OpenGL. They work in the context that was current at create() and in
/// every context that shares objects with that one, from any thread.
/// Before a call in another context, finish the commands of the previous one (glFinish or a fence).
/// Without a current context a marked call changes nothing and returns NoContext.
/// In a context that shares no objects it changes nothing and returns WrongContext.
/// Calls without the mark need no context.
class AOLIB_EXPORT AmbientOcclusion {
public:
    /// Receives the progress of a long call, 0 to 1, never decreasing. Returning false cancels the
    /// call.
    using ProgressCallback = std::function<bool(float progress)>;
    /// Receives each failure, after lastStatus() has stored it.
    using MessageSink = std::function<void(const AoStatus&)>;

    /// Makes an instance for the current context: OpenGL 3.3 or newer, core or compatibility.
    /// @param loader  returns the address of a GL function, as eglGetProcAddress does.
    /// Errors: NoContext, MissingCapability, InvalidOption, ShaderError, OutOfMemory. Context.
    /// Since 0.1.
    static Result<AmbientOcclusion> create(const ProcAddressLoader& loader,
                                           const Options& options = {});

    AmbientOcclusion(AmbientOcclusion&&) noexcept;
    /// Destroys the former content as the destructor does.
    AmbientOcclusion& operator=(AmbientOcclusion&&) noexcept;
    /// Deletes every GL object that the current context may delete.
    /// If the instance worked in one context and that context is current, all objects are deleted.
    /// Framebuffers, vertex arrays and queries of other contexts are not shared by GL: these are
    /// freed with those contexts.
    /// Without a context, or in one that shares no objects, nothing is deleted.
    ~AmbientOcclusion();
    /// Drops every GL object without calling GL: for a context that was lost or destroyed.
    /// Calls that need a context return NoContext afterwards; the scene can still be edited.
    /// Errors, in lastStatus(): InvalidCallOrder within the scene renderer. Since 0.1.
    void abandon();

    // ---- Options ---------------------------------------------------------------------------

    const Options& options() const;
    /// Sets the options from the next frame on. Data that depends on a changed option is rebuilt;
    /// the scene is kept. A new `backbone` replaces the strategy.
    /// Errors, which change nothing: InvalidOption, ShaderError, OutOfMemory.
    /// Context, if the backbone changes. Since 0.1.
    AoStatus setOptions(const Options& options);

    /// Sets the tracer that `Estimator::RayTraced` uses; empty removes the tracer. Cube maps that
    /// another tracer computed are traced again. Since 0.1.
    void setTexelTracer(std::unique_ptr<AbstractTexelTracer> tracer);

    // ---- Scene definition, one vertex at a time (thesis 4.7.1) -----------------------------

    /// Starts a mesh. Errors: InvalidCallOrder inside another mesh.
    AoStatus meshBegin();
    /// Sets the normal of the vertices that follow. A mesh with normals sets the first one before
    /// its first vertex.
    /// Errors: InvalidCallOrder, InvalidNormal.
    AoStatus aoNormal3f(float x, float y, float z);
    /// Adds a vertex, world units. Errors: InvalidCallOrder, InvalidPosition.
    AoStatus aoVertex3f(float x, float y, float z);
    /// Starts a run of indices. Errors: InvalidCallOrder, InvalidPrimitive.
    AoStatus aoBegin(AoPrimitive primitive);
    /// Adds an index of a vertex given before. Errors: InvalidCallOrder, InvalidIndex.
    AoStatus aoVertexIndex(std::uint32_t index);
    /// Ends the run. Errors: InvalidCallOrder, IncompletePrimitive.
    AoStatus aoEnd();
    /// Ends the mesh and adds it to the scene. A mesh with invalid data is dropped as a whole, and
    /// the error of that data is returned again. Errors: InvalidCallOrder, EmptyMesh, and those of
    /// the calls since meshBegin().
    Result<MeshId> meshEnd();

    // ---- Scene definition in bulk ----------------------------------------------------------

    /// Adds a mesh. Errors: InvalidPosition, InvalidNormal, InvalidIndex, IncompletePrimitive,
    /// EmptyMesh. Since 0.1.
    Result<MeshId> addMesh(const MeshData& mesh);
    /// Replaces the content and transform of a mesh; its id stays. Errors: UnknownMesh, and those
    /// of addMesh().
    AoStatus replaceMesh(MeshId id, const MeshData& mesh);
    /// Replaces the transform of a mesh, model to world. Errors: UnknownMesh, InvalidPosition.
    AoStatus moveMesh(MeshId id, const glm::mat4& transform);
    /// Removes a mesh from the scene. Errors: UnknownMesh.
    AoStatus removeMesh(MeshId id);

    // ---- Scene definition by drawing -------------------------------------------------------

    /// Sets a callback that draws the occluders with the host's shaders, once per computed cube map
    /// face. The callback replaces the triangles of the meshes.
    /// Only the first surface is captured; `layered-intervals` assumes a thickness behind it.
    /// `Estimator::RayTraced` uses only the described meshes.
    /// @param renderer  kept until replaced; empty selects the meshes again.
    /// @param min,max   bounding box of everything drawn, world units.
    /// Errors: InvalidPosition (not finite, or min exceeds max in a component), InvalidCallOrder
    /// within the callback. Since 0.1.
    AoStatus setSceneRenderer(SceneRenderer renderer, const glm::vec3& min, const glm::vec3& max);
    /// Recomputes the cube maps that see a box in which the renderer's geometry changed.
    /// @param min,max  box around the changed geometry before and after the change, world units.
    /// Errors: InvalidPosition, NoScene without a renderer. Since 0.1.
    AoStatus aoSceneChanged(const glm::vec3& min, const glm::vec3& max);

    // ---- Cube maps -------------------------------------------------------------------------

    /// Places a cube map.
    /// If `Options::frameBudget` is 0, its ambient occlusion is computed before this call returns;
    /// otherwise over the following frames.
    /// @param position  world units; moved to free space if it lies on a surface.
    /// Errors: InvalidCallOrder (the backbone keeps no cube maps), InvalidPosition, NoScene,
    /// MissingCapability, OutOfMemory, CallbackFailed. Context. Thesis 4.2.1. Since 0.1.
    Result<CubeMapId> addCubeMap(const glm::vec3& position);
    /// Computes all cube maps of addCubeMap() completely before it returns, without regard to the
    /// frame budget: for a loading screen.
    /// @param callback   called about every 20 milliseconds, and with 1 at the end; may be empty.
    ///                   GL state is the host's during the callback, which may draw and swap. Calls
    ///                   to the same instance fail with InvalidCallOrder meanwhile.
    /// @param positions  cube maps to place first, as by addCubeMap(), world units. A position that
    ///                   already has a cube map of addCubeMap() gets no second one.
    /// Errors: InvalidCallOrder (within a frame, or the backbone keeps no cube maps), Cancelled
    /// (the callback returned false), CallbackFailed, and those of addCubeMap().
    /// After any error, texels that were computed stay. After Cancelled, later frames compute the
    /// rest. Context. Since 0.1.
    AoStatus prepare(const ProgressCallback& callback, std::span<const glm::vec3> positions = {});
    /// Removes a cube map. Errors: UnknownCubeMap. Context.
    AoStatus removeCubeMap(CubeMapId id);
    /// Removes all cube maps; the scene stays. Context.
    AoStatus clear();
    /// Lists the cube maps that exist, oldest first.
    std::vector<CubeMapInfo> cubeMaps() const;

    // ---- Frame (thesis 4.7.2) --------------------------------------------------------------

    /// Sets the camera of the following frames. Matrices are column-major, for column vectors, as
    /// the host draws with them. Eye space may be right-handed or left-handed.
    /// @param view        world to eye.
    /// @param projection  eye to clip.
    /// Errors: InvalidCamera.
    AoStatus aoSetCamera(const glm::mat4& view, const glm::mat4& projection);
    /// Starts a frame. The host then draws as usual to its own framebuffer.
    /// Errors: InvalidCallOrder. Context.
    AoStatus aoDrawBegin();
    /// Ends the frame: reads the host's depth buffer and darkens the host's colours by the ambient
    /// occlusion of the scene. Framebuffer and viewport are those current at this call.
    /// @param x,y,z  world position of the camera, world units.
    /// @param view   the view that the frame belongs to, for hosts with several.
    /// Without aoSetCamera(), in a compatibility context, the matrices are read from GL at
    /// aoDrawBegin() and aoDrawEnd(). The camera of one of these must match the position.
    /// Errors: InvalidCallOrder, NoCamera, InvalidCamera, InvalidFramebuffer, OutOfMemory,
    /// MissingCapability, CallbackFailed. Context.
    AoStatus aoDrawEnd(float x, float y, float z, ViewId view = {});
    /// Calls aoSetCamera(), aoDrawBegin() and aoDrawEnd() at the eye position of the matrices: for
    /// hosts that call aolib only after drawing. Errors: those of the three calls. Context.
    /// Since 0.1.
    AoStatus aoShade(const glm::mat4& view, const glm::mat4& projection, ViewId id = {});
    /// Computes a frame for hosts that render to their own textures, in place of aoDrawBegin() and
    /// aoDrawEnd(). May be called between these two or outside.
    /// Clip control and depth range are those current at this call; viewport and framebuffer are
    /// ignored.
    /// @param position  world position of the camera, world units.
    /// @param view      the view that the frame belongs to, for hosts with several.
    /// @return without a colour texture: a GL_R8 texture of the given size that belongs to aolib.
    /// Red holds the factor for the host's colours, (1 - a) + a W, 1 for the background. The
    /// texture is valid until the next call for the view, or until the view is dropped.
    /// With a colour texture: none; the colour texture has been multiplied by that factor.
    /// Errors: InvalidFramebuffer for a texture that is missing or unsuitable, and those of
    /// aoDrawEnd(). Context. Since 0.1.
    Result<TextureName> aoApply(const HostTextures& textures, const glm::vec3& position,
                                ViewId view = {});
    /// Drops the data kept for a view, for instance of a closed window. Does nothing for a view
    /// without data.
    /// A view that is not drawn is dropped automatically after 256 frames of other views, or eight
    /// frames for each view. Above 64 views, the one drawn longest ago is dropped.
    /// Errors: InvalidCallOrder within a scene renderer. Context. Since 0.1.
    AoStatus removeView(ViewId view);

    // ---- Results ---------------------------------------------------------------------------

    /// Returns results and costs of the latest frame of any view.
    Statistics statistics() const;
    /// Returns coverage, geometry share, convergence, cube maps and refined pixels of a view's
    /// latest frame; the other fields are the instance's. A view without a frame is not converged.
    /// Since 0.1.
    Statistics statistics(ViewId view) const;
    /// Reads back the latest frame's ambient occlusion; waits for the GPU. In a multisampled
    /// framebuffer, W of a pixel with several surfaces is the mean of its samples; background
    /// samples count as 1. Errors: InvalidCallOrder before the first frame. Context.
    Result<VisibilityImage> readVisibility();
    /// Reads back the ambient occlusion of a view's latest frame; waits for the GPU.
    /// Errors: InvalidCallOrder for a view without a frame. Context. Since 0.1.
    Result<VisibilityImage> readVisibility(ViewId view);
    /// Reads back a cube map; waits for the GPU. Errors: UnknownCubeMap. Context.
    Result<CubeMapImage> readCubeMap(CubeMapId id);

    /// Returns the latest failure, or Ok if no call failed. Successful calls do not reset the
    /// failure.
    const AoStatus& lastStatus() const;
    /// Sets the function that receives every later failure; empty for none.
    void setMessageSink(MessageSink sink);

private:
    struct AOLIB_NO_EXPORT Impl;
    explicit AmbientOcclusion(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

} // namespace aolib
