/// superstep_audit: judges every registered method on random scenes.

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include "audit/audit.hpp"
#include "audit/special_audits.hpp"
#include "audit/verdict.hpp"
#include "bench/host/machine.hpp"
#include "core/stopwatch.hpp"

namespace superstep::audit {
namespace {

constexpr const char* usage = R"(superstep_audit: random scenes against an oracle, for every registered method

  --seeds A:B          seeds A to B-1 (default 1:101)
  --methods M,M        names or SPECs without rtol, separated by ';' (default all)
  --rtol X,X           tolerances of adaptive methods (default 1e-3,1e-5,1e-7)
  --class NAME         scenes of one class only
  --no-steps           no steps in time tables
  --true-spans         hand the oracle's spans to the runs
  --jobs N             processes side by side (default 1)
  --limit S            seconds of CPU time that one run may take (default 5)
  --csv FILE           every run, one a line
  --table FILE...      tables of CSVs written before, nothing is run
  --by-class           a table for each class, too
  --list-bad           runs that failed or miss by more than ten times
  --shift              compare each scene with itself at temperatures 273.15 higher
  --reference          judge the reference instead: is its bar above its error, and how large is it
  --spans              judge the spans that the library finds
  --bounds             judge the bounds that methods state, against sixty digits (default class: linear-constant,
                       default methods: exponential in each basis)
  --describe           what the scenes are, with the oracle's span, error and time
)";

struct Arguments {
  std::uint64_t first = 1, last = 101;
  std::vector<std::string> methods, tables;
  std::vector<double> rtols = {1e-3, 1e-5, 1e-7};
  SceneWishes wishes{.steps = true};
  AuditSettings settings;
  double limit = 5;  // s
  int jobs = 1;
  std::string csv;
  bool by_class = false, list_bad = false, shift = false, reference = false, spans = false, bounds = false,
       describe = false;
};

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, separator);) parts.push_back(part);
  return parts;
}

[[noreturn]] void refuse(const std::string& what) {
  std::cerr << what << "\n\n" << usage;
  std::exit(2);
}

Arguments parse(const std::vector<std::string>& words) {
  Arguments out;
  for (std::size_t k = 0; k < words.size(); ++k) {
    const std::string& word = words[k];
    const auto next = [&] {
      if (k + 1 >= words.size()) refuse(word + " needs a value");
      return words[++k];
    };
    if (word == "--seeds") {
      const auto range = split(next(), ':');
      if (range.size() != 2) refuse("--seeds takes A:B");
      out.first = std::stoull(range[0]);
      out.last = std::stoull(range[1]);
    } else if (word == "--methods") {
      out.methods = split(next(), ';');
    } else if (word == "--rtol") {
      out.rtols.clear();
      for (const auto& value : split(next(), ',')) out.rtols.push_back(std::stod(value));
    } else if (word == "--class") {
      out.wishes.kind = next();
    } else if (word == "--no-steps") {
      out.wishes.steps = false;
    } else if (word == "--true-spans") {
      out.settings.true_spans = true;
    } else if (word == "--jobs") {
      out.jobs = std::stoi(next());
    } else if (word == "--limit") {
      out.limit = std::stod(next());
    } else if (word == "--csv") {
      out.csv = next();
    } else if (word == "--table") {
      while (k + 1 < words.size() && words[k + 1].rfind("--", 0) != 0) out.tables.push_back(next());
    } else if (word == "--by-class") {
      out.by_class = true;
    } else if (word == "--list-bad") {
      out.list_bad = true;
    } else if (word == "--shift") {
      out.shift = true;
    } else if (word == "--reference") {
      out.reference = true;
    } else if (word == "--spans") {
      out.spans = true;
    } else if (word == "--bounds") {
      out.bounds = true;
    } else if (word == "--describe") {
      out.describe = true;
    } else if (word == "--help") {
      std::cout << usage;
      std::exit(0);
    } else {
      refuse("unknown: " + word);
    }
  }
  return out;
}

/// Every contender on the scenes of one worker; a scene that cannot be judged is a row, too.
std::vector<Row> audit_share(const Arguments& arguments, int worker) {
  std::vector<Row> rows;
  const auto all = contenders(arguments.methods);
  TimeLimit limit(arguments.limit);
  for (auto seed = arguments.first; seed < arguments.last; ++seed) {
    if (seed % static_cast<std::uint64_t>(arguments.jobs) != static_cast<std::uint64_t>(worker)) continue;
    const auto stated = state_scene(seed, arguments.wishes);
    try {
      const Truth truth = find_truth(stated);
      const Scene scene = build_scene(stated);
      for (const auto& contender : all)
        for (const double rtol : contender.adaptive ? arguments.rtols : std::vector<double>{0})
          rows.push_back(judge(stated, scene, truth, contender, rtol, arguments.settings, limit));
    } catch (const std::exception& error) {
      Row row{.seed = seed, .kind = stated.kind, .shape = stated.shape};
      row.label = "(oracle)";
      row.status = "failed";
      row.reason = error.what();
      rows.push_back(row);
    }
  }
  return rows;
}

/// Processes, because one that breaks takes nothing else with it and nothing needs to be safe for threads.
std::vector<Row> audit_all(const Arguments& arguments) {
  if (arguments.jobs <= 1) return audit_share(arguments, 0);
  const auto file_of = [&](int worker) {
    return std::filesystem::temp_directory_path() /
           fmt::format("superstep_audit_{}_{}.csv", ::getpid(), worker);
  };
  std::vector<std::filesystem::path> files;
  std::vector<pid_t> children;
  for (int worker = 0; worker < arguments.jobs; ++worker) {
    files.push_back(file_of(worker));
    const pid_t child = ::fork();
    if (child == 0) {
      std::ofstream out(files.back());
      write_rows(out, audit_share(arguments, worker));
      out.close();
      ::_exit(0);
    }
    children.push_back(child);
  }
  std::vector<Row> rows;
  for (std::size_t k = 0; k < children.size(); ++k) {
    int status = 0;
    ::waitpid(children[k], &status, 0);
    if (status != 0) std::cerr << "a worker broke with status " << status << '\n';
    std::ifstream in(files[k]);
    if (status == 0)
      for (auto& row : read_rows(in)) rows.push_back(std::move(row));
    std::filesystem::remove(files[k]);
  }
  std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.seed < b.seed; });
  return rows;
}

void describe(const Arguments& arguments) {
  for (auto seed = arguments.first; seed < arguments.last; ++seed) {
    const auto stated = state_scene(seed, arguments.wishes);
    std::size_t tables = 0, knots = 0;
    for (const auto& field : stated.fields)
      for (const auto& table : field.graph.tables) {
        ++tables;
        knots += table.time.size();
      }
    std::cout << fmt::format("{} {} {} nodes={} edges={} tables={} knots={} outputs={} t*lambda={:.2g}", seed,
                             stated.kind, stated.shape, stated.fields.back().graph.nodes(),
                             stated.fields.back().graph.edges(), tables, knots, stated.output_times.size(),
                             stated.t_lambda);
    try {
      const double begin = wall_seconds();
      const Truth truth = find_truth(stated);
      std::cout << fmt::format(" oracle {:.1f} ms, {} steps", 1e3 * (wall_seconds() - begin), truth.steps);
      for (const auto& field : truth.fields)
        std::cout << fmt::format("; {} {:g} .. {:g}, error/span {:.1g}", field.name, field.low, field.high,
                                 field.span() > 0 ? field.error / field.span() : 0.0);
    } catch (const std::exception& error) {
      std::cout << " oracle: " << error.what();
    }
    std::cout << std::endl;
  }
}

int run(const Arguments& arguments) {
  set_library_threads(1);
  if (arguments.describe) {
    describe(arguments);
    return 0;
  }
  const SeedRange seeds{arguments.first, arguments.last};
  if (arguments.reference) {
    print_reference_audit(std::cout, seeds, arguments.wishes, arguments.list_bad);
    return 0;
  }
  if (arguments.spans) {
    print_span_audit(std::cout, seeds, arguments.wishes, arguments.list_bad);
    return 0;
  }
  if (arguments.bounds) {
    const std::vector<std::string> bases = {"exponential:basis=chebyshev", "exponential:basis=lanczos",
                                            "exponential:basis=shift-invert"};
    const auto methods = contenders(arguments.methods.empty() ? bases : arguments.methods);
    SceneWishes wishes = arguments.wishes;
    if (wishes.kind.empty()) wishes.kind = "linear-constant";
    return print_bounds_audit(std::cout, seeds, wishes, methods, arguments.rtols, arguments.list_bad) == 0
               ? 0
               : 1;
  }
  if (arguments.shift) {
    TimeLimit limit(arguments.limit);
    print_shift_audit(std::cout, seeds, arguments.wishes, contenders(arguments.methods), arguments.rtols,
                      arguments.settings, limit, arguments.list_bad);
    return 0;
  }
  std::vector<Row> rows;
  for (const auto& file : arguments.tables) {
    std::ifstream in(file);
    for (auto& row : read_rows(in)) rows.push_back(std::move(row));
  }
  if (arguments.tables.empty()) rows = audit_all(arguments);
  if (!arguments.csv.empty()) {
    std::ofstream out(arguments.csv);
    write_rows(out, rows);
  }
  print_tables(std::cout, rows, arguments.by_class);
  if (arguments.list_bad) print_bad(std::cout, rows);
  return broken_claims(tally(rows)).empty() ? 0 : 1;
}

}  // namespace
}  // namespace superstep::audit

int main(int count, char** words) {
  try {
    return superstep::audit::run(superstep::audit::parse({words + 1, words + count}));
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
