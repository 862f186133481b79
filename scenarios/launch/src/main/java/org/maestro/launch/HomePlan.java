package org.maestro.launch;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.maestro.coordination.api.GoalCheck;
import org.maestro.coordination.api.InvalidGoalException;
import org.maestro.coordination.api.Sentences;
import org.maestro.knowledge.CollectiveKnowledge;
import org.maestro.ontology.home.Home;
import org.maestro.planning.OptimalPlanner;
import org.maestro.planning.api.PlanTime;
import org.maestro.planning.api.PlannedSearch;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.api.PricedFeature;
import org.maestro.planning.api.Step;
import org.maestro.planning.cases.NotCarriedException;
import org.maestro.planning.export.PddlWriter;
import org.maestro.rats.time.SteppedClock;
import org.maestro.sl.Formula;
import org.maestro.sl.Leaves;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/**
 * The platform's plan for a goal, made from a home file alone: nobody is asked for prices, and
 * nothing is known but what stands in the file.
 */
final class HomePlan {
  private static final int UNSOLVABLE = 10;
  private static final int NOTHING_FOUND = 12;

  /** Told of a search, beside the one where it begins. */
  private static final int MOST_PLACES = 3;

  private final PrintWriter out;

  HomePlan(PrintWriter out) {
    this.out = out;
  }

  /**
   * Prints the plan.
   *
   * @param directory where to write the task as PDDL
   * @return the exit code
   */
  int show(String homeFile, String goalText, Optional<Path> directory) {
    Home home = Shipped.home(homeFile);
    PlanningTask task = task(home, goal(home, goalText));
    directory.ifPresent(place -> write(task, place));
    PlanningResult result = new OptimalPlanner().plan(task);
    Sentences sentences = new Sentences(home.vocabulary());
    if (result instanceof PlanningResult.Found found) {
      for (Step step : found.plan().steps()) {
        out.printf(
            Locale.ROOT,
            "%3d. %s; %s%s%n",
            step.number(),
            sentences.step(step),
            step.exactPrice() ? "" : "at least ",
            Sentences.number(step.cost()));
      }
      found.plan().searches().forEach(search -> printSearch(search, sentences));
      out.printf("; cost = %s (%s)%n", Sentences.number(found.plan().cost()), worth(found));
      return ExitCode.DONE;
    }
    if (result instanceof PlanningResult.Impossible impossible) {
      String told = told(home, impossible.explanation().obstacles());
      out.println(
          told.isEmpty()
              ? "; unsolvable (proven)"
              : "; no plan from the file alone: the devices themselves tell " + told);
      impossible
          .explanation()
          .obstacles()
          .forEach(
              obstacle ->
                  out.printf(
                      "; needed: %s, %s; %s: %s%n",
                      obstacle.condition(),
                      obstacle.needed(),
                      reachedWord(obstacle),
                      obstacle.possible()));
      return told.isEmpty() ? UNSOLVABLE : NOTHING_FOUND;
    }
    out.println("; no plan found: " + ((PlanningResult.GaveUp) result).reason());
    return NOTHING_FOUND;
  }

  /** Where it is looked first, how surely it is there, and what else was weighed. */
  private void printSearch(PlannedSearch search, Sentences sentences) {
    PlannedSearch.Place first = search.places().get(0);
    List<Term> found = new ArrayList<>(search.arguments());
    found.add(first.value());
    out.printf(
        Locale.ROOT,
        "; %s: %.0f %%; to look there first is expected to cost %s in all%s%n",
        sentences.fact(new Formula.Atom(search.predicate(), found)),
        100 * first.chance(),
        Sentences.number(first.expectedCost()),
        search.places().stream()
            .skip(1)
            .filter(place -> Double.isFinite(place.expectedCost()))
            .limit(MOST_PLACES)
            .map(
                place ->
                    ", in %s %s"
                        .formatted(
                            SlPrinter.print(place.value()), Sentences.number(place.expectedCost())))
            .collect(Collectors.joining()));
  }

  /** What is said of the cost: no more than is proven. */
  private static String worth(PlanningResult.Found found) {
    if (found.atLeast().isPresent()) {
      return "lower bound " + Sentences.number(found.atLeast().getAsDouble());
    }
    boolean findsOut =
        found.plan().steps().stream().anyMatch(step -> PlanTime.senses(step.feature().effect()));
    return findsOut ? "if what is found out is as hoped" : "optimal";
  }

  /** The words in what stands in the way that a platform would hear from its devices. */
  private static String told(Home home, List<PlanningResult.Obstacle> obstacles) {
    Set<String> words = new TreeSet<>();
    obstacles.stream()
        .filter(obstacle -> obstacle.subject().isEmpty())
        .map(obstacle -> SlParser.formula(obstacle.condition(), home.vocabulary()::isFluent))
        .forEach(
            condition ->
                Leaves.of(
                    condition,
                    atom -> words.add(atom.predicate()),
                    fluent -> words.add(fluent.name())));
    words.removeIf(word -> home.devices().values().stream().noneMatch(one -> one.tells(word)));
    return String.join(", ", words);
  }

  /** What is only known now, or the best that was found, is no limit. */
  private static String reachedWord(PlanningResult.Obstacle obstacle) {
    if (obstacle.kind() != PlanningResult.Obstacle.Kind.NUMBER) {
      return "possible";
    }
    return switch (obstacle.extent()) {
      case KNOWN -> "it is";
      case LIMIT, LIMIT_NOW -> "possible";
      case FOUND -> "found";
    };
  }

  private static Formula goal(Home home, String text) {
    Formula goal = SlParser.formula(text, home.vocabulary()::isFluent);
    try {
      new GoalCheck(home).check(goal);
    } catch (InvalidGoalException e) {
      throw CommandException.badInput(e);
    }
    return goal;
  }

  private static PlanningTask task(Home home, Formula goal) {
    List<PricedFeature> features =
        home.devices().values().stream()
            .flatMap(
                device ->
                    device.features().stream()
                        .map(type -> new PricedFeature(device.id(), type, type.cost(), Map.of())))
            .toList();
    try (CollectiveKnowledge knowledge = new CollectiveKnowledge(home, new SteppedClock())) {
      return new PlanningTask(home.vocabulary(), knowledge.snapshot(), features, goal, Set.of());
    }
  }

  private void write(PlanningTask task, Path directory) {
    try {
      PddlWriter.Texts texts = PddlWriter.write(task, "maestro-home");
      Files.createDirectories(directory);
      Path domain = directory.resolve("domain.pddl");
      Path problem = directory.resolve("problem.pddl");
      Files.writeString(domain, texts.domain());
      Files.writeString(problem, texts.problem());
      out.printf("Written: %s and %s.%n", domain, problem);
      texts.notCarried().forEach(sentence -> out.println("  " + sentence));
    } catch (NotCarriedException e) {
      throw CommandException.badInput(e);
    } catch (IOException e) {
      throw CommandException.outside("Into %s nothing can be written.".formatted(directory), e);
    }
  }
}
