#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace aolib::bench {

/// Foretells how long a table of cases x methods takes from what its first cells took. Methods
/// differ a thousandfold, so each is expected to take what it has taken on average; a method not
/// seen yet is expected to take what all have.
class TimeLeft {
public:
    TimeLeft(std::size_t cases, std::size_t methods);

    /// A cell was done, or left out after no time.
    void done(std::size_t method, double seconds);
    /// Cells of a case that will never be done.
    void skipCase();

    double secondsDone() const { return total_; }
    double secondsLeft() const;
    /// Share of the expected time that has passed, 0 to 1.
    double fraction() const;
    /// "about 12 min left"; empty before anything is known.
    std::string text() const;

private:
    struct PerMethod {
        std::size_t cells = 0;
        std::size_t left = 0;
        double seconds = 0.0;
    };
    std::vector<PerMethod> methods_;
    double total_ = 0.0;
};

} // namespace aolib::bench
