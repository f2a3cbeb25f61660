#include "app/Commands.h"

#include <cmath>
#include <iostream>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include <nlohmann/json.hpp>

#include "app/Comparison.h"
#include "app/NumberFlags.h"
#include "app/OutputFiles.h"

#include "app/Table.h"
#include "image/DifferencePicture.h"
#include "image/Metrics.h"
#include "image/Pfm.h"

namespace aolib::app {

namespace {

struct CompareFlags {
    std::string test;
    std::string reference;
    std::string difference;
    double scale = static_cast<double>(kDifferenceScale);
    bool json = false;
};

void printJson(const Metrics& metrics) {
    nlohmann::ordered_json json;
    json["pixels"] = metrics.pixels;
    json["background_only_in_test"] = metrics.backgroundOnlyInTest;
    json["background_only_in_reference"] = metrics.backgroundOnlyInReference;
    json["rmse"] = metrics.rmse;
    json["mae"] = metrics.mae;
    json["bias"] = metrics.bias;
    json["p95"] = metrics.percentile95;
    json["max"] = metrics.maximum;
    json["ssim"] = nullptr;
    json["psnr_db"] = nullptr; // stays null when the pictures are equal
    if (metrics.ssim) {
        json["ssim"] = *metrics.ssim;
    }
    if (std::isfinite(metrics.psnr)) {
        json["psnr_db"] = metrics.psnr;
    }
    std::cout << json.dump(2) << '\n';
}

std::string fixed(double value, int decimals) {
    return (value < 0.0 ? "-" : "") + knownNumber(std::abs(value), decimals);
}

void printTable(const Metrics& metrics) {
    Table table({"measure", "value"});
    table.add({"pixels compared", grouped(metrics.pixels)});
    table.add({"background only in test", grouped(metrics.backgroundOnlyInTest)});
    table.add({"background only in reference", grouped(metrics.backgroundOnlyInReference)});
    table.add({"RMSE", fixed(metrics.rmse, 5)});
    table.add({"MAE", fixed(metrics.mae, 5)});
    table.add({"bias (test - reference)", fixed(metrics.bias, 5)});
    table.add({"95th percentile of |error|", fixed(metrics.percentile95, 5)});
    table.add({"maximum |error|", fixed(metrics.maximum, 5)});
    table.add({"SSIM", metrics.ssim ? fixed(*metrics.ssim, 5) : "-"});
    table.add({"PSNR dB", std::isfinite(metrics.psnr) ? fixed(metrics.psnr, 2) : "infinite"});
    std::cout << table.text();
}

MaybeFailure compare(const CompareFlags& flags) {
    OutputFiles files;
    if (!flags.difference.empty()) {
        if (MaybeFailure failure = files.announce("--difference", flags.difference, {".png"})) {
            return failure;
        }
    }
    const Result<FloatImage, ImageError> test = readPfm(flags.test);
    if (!test) {
        return badInput(test.error().message);
    }
    const Result<FloatImage, ImageError> reference = readPfm(flags.reference);
    if (!reference) {
        return badInput(reference.error().message);
    }
    const std::string both = flags.test + " and " + flags.reference + ": ";
    const Result<Metrics, ImageError> metrics = compareImages(*test, *reference);
    if (!metrics) {
        return badInput(both + metrics.error().message);
    }
    if (!flags.difference.empty()) {
        const Result<ByteImage, ImageError> picture =
            differencePicture(*test, *reference, static_cast<float>(flags.scale));
        if (!picture) {
            return badInput(both + picture.error().message);
        }
        files.put(flags.difference, *picture);
        if (MaybeFailure failure = files.commit()) {
            return failure;
        }
    }
    if (flags.json) {
        printJson(*metrics);
    } else {
        printTable(*metrics);
    }
    return std::nullopt;
}

} // namespace

void addCompareCommand(CLI::App& program, MaybeFailure& failure) {
    const auto flags = std::make_shared<CompareFlags>();
    CLI::App* command = program.add_subcommand(
        "compare", "compare a picture of W with a reference: RMSE, SSIM and more");
    command->add_option("test", flags->test, "picture of W, .pfm, background -1")->required();
    command->add_option("reference", flags->reference, "what it should be, .pfm")->required();
    command
        ->add_option("--difference", flags->difference,
                     "write a picture of the difference, .png: red too bright, blue too dark")
        ->type_name("FILE");
    addNumber(
        *command, "--scale",
        [flags](double scale) {
            if (!(scale > 0.0)) {
                throw CLI::ValidationError("--scale: a number above 0 is needed");
            }
            flags->scale = scale;
        },
        "difference of W shown in full colour")
        ->default_str("0.25");
    command->add_flag("--json", flags->json, "print JSON in place of a table");
    command->footer("Examples:\n"
                    "  aolib render town --ao w.pfm --truth t.pfm\n"
                    "  aolib compare w.pfm t.pfm --difference d.png");
    command->callback([flags, &failure] { failure = compare(*flags); });
}

} // namespace aolib::app
