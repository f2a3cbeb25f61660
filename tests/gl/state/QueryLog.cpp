#include "QueryLog.h"

#include <algorithm>
#include <map>
#include <string>

namespace aolib {

namespace {

QueryLog* logInUse = nullptr;

/// A name that is part of a type.
template <std::size_t N>
struct FunctionName {
    char value[N]{};
    constexpr FunctionName(const char (&text)[N]) { std::copy_n(text, N, value); }
};

/// The real function behind each watched one.
template <FunctionName Name, typename Function>
Function real = nullptr;

void note(GLenum name) {
    logInUse->asked.insert(name);
    ++logInUse->queries;
}

template <FunctionName Name, typename Value>
void APIENTRY get(GLenum name, Value* value) {
    note(name);
    real<Name, void(APIENTRY*)(GLenum, Value*)>(name, value);
}
template <FunctionName Name, typename Value>
void APIENTRY getIndexed(GLenum name, GLuint index, Value* value) {
    note(name);
    real<Name, void(APIENTRY*)(GLenum, GLuint, Value*)>(name, index, value);
}
GLboolean APIENTRY isEnabled(GLenum name) {
    note(name);
    return real<"glIsEnabled", PFNGLISENABLEDPROC>(name);
}
GLboolean APIENTRY isEnabledIndexed(GLenum name, GLuint index) {
    note(name);
    return real<"glIsEnabledi", PFNGLISENABLEDIPROC>(name, index);
}
void APIENTRY pushDebugGroup(GLenum source, GLuint id, GLsizei length, const GLchar* text) {
    ++logInUse->groups;
    real<"glPushDebugGroup", PFNGLPUSHDEBUGGROUPPROC>(source, id, length, text);
}

template <FunctionName Name, typename Function>
void watch(std::map<std::string, void*>& table, const ProcAddressLoader& loader,
           Function function) {
    real<Name, Function> = reinterpret_cast<Function>(loader(Name.value));
    table[Name.value] = reinterpret_cast<void*>(function);
}

} // namespace

QueryLog::QueryLog(const ProcAddressLoader& loader) {
    logInUse = this;
    std::map<std::string, void*> table;
    watch<"glGetIntegerv">(table, loader, &get<"glGetIntegerv", GLint>);
    watch<"glGetFloatv">(table, loader, &get<"glGetFloatv", GLfloat>);
    watch<"glGetDoublev">(table, loader, &get<"glGetDoublev", GLdouble>);
    watch<"glGetBooleanv">(table, loader, &get<"glGetBooleanv", GLboolean>);
    watch<"glGetIntegeri_v">(table, loader, &getIndexed<"glGetIntegeri_v", GLint>);
    watch<"glGetFloati_v">(table, loader, &getIndexed<"glGetFloati_v", GLfloat>);
    watch<"glGetDoublei_v">(table, loader, &getIndexed<"glGetDoublei_v", GLdouble>);
    watch<"glGetBooleani_v">(table, loader, &getIndexed<"glGetBooleani_v", GLboolean>);
    watch<"glIsEnabled">(table, loader, &isEnabled);
    watch<"glIsEnabledi">(table, loader, &isEnabledIndexed);
    watch<"glPushDebugGroup">(table, loader, &pushDebugGroup);
    loader_ = [loader, table](const char* name) {
        const auto found = table.find(name);
        void* address = loader(name);
        return found == table.end() || address == nullptr ? address : found->second;
    };
}

QueryLog::~QueryLog() {
    logInUse = nullptr;
}

void QueryLog::clear() {
    asked.clear();
    queries = 0;
    groups = 0;
}

} // namespace aolib
