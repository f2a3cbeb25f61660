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
/// Every call reports an AoStatus and never throws, prints or aborts; a failed call leaves the
/// scene, the cube maps and the host's GL state as they were. One thread at a time.
///
/// Calls that need OpenGL say "Context". They work in the context that was current at create() and
/// in each that shares objects with it, by turns and in any thread; commands of one context must
/// have ended (glFinish, or a fence) before a call in another, as for all shared objects. Elsewhere
/// they change nothing, of the instance or of the context: NoContext where none is current,
/// WrongContext in one that shares nothing. Calls that do not say so may be made anywhere.
class AOLIB_EXPORT AmbientOcclusion {
public:
    /// Called with how much of a longer call is done, 0 to 1, never less than before. False stops
    /// it.
    using ProgressCallback = std::function<bool(float progress)>;
    /// Called with each failure, after it was kept as lastStatus().
    using MessageSink = std::function<void(const AoStatus&)>;

    /// Makes an instance for the current context: OpenGL 3.3 or newer, core or compatibility.
    /// @param loader  gives the address of a GL function, as eglGetProcAddress does.
    /// Errors: NoContext, MissingCapability, InvalidOption, ShaderError, OutOfMemory. Context.
    /// Since 0.1.
    static Result<AmbientOcclusion> create(const ProcAddressLoader& loader,
                                           const Options& options = {});

    AmbientOcclusion(AmbientOcclusion&&) noexcept;
    /// The former content ends as in the destructor.
    AmbientOcclusion& operator=(AmbientOcclusion&&) noexcept;
    /// Deletes every GL object that the current context may delete: all of them where the instance
    /// has worked in one context and that is current. Framebuffers, vertex arrays and queries of
    /// others, which GL does not share, end with those contexts. Without a context, or in one that
    /// shares nothing, no object is deleted: they end with their own contexts.
    ~AmbientOcclusion();
    /// Forgets every GL object without a call of GL: for a context that was lost or destroyed.
    /// Calls that need a context answer NoContext from then on; the scene can still be edited.
    /// Errors: InvalidCallOrder within the scene renderer, as lastStatus(). Since 0.1.
    void abandon();

    // ---- Options ---------------------------------------------------------------------------

    const Options& options() const;
    /// Takes effect at the next frame; what the change touches is rebuilt, the scene is kept.
    /// A new `backbone` exchanges the strategy. Errors, which change nothing: InvalidOption,
    /// ShaderError, OutOfMemory. Context, where the backbone changes. Since 0.1.
    AoStatus setOptions(const Options& options);

    /// Gives the tracer that `Estimator::RayTraced` works with, or takes it away (empty). Cube maps
    /// that were traced by another are traced again. Since 0.1.
    void setTexelTracer(std::unique_ptr<AbstractTexelTracer> tracer);

    // ---- Scene definition, one vertex at a time (thesis 4.7.1) -----------------------------

    /// Starts a mesh. Errors: InvalidCallOrder inside another mesh.
    AoStatus meshBegin();
    /// Sets the normal of the vertices that follow. Before the first vertex or not at all.
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
    /// Ends the mesh and adds it to the scene. A mesh that met invalid data is dropped as a whole
    /// and that error is returned again. Errors: InvalidCallOrder, EmptyMesh, and the data's own.
    Result<MeshId> meshEnd();

    // ---- Scene definition in bulk ----------------------------------------------------------

    /// Adds a mesh. Errors: InvalidPosition, InvalidNormal, InvalidIndex, IncompletePrimitive,
    /// EmptyMesh. Since 0.1.
    Result<MeshId> addMesh(const MeshData& mesh);
    /// Replaces a mesh's content and transform under the same id. Errors: as addMesh, UnknownMesh.
    AoStatus replaceMesh(MeshId id, const MeshData& mesh);
    /// Gives a mesh another transform. Errors: UnknownMesh, InvalidPosition.
    AoStatus moveMesh(MeshId id, const glm::mat4& transform);
    /// Takes a mesh out of the scene. Errors: UnknownMesh.
    AoStatus removeMesh(MeshId id);

    // ---- Scene definition by drawing -------------------------------------------------------

    /// Has the host draw what occludes, with its own shaders, in place of the meshes' triangles:
    /// once for each face of a cube map that is computed. What is behind the first surface stays
    /// unknown; `layered-intervals` assumes a thickness. `Estimator::RayTraced` knows the described
    /// meshes alone.
    /// @param renderer  kept until it is exchanged; empty goes back to the meshes.
    /// @param min,max   a box that holds all that is drawn, world units.
    /// Errors: InvalidPosition (not finite, or min above max), InvalidCallOrder in the callback.
    /// Since 0.1.
    AoStatus setSceneRenderer(SceneRenderer renderer, const glm::vec3& min, const glm::vec3& max);
    /// Says that what the renderer draws has changed within a box, before and after together: the
    /// cube maps that see it are computed again.
    /// Errors: InvalidPosition, NoScene without a renderer. Since 0.1.
    AoStatus aoSceneChanged(const glm::vec3& min, const glm::vec3& max);

    // ---- Cube maps -------------------------------------------------------------------------

    /// Places a cube map. Without a frame budget its ambient occlusion is computed before this call
    /// returns, else over the frames to come.
    /// @param position  world units; moved to free space if it lies on a surface.
    /// Errors: InvalidCallOrder (the backbone keeps no cube maps), InvalidPosition, NoScene,
    /// MissingCapability, OutOfMemory, CallbackFailed. Context. Thesis 4.2.1. Since 0.1.
    Result<CubeMapId> addCubeMap(const glm::vec3& position);
    /// Computes all cube maps that were placed by addCubeMap(), whole, before it returns, whatever
    /// the frame budget: behind a loading screen.
    /// @param callback   called every few hundredths of a second, and with 1 at the end; empty for
    ///                   none. GL state is the host's while it runs: it may draw and swap. Calls to
    ///                   the same instance are refused meanwhile.
    /// @param positions  where cube maps are to be placed before, as by addCubeMap(); world units.
    ///                   Where such a one stands already there is no other.
    /// Errors: InvalidCallOrder (within a frame, or the backbone keeps no cube maps), Cancelled
    /// (the callback said so: what was computed stays, the rest is left to frames), CallbackFailed,
    /// and those of addCubeMap(); a failure on the way leaves what was computed, too. Context.
    /// Since 0.1.
    AoStatus prepare(const ProgressCallback& callback, std::span<const glm::vec3> positions = {});
    /// Errors: UnknownCubeMap. Context.
    AoStatus removeCubeMap(CubeMapId id);
    /// Removes all cube maps; the scene stays. Context.
    AoStatus clear();
    /// The cube maps that exist, oldest first.
    std::vector<CubeMapInfo> cubeMaps() const;

    // ---- Frame (thesis 4.7.2) --------------------------------------------------------------

    /// Gives the camera of the frames to come: world to eye, eye to clip, column-major, column
    /// vectors, as the host draws with them. Eye space may be right-handed or left-handed.
    /// Errors: InvalidCamera.
    AoStatus aoSetCamera(const glm::mat4& view, const glm::mat4& projection);
    /// Starts a frame. The host then draws as ever, to its own framebuffer.
    /// Errors: InvalidCallOrder. Context.
    AoStatus aoDrawBegin();
    /// Ends the frame: reads the depth that the host drew, and darkens its colours by the ambient
    /// occlusion of the scene. Framebuffer and viewport are those current at this call.
    /// @param x,y,z  world position of the camera.
    /// @param view   whose frame it is, where the host has several.
    /// Without aoSetCamera() in a compatibility context the matrices are read from GL, if one of
    /// those at aoDrawBegin() and aoDrawEnd() belongs to this position.
    /// Errors: InvalidCallOrder, NoCamera, InvalidCamera, InvalidFramebuffer, OutOfMemory,
    /// MissingCapability, CallbackFailed. Context.
    AoStatus aoDrawEnd(float x, float y, float z, ViewId view = {});
    /// The same as aoSetCamera(), aoDrawBegin() and aoDrawEnd() at the eye of the matrices: for
    /// hosts that hook in once they have drawn. Errors: theirs. Context. Since 0.1.
    AoStatus aoShade(const glm::mat4& view, const glm::mat4& projection, ViewId id = {});
    /// A frame for hosts that render to textures of their own: instead of aoDrawBegin() and
    /// aoDrawEnd(), between them or not. Clip control and depth range that count are those current
    /// at this call; viewport and framebuffer do not.
    /// @param position  world position of the camera.
    /// @param view      whose frame it is, where the host has several.
    /// @return without a colour texture one that holds what colours are to be multiplied by,
    /// (1 - a) + a W, in red (GL_R8, 1 for the background); aolib's own, of the size given, valid
    /// until the next call for the view or its end. With a colour texture none: that one has been
    /// multiplied. Errors: as aoDrawEnd; InvalidFramebuffer for a texture that is missing or of no
    /// use here. Context. Since 0.1.
    Result<TextureName> aoApply(const HostTextures& textures, const glm::vec3& position,
                                ViewId view = {});
    /// Drops what is kept for a view: a window was closed. Nothing happens where nothing is. Views
    /// that are not drawn are dropped by themselves, after 256 frames of others or eight for each
    /// view, and of more than 64 the one that was drawn longest ago. Errors: InvalidCallOrder
    /// within a scene renderer. Context. Since 0.1.
    AoStatus removeView(ViewId view);

    // ---- Results ---------------------------------------------------------------------------

    /// What the latest frame did and cost, of whatever view.
    Statistics statistics() const;
    /// What the latest frame of a view did: its coverage, geometry, convergence, cube maps and
    /// repaired pixels; all else is the instance's. A view that has none is not converged.
    /// Since 0.1.
    Statistics statistics(ViewId view) const;
    /// Reads back the latest frame's ambient occlusion; waits for the GPU. Where the host has
    /// samples and a pixel shows several surfaces, W is the mean of its samples, background
    /// counting as 1. Errors: InvalidCallOrder before the first frame. Context.
    Result<VisibilityImage> readVisibility();
    /// The same of a view's latest frame. Errors: InvalidCallOrder where it has none. Context.
    /// Since 0.1.
    Result<VisibilityImage> readVisibility(ViewId view);
    /// Reads back a cube map; waits for the GPU. Errors: UnknownCubeMap. Context.
    Result<CubeMapImage> readCubeMap(CubeMapId id);

    /// The latest failure, or Ok if there was none. Successful calls do not reset it.
    const AoStatus& lastStatus() const;
    /// Receives every failure from now on; empty for none.
    void setMessageSink(MessageSink sink);

private:
    struct AOLIB_NO_EXPORT Impl;
    explicit AmbientOcclusion(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

} // namespace aolib
