#pragma once

#include <cstdint>

#include "content/NamedCamera.h"
#include "scene/Bounds.h"
#include "viewer/Input.h"

namespace aolib::viewer {

enum class CameraMode : std::uint8_t { Orbit, Walk };

/// The camera of the window, and what mouse and keys do to it.
class CameraControl {
public:
    /// Takes over a scene's camera.
    /// @param bounds  of what must stay between the planes.
    /// @param size    of the scene, world units: a step's measure.
    void begin(const NamedCamera& camera, const Bounds& bounds, float size);
    /// Another view of the same scene.
    void place(const NamedCamera& camera);
    /// Back to the camera of the latest begin() or place().
    void reset() { camera_ = home_; }

    /// @param height   of the picture, mouse pixels.
    /// @param seconds  since the last frame.
    /// @param turning  whether a drag of the left button is the camera's.
    /// Returns whether the camera has moved.
    bool follow(const Input& input, float height, float seconds, bool turning);

    const NamedCamera& camera() const { return camera_; }
    CameraMode mode = CameraMode::Orbit;
    float walkSpeed = kWalkSpeed; ///< scene diagonals per second

    static constexpr float kWalkSpeed = 0.08F;

private:
    void orbit(const Input& input, float height, bool turning);
    void walk(const Input& input, float height, float seconds, bool turning);
    void enclose();

    NamedCamera home_;
    NamedCamera camera_;
    Bounds bounds_;
    float size_ = 1.0F;
};

} // namespace aolib::viewer
