#include "content/EnvironmentSource.h"

#include <filesystem>
#include <system_error>

#include "content/FileBytes.h"
#include "content/HdrReader.h"
#include "content/generated/Environments.h"

namespace aolib {

Result<lighting::EnvironmentMap, LoadError> openEnvironment(const std::string& nameOrPath) {
    if (const GeneratedEnvironment* environment = findGeneratedEnvironment(nameOrPath)) {
        return environment->build();
    }
    const std::filesystem::path file(nameOrPath);
    std::error_code code;
    if (!file.has_extension() && !std::filesystem::exists(file, code)) {
        std::string names;
        for (const GeneratedEnvironment& environment : generatedEnvironments()) {
            names += std::string(names.empty() ? "" : ", ") + environment.name;
        }
        return LoadError{nameOrPath + ": neither a file nor a generated environment (" + names +
                         ")"};
    }
    const Result<std::string, LoadError> bytes = readFileBytes(file);
    return bytes ? readHdr(*bytes, file)
                 : Result<lighting::EnvironmentMap, LoadError>(bytes.error());
}

} // namespace aolib
