#pragma once

#include <chrono>
#include <deque>
#include <string>

#include <glm/vec2.hpp>

namespace aolib::viewer {

/// Short sentences over the picture: what was saved, what went wrong. They go by themselves.
class Messages {
public:
    using Clock = std::chrono::steady_clock;

    void tell(std::string sentence) { add(std::move(sentence), false); }
    void warn(std::string sentence) { add(std::move(sentence), true); }
    /// Draws those that still count over the lower left of the picture.
    void draw(const glm::vec2& size);

    /// Seconds until the next one goes, below 0 if there is none.
    double secondsLeft() const;
    /// The latest, also when it has gone.
    const std::string& latest() const { return latest_; }

private:
    struct Message {
        std::string sentence;
        bool warning;
        Clock::time_point until;
    };

    void add(std::string sentence, bool warning);

    std::deque<Message> messages_;
    std::string latest_;
};

} // namespace aolib::viewer
