#include "gl/Container.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace aolib::gl {

struct Container::Content {
    struct Name {
        ContextId context;
        GLuint name;
    };

    const Functions& gl;
    Kind kind;
    std::string label;
    Fill fill;
    std::vector<Name> names;
    ContextGroup::MakeHere makeHere;

    const Name* here() const {
        const ContextId context = currentContext(gl);
        const auto found = std::find_if(names.begin(), names.end(), [context](const Name& name) {
            return name.context == context;
        });
        return found != names.end() ? &*found : nullptr;
    }

    AoStatus make() {
        if (here() != nullptr) {
            return {};
        }
        Name made{currentContext(gl), 0};
        (gl.*kind.generate)(1, &made.name);
        if (made.name == 0) {
            return {StatusCode::OutOfMemory, label + ": GL gave no " + kind.name + " name"};
        }
        AoStatus status = fill ? fill(gl, made.name) : AoStatus();
        if (status) {
            names.push_back(made);
        } else {
            (gl.*kind.remove)(1, &made.name);
        }
        return status;
    }
};

void Container::Deleter::operator()(Content* content) const {
    const Functions& gl = content->gl;
    if (gl.group != nullptr) {
        gl.group->remove(&content->makeHere);
    }
    for (const Content::Name& each : content->names) {
        release(gl, each.context,
                [remove = gl.*content->kind.remove, name = each.name] { remove(1, &name); });
    }
    delete content;
}

Result<Container> Container::create(const Functions& gl, const Kind& kind, const std::string& label,
                                    Fill fill) {
    Container container;
    container.content_.reset(new Content{gl, kind, label, std::move(fill), {}, {}});
    Content* content = container.content_.get();
    content->makeHere = [content] { return content->make(); };
    if (AoStatus status = content->make(); !status) {
        return status;
    }
    if (gl.group != nullptr) {
        gl.group->add(&content->makeHere);
    }
    return container;
}

GLuint Container::name() const {
    const Content::Name* here = content_ != nullptr ? content_->here() : nullptr;
    return here != nullptr ? here->name : 0;
}

} // namespace aolib::gl
