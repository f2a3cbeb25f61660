#include "FileDrop.h"

#include <array>
#include <chrono>
#include <memory>
#include <thread>

#include <X11/Xatom.h>
#include <X11/Xlib.h>

namespace aolib::test {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kDropPatience{60};
constexpr long kVersion = 5;

/// The side of the drag and drop protocol that has the file.
class DragSource {
public:
    DragSource(::Display* display, Window target, std::string uri)
        : display_(display), target_(target), uri_(std::move(uri)),
          own_(XCreateSimpleWindow(display, DefaultRootWindow(display), 0, 0, 1, 1, 0, 0, 0)) {
        XSetSelectionOwner(display_, atom("XdndSelection"), own_, CurrentTime);
    }
    ~DragSource() { XDestroyWindow(display_, own_); }
    DragSource(const DragSource&) = delete;
    DragSource& operator=(const DragSource&) = delete;

    std::string drop() {
        send("XdndEnter", {kVersion << 24, long(atom("text/uri-list")), 0, 0});
        send("XdndPosition", {0, (20L << 16) | 20L, CurrentTime, long(atom("XdndActionCopy"))});
        if (!waitFor("XdndStatus")) {
            return "the window does not answer to a drag";
        }
        send("XdndDrop", {0, CurrentTime, 0, 0});
        return waitFor("XdndFinished") ? "" : "the window does not take the drop";
    }

private:
    Atom atom(const char* name) const { return XInternAtom(display_, name, False); }

    void send(const char* kind, const std::array<long, 4>& data) {
        XEvent event{};
        event.xclient.type = ClientMessage;
        event.xclient.window = target_;
        event.xclient.message_type = atom(kind);
        event.xclient.format = 32;
        event.xclient.data.l[0] = static_cast<long>(own_);
        for (std::size_t i = 0; i < data.size(); ++i) {
            event.xclient.data.l[i + 1] = data[i];
        }
        XSendEvent(display_, target_, False, NoEventMask, &event);
        XFlush(display_);
    }

    /// Hands the file's name out when asked, until a message comes.
    bool waitFor(const char* kind) {
        const Clock::time_point end = Clock::now() + kDropPatience;
        while (Clock::now() < end) {
            while (XPending(display_) > 0) {
                XEvent event{};
                XNextEvent(display_, &event);
                if (event.type == SelectionRequest) {
                    answer(event.xselectionrequest);
                } else if (event.type == ClientMessage &&
                           event.xclient.message_type == atom(kind)) {
                    return true;
                }
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        return false;
    }

    void answer(const XSelectionRequestEvent& request) {
        XChangeProperty(display_, request.requestor, request.property, request.target, 8,
                        PropModeReplace, reinterpret_cast<const unsigned char*>(uri_.data()),
                        static_cast<int>(uri_.size()));
        XEvent event{};
        event.xselection.type = SelectionNotify;
        event.xselection.requestor = request.requestor;
        event.xselection.selection = request.selection;
        event.xselection.target = request.target;
        event.xselection.property = request.property;
        event.xselection.time = request.time;
        XSendEvent(display_, request.requestor, False, NoEventMask, &event);
        XFlush(display_);
    }

    ::Display* display_;
    Window target_;
    std::string uri_;
    Window own_;
};

} // namespace

std::string dropFile(const std::string& display, const std::string& window,
                     const std::string& file) {
    const std::unique_ptr<::Display, int (*)(::Display*)> opened(XOpenDisplay(display.c_str()),
                                                                 &XCloseDisplay);
    if (!opened) {
        return "there is no display " + display;
    }
    DragSource source(opened.get(), std::stoul(window), "file://" + file + "\r\n");
    return source.drop();
}

} // namespace aolib::test
