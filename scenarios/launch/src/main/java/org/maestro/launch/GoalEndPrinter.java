package org.maestro.launch;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.PrintWriter;
import java.util.Locale;
import org.maestro.agents.content.GoalReport;
import org.maestro.agents.content.HeldReport;
import org.maestro.agents.content.Words;

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
      ObjectNode node = node(report.goalId(), true, report.confirmed());
      node.put("held", true);
      out.println(node);
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
    ObjectNode node = node(report.id().orElse(""), report.reached(), report.confirmed());
    ObjectNode binding = node.putObject("binding");
    report.binding().forEach((name, term) -> binding.put(name, Words.plain(term)));
    node.put("simulated_s", seconds(report));
    node.put("calls", report.calls());
    node.put("replans", report.replans());
    node.put("decision_ms", report.decisionMillis());
    report.reasons().forEach(node.putArray("reasons")::add);
    out.println(node);
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

  private ObjectNode node(String id, boolean reached, boolean confirmed) {
    ObjectNode node = new ObjectMapper().createObjectNode();
    node.put("id", id);
    node.put("goal", goal);
    node.put("reached", reached);
    node.put("confirmed", confirmed);
    return node;
  }
}
