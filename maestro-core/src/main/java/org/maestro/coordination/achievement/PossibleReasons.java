package org.maestro.coordination.achievement;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.maestro.coordination.api.ActionDispatcher.Report;
import org.maestro.coordination.api.Sentences;
import org.maestro.knowledge.api.FeatureRun;
import org.maestro.knowledge.api.KnowledgeException;
import org.maestro.knowledge.belief.FactReader;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.StatementCheck;
import org.maestro.planning.api.Step;

/**
 * The reasons that a failure teaches, without those that cannot be facts of the home: their words
 * are not there, or are for other things. What was wrong with these is told with the failure.
 */
final class PossibleReasons {
  private PossibleReasons() {}

  static Report of(Step step, Report report, Home home) {
    StatementCheck check = new StatementCheck(home, "it");
    List<FeatureRun.Learnt> possible = new ArrayList<>();
    List<String> problems = new ArrayList<>();
    for (FeatureRun.Learnt reason : report.refs()) {
      fault(reason, step.member(), check)
          .ifPresentOrElse(
              why ->
                  problems.add(
                      "its reason %s is passed over: %s"
                          .formatted(reason.fact(), withoutCure(why))),
              () -> possible.add(reason));
    }
    if (problems.isEmpty()) {
      return report;
    }
    String problem =
        "%s (%s)"
            .formatted(
                Sentences.withoutFullStop(report.problem().orElse("no reason given")),
                String.join("; ", problems));
    return report.with(Optional.of(problem), possible);
  }

  /** The cure is for who writes the device, and long: its description is checked with it. */
  private static String withoutCure(String fault) {
    return Sentences.withoutFullStop(fault.split("; ", 2)[0]);
  }

  private static Optional<String> fault(
      FeatureRun.Learnt reason, String member, StatementCheck check) {
    try {
      return check.misfit(FactReader.read(reason, member));
    } catch (KnowledgeException noFact) {
      return Optional.of(Objects.requireNonNullElse(noFact.getMessage(), noFact.toString()));
    }
  }
}
