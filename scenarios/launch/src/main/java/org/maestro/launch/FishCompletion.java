package org.maestro.launch;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.StreamSupport;
import picocli.CommandLine;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;

/** The completions of a command line in the language of the fish shell. */
final class FishCompletion {
  private final String program;
  private final List<String> lines = new ArrayList<>();

  private FishCompletion(String program) {
    this.program = program;
  }

  static String of(String program, CommandSpec command) {
    FishCompletion completion = new FishCompletion(program);
    completion.lines.add("complete -c %s -e".formatted(program));
    completion.command(command, List.of());
    return String.join("\n", completion.lines);
  }

  /**
   * @param path the words that lead to the command
   */
  private void command(CommandSpec command, List<String> path) {
    Map<String, CommandLine> inner = new TreeMap<>(command.subcommands());
    String here = condition(path, inner.keySet());
    inner.forEach(
        (name, sub) -> complete(here, "-f -a " + quoted(name), description(sub.getCommandSpec())));
    for (OptionSpec option : command.options()) {
      option(here, option);
    }
    for (ArgSpec parameter : command.positionalParameters()) {
      if (parameter.completionCandidates() != null) {
        complete(here, "-a " + quoted(candidates(parameter)), first(parameter.description()));
      }
    }
    inner.forEach(
        (name, sub) -> {
          List<String> longer = new ArrayList<>(path);
          longer.add(name);
          command(sub.getCommandSpec(), longer);
        });
  }

  private static String condition(List<String> path, Set<String> inner) {
    if (path.isEmpty()) {
      return "__fish_use_subcommand";
    }
    StringBuilder all = new StringBuilder();
    path.forEach(
        word ->
            all.append(all.isEmpty() ? "" : "; and ")
                .append("__fish_seen_subcommand_from ")
                .append(word));
    if (!inner.isEmpty()) {
      all.append("; and not __fish_seen_subcommand_from ").append(String.join(" ", inner));
    }
    return all.toString();
  }

  private void option(String here, OptionSpec option) {
    StringBuilder names = new StringBuilder();
    for (String name : option.names()) {
      names.append(name.startsWith("--") ? " -l " + name.substring(2) : " -s " + name.substring(1));
    }
    if (option.arity().max() > 0) {
      names.append(" -r");
      if (option.completionCandidates() != null) {
        names.append(" -a ").append(quoted(candidates(option)));
      }
    }
    complete(here, names.toString().strip(), first(option.description()));
  }

  private void complete(String condition, String what, String description) {
    lines.add(
        "complete -c %s -n %s %s%s"
            .formatted(
                program,
                quoted(condition),
                what,
                description.isEmpty() ? "" : " -d " + quoted(description)));
  }

  private static String candidates(ArgSpec argument) {
    return String.join(
        " ", StreamSupport.stream(argument.completionCandidates().spliterator(), false).toList());
  }

  private static String description(CommandSpec command) {
    return first(command.usageMessage().description());
  }

  private static String first(String... description) {
    return description.length == 0
        ? ""
        : CommandLine.Help.Ansi.OFF.string(description[0].replaceAll("\\$\\{[^}]*}", "..."));
  }

  private static String quoted(String text) {
    return "'" + text.replace("\\", "\\\\").replace("'", "\\'") + "'";
  }
}
