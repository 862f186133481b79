package org.maestro.launch;

import com.fasterxml.jackson.databind.node.ArrayNode;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import org.maestro.console.documents.JsonMembers;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.PlannedSearch;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.Step;
import org.maestro.planning.api.StepKey;

/**
 * What planning for a home's goal came to, as one JSON document.
 *
 * @param findsOut whether the plan counts on what it is going to find out
 * @param toldByDevices words for want of which there is no plan from the file alone
 * @param written where the task was written as PDDL, if it was
 */
record HomePlanDocument(
    String home,
    String goal,
    PlanningResult result,
    boolean findsOut,
    List<String> toldByDevices,
    Optional<HomePlan.Written> written) {

  @Override
  public String toString() {
    JsonMembers document =
        JsonMembers.empty()
            .text("home", home)
            .text("goal", goal)
            .text("verdict", verdict())
            .truth("proven", proven());
    OptionalDouble atLeast = OptionalDouble.empty();
    Plan plan = new Plan(List.of(), Double.NaN, Map.of());
    List<PlanningResult.Obstacle> obstacles = List.of();
    Optional<String> reason = Optional.empty();
    if (result instanceof PlanningResult.Found found) {
      plan = found.plan();
      atLeast = proven() ? OptionalDouble.of(plan.cost()) : found.atLeast();
    } else if (result instanceof PlanningResult.Impossible impossible) {
      obstacles = impossible.explanation().obstacles();
    } else if (result instanceof PlanningResult.GaveUp gaveUp) {
      reason = Optional.of(gaveUp.reason());
    }
    document
        .number("cost", plan.cost())
        .number("lower_bound", atLeast)
        .number("duration_s", isFound() ? plan.seconds() : Double.NaN)
        .truth("finds_out", findsOut)
        .terms("binding", plan.goalBinding());
    steps(document.node().putArray("steps"), plan);
    searches(document.node().putArray("searches"), plan.searches());
    obstacles(document.node().putArray("obstacles"), obstacles, true);
    document.words("told_by_devices", toldByDevices).text("reason", reason);
    written.ifPresentOrElse(
        files ->
            new JsonMembers(document.node().putObject("written"))
                .text("domain", files.domain().toString())
                .text("problem", files.problem().toString())
                .words("not_carried", files.notCarried()),
        () -> document.node().putNull("written"));
    return document.toString();
  }

  private boolean isFound() {
    return result instanceof PlanningResult.Found;
  }

  private String verdict() {
    if (isFound()) {
      return "plan";
    }
    return result instanceof PlanningResult.Impossible && toldByDevices.isEmpty()
        ? "unsolvable"
        : "none found";
  }

  private boolean proven() {
    return result instanceof PlanningResult.Found found
        ? found.atLeast().isEmpty() && !findsOut
        : verdict().equals("unsolvable");
  }

  private static void steps(ArrayNode array, Plan plan) {
    Map<Integer, Double> starts = plan.starts();
    for (Step step : plan.steps()) {
      JsonMembers members = JsonMembers.in(array);
      members.node().put("number", step.number());
      members
          .text("agent", step.member())
          .text("feature", step.feature().name())
          .terms("bindings", step.bindings());
      step.after().stream().sorted().forEach(members.node().putArray("after")::add);
      members
          .number("start_s", Objects.requireNonNull(starts.get(step.number())))
          .number("duration_s", step.seconds())
          .number("cost", step.cost())
          .truth("exact_cost", step.exactPrice());
    }
  }

  private static void searches(ArrayNode array, List<PlannedSearch> searches) {
    for (PlannedSearch search : searches) {
      JsonMembers members =
          JsonMembers.in(array)
              .text("predicate", search.predicate())
              .terms("arguments", search.arguments());
      ArrayNode places = members.node().putArray("places");
      for (PlannedSearch.Place place : search.places()) {
        JsonMembers where = JsonMembers.in(places);
        where.node().set("value", JsonMembers.value(place.value()));
        where
            .number("chance", place.chance())
            .number("look_cost", place.lookCost())
            .number("expected_cost", place.expectedCost());
      }
    }
  }

  private static void obstacles(
      ArrayNode array, List<PlanningResult.Obstacle> obstacles, boolean withCures) {
    for (PlanningResult.Obstacle obstacle : obstacles) {
      JsonMembers members =
          JsonMembers.in(array)
              .text("kind", word(obstacle.kind()))
              .text("condition", obstacle.condition())
              .text("needed", obstacle.needed())
              .text("possible", obstacle.possible())
              .text("extent", word(obstacle.extent()))
              .number("missing", obstacle.missing());
      step(members, "needed_by", obstacle.neededBy());
      step(members, "subject", obstacle.subject());
      if (withCures) {
        ArrayNode cures = members.node().putArray("cures");
        obstacle.cures().forEach(cure -> obstacles(cures.addArray(), cure.conditions(), false));
      }
    }
  }

  private static void step(JsonMembers members, String name, Optional<StepKey> step) {
    step.ifPresentOrElse(
        key ->
            new JsonMembers(members.node().putObject(name))
                .text("agent", key.member())
                .text("feature", key.feature())
                .terms("bindings", key.bindings()),
        () -> members.node().putNull(name));
  }

  private static String word(Enum<?> value) {
    return value.name().toLowerCase(Locale.ROOT).replace('_', ' ');
  }
}
