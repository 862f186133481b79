package org.maestro.launch;

import java.io.PrintWriter;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.maestro.agents.content.GoalReport;
import org.maestro.agents.content.HeldReport;
import org.maestro.agents.content.Words;
import org.maestro.console.documents.JsonMembers;

/**
 * Printer of how a goal ended, in sentences or as one JSON document, with the exit code that says
 * the same.
 *
 * @param goal as it was stated
 */
record GoalEndPrinter(String goal, boolean json, PrintWriter out) {

  /** A goal that is kept has no end to wait for: it is told that it is so, and how to end it. */
  int print(HeldReport report) {
    if (json) {
      out.println(
          node(Optional.of(report.goalId()), true, report.confirmed(), true)
              .terms("binding", Map.of())
              .number("simulated_s", OptionalDouble.empty())
              .number("calls", OptionalDouble.empty())
              .number("replans", OptionalDouble.empty())
              .number("decision_ms", OptionalDouble.empty())
              .words("reasons", report.reasons()));
    } else {
      out.println(
          (report.confirmed()
                  ? "It is kept so"
                  : "It is kept so, as far as is known but not confirmed,")
              + " until ./maestro cancel "
              + report.goalId()
              + ".");
    }
    return report.confirmed() ? ExitCode.DONE : ExitCode.NOT_SEEN;
  }

  int print(GoalReport report) {
    if (json) {
      printJson(report);
    } else {
      printSentences(report);
    }
    if (!report.reached()) {
      return ExitCode.NOT_REACHED;
    }
    return report.confirmed() ? ExitCode.DONE : ExitCode.NOT_SEEN;
  }

  private void printJson(GoalReport report) {
    JsonMembers members =
        node(report.id(), report.reached(), report.confirmed(), false)
            .terms("binding", report.binding())
            .number("simulated_s", seconds(report));
    members.node().put("calls", report.calls()).put("replans", report.replans());
    out.println(
        members.number("decision_ms", report.decisionMillis()).words("reasons", report.reasons()));
  }

  private void printSentences(GoalReport report) {
    out.printf(
        Locale.ROOT,
        "%s in %.1f simulated seconds; calls: %d, replans: %d.%n",
        end(report),
        seconds(report),
        report.calls(),
        report.replans());
    report
        .binding()
        .forEach((name, term) -> out.println("  ?" + name + " is " + Words.plain(term)));
    report.reasons().forEach(reason -> out.println("  " + reason));
  }

  private static String end(GoalReport report) {
    if (!report.reached()) {
      return "Not reached";
    }
    return report.confirmed() ? "Reached" : "Reached, but not confirmed,";
  }

  private static double seconds(GoalReport report) {
    return report.duration().toMillis() / 1000.0;
  }

  private JsonMembers node(Optional<String> id, boolean reached, boolean confirmed, boolean held) {
    return JsonMembers.empty()
        .text("id", id)
        .text("goal", goal)
        .truth("reached", reached)
        .truth("confirmed", confirmed)
        .truth("held", held);
  }
}
