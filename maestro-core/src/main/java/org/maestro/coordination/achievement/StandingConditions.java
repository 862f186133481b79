package org.maestro.coordination.achievement;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.coordination.api.ActionDispatcher.Report;
import org.maestro.coordination.api.Ports;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.Source;
import org.maestro.planning.api.Step;
import org.maestro.planning.api.StepKey;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Formula;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Substitution;
import org.maestro.sl.Truth;

/**
 * Conditions that have to hold as long as steps run, as their features say: when one is known not
 * to hold any more, its step is ended, and the report says why. The coordinator's thread only.
 */
final class StandingConditions {

  private final Ports ports;
  private final Map<StepKey, Standing> standing = new HashMap<>();

  private record Standing(Step step, ActionDispatcher.Handle call, boolean isBroken) {}

  StandingConditions(Ports ports) {
    this.ports = ports;
  }

  /** The step runs from now on. */
  void begun(Step step, ActionDispatcher.Handle call) {
    if (step.feature().timing().meanwhile().isPresent()) {
      standing.put(step.key(), new Standing(step, call, false));
    }
  }

  /** What is known has changed. */
  void look(KnowledgeBase.Change change) {
    for (Standing one : new ArrayList<>(standing.values())) {
      if (!one.isBroken() && isBroken(one.step(), change.source())) {
        standing.put(one.step().key(), new Standing(one.step(), one.call(), true));
        one.call().cancel();
      }
    }
  }

  /** The step is over; a failure after its condition was broken has that as its reason. */
  Report over(Step step, Report report) {
    Standing ended = standing.remove(step.key());
    return ended == null || !ended.isBroken() || report.succeeded()
        ? report
        : new Report(false, Map.of(), Optional.of(reason(step)), report.refs());
  }

  private String reason(Step step) {
    Formula needed =
        new Substitution(step.values()).apply(step.feature().timing().meanwhile().orElseThrow());
    return "%s was ended in %s, as it has to hold meanwhile that %s, and it did not any more."
        .formatted(step.member(), step.feature().name(), SlPrinter.print(needed));
  }

  /** What is not known any more may be so still, unless its own member has taken back its word. */
  private boolean isBroken(Step step, Source source) {
    boolean hasSpoken = source.equals(new Source(Source.Kind.STATED, step.member()));
    return step.feature()
        .timing()
        .meanwhile()
        .map(needed -> new Evaluation(ports.knowledge().snapshot()).truth(needed, step.values()))
        .filter(truth -> truth == Truth.FALSE || hasSpoken && truth == Truth.UNKNOWN)
        .isPresent();
  }
}
