package org.maestro.coordination.contention;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.coordination.facts.FactsMaskedByRunningSteps;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.ontology.home.Script;
import org.maestro.planning.api.Step;
import org.maestro.planning.api.StepKey;
import org.maestro.sl.Term;

/**
 * The steps of one goal that agents are at, and which of them the coordinator itself has called
 * off.
 */
public final class StepsUnderway {
  private final Map<StepKey, Underway> underway = new LinkedHashMap<>();
  private final Map<StepKey, FactsMaskedByRunningSteps.Handled> handled = new HashMap<>();
  private final Set<StepKey> calledOff = new LinkedHashSet<>();
  private final Set<StepKey> offeredFor = new LinkedHashSet<>();
  private final Set<StepKey> ending = new LinkedHashSet<>();

  private record Underway(Step step, Snapshot before, ActionDispatcher.Handle performance) {}

  public void begun(Step step, Snapshot before, ActionDispatcher.Handle performance) {
    underway.put(step.key(), new Underway(step, before, performance));
  }

  /** Returns whether it was called off, so that its failure says nothing. */
  public boolean ended(Step step) {
    underway.remove(step.key());
    handled.remove(step.key());
    offeredFor.remove(step.key());
    ending.remove(step.key());
    return calledOff.remove(step.key());
  }

  /**
   * Its member has said nothing of it, and is told to end it: until it is over nothing else is
   * begun with that member.
   */
  public void isEnding(Step step) {
    ending.add(step.key());
    calledOff.add(step.key());
  }

  /** Nobody waits for what was given up to end. */
  public boolean isEmpty() {
    return ending.containsAll(underway.keySet());
  }

  public boolean contains(Step step) {
    return underway.containsKey(step.key());
  }

  /** Whether a step of the same member uses a component that this one needs, or is to end first. */
  public boolean clashesWith(Step next) {
    return underway.values().stream()
        .map(Underway::step)
        .anyMatch(
            running ->
                running.member().equals(next.member())
                    && (ending.contains(running.key())
                        || running.feature().occupies().stream()
                            .anyMatch(next.feature().occupies()::contains)));
  }

  /** Whether one of them is a script that goes on. */
  public boolean isAScript() {
    return underway.values().stream()
        .map(Underway::step)
        .anyMatch(step -> isScript(step) && !calledOff.contains(step.key()));
  }

  /**
   * Whether the step has to wait for others of its plan: a script may use what they use, so nothing
   * is done beside it.
   */
  public boolean goesAlone(Step next) {
    return !underway.isEmpty()
        && (isScript(next) || steps().stream().anyMatch(StepsUnderway::isScript));
  }

  private static boolean isScript(Step step) {
    return step.member().equals(Script.PLANNED_AS);
  }

  /** The member's step of that feature, unless it was called off already. */
  public Optional<Step> find(String member, String feature) {
    return steps().stream()
        .filter(step -> step.member().equals(member) && step.feature().name().equals(feature))
        .filter(step -> !calledOff.contains(step.key()))
        .findFirst();
  }

  /** Another member may get what this step is for. */
  public void mayChangeHands(Step step) {
    offeredFor.add(step.key());
  }

  /**
   * Whether the next step has to wait until one that another is to take over has ended, so that
   * never two are at the same.
   */
  public boolean isHandedOver(Step next) {
    return underway.values().stream()
        .map(Underway::step)
        .filter(step -> calledOff.contains(step.key()) && offeredFor.contains(step.key()))
        .anyMatch(
            step ->
                step.feature().name().equals(next.feature().name())
                    || step.bindings().values().stream()
                        .filter(Term.Name.class::isInstance)
                        .anyMatch(next.bindings().values()::contains));
  }

  public void callOffAllBut(Set<StepKey> wanted, Consumer<Step> told) {
    for (Underway u : List.copyOf(underway.values())) {
      if (!wanted.contains(u.step().key()) && calledOff.add(u.step().key())) {
        told.accept(u.step());
        u.performance().cancel();
      }
    }
  }

  public List<Step> steps() {
    return underway.values().stream().map(Underway::step).toList();
  }

  /** Tells what these steps are just changing. */
  void addTo(FactsMaskedByRunningSteps facts) {
    underway.forEach(
        (key, u) ->
            facts.add(handled.computeIfAbsent(key, k -> facts.handled(u.step(), u.before()))));
  }
}
