#include "app/Commands.h"

#include <CLI/CLI.hpp>

#include "app/BenchBake.h"
#include "app/BenchEnvironment.h"
#include "app/BenchPareto.h"
#include "app/BenchPoses.h"
#include "app/BenchThesis.h"

namespace aolib::app {

void addBenchCommand(CLI::App& program, MaybeFailure& failure) {
    CLI::App* bench = program.add_subcommand("bench", "measure error and cost, ours and others'");
    bench->require_subcommand(1);
    addBenchBake(*bench, failure);
    addBenchEnvironment(*bench, failure);
    addBenchPareto(*bench, failure);
    addBenchPoses(*bench, failure);
    addBenchThesis(*bench, failure);
    bench->footer("Examples:\n"
                  "  aolib bench pareto --list\n"
                  "  aolib bench pareto --quick --scene town --method 'layered-*'\n"
                  "  aolib bench thesis --scene bunny\n"
                  "  aolib bench bake --quick\n"
                  "  aolib bench environment --quick");
}

} // namespace aolib::app
