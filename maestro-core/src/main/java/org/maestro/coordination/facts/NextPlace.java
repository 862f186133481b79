package org.maestro.coordination.facts;

import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.maestro.coordination.api.Argument;
import org.maestro.coordination.api.CallArguments;
import org.maestro.ontology.vocabulary.Parameter;
import org.maestro.planning.api.Step;
import org.maestro.sl.Term;

/**
 * Tells a member where its plan takes it next, where its feature asks for that: so that it ends a
 * step where the next one begins well. Only the plan knows; a member knows one call at a time.
 */
public final class NextPlace {
  private static final String POSITION = "position";

  private final CallArguments known;

  public NextPlace(CallArguments known) {
    this.known = known;
  }

  /**
   * A value for each input that asks for it; empty when the member's next step is about nothing
   * whose place is known.
   */
  public Map<String, Argument> of(Step step, List<Step> planned) {
    Map<String, Argument> told = new TreeMap<>();
    for (Parameter input : step.feature().inputs()) {
      if (input.types().contains(Parameter.NEXT_PLACE)
          && !step.bindings().containsKey(input.name())) {
        place(step, planned)
            .ifPresent(
                place -> told.put(input.name(), new Argument(place, Optional.empty(), Map.of())));
      }
    }
    return told;
  }

  /** Of the first thing of which one of the member's later steps has to know the position. */
  private Optional<Term> place(Step step, List<Step> planned) {
    return planned.stream()
        .filter(later -> later.member().equals(step.member()) && later.number() > step.number())
        .sorted(Comparator.comparingInt(Step::number))
        .flatMap(later -> pointers(later).stream())
        .findFirst()
        .flatMap(pointer -> Optional.ofNullable(pointer.properties().get(POSITION)))
        .map(values -> values.get(0));
  }

  private List<Argument> pointers(Step step) {
    Map<String, Argument> arguments = known.of(step.feature(), step.bindings());
    return step.feature().inputs().stream()
        .filter(input -> input.needs().contains(POSITION))
        .flatMap(input -> Optional.ofNullable(arguments.get(input.name())).stream())
        .toList();
  }
}
