package org.maestro.console.chat;

import com.fasterxml.jackson.databind.JsonNode;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import org.maestro.coordination.api.GoalId;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.Requester;
import org.maestro.language.wording.Wish;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlSyntaxException;

/**
 * A goal of the platform, with what the conversations know of it.
 *
 * @param formula empty when it is none that can be read
 * @param by the person who asked for it, where that is known
 * @param said in which words, if in words
 * @param turn number of the utterance by which it was stated; 0 of another one
 * @param holders the goals for which it waits
 */
record KnownGoal(
    String id,
    Optional<Formula> formula,
    GoalState state,
    Optional<String> by,
    Optional<String> said,
    long turn,
    Duration age,
    List<String> holders) {
  private static final String PERSON = "Person";
  private static final Set<GoalState> LATER =
      Set.of(GoalState.WAITING, GoalState.SUSPENDED, GoalState.SUBMITTED);

  /** Those that are pursued for no other one, in the order in which they were stated. */
  static List<KnownGoal> all(JsonNode document, StatedGoals stated, Home home) {
    List<KnownGoal> all = new ArrayList<>();
    for (JsonNode row : document.path("goals")) {
      String id = row.path("id").asText();
      if (!GoalId.isPart(id)) {
        all.add(of(id, row, stated.of(id), home));
      }
    }
    return all.stream().filter(goal -> !goal.isBegunBy(all)).toList();
  }

  /** Whether it was begun by a goal that is bound to a time or an event, and by nobody else. */
  private boolean isBegunBy(List<KnownGoal> others) {
    return turn == 0
        && others.stream()
            .map(KnownGoal::formula)
            .flatMap(Optional::stream)
            .filter(Formula.Bound.class::isInstance)
            .map(bound -> Optional.of(((Formula.Bound) bound).goal()))
            .anyMatch(formula::equals);
  }

  private static KnownGoal of(
      String id, JsonNode row, Optional<StatedGoals.Stated> how, Home home) {
    List<String> holders = new ArrayList<>();
    row.path("waits").forEach(edge -> holders.add(GoalId.whole(edge.path("holder").asText())));
    String requester = row.path("requester").asText();
    return new KnownGoal(
        id,
        formula(row.path("goal").asText(), home),
        GoalState.valueOf(row.path("state").asText().toUpperCase(Locale.ROOT)),
        how.map(StatedGoals.Stated::person)
            .or(() -> Requester.parse(requester).person())
            .or(() -> Optional.of(requester).filter(name -> isPerson(name, home))),
        how.map(StatedGoals.Stated::words),
        how.map(StatedGoals.Stated::turn).orElse(0L),
        Duration.ofMillis(Math.round(row.path("age_s").asDouble() * 1000)),
        holders.stream().filter(holder -> !holder.equals(id)).distinct().toList());
  }

  private static boolean isPerson(String name, Home home) {
    Individual individual = home.individuals().get(name);
    return individual != null && individual.classes().contains(PERSON);
  }

  static Optional<Formula> formula(String text, Home home) {
    try {
      return Optional.of(SlParser.formula(text, home.vocabulary()::isFluent));
    } catch (SlSyntaxException e) {
      return Optional.empty();
    }
  }

  boolean isOver() {
    return state.isFinal();
  }

  /** Whether it waits for its turn or its time. */
  boolean isLater() {
    return LATER.contains(state);
  }

  boolean isBy(String person) {
    return by.filter(person::equals).isPresent();
  }

  Wish wish() {
    return new Wish(formula, said, by, age);
  }
}
